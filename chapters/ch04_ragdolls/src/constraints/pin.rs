//! The pin: a point of the parent and a point of the child that stay together. Report 9.3.

use ch00_maths::f32::joint::pin_matrix;
use ch00_maths::f32::{impulse, pin};
use ch02_rigid_bodies::RigidBody;
use glam::{Mat3, Vec3};

use super::{LONGEST_GAP, SMALL_GAP, WIDE};

// ANCHOR: pin
/// 0 = (p₁ + t₁) − (p₂ + t₂), with t = q ∗ o.
pub struct PinConstraint {
    /// o₁ and o₂, in the bodies' own coordinates, m.
    offset_parent: Vec3,
    offset_child: Vec3,
    /// While contacts are resolved: t₁, t₂, the gap, and K⁻¹.
    t1: Vec3,
    t2: Vec3,
    gap: Vec3,
    yielding: Mat3,
    /// Their relative velocity in the middle of the last step, m/s.
    parted: Vec3,
    /// What the parent received in the last step, N s: where the next begins.
    impulse: Vec3,
    /// The gap that the last step left, m: what it couldn't close must not be pulled shut with speed.
    left: Vec3,
}
// ANCHOR_END: pin

/// How two pinned bodies turn against each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lever {
    /// g: turning impulse on the child; the parent gets its opposite.
    pub turn: Vec3,
    /// Impulse at the pin on the parent that goes with it; the child gets its opposite.
    pub pin: Vec3,
    /// What g·(ω₂ − ω₁) changes by.
    pub response: f32,
}

impl PinConstraint {
    /// Pins a point of one body to a point of another, m, each in its body's coordinates.
    #[must_use]
    pub fn new(offset_parent: Vec3, offset_child: Vec3) -> Self {
        Self {
            offset_parent,
            offset_child,
            t1: Vec3::ZERO,
            t2: Vec3::ZERO,
            gap: Vec3::ZERO,
            yielding: Mat3::ZERO,
            parted: Vec3::ZERO,
            impulse: Vec3::ZERO,
            left: Vec3::ZERO,
        }
    }

    // ANCHOR: locate
    /// t₁, t₂ and d where the bodies are now.
    fn locate(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.t1 = parent.orientation() * self.offset_parent;
        self.t2 = child.orientation() * self.offset_child;
        self.gap = (parent.position() + self.t1) - (child.position() + self.t2);
    }
    // ANCHOR_END: locate

    // ANCHOR: correct
    /// Closes the gap that has opened since the last step. Says whether there was one.
    ///
    /// It pushes at t₁, t₂ and with K as they were when the step began: what keeps a step from losing
    /// or making energy is that its force acts where the step starts from. A gap that is wide beside
    /// the arms says that the bodies have turned too far for that: then as they are now.
    pub fn correct(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> bool {
        let (one, two) = self.points(parent, child);
        let opened = one - two - self.left;
        let gap = opened.length();
        if gap < SMALL_GAP {
            return false;
        }
        if gap > WIDE * (self.t1.length() + self.t2.length()) {
            parent.weigh();
            child.weigh();
            self.weigh(parent, child);
        }
        let d = self.yielding * -opened;
        parent.displace_by(self.t1, d);
        child.displace_by(self.t2, -d);
        true
    }
    // ANCHOR_END: correct

    /// Works out where the points are and how they yield.
    fn weigh(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.locate(parent, child);
        let k = pin_matrix(parent.answers(), self.t1, child.answers(), self.t2);
        self.yielding = k.inverse();
    }

    // ANCHOR: lever
    /// How the two turn about the pin: a unit turning impulse g on the child, and its opposite on the
    /// parent, would also part the points; the lever's impulse at the pin keeps them together.
    #[must_use]
    pub fn lever(&self, parent: &RigidBody, child: &RigidBody, g: Vec3) -> Lever {
        let (turn_1, turn_2) = (parent.answers().moment(g), child.answers().moment(g));
        let parting = -turn_1.cross(self.t1) - turn_2.cross(self.t2);
        let pin = self.yielding * -parting;
        Lever {
            turn: g,
            pin,
            response: g.dot(turn_1 + turn_2) + parting.dot(pin),
        }
    }
    // ANCHOR_END: lever

    // ANCHOR: printed
    /// The report's correction: along the gap, by one number, and with erratum 6 on the child.
    pub fn correct_printed(&mut self, parent: &mut RigidBody, child: &mut RigidBody) {
        self.locate(parent, child);
        let (mass_1, mass_2) = (*parent.answers(), *child.answers());
        let d = pin::correction(&mass_1, self.t1, &mass_2, self.t2, self.gap);
        parent.displace_printed(d * mass_1.inverse_mass, mass_1.moment(self.t1.cross(d)));
        child.displace_printed(-d * mass_2.inverse_mass, mass_2.moment(self.t2).cross(-d));
    }
    // ANCHOR_END: printed

    // ANCHOR: prepare
    /// Works out what stays the same while contacts are resolved.
    ///
    /// On a curved path the points part along the tangent, in the middle of the last step outwards
    /// and in the middle of the next inwards, equally fast: now, halfway between, they don't.
    pub fn prepare(&mut self, parent: &RigidBody, child: &RigidBody, dt: f32, longer: f32) {
        self.weigh(parent, child);
        self.impulse *= longer;
        let (one, two) = (parent.moved(), child.moved());
        let circling = |omega: Vec3, t: Vec3| 0.5 * dt * omega.length_squared() * t.length();
        let most = circling(one.omega, self.t1) + circling(two.omega, self.t2);
        let parted = impulse::relative_velocity(one, self.t1, two, self.t2);
        self.parted = parted.clamp_length_max(most);
    }
    // ANCHOR_END: prepare

    // ANCHOR: part
    /// Nudges the two points together; gives how far they were apart, m.
    ///
    /// The gap, the arms and K are those of the nudged poses: a limb that is folded in half turns
    /// further than a first order can tell.
    pub fn part(&self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let ((p1, q1), (p2, q2)) = (parent.nudged_pose(), child.nudged_pose());
        let (t1, t2) = (q1 * self.offset_parent, q2 * self.offset_child);
        let left = (p1 + t1) - (p2 + t2);
        let gap = left.length();
        if gap >= SMALL_GAP {
            let k = pin_matrix(parent.answers(), t1, child.answers(), t2);
            let nudge = k.inverse() * -left.clamp_length_max(LONGEST_GAP);
            parent.nudge(t1, nudge);
            child.nudge(t2, -nudge);
        }
        gap
    }
    // ANCHOR_END: part

    // ANCHOR: hold
    /// Begins with what held them in the last step.
    pub fn resume(&self, parent: &mut RigidBody, child: &mut RigidBody) {
        parent.push(self.t1, self.impulse);
        child.push(self.t2, -self.impulse);
    }

    /// Lets the two points move alike. Gives by how much they didn't, m/s.
    pub fn hold(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let v_r = impulse::relative_velocity(parent.moving(), self.t1, child.moving(), self.t2);
        let off = v_r + self.parted;
        let change = self.yielding * -off;
        parent.push(self.t1, change);
        child.push(self.t2, -change);
        self.impulse += change;
        off.length()
    }
    // ANCHOR_END: hold

    // ANCHOR: turn
    /// Turns the two about the pin by a turning impulse of this size, N m s, along a lever.
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
        parent.push(self.t1, change);
        child.push(self.t2, -change);
        self.impulse += change;
    }
    // ANCHOR_END: turn

    /// The same with positions: a turning impulse in kg m², of nudges.
    pub fn nudge_turn(
        &self,
        lever: &Lever,
        size: f32,
        parent: &mut RigidBody,
        child: &mut RigidBody,
    ) {
        child.nudge_turn(size * lever.turn);
        parent.nudge_turn(-size * lever.turn);
        parent.nudge(self.t1, size * lever.pin);
        child.nudge(self.t2, -size * lever.pin);
    }

    /// The same at once; velocities follow.
    pub fn displace_turn(
        &self,
        lever: &Lever,
        size: f32,
        parent: &mut RigidBody,
        child: &mut RigidBody,
    ) {
        child.displace_about(self.t2, -size * lever.pin, size * lever.turn);
        parent.displace_about(self.t1, size * lever.pin, -size * lever.turn);
    }

    /// Notes the gap that is left.
    pub fn finish(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.locate(parent, child);
        self.left = self.gap;
    }

    /// Forgets the impulse of the last step.
    pub fn forget(&mut self) {
        self.impulse = Vec3::ZERO;
    }

    /// The two points in the world, m.
    #[must_use]
    pub fn points(&self, parent: &RigidBody, child: &RigidBody) -> (Vec3, Vec3) {
        (
            parent.position() + parent.orientation() * self.offset_parent,
            child.position() + child.orientation() * self.offset_child,
        )
    }
}
