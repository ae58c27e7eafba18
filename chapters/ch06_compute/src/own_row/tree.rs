//! All joints of a tree of bodies, solved at once: a ragdoll, a chain, a door.
//!
//! Contacts have left the bodies with velocities and pushes that part the joints. The impulses λ that
//! mend all joints together solve J M⁻¹ Jᵀ λ = e, where e is what their speeds have to change by: so
//! much that no joint parts and all gaps close. Along a tree that takes two walks and no iteration: from
//! the leaves to the root, where each body is folded into its parent ([`fold`]), and back ([`unfold`]).
//! The two right-hand sides, velocities and pushes, share the walks.
//!
//! Trees of one shape, all ragdolls of a scene, are walked together, a tree a lane ([`batch`]).
//!
//! Contacts must know beforehand what hangs on what, so a substep starts with the joints' impulses of
//! the last one. The tree takes these back first and gives its own instead.

mod articulated;
pub mod batch;
mod build;
mod error;
mod fold;
mod graph;
mod heft;
mod link;
mod merge;
#[cfg(test)]
mod tests;

use std::ops::Range;

pub use articulated::{Articulated, Rate, Wrench};
pub use batch::{Batch, Batches, Limb, Solved};
pub use build::{Ends, Trees, WORKGROUP};
pub use error::TreeError;
pub use fold::{Carried, Kept, fold, unfold};
pub use heft::Heft;
pub use link::{Bone, FASTEST_ALIGNING, FASTEST_CLOSING, Fitting, Link, link_of};

use crate::bodies::Bodies;
use crate::rows::{FREE, Held, Node, TWO_RODS};
use crate::simd::{Quat, Real, Symmetric, Vec3, gather};

/// How much of the stiffness that a pull gives a joint stands in the inertia. A quarter is enough by
/// theory, where turns are small; see [`stiffened`].
pub const PULL_SHARE: f32 = 0.5;

/// What a walk knows of a node.
#[derive(Clone, Copy, Debug, Default)]
pub struct Walked<R> {
    bone: Bone<R>,
    link: Link<R>,
    kept: Kept<R>,
    /// What the parent feels of it.
    felt: Carried<R>,
    /// What becomes of its motion.
    change: [Rate<R>; 2],
}

// ANCHOR: solve_tree
/// Mends the velocities and the pushes of all bodies of a tree, so that no joint parts: with what its
/// joints hold each body now, and how that makes it move, stands in the tree's own rows.
///
/// `joined` must be what the substep began with: that much the bodies have received already.
pub fn solve_tree<R: Real>(
    tree: &mut Batch<R>,
    bodies: &Bodies,
    joined: &[Held],
    walked: &mut Vec<Walked<R>>,
    h: f32,
) {
    walked.resize_with(tree.nodes.len(), Walked::default);
    for (node, here) in tree.nodes.iter().zip(walked.iter_mut()) {
        here.bone = bone_of(bodies, &node.rows);
        take_back(node, &mut here.bone, joined);
    }
    for (i, node) in tree.nodes.iter().enumerate().rev() {
        let link = meet(node, &walked[i].bone, bodies, walked, h);
        let mut body = stands(node, &walked[i].bone, &link, h);
        for child in node.children.clone() {
            body = body.plus(walked[child].felt);
        }
        let here = &mut walked[i];
        (here.kept, here.felt) = fold(node.kind, &link, &node.heft, &body);
        here.felt = pulled(node, &link, here.felt, h);
        here.link = link;
    }
    for i in 0..tree.nodes.len() {
        let parent = tree.nodes[i].parent;
        let parent = match parent {
            Some(parent) => walked[parent].change,
            None => [Rate::default(); 2],
        };
        let here = &mut walked[i];
        let kind = tree.nodes[i].kind;
        let (change, given) = unfold(kind, &here.link, &here.kept, &here.felt, parent);
        here.change = change;
        tree.nodes[i].impulse = given;
        tree.write(i, &here.bone, change);
    }
}
// ANCHOR_END: solve_tree

/// Takes back from a body what its joints gave it at the start of the substep.
#[inline(always)]
fn take_back<R: Real>(node: &Limb<R>, bone: &mut Bone<R>, joined: &[Held]) {
    let [linear, angular] = halves(bytemuck::cast_slice(joined), &node.rows);
    bone.rate.velocity -= linear * node.heft.inverse_mass;
    bone.rate.spin -= bone.attitude.moment(node.heft.inverse_moments, angular);
}

/// A node's joint where it is now.
#[inline(always)]
fn meet<R: Real>(
    node: &Limb<R>,
    bone: &Bone<R>,
    bodies: &Bodies,
    walked: &[Walked<R>],
    h: f32,
) -> Link<R> {
    if node.kind == FREE {
        return Link::default();
    }
    let outside;
    let parent = if let Some(parent) = node.parent {
        &walked[parent].bone
    } else {
        // What isn't in the tree is static: no joint has given it anything.
        outside = bone_of(bodies, &node.parent_rows);
        &outside
    };
    let second = if node.kind == TWO_RODS {
        bone_of(bodies, &node.second_rows)
    } else {
        Bone::default()
    };
    link_of(node.kind, &node.fitting, bone, parent, &second, h)
}

/// Bodies, as their joints see them.
#[inline(always)]
fn bone_of<R: Real>(bodies: &Bodies, rows: &[u32]) -> Bone<R> {
    let [x, y, z, _] = gather::<R>(bytemuck::cast_slice(&bodies.place), rows);
    let [i, j, k, w] = gather::<R>(bytemuck::cast_slice(&bodies.attitude), rows);
    let [vx, vy, vz, _] = gather::<R>(bytemuck::cast_slice(&bodies.motion), rows);
    let [wx, wy, wz, _] = gather::<R>(bytemuck::cast_slice(&bodies.spin), rows);
    let [push, push_spin] = halves(bytemuck::cast_slice(&bodies.push), rows);
    Bone {
        position: Vec3::new(x, y, z),
        attitude: Quat {
            v: Vec3::new(i, j, k),
            w,
        },
        rate: Rate {
            velocity: Vec3::new(vx, vy, vz),
            spin: Vec3::new(wx, wy, wz),
        },
        push: Rate {
            velocity: push,
            spin: push_spin,
        },
    }
}

/// Two vectors of a row, each with a spare number behind it.
#[inline(always)]
fn halves<R: Real>(table: &[[[f32; 4]; 2]], rows: &[u32]) -> [Vec3<R>; 2] {
    let [x, y, z, _] = R::of_rows(|lane| table[rows[lane] as usize][0]);
    let [u, v, w, _] = R::of_rows(|lane| table[rows[lane] as usize][1]);
    [Vec3::new(x, y, z), Vec3::new(u, v, w)]
}

/// A body before anything is folded into it.
#[inline(always)]
#[must_use]
pub fn stands<R: Real>(node: &Limb<R>, bone: &Bone<R>, link: &Link<R>, h: f32) -> Carried<R> {
    let alone = Articulated::of_body(node.heft.mass, node.heft.moments, bone.attitude);
    Carried {
        articulated: stiffened(alone, link.arm, node.impulse, h),
        ..Carried::default()
    }
}

/// What the parent feels, with the stiffness that the pull of the joint gives the parent.
#[inline(always)]
#[must_use]
pub fn pulled<R: Real>(node: &Limb<R>, link: &Link<R>, felt: Carried<R>, h: f32) -> Carried<R> {
    Carried {
        articulated: stiffened(felt.articulated, link.parent_arm, -node.impulse, h),
        ..felt
    }
}

// ANCHOR: stiffened
/// The inertia of a body that is pulled at an arm's end, as it was in the last substep.
///
/// A pull along the arm holds the body as gravity holds a pendulum: if it turns by θ across the arm, the
/// pull turns it back with −κ θ, κ = r·λ/h. A taut chain of light links is full of such pendulums, of up
/// to √(12 F/(m l)) rad/s, and a substep that only looks at where they are blows them up when h²κ/I
/// passes 4. With ¼ h²κ more of inertia it never does: that is the trapezoidal rule. It changes nothing
/// but how fast the fastest of them swing. [Tournier, Nesme, Gilles and Faure 2015]
#[inline(always)]
#[must_use]
pub fn stiffened<R: Real>(
    body: Articulated<R>,
    arm: Vec3<R>,
    impulse: Vec3<R>,
    h: f32,
) -> Articulated<R> {
    let pull = arm.dot(impulse).max(R::splat(0.0)) * R::splat(PULL_SHARE * h);
    let along = -pull / arm.length_squared().max(R::splat(SMALL));
    let along = Symmetric::outer(arm).scaled(along);
    Articulated {
        inertia: body.inertia.plus(Symmetric::splat(pull)).plus(along),
        ..body
    }
}
// ANCHOR_END: stiffened

/// Below this the square of an arm is none.
const SMALL: f32 = 1e-12;

/// The nodes that hang on a node.
fn children(node: &Node) -> Range<usize> {
    let first = node.first_child as usize;
    if node.children == 0 {
        0..0
    } else {
        first..first + node.children as usize
    }
}
