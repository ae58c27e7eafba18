//! All joints of a tree of bodies, solved at once: a ragdoll, a chain, a door.
//!
//! Contacts have left the bodies with velocities and pushes that part the joints. The impulses λ that
//! mend all joints together solve J M⁻¹ Jᵀ λ = e, where e is what their speeds have to change by: so
//! much that no joint parts and all gaps close. Along a tree that takes two walks and no iteration: from
//! the leaves to the root, where each body is folded into its parent ([`fold`]), and back ([`unfold`]).
//! The two right-hand sides, velocities and pushes, share the walks.
//!
//! Contacts must know beforehand what hangs on what, so a substep starts with the joints' impulses of
//! the last one. The tree takes these back first and gives its own instead.

mod articulated;
mod build;
mod error;
mod fold;
mod graph;
mod link;
mod merge;
mod symmetric;
#[cfg(test)]
mod tests;

use std::ops::Range;

use ch00_maths::f32::rotation;
use glam::Vec3;

pub use articulated::{Articulated, Rate, Wrench, transposed_times, world_moments};
pub use build::{Ends, Trees, WORKGROUP};
pub use error::TreeError;
pub use fold::{Carried, Kept, fold, unfold};
pub use link::{Bone, FASTEST_ALIGNING, FASTEST_CLOSING, Link, link_of};
pub use symmetric::Symmetric;

use crate::bodies::Bodies;
use crate::rows::{FREE, Held, NONE, Node, TWO_RODS};

/// How much of the stiffness that a pull gives a joint stands in the inertia. A quarter is enough by
/// theory, where turns are small; see [`stiffened`].
pub const PULL_SHARE: f32 = 0.5;

/// What a walk knows of a node.
#[derive(Clone, Copy, Debug, Default)]
pub struct Walked {
    bone: Bone,
    link: Link,
    kept: Kept,
    /// What the parent feels of it.
    felt: Carried,
    /// What becomes of its motion.
    change: [Rate; 2],
}

// ANCHOR: solve_tree
/// Mends the velocities and the pushes of all bodies of a tree, whose nodes these are, so that no joint
/// parts; and says in `joined` with what its joints hold each body.
///
/// `joined` must be what the substep began with: that much the bodies have received already.
pub fn solve_tree(
    nodes: &mut [Node],
    tree: Range<usize>,
    bodies: &mut Bodies,
    joined: &mut [Held],
    walked: &mut Vec<Walked>,
    h: f32,
) {
    let first = tree.start;
    walked.clear();
    for node in &nodes[tree.clone()] {
        take_back(node.body as usize, bodies, joined);
        let bone = bone_of(bodies, node.body);
        walked.push(Walked {
            bone,
            ..Walked::default()
        });
    }
    for i in tree.clone().rev() {
        let node = &nodes[i];
        let bone = walked[i - first].bone;
        let link = meet(node, &bone, bodies, h);
        let mut body = stands(node, &bone, &link, h);
        for child in children(node) {
            body = body.plus(walked[child - first].felt);
        }
        let (kept, felt) = fold(node.kind, &link, &bone, &body);
        let felt = pulled(node, &link, felt, h);
        walked[i - first] = Walked {
            bone,
            link,
            kept,
            felt,
            ..Walked::default()
        };
    }
    for i in tree {
        let node = &mut nodes[i];
        let here = walked[i - first];
        let parent = match node.parent {
            NONE => [Rate::default(); 2],
            parent => walked[parent as usize - first].change,
        };
        let (change, given) = unfold(node.kind, &here.link, &here.kept, &here.felt, parent);
        walked[i - first].change = change;
        node.impulse = given;
        move_body(node.body as usize, &here.bone, change, bodies, joined);
    }
}
// ANCHOR_END: solve_tree

/// The nodes that hang on a node.
fn children(node: &Node) -> Range<usize> {
    let first = node.first_child as usize;
    if node.children == 0 {
        0..0
    } else {
        first..first + node.children as usize
    }
}

/// Takes back from a body what its joints gave it at the start of the substep.
fn take_back(row: usize, bodies: &mut Bodies, joined: &[Held]) {
    let turned = bodies.turned_by(row, joined[row].angular);
    bodies.motion[row].velocity -= joined[row].linear * bodies.spin[row].inverse_mass;
    bodies.spin[row].angular_velocity -= turned;
    bodies.momentum[row] -= joined[row].angular;
}

/// A node's joint where it is now.
fn meet(node: &Node, bone: &Bone, bodies: &Bodies, h: f32) -> Link {
    if node.kind == FREE {
        return Link::default();
    }
    let parent = bone_of(bodies, node.parent_body);
    let second = if node.kind == TWO_RODS {
        bone_of(bodies, node.second_parent)
    } else {
        Bone::default()
    };
    link_of(node, bone, &parent, &second, h)
}

/// A body, as its joints see it.
fn bone_of(bodies: &Bodies, row: u32) -> Bone {
    let row = row as usize;
    Bone {
        position: bodies.place[row].position,
        attitude: bodies.attitude[row],
        rate: Rate {
            velocity: bodies.motion[row].velocity,
            spin: bodies.spin[row].angular_velocity,
        },
        push: Rate {
            velocity: bodies.push[row].velocity,
            spin: bodies.push[row].angular_velocity,
        },
        inverse_mass: bodies.spin[row].inverse_mass,
        inverse_inertia: bodies.solid[row].inverse_inertia,
    }
}

/// A body before anything is folded into it.
#[must_use]
pub fn stands(node: &Node, bone: &Bone, link: &Link, h: f32) -> Carried {
    let alone = Articulated::of_body(bone.inverse_mass, bone.inverse_inertia, bone.attitude);
    Carried {
        articulated: stiffened(alone, link.arm, node.impulse, h),
        ..Carried::default()
    }
}

/// What the parent feels, with the stiffness that the pull of the joint gives the parent.
#[must_use]
pub fn pulled(node: &Node, link: &Link, felt: Carried, h: f32) -> Carried {
    Carried {
        articulated: stiffened(felt.articulated, link.parent_arm, -node.impulse, h),
        ..felt
    }
}

// ANCHOR: stiffened
/// The inertia of a body that is pulled at an arm's end, as it was in the last substep.
///
/// A pull along the arm holds the body as gravity holds a pendulum: if it turns by θ across the arm, the
/// pull turns it back with −K θ, K = r·λ/h. A taut chain of light links is full of such pendulums, of up
/// to √(12 F/(m l)) rad/s, and a substep that only looks at where they are blows them up when h²K/I
/// passes 4. With ¼ h²K more of inertia it never does: that is the trapezoidal rule. It changes nothing
/// but how fast the fastest of them swing. [Tournier, Nesme, Gilles and Faure 2015]
#[must_use]
pub fn stiffened(body: Articulated, arm: Vec3, impulse: Vec3, h: f32) -> Articulated {
    let pull = (PULL_SHARE * h) * arm.dot(impulse).max(0.0);
    let along = Symmetric::outer(arm).scaled(-pull / arm.length_squared().max(SMALL));
    Articulated {
        inertia: body.inertia.plus(Symmetric::splat(pull)).plus(along),
        ..body
    }
}
// ANCHOR_END: stiffened

/// Below this the square of an arm is none.
const SMALL: f32 = 1e-12;

/// Changes a body's velocities and pushes, and says with what its joints hold it: with what changed its
/// velocities.
fn move_body(row: usize, bone: &Bone, change: [Rate; 2], bodies: &mut Bodies, joined: &mut [Held]) {
    let [moved, pushed] = change;
    bodies.motion[row].velocity += moved.velocity;
    bodies.spin[row].angular_velocity += moved.spin;
    bodies.push[row].velocity += pushed.velocity;
    bodies.push[row].angular_velocity += pushed.spin;
    joined[row].linear = moved.velocity / bone.inverse_mass;
    joined[row].angular = rotation::moment(bone.attitude, bone.inverse_inertia.recip(), moved.spin);
    bodies.momentum[row] += joined[row].angular;
}
