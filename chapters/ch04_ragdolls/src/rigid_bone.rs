//! A bone: a rigid body, and its place in the tree of a ragdoll. Report 9.1.

use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;

// ANCHOR: bone
/// A bone's place in its ragdoll's list of bones.
pub type BoneId = usize;

/// A limb or another part of a body.
pub struct RigidBone {
    /// What moves.
    pub body: Shared<RigidBody>,
    /// The body's index in the scene.
    pub index: usize,
    /// The bone that it hangs on; the root has none.
    pub parent: Option<BoneId>,
    /// The joints, in the ragdoll's list, to the bones that hang on it.
    pub children: Vec<usize>,
}
// ANCHOR_END: bone
