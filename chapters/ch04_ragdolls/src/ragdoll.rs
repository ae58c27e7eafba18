//! A ragdoll: bones in a tree, the hips at its root. Report 9.1.

use crate::{BoneId, RigidBone, RigidJoint};

// ANCHOR: ragdoll
/// A tree of bones and joints.
///
/// Where the report has pointers, this has places in two lists. The joints stand in the order of
/// a walk from the root outwards, every parent before its children.
pub struct Ragdoll {
    bones: Vec<RigidBone>,
    joints: Vec<RigidJoint>,
}
// ANCHOR_END: ragdoll

impl Ragdoll {
    /// A ragdoll of one bone.
    #[must_use]
    pub fn new(root: RigidBone) -> Self {
        Self {
            bones: vec![root],
            joints: Vec::new(),
        }
    }

    // ANCHOR: grow
    /// Hangs a child on a bone; gives the child's place.
    ///
    /// # Panics
    /// If there is no such bone.
    pub fn grow(&mut self, parent: BoneId, joint: RigidJoint) -> BoneId {
        let child = self.bones.len();
        self.bones[parent].children.push(self.joints.len());
        self.bones.push(RigidBone {
            body: joint.bodies().1.clone(),
            index: joint.indices().1,
            parent: Some(parent),
            children: Vec::new(),
        });
        self.joints.push(joint);
        child
    }
    // ANCHOR_END: grow

    /// Its bones, the root first.
    #[must_use]
    pub fn bones(&self) -> &[RigidBone] {
        &self.bones
    }

    /// Its joints, from the root outwards.
    #[must_use]
    pub fn joints(&self) -> &[RigidJoint] {
        &self.joints
    }

    /// The same, to be changed.
    pub fn joints_mut(&mut self) -> &mut [RigidJoint] {
        &mut self.joints
    }

    // ANCHOR: update
    /// The report's `constraintUpdate`, swept at most `sweeps` times.
    pub fn constraint_update(&mut self, sweeps: u32) {
        sweep(sweeps, || {
            let correct = |moved: bool, joint: &mut RigidJoint| moved | joint.correct();
            self.joints.iter_mut().fold(false, correct)
        });
    }

    /// The same as printed: one walk through the tree.
    pub fn constraint_update_printed(&mut self) {
        for joint in &mut self.joints {
            joint.correct_printed();
        }
    }
    // ANCHOR_END: update
}

// ANCHOR: sweep
/// Goes through joints again and again, at most `sweeps` times, until none was off.
pub(crate) fn sweep(sweeps: u32, mut once: impl FnMut() -> bool) {
    for _ in 0..sweeps {
        if !once() {
            break;
        }
    }
}
// ANCHOR_END: sweep
