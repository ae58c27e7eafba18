//! The distance constraint: a rod without mass between a point of the parent and one of the child.
//! Report 9.2.

use ch00_maths::f32::impulse::{relative_velocity, response};
use ch00_maths::f32::joint::distance_correction;
use ch02_rigid_bodies::RigidBody;
use ch03_collision::Span;
use glam::Vec3;

use super::anchors::{Anchors, Arms};
use super::{LONGEST_GAP, SMALL_GAP, WIDE};

// ANCHOR: distance
/// 0 = |d| − l.
pub struct DistanceConstraint {
    /// o₁ and o₂.
    anchors: Anchors,
    /// l, m.
    length: f32,
    /// t₁, t₂, the unit vector of d and the response along it as they were when the step began.
    arms: Arms,
    along: Vec3,
    response: f32,
    /// The stretch's rate in the middle of the last step, m/s.
    parted: f32,
    /// What the parent received along d in the last step, N s.
    impulse: f32,
    /// The stretch that the last step left, m.
    left: f32,
}
// ANCHOR_END: distance

impl DistanceConstraint {
    /// Ties a point of one body to a point of another.
    #[must_use]
    pub fn new(anchors: Anchors, length: f32) -> Self {
        Self {
            anchors,
            length,
            arms: Arms::default(),
            along: Vec3::ZERO,
            response: 0.0,
            parted: 0.0,
            impulse: 0.0,
            left: 0.0,
        }
    }

    /// The two points.
    #[must_use]
    pub fn anchors(&self) -> &Anchors {
        &self.anchors
    }

    // ANCHOR: correct
    /// Brings the points back to their distance, along the rod as it lay when the step began, or, if
    /// it has swung too far for that, as it lies. Says whether they were off.
    pub fn correct(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> bool {
        let off = self.anchors.arms(parent, child).d.length() - self.length - self.left;
        if off.abs() < SMALL_GAP {
            return false;
        }
        if off.abs() > WIDE * self.length {
            parent.weigh();
            child.weigh();
            self.weigh(parent, child);
        }
        let nudge = self.along * (-off / self.response);
        parent.displace_by(self.arms.t1, nudge);
        child.displace_by(self.arms.t2, -nudge);
        true
    }
    // ANCHOR_END: correct

    /// The report's distribution of the difference by mass, for points of rigid bodies.
    pub fn correct_printed(&self, parent: &mut RigidBody, child: &mut RigidBody) {
        let Arms { t1, t2, d } = self.anchors.arms(parent, child);
        let (mass_1, mass_2) = (*parent.answers(), *child.answers());
        let nudge = distance_correction(&mass_1, t1, &mass_2, t2, d, self.length);
        parent.displace_by(t1, nudge);
        child.displace_by(t2, -nudge);
    }

    /// Works out how the rod lies and how its ends yield.
    fn weigh(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.arms = self.anchors.arms(parent, child);
        let Arms { t1, t2, d } = self.arms;
        self.along = d.normalize_or(Vec3::Y);
        self.response = response(parent.answers(), t1, child.answers(), t2, self.along);
    }

    /// Works out what stays the same while contacts are resolved.
    pub fn prepare(&mut self, parent: &RigidBody, child: &RigidBody, span: Span) {
        self.weigh(parent, child);
        self.impulse *= span.longer;
        let v_r = relative_velocity(parent.moved(), self.arms.t1, child.moved(), self.arms.t2);
        self.parted = v_r.dot(self.along);
    }

    /// Nudges the points to their distance, from where their nudges have brought them; gives how far
    /// they were off, m.
    pub fn part(&self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let Arms { t1, t2, d } = self.anchors.nudged_arms(parent, child);
        let left = d.length() - self.length;
        if left.abs() >= SMALL_GAP {
            let along = d.normalize_or(self.along);
            let response = response(parent.answers(), t1, child.answers(), t2, along);
            let nudge = along * (-left.clamp(-LONGEST_GAP, LONGEST_GAP) / response);
            parent.nudge(t1, nudge);
            child.nudge(t2, -nudge);
        }
        left.abs()
    }

    // ANCHOR: hold
    /// Begins with what held them in the last step.
    pub fn resume(&self, parent: &mut RigidBody, child: &mut RigidBody) {
        parent.push(self.arms.t1, self.impulse * self.along);
        child.push(self.arms.t2, -self.impulse * self.along);
    }

    /// Keeps the rod as long as it is. Gives how fast it was changing, m/s.
    pub fn hold(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let v_r = relative_velocity(parent.moving(), self.arms.t1, child.moving(), self.arms.t2);
        let off = v_r.dot(self.along) + self.parted;
        let change = -off / self.response;
        parent.push(self.arms.t1, change * self.along);
        child.push(self.arms.t2, -change * self.along);
        self.impulse += change;
        off.abs()
    }
    // ANCHOR_END: hold

    /// Notes the stretch that is left.
    pub fn finish(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.arms = self.anchors.arms(parent, child);
        self.left = self.arms.d.length() - self.length;
    }

    /// Forgets the impulse of the last step.
    pub fn forget(&mut self) {
        self.impulse = 0.0;
    }
}
