//! The pin: a point of the parent and a point of the child that stay together. Report 9.3.

use ch00_maths::f32::joint::{self, Lever, pin_matrix};
use ch00_maths::f32::{impulse, pin};
use ch02_rigid_bodies::RigidBody;
use ch03_collision::Span;
use glam::{Mat3, Vec3};

use super::anchors::{Anchors, Arms};
use super::{LONGEST_GAP, SMALL_GAP, WIDE};

// ANCHOR: pin
/// 0 = d = (p₁ + t₁) − (p₂ + t₂), with t = q ∗ o.
pub struct PinConstraint {
    /// o₁ and o₂.
    anchors: Anchors,
    /// t₁, t₂ and K⁻¹ as they were when the step began.
    arms: Arms,
    yielding: Mat3,
    /// Relative velocity of the two points in the middle of the last step, m/s.
    parted: Vec3,
    /// What the parent received in the last step, N s: where the next begins.
    impulse: Vec3,
    /// The gap that the last step left, m: what it couldn't close must not be pulled shut with speed.
    left: Vec3,
}
// ANCHOR_END: pin

impl PinConstraint {
    /// Pins a point of one body to a point of another.
    #[must_use]
    pub fn new(anchors: Anchors) -> Self {
        Self {
            anchors,
            arms: Arms::default(),
            yielding: Mat3::ZERO,
            parted: Vec3::ZERO,
            impulse: Vec3::ZERO,
            left: Vec3::ZERO,
        }
    }

    /// The two points.
    #[must_use]
    pub fn anchors(&self) -> &Anchors {
        &self.anchors
    }

    // ANCHOR: correct
    /// Closes the gap that has opened since the last step. Says whether there was one.
    ///
    /// It pushes at t₁, t₂ and with K as they were when the step began: what keeps a step from losing
    /// or making energy is that its force acts where the step starts from. A gap that is wide beside
    /// the arms says that the bodies have turned too far for that: then as they are now.
    pub fn correct(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> bool {
        let opened = self.anchors.arms(parent, child).d - self.left;
        let gap = opened.length();
        if gap < SMALL_GAP {
            return false;
        }
        if gap > WIDE * (self.arms.t1.length() + self.arms.t2.length()) {
            parent.weigh();
            child.weigh();
            self.weigh(parent, child);
        }
        let d = self.yielding * -opened;
        parent.displace_by(self.arms.t1, d);
        child.displace_by(self.arms.t2, -d);
        true
    }
    // ANCHOR_END: correct

    /// Works out where the points are and how they yield.
    fn weigh(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.arms = self.anchors.arms(parent, child);
        let Arms { t1, t2, .. } = self.arms;
        self.yielding = pin_matrix(parent.answers(), t1, child.answers(), t2).inverse();
    }

    /// How the two turn about the pin by angular impulses along g.
    #[must_use]
    pub fn lever(&self, parent: &RigidBody, child: &RigidBody, g: Vec3) -> Lever {
        let Arms { t1, t2, .. } = self.arms;
        joint::lever(parent.answers(), t1, child.answers(), t2, self.yielding, g)
    }

    // ANCHOR: printed
    /// The report's correction: along the gap, by one number, and with erratum 6 on the child.
    pub fn correct_printed(&self, parent: &mut RigidBody, child: &mut RigidBody) {
        let Arms { t1, t2, d } = self.anchors.arms(parent, child);
        let (mass_1, mass_2) = (*parent.answers(), *child.answers());
        let d = pin::correction(&mass_1, t1, &mass_2, t2, d);
        parent.displace_printed(d * mass_1.inverse_mass, mass_1.moment(t1.cross(d)));
        child.displace_printed(-d * mass_2.inverse_mass, mass_2.moment(t2).cross(-d));
    }
    // ANCHOR_END: printed

    // ANCHOR: prepare
    /// Works out what stays the same while contacts are resolved.
    pub fn prepare(&mut self, parent: &RigidBody, child: &RigidBody, span: Span) {
        self.weigh(parent, child);
        self.impulse *= span.longer;
        let Arms { t1, t2, .. } = self.arms;
        self.parted = joint::parted(parent.moved(), t1, child.moved(), t2, span.dt);
    }
    // ANCHOR_END: prepare

    // ANCHOR: part
    /// Nudges the two points together; gives how far they were apart, m.
    ///
    /// The gap, the arms and K are those of the nudged poses: a limb that is folded in half turns
    /// further than a first order can tell.
    pub fn part(&self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let Arms { t1, t2, d } = self.anchors.nudged_arms(parent, child);
        let gap = d.length();
        if gap >= SMALL_GAP {
            let k = pin_matrix(parent.answers(), t1, child.answers(), t2);
            let nudge = k.inverse() * -d.clamp_length_max(LONGEST_GAP);
            parent.nudge(t1, nudge);
            child.nudge(t2, -nudge);
        }
        gap
    }
    // ANCHOR_END: part

    // ANCHOR: hold
    /// Begins with what held them in the last step.
    pub fn resume(&self, parent: &mut RigidBody, child: &mut RigidBody) {
        parent.push(self.arms.t1, self.impulse);
        child.push(self.arms.t2, -self.impulse);
    }

    /// Lets the two points move alike. Gives by how much they didn't, m/s.
    pub fn hold(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let v_r =
            impulse::relative_velocity(parent.moving(), self.arms.t1, child.moving(), self.arms.t2);
        let off = v_r + self.parted;
        let change = self.yielding * -off;
        parent.push(self.arms.t1, change);
        child.push(self.arms.t2, -change);
        self.impulse += change;
        off.length()
    }
    // ANCHOR_END: hold

    // ANCHOR: turn
    /// Turns the two about the pin by an angular impulse of this size, N m s, along a lever.
    pub fn turn(
        &mut self,
        lever: &Lever,
        size: f32,
        parent: &mut RigidBody,
        child: &mut RigidBody,
    ) {
        child.twist(size * lever.turn);
        parent.twist(-size * lever.turn);
        let change = size * lever.pin;
        parent.push(self.arms.t1, change);
        child.push(self.arms.t2, -change);
        self.impulse += change;
    }
    // ANCHOR_END: turn

    /// The same with positions: an angular impulse in kg m², of nudges.
    pub fn nudge_turn(
        &self,
        lever: &Lever,
        size: f32,
        parent: &mut RigidBody,
        child: &mut RigidBody,
    ) {
        child.nudge_turn(size * lever.turn);
        parent.nudge_turn(-size * lever.turn);
        parent.nudge(self.arms.t1, size * lever.pin);
        child.nudge(self.arms.t2, -size * lever.pin);
    }

    /// The same at once; velocities follow.
    pub fn displace_turn(
        &self,
        lever: &Lever,
        size: f32,
        parent: &mut RigidBody,
        child: &mut RigidBody,
    ) {
        child.displace_about(self.arms.t2, -size * lever.pin, size * lever.turn);
        parent.displace_about(self.arms.t1, size * lever.pin, -size * lever.turn);
    }

    /// Notes the gap that is left.
    pub fn finish(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.arms = self.anchors.arms(parent, child);
        self.left = self.arms.d;
    }

    /// Forgets the impulse of the last step.
    pub fn forget(&mut self) {
        self.impulse = Vec3::ZERO;
    }
}
