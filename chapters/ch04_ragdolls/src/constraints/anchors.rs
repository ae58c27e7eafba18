//! Where a joint takes hold of its two bodies.

use ch02_rigid_bodies::RigidBody;
use glam::{Quat, Vec3};

/// o₁ and o₂: a point of the parent and one of the child, each in its body's own coordinates, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchors {
    /// o₁.
    pub parent: Vec3,
    /// o₂.
    pub child: Vec3,
}

// ANCHOR: anchors
/// The arms to the two points, and the gap between these, world, m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arms {
    /// t₁ = q₁ ∗ o₁, from the parent's centre.
    pub t1: Vec3,
    /// t₂ = q₂ ∗ o₂, from the child's centre.
    pub t2: Vec3,
    /// d = (p₁ + t₁) − (p₂ + t₂).
    pub d: Vec3,
}

impl Anchors {
    /// Where the bodies are now.
    #[must_use]
    pub fn arms(&self, parent: &RigidBody, child: &RigidBody) -> Arms {
        self.arms_at(
            (parent.position(), parent.orientation()),
            (child.position(), child.orientation()),
        )
    }

    /// Where their nudges have brought the bodies.
    #[must_use]
    pub fn nudged_arms(&self, parent: &RigidBody, child: &RigidBody) -> Arms {
        self.arms_at(parent.nudged_pose(), child.nudged_pose())
    }

    /// At two poses.
    #[must_use]
    pub fn arms_at(&self, (p1, q1): (Vec3, Quat), (p2, q2): (Vec3, Quat)) -> Arms {
        let (t1, t2) = (q1 * self.parent, q2 * self.child);
        let d = (p1 + t1) - (p2 + t2);
        Arms { t1, t2, d }
    }
    // ANCHOR_END: anchors

    /// The two points in the world, m.
    #[must_use]
    pub fn points(&self, parent: &RigidBody, child: &RigidBody) -> (Vec3, Vec3) {
        let arms = self.arms(parent, child);
        (parent.position() + arms.t1, child.position() + arms.t2)
    }
}
