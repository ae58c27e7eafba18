//! From a scene's list of joints to ragdolls: which joints make trees, and what is left.

use std::collections::BTreeMap;

use ch00_scenes::{Joint, Scene};
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use ch03_collision::{Links, Span};
use glam::{DQuat, DVec3};

use crate::ragdoll::sweep;
use crate::{Anchors, AngleLimits, JointSpec, Ragdoll, RigidBone, RigidJoint};

// ANCHOR: assembly
/// All joints of a scene.
#[derive(Default)]
pub struct Assembly {
    /// The trees: ragdolls, chains, whatever hangs on something in one way only.
    pub ragdolls: Vec<Ragdoll>,
    /// Joints that close a loop, such as the second pin of a door, in the scene's order.
    pub loops: Vec<RigidJoint>,
}
// ANCHOR_END: assembly

impl Assembly {
    /// Makes the joints of a scene. Two static bodies need none.
    #[must_use]
    pub fn of(scene: &Scene, bodies: &[Shared<RigidBody>]) -> Self {
        let forest = Forest::of(scene);
        let make = |j: usize| make_joint(&scene.joints[j], bodies);
        Self {
            ragdolls: forest
                .trees
                .iter()
                .map(|joints| grow(joints, scene, bodies, &make))
                .collect(),
            loops: forest.loops.iter().map(|&j| make(j)).collect(),
        }
    }

    // ANCHOR: update
    /// Puts all bodies back where their joints want them.
    pub fn constraint_update(&mut self, sweeps: u32) {
        for ragdoll in &mut self.ragdolls {
            ragdoll.constraint_update(sweeps);
        }
        if !self.loops.is_empty() {
            self.close_loops(sweeps);
        }
    }
    // ANCHOR_END: update

    /// A loop needs all of its joints in the same sweep.
    fn close_loops(&mut self, sweeps: u32) {
        sweep(sweeps, || {
            self.joints_mut()
                .fold(false, |moved, joint| moved | joint.correct())
        });
    }

    /// The same as printed.
    pub fn constraint_update_printed(&mut self) {
        for ragdoll in &mut self.ragdolls {
            ragdoll.constraint_update_printed();
        }
        for joint in &mut self.loops {
            joint.correct_printed();
        }
    }

    /// Forgets what the last step left, since the bodies have been put elsewhere.
    pub fn forget(&mut self) {
        self.joints_mut().for_each(RigidJoint::forget);
    }

    /// All joints: those of the trees, then those that close loops.
    pub fn joints(&self) -> impl Iterator<Item = &RigidJoint> {
        let trees = self.ragdolls.iter().flat_map(Ragdoll::joints);
        trees.chain(&self.loops)
    }

    /// The same, to be changed.
    pub fn joints_mut(&mut self) -> impl Iterator<Item = &mut RigidJoint> {
        let trees = self.ragdolls.iter_mut().flat_map(Ragdoll::joints_mut);
        trees.chain(&mut self.loops)
    }
}

// ANCHOR: links
impl Links for Assembly {
    fn each_body(&self, mut visit: impl FnMut(usize)) {
        for joint in self.joints() {
            visit(joint.indices().0);
            visit(joint.indices().1);
        }
    }

    fn prepare(&mut self, span: Span) {
        self.joints_mut().for_each(|joint| joint.prepare(span));
    }

    fn part(&mut self) -> f32 {
        self.joints_mut().map(RigidJoint::part).fold(0.0, f32::max)
    }

    fn resume(&mut self) {
        self.joints_mut().for_each(RigidJoint::resume);
    }

    fn hold(&mut self, still: f32) -> bool {
        self.joints_mut()
            .fold(false, |changed, joint| changed | joint.hold(still))
    }

    fn finish(&mut self) {
        self.joints_mut().for_each(RigidJoint::finish);
    }
}
// ANCHOR_END: links

// ANCHOR: forest
/// Which joints of a scene make trees, by their indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Forest {
    /// The joints of each tree, branch by branch, every parent before its children.
    pub trees: Vec<Vec<usize>>,
    /// Joints that close loops, in the scene's order. Between two static bodies none is needed.
    pub loops: Vec<usize>,
}

impl Forest {
    /// Of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let parent_joint = tree_joints(scene);
        let children = children_of(scene, &parent_joint);
        let roots = (0..scene.bodies.len()).filter(|&i| parent_joint[i].is_none());
        let trees = roots.map(|root| walk(root, &children, scene));
        let is_loop = |j: &usize| {
            let (a, b) = scene.joints[*j].bodies();
            let both_static = scene.bodies[a].is_static() && scene.bodies[b].is_static();
            parent_joint[b] != Some(*j) && !both_static
        };
        Self {
            trees: trees.filter(|joints| !joints.is_empty()).collect(),
            loops: (0..scene.joints.len()).filter(is_loop).collect(),
        }
    }
}
// ANCHOR_END: forest

/// The joints below a root, branch by branch.
fn walk(root: usize, children: &[Vec<usize>], scene: &Scene) -> Vec<usize> {
    let mut joints = Vec::new();
    let mut open: Vec<usize> = children[root].iter().rev().copied().collect();
    while let Some(j) = open.pop() {
        joints.push(j);
        let child = scene.joints[j].bodies().1;
        open.extend(children[child].iter().rev());
    }
    joints
}

// ANCHOR: tree
/// The joint by which each body hangs on its parent, if it hangs on something in one way only and
/// doesn't, after however many parents, hang on itself.
fn tree_joints(scene: &Scene) -> Vec<Option<usize>> {
    let mut joints = vec![None; scene.bodies.len()];
    let mut hung = vec![0; scene.bodies.len()];
    for (j, joint) in scene.joints.iter().enumerate() {
        let child = joint.bodies().1;
        joints[child] = Some(j);
        hung[child] += 1;
    }
    for (i, joint) in joints.iter_mut().enumerate() {
        if hung[i] != 1 || scene.bodies[i].is_static() {
            *joint = None;
        }
    }
    for start in 0..joints.len() {
        let parent = |i: usize| joints[i].map(|j: usize| scene.joints[j].bodies().0);
        let mut above = parent(start);
        let mut walked = 0;
        while let Some(i) = above.filter(|&i| i != start && walked <= joints.len()) {
            walked += 1;
            above = parent(i);
        }
        if above == Some(start) {
            joints[start] = None;
        }
    }
    joints
}
// ANCHOR_END: tree

/// The tree joints below each body, in the scene's order.
fn children_of(scene: &Scene, parent_joint: &[Option<usize>]) -> Vec<Vec<usize>> {
    let mut children = vec![Vec::new(); scene.bodies.len()];
    for (j, joint) in scene.joints.iter().enumerate() {
        let (a, b) = joint.bodies();
        if parent_joint[b] == Some(j) {
            children[a].push(j);
        }
    }
    children
}

/// Grows a tree of joints, every parent before its children.
fn grow(
    joints: &[usize],
    scene: &Scene,
    bodies: &[Shared<RigidBody>],
    make: &impl Fn(usize) -> RigidJoint,
) -> Ragdoll {
    let root = scene.joints[joints[0]].bodies().0;
    let mut ragdoll = Ragdoll::new(RigidBone {
        body: bodies[root].clone(),
        index: root,
        parent: None,
        children: Vec::new(),
    });
    let mut bone_of = BTreeMap::from([(root, 0)]);
    for &j in joints {
        let (parent, child) = scene.joints[j].bodies();
        let bone = ragdoll.grow(bone_of[&parent], make(j));
        bone_of.insert(child, bone);
    }
    ragdoll
}

/// A joint of the scene in the engine's precision.
fn make_joint(joint: &Joint, bodies: &[Shared<RigidBody>]) -> RigidJoint {
    let (a, b) = joint.bodies();
    let of = |i: usize| (i, bodies[i].clone());
    RigidJoint::new(of(a), of(b), JointSpec::of(joint))
}

impl JointSpec {
    /// A joint of a scene.
    #[must_use]
    pub fn of(joint: &Joint) -> Self {
        let (anchor_a, anchor_b) = joint.anchors();
        let pinned = JointSpec {
            anchors: Anchors {
                parent: anchor_a.as_vec3(),
                child: anchor_b.as_vec3(),
            },
            distance: None,
            limits: None,
            rest: None,
        };
        match *joint {
            Joint::Ball {
                cone,
                twist,
                limits,
                rest,
                ..
            } => JointSpec {
                limits: match limits {
                    Some(limits) => Some(AngleLimits::PitchYawRoll {
                        pitch: single(limits.pitch),
                        yaw: single(limits.yaw),
                        roll: single(limits.roll),
                    }),
                    None if cone.is_none() && twist.is_none() => None,
                    None => Some(AngleLimits::ConeTwist {
                        cone: cone.map(|cone| cone as f32),
                        twist: twist.map(single),
                    }),
                },
                rest: rest.map(|q: DQuat| q.as_quat()),
                ..pinned
            },
            Joint::Distance { length, .. } => JointSpec {
                distance: Some(length as f32),
                ..pinned
            },
            Joint::Hinge {
                axis_a,
                axis_b,
                range,
                ..
            } => JointSpec {
                limits: Some(AngleLimits::Hinge {
                    axis_parent: unit(axis_a),
                    axis_child: unit(axis_b),
                    range: range.map(single),
                }),
                ..pinned
            },
        }
    }
}

fn single([low, high]: [f64; 2]) -> [f32; 2] {
    [low as f32, high as f32]
}

fn unit(axis: DVec3) -> glam::Vec3 {
    axis.normalize().as_vec3()
}
