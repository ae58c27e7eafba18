//! Where a joint is and what it wants: the geometry of a substep.

use glam::{Quat, Vec3};

use super::Rate;
use crate::rows::{HINGE, Node, PIN, ROD, TWO_RODS};

/// The share of a gap that a substep closes in any case.
pub const JOINT_SHARE: f32 = 0.2;

/// Up to this, m/s, a substep closes a gap once more, and all of it. In common motion that is the most of
/// it; where a chain lashes about, it would feed the gaps of fast turns into the velocities.
pub const GENTLE_CLOSING: f32 = 0.2;

/// The same for a hinge's axes, rad/s.
pub const GENTLE_ALIGNING: f32 = 1.0;

/// The fastest that a gap closes, m/s: joints that were torn apart (by a mouse, say) come together
/// without a bang.
pub const FASTEST_CLOSING: f32 = 10.0;

/// The fastest that a hinge's axes come together, rad/s.
pub const FASTEST_ALIGNING: f32 = 20.0;

/// Below this a length, m, or a reply is none.
const SMALL: f32 = 1e-12;

// ANCHOR: bone
/// A body of a tree, as its joints see it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bone {
    /// World position, m.
    pub position: Vec3,
    /// Body to world.
    pub attitude: Quat,
    /// How it moves.
    pub rate: Rate,
    /// How it is pushed.
    pub push: Rate,
    /// 1/m.
    pub inverse_mass: f32,
    /// In its own axes, 1/(kg m²).
    pub inverse_inertia: Vec3,
}
// ANCHOR_END: bone

// ANCHOR: link
/// A joint where it is now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Link {
    /// r: from the body's centre to the joint's point c, m.
    pub arm: Vec3,
    /// s: from the parent's centre to c, m.
    pub parent_arm: Vec3,
    /// A hinge's axis; the direction of a rod.
    pub along: Vec3,
    /// The direction of the second rod.
    pub second: Vec3,
    /// What the joint wants the relative motion at c to change by: first of the velocities, then of the
    /// pushes. Rods want speeds along them: x of the first, y of the second.
    pub wanted: [Rate; 2],
}
// ANCHOR_END: link

// ANCHOR: link_of
/// The joint of a node between bodies where they are now. `second` is what the second of two rods hangs
/// on.
#[must_use]
pub fn link_of(node: &Node, child: &Bone, parent: &Bone, second: &Bone, h: f32) -> Link {
    match node.kind {
        PIN | HINGE => {
            let mut link = pinned(node, child, parent, h);
            if node.kind == HINGE {
                align(&mut link, node, child, parent, h);
            }
            link
        }
        ROD | TWO_RODS => rods(node, child, parent, second, h),
        _ => Link::default(),
    }
}
// ANCHOR_END: link_of

// ANCHOR: closing
/// How fast a gap closes. Joints of a tree are solved together and last, so no blow and no push parts
/// them; what opens a gap is that the end of a turning arm leaves its circle along the tangent, by
/// d = ½ h² ω² r in a substep. Where a share s of a gap is closed, d/s of it remains.
fn closing(gap: Vec3, gentle: f32, fastest: f32, h: f32) -> Vec3 {
    at_most(gap * (JOINT_SHARE / h) + at_most(gap / h, gentle), fastest)
}
// ANCHOR_END: closing

// ANCHOR: pinned
/// Two points. Impulses act midway between them, or the pair of them would turn both bodies while there
/// is a gap.
fn pinned(node: &Node, child: &Bone, parent: &Bone, h: f32) -> Link {
    let apart = child.position - parent.position;
    let anchor = child.attitude * node.anchor;
    let parent_anchor = parent.attitude * node.parent_anchor;
    let gap = apart + anchor - parent_anchor;
    let arm = anchor - 0.5 * gap;
    let mut link = Link {
        arm,
        parent_arm: arm + apart,
        ..Link::default()
    };
    let speeds = [
        relative(child.rate, parent.rate, &link),
        relative(child.push, parent.push, &link),
    ];
    let closing = closing(gap, GENTLE_CLOSING, FASTEST_CLOSING, h);
    link.wanted[0].velocity = -speeds[0] - closing;
    link.wanted[1].velocity = -speeds[1];
    link
}

/// Ċ: the velocity at c of the child against the parent.
fn relative(child: Rate, parent: Rate, link: &Link) -> Vec3 {
    child.at(link.arm).velocity - parent.at(link.parent_arm).velocity
}
// ANCHOR_END: pinned

// ANCHOR: align
/// Two axes. Â_p × Â is, to first order, the turn by which the child's axis has left the parent's.
fn align(link: &mut Link, node: &Node, child: &Bone, parent: &Bone, h: f32) {
    let axis = child.attitude * node.axis;
    let parent_axis = parent.attitude * node.parent_axis;
    let aligning = closing(
        parent_axis.cross(axis),
        GENTLE_ALIGNING,
        FASTEST_ALIGNING,
        h,
    );
    let across = |v: Vec3| v - axis * axis.dot(v);
    link.along = axis;
    link.wanted[0].spin = across(parent.rate.spin - child.rate.spin) - aligning;
    link.wanted[1].spin = across(parent.push.spin - child.push.spin);
}
// ANCHOR_END: align

// ANCHOR: rods
/// One or two distances from the child's point, which is c: a rod's impulse acts along it, so it may be
/// taken at either end.
fn rods(node: &Node, child: &Bone, parent: &Bone, second: &Bone, h: f32) -> Link {
    let arm = child.attitude * node.anchor;
    let mut link = Link {
        arm,
        parent_arm: arm + (child.position - parent.position),
        ..Link::default()
    };
    let first = rod(node.parent_anchor, node.length, child, parent, arm, h);
    link.along = first.along;
    link.wanted[0].velocity.x = first.wanted;
    link.wanted[1].velocity.x = first.pushed;
    if node.kind == TWO_RODS {
        let other = rod(node.parent_axis, node.second_length, child, second, arm, h);
        link.second = other.along;
        link.wanted[0].velocity.y = other.wanted;
        link.wanted[1].velocity.y = other.pushed;
    }
    link
}

/// A rod: its direction, and what it wants its stretching to change by.
struct Rod {
    along: Vec3,
    wanted: f32,
    pushed: f32,
}

fn rod(hook: Vec3, length: f32, child: &Bone, parent: &Bone, arm: Vec3, h: f32) -> Rod {
    let hook = parent.attitude * hook;
    let line = child.position - parent.position + arm - hook;
    let distance = line.length();
    let along = line / distance.max(SMALL);
    let stretching =
        |child: Rate, parent: Rate| along.dot(child.at(arm).velocity - parent.at(hook).velocity);
    let gap = along * (distance - length);
    let closing = closing(gap, GENTLE_CLOSING, FASTEST_CLOSING, h);
    Rod {
        along,
        wanted: -stretching(child.rate, parent.rate) - along.dot(closing),
        pushed: -stretching(child.push, parent.push),
    }
}
// ANCHOR_END: rods

/// The same direction, no longer than `most`.
fn at_most(v: Vec3, most: f32) -> Vec3 {
    v * (most / v.length().max(most))
}
