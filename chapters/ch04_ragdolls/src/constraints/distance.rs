//! The distance constraint: a rod without mass between a point of the parent and one of the child.
//! Report 9.2.

use ch00_maths::f32::impulse::{relative_velocity, response};
use ch00_maths::f32::joint::distance_correction;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use super::{LONGEST_GAP, SMALL_GAP, WIDE};

// ANCHOR: distance
/// 0 = |d| − l.
pub struct DistanceConstraint {
    offset_parent: Vec3,
    offset_child: Vec3,
    /// l, m.
    length: f32,
    /// While contacts are resolved: t₁, t₂, the unit vector of d, and the response along d.
    t1: Vec3,
    t2: Vec3,
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
    /// Ties a point of one body to a point of another, m, each in its body's coordinates.
    #[must_use]
    pub fn new(offset_parent: Vec3, offset_child: Vec3, length: f32) -> Self {
        Self {
            offset_parent,
            offset_child,
            length,
            t1: Vec3::ZERO,
            t2: Vec3::ZERO,
            along: Vec3::ZERO,
            response: 0.0,
            parted: 0.0,
            impulse: 0.0,
            left: 0.0,
        }
    }

    /// t₁ and t₂ where the bodies are now; gives d.
    fn locate(&mut self, parent: &RigidBody, child: &RigidBody) -> Vec3 {
        self.t1 = parent.orientation() * self.offset_parent;
        self.t2 = child.orientation() * self.offset_child;
        (parent.position() + self.t1) - (child.position() + self.t2)
    }

    // ANCHOR: correct
    /// Brings the points back to their distance, along the rod as it lay when the step began, or, if
    /// it has swung too far for that, as it lies. Says whether they were off.
    pub fn correct(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> bool {
        let (one, two) = self.points(parent, child);
        let off = one.distance(two) - self.length - self.left;
        if off.abs() < SMALL_GAP {
            return false;
        }
        if off.abs() > WIDE * self.length {
            parent.weigh();
            child.weigh();
            self.weigh(parent, child);
        }
        let nudge = self.along * (-off / self.response);
        parent.displace_by(self.t1, nudge);
        child.displace_by(self.t2, -nudge);
        true
    }
    // ANCHOR_END: correct

    /// The report's distribution of the difference by mass, for points of rigid bodies.
    pub fn correct_printed(&mut self, parent: &mut RigidBody, child: &mut RigidBody) {
        let d = self.locate(parent, child);
        let (mass_1, mass_2) = (*parent.answers(), *child.answers());
        let nudge = distance_correction(&mass_1, self.t1, &mass_2, self.t2, d, self.length);
        parent.displace_by(self.t1, nudge);
        child.displace_by(self.t2, -nudge);
    }

    /// Works out how the rod lies and how its ends yield.
    fn weigh(&mut self, parent: &RigidBody, child: &RigidBody) {
        let d = self.locate(parent, child);
        self.along = d.normalize_or(Vec3::Y);
        let (mass_1, mass_2) = (parent.answers(), child.answers());
        self.response = response(mass_1, self.t1, mass_2, self.t2, self.along);
    }

    /// Works out what stays the same while contacts are resolved.
    pub fn prepare(&mut self, parent: &RigidBody, child: &RigidBody, longer: f32) {
        self.weigh(parent, child);
        self.impulse *= longer;
        let v_r = relative_velocity(parent.moved(), self.t1, child.moved(), self.t2);
        self.parted = v_r.dot(self.along);
    }

    /// Nudges the points to their distance, from where their nudges have brought them; gives how far
    /// they were off, m.
    pub fn part(&self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let ((p1, q1), (p2, q2)) = (parent.nudged_pose(), child.nudged_pose());
        let (t1, t2) = (q1 * self.offset_parent, q2 * self.offset_child);
        let d = (p1 + t1) - (p2 + t2);
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
        parent.push(self.t1, self.impulse * self.along);
        child.push(self.t2, -self.impulse * self.along);
    }

    /// Keeps the rod as long as it is. Gives how fast it was changing, m/s.
    pub fn hold(&mut self, parent: &mut RigidBody, child: &mut RigidBody) -> f32 {
        let v_r = relative_velocity(parent.moving(), self.t1, child.moving(), self.t2);
        let off = v_r.dot(self.along) + self.parted;
        let change = -off / self.response;
        parent.push(self.t1, change * self.along);
        child.push(self.t2, -change * self.along);
        self.impulse += change;
        off.abs()
    }
    // ANCHOR_END: hold

    /// Notes the stretch that is left.
    pub fn finish(&mut self, parent: &RigidBody, child: &RigidBody) {
        self.left = self.locate(parent, child).length() - self.length;
    }

    /// Forgets the impulse of the last step.
    pub fn forget(&mut self) {
        self.impulse = 0.0;
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
