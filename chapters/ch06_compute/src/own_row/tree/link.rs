//! Where a joint is and what it wants: the geometry of a substep.

use super::Rate;
use crate::rows::{HINGE, Node, PIN, ROD, TWO_RODS};
use crate::simd::{Quat, Real, Vec3};

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

// ANCHOR: fitting
/// Where a joint sits in its two bodies: what of a [`Node`] never changes, a joint a lane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fitting<R> {
    /// The joint's point, in the body's axes, m.
    pub anchor: Vec3<R>,
    /// The joint's point, in the parent's axes, m.
    pub parent_anchor: Vec3<R>,
    /// A hinge's unit axis, in the body's axes.
    pub axis: Vec3<R>,
    /// A hinge's unit axis, in the parent's axes; where the second rod hangs, in its parent's axes, m.
    pub parent_axis: Vec3<R>,
    /// Length of the rod, m.
    pub length: R,
    /// Length of the second rod, m.
    pub second_length: R,
}
// ANCHOR_END: fitting

impl<R: Real> Fitting<R> {
    /// Of the nodes that `node` gives for each lane, which are of one kind.
    pub fn of<'a>(node: impl Fn(usize) -> &'a Node) -> Self {
        Self {
            anchor: Vec3::of(|lane| node(lane).anchor),
            parent_anchor: Vec3::of(|lane| node(lane).parent_anchor),
            axis: Vec3::of(|lane| node(lane).axis),
            parent_axis: Vec3::of(|lane| node(lane).parent_axis),
            length: R::of(|lane| node(lane).length),
            second_length: R::of(|lane| node(lane).second_length),
        }
    }
}

// ANCHOR: bone
/// A body of a tree, as its joints see it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bone<R> {
    /// World position, m.
    pub position: Vec3<R>,
    /// Body to world.
    pub attitude: Quat<R>,
    /// How it moves.
    pub rate: Rate<R>,
    /// How it is pushed.
    pub push: Rate<R>,
}
// ANCHOR_END: bone

// ANCHOR: link
/// A joint where it is now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Link<R> {
    /// r: from the body's centre to the joint's point c, m.
    pub arm: Vec3<R>,
    /// s: from the parent's centre to c, m.
    pub parent_arm: Vec3<R>,
    /// A hinge's axis; the direction of a rod.
    pub along: Vec3<R>,
    /// The direction of the second rod.
    pub second: Vec3<R>,
    /// What the joint wants the relative motion at c to change by: first of the velocities, then of the
    /// pushes. Rods want speeds along them: x of the first, y of the second.
    pub wanted: [Rate<R>; 2],
}
// ANCHOR_END: link

// ANCHOR: link_of
/// The joints of this kind between bodies where they are now. `second` is what the second of two rods
/// hangs on.
#[inline(always)]
#[must_use]
pub fn link_of<R: Real>(
    kind: u32,
    joint: &Fitting<R>,
    child: &Bone<R>,
    parent: &Bone<R>,
    second: &Bone<R>,
    h: f32,
) -> Link<R> {
    match kind {
        PIN | HINGE => {
            let mut link = pinned(joint, child, parent, h);
            if kind == HINGE {
                align(&mut link, joint, child, parent, h);
            }
            link
        }
        ROD | TWO_RODS => rods(kind, joint, child, parent, second, h),
        _ => Link::default(),
    }
}
// ANCHOR_END: link_of

// ANCHOR: closing
/// How fast a gap closes. Joints of a tree are solved together and last, so no blow and no push parts
/// them; what opens a gap is that the end of a turning arm leaves its circle along the tangent, by
/// d = ½ h² ω² r in a substep. Where a share β of a gap is closed, d/β of it remains.
#[inline(always)]
fn closing<R: Real>(gap: Vec3<R>, gentle: f32, fastest: f32, h: f32) -> Vec3<R> {
    let all = at_most(gap * R::splat(1.0 / h), gentle);
    at_most(gap * R::splat(JOINT_SHARE / h) + all, fastest)
}
// ANCHOR_END: closing

// ANCHOR: pinned
/// Two points. Impulses act midway between them, or the pair of them would turn both bodies while there
/// is a gap.
#[inline(always)]
fn pinned<R: Real>(joint: &Fitting<R>, child: &Bone<R>, parent: &Bone<R>, h: f32) -> Link<R> {
    let apart = child.position - parent.position;
    let anchor = child.attitude.rotate(joint.anchor);
    let parent_anchor = parent.attitude.rotate(joint.parent_anchor);
    let gap = apart + anchor - parent_anchor;
    let arm = anchor - gap * R::splat(0.5);
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
#[inline(always)]
fn relative<R: Real>(child: Rate<R>, parent: Rate<R>, link: &Link<R>) -> Vec3<R> {
    child.at(link.arm).velocity - parent.at(link.parent_arm).velocity
}
// ANCHOR_END: pinned

// ANCHOR: align
/// Two axes. Â_p × Â is, to first order, the turn by which the child's axis has left the parent's.
#[inline(always)]
fn align<R: Real>(
    link: &mut Link<R>,
    joint: &Fitting<R>,
    child: &Bone<R>,
    parent: &Bone<R>,
    h: f32,
) {
    let axis = child.attitude.rotate(joint.axis);
    let parent_axis = parent.attitude.rotate(joint.parent_axis);
    let left = parent_axis.cross(axis);
    let aligning = closing(left, GENTLE_ALIGNING, FASTEST_ALIGNING, h);
    let across = |v: Vec3<R>| v - axis * axis.dot(v);
    link.along = axis;
    link.wanted[0].spin = across(parent.rate.spin - child.rate.spin) - aligning;
    link.wanted[1].spin = across(parent.push.spin - child.push.spin);
}
// ANCHOR_END: align

// ANCHOR: rods
/// One or two distances from the child's point, which is c: a rod's impulse acts along it, so it may be
/// taken at either end.
#[inline(always)]
fn rods<R: Real>(
    kind: u32,
    joint: &Fitting<R>,
    child: &Bone<R>,
    parent: &Bone<R>,
    second: &Bone<R>,
    h: f32,
) -> Link<R> {
    let arm = child.attitude.rotate(joint.anchor);
    let mut link = Link {
        arm,
        parent_arm: arm + (child.position - parent.position),
        ..Link::default()
    };
    let first = rod(joint.parent_anchor, joint.length, child, parent, arm, h);
    link.along = first.along;
    link.wanted[0].velocity.x = first.wanted;
    link.wanted[1].velocity.x = first.pushed;
    if kind == TWO_RODS {
        let (hook, length) = (joint.parent_axis, joint.second_length);
        let other = rod(hook, length, child, second, arm, h);
        link.second = other.along;
        link.wanted[0].velocity.y = other.wanted;
        link.wanted[1].velocity.y = other.pushed;
    }
    link
}

/// A rod: its direction, and what it wants its stretching to change by.
struct Rod<R> {
    along: Vec3<R>,
    wanted: R,
    pushed: R,
}

#[inline(always)]
fn rod<R: Real>(
    hook: Vec3<R>,
    length: R,
    child: &Bone<R>,
    parent: &Bone<R>,
    arm: Vec3<R>,
    h: f32,
) -> Rod<R> {
    let hook = parent.attitude.rotate(hook);
    let line = child.position - parent.position + arm - hook;
    let distance = line.length();
    let along = line * distance.max(R::splat(SMALL)).recip();
    let stretching = |child: Rate<R>, parent: Rate<R>| {
        along.dot(child.at(arm).velocity - parent.at(hook).velocity)
    };
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
#[inline(always)]
fn at_most<R: Real>(v: Vec3<R>, most: f32) -> Vec3<R> {
    let most = R::splat(most);
    v * (most / v.length().max(most))
}
