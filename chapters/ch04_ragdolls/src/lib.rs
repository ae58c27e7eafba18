//! Chapter 4: ragdolls. Bones that joints hold together: at a point (the pin), at a distance, and
//! within the angles that a body's own joints allow.
//!
//! A step is chapter 3's with one part more: after the bodies have moved and before collisions are
//! found, every joint puts its two bodies back where they belong.

mod constraints;
mod engine;
pub mod layers;
mod load;
mod ragdoll;
mod rigid_bone;
mod rigid_joint;

pub use constraints::{
    Anchors, AngleConstraint, AngleLimits, Arms, Bound, DistanceConstraint, LARGEST_TURN,
    LONGEST_GAP, MOST_ROWS, PinConstraint, Row, SMALL_ANGLE, SMALL_GAP, WIDE,
};
pub use engine::{ENGINE, RagdollEngine};
pub use load::{Assembly, Forest};
pub use ragdoll::Ragdoll;
pub use rigid_bone::{BoneId, RigidBone};
pub use rigid_joint::{JointSpec, RigidJoint};
