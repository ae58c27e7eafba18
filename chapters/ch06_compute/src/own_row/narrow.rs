//! The narrow phase: where two bodies touch or soon may, as a row of up to four points.
//!
//! A pair has one of ten kinds, and a pass runs over the pairs of one kind, so that the invocations of a
//! workgroup do the same work. Balls have closed forms. All others go three ways in turn, each of
//! which may be the last: a direction along which the two are far apart or hardly overlap
//! ([`best_axis`](axis::best_axis)), a better one ([`push_apart`](way::push_apart)), and the points there
//! ([`contacts`](contacts::contacts)).
//!
//! The shaders `common/narrow*.wgsl` have the same functions by the same names.

pub mod axis;
pub mod ball;
pub mod capsule;
pub mod contacts;
pub mod convex;
pub mod core;
pub mod edges;
pub mod faces;
pub mod features;
pub mod gjk;
pub mod simplex;
pub mod spots;
pub mod way;

use glam::{Quat, Vec3, Vec4};

use self::core::{BOX, CAPSULE, CYLINDER, core_of};
use crate::rows::{Manifold, WITH_A, WITH_B};

/// A body as the narrow phase is given it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Posed {
    /// World position of its origin, m.
    pub position: Vec3,
    /// Body to world.
    pub attitude: Quat,
    /// 0 ball, 1 box, 2 capsule, 3 cylinder.
    pub kind: u32,
    /// Ball: radius, 0, 0. Box: half extents. Capsule and cylinder: radius, half height, 0. m.
    pub size: Vec3,
}

/// [`manifold`], in its place. A ball's is put together there: made elsewhere and copied at once, its numbers
/// would have to be waited for.
#[inline]
pub fn put_manifold(place: &mut Manifold, a: &Posed, b: &Posed, margin: f32) {
    match pair_kind(a.kind, b.kind) {
        0 => *place = manifold_of_kind(0, a, b, margin),
        1 => *place = manifold_of_kind(1, a, b, margin),
        kind => *place = manifold_of_kind(kind, a, b, margin),
    }
}

// ANCHOR: pair_kind
/// How many kinds of pairs there are.
pub const PAIR_KINDS: u32 = 10;

/// The kind of a pair: 0 to 3 a ball with a ball, box, capsule, cylinder; 4 to 6 a box with a box,
/// capsule, cylinder; 7 and 8 a capsule with a capsule, cylinder; 9 two cylinders.
#[must_use]
pub fn pair_kind(a: u32, b: u32) -> u32 {
    let low = a.min(b);
    let high = a.max(b);
    low * (7 - low) / 2 + high
}
// ANCHOR_END: pair_kind

/// Where a and b touch or are at most `margin`, m, from touching; without points where they are further
/// apart.
#[must_use]
pub fn manifold(a: &Posed, b: &Posed, margin: f32) -> Manifold {
    manifold_of_kind(pair_kind(a.kind, b.kind), a, b, margin)
}

// ANCHOR: manifold_of_kind
/// [`manifold`], for a pair whose kind is known.
#[inline(always)]
#[must_use]
pub fn manifold_of_kind(kind: u32, a: &Posed, b: &Posed, margin: f32) -> Manifold {
    let swapped = a.kind > b.kind;
    let (first, second) = if swapped { (b, a) } else { (a, b) };
    let mut m = in_order(kind, first, second, margin);
    m.kind = kind;
    if swapped {
        m = flipped(&m);
    }
    m
}

/// [`manifold_of_kind`], for a pair whose first body has the smaller kind.
#[inline(always)]
fn in_order(kind: u32, a: &Posed, b: &Posed, margin: f32) -> Manifold {
    let d = b.position - a.position;
    match kind {
        0 => ball::ball_ball(a.size.x, b.size.x, d, margin),
        1 => ball::ball_box(a, &core_of(BOX, b, d), margin),
        2 => ball::ball_capsule(a, &core_of(CAPSULE, b, d), margin),
        3 => ball::ball_cylinder(a, &core_of(CYLINDER, b, d), margin),
        4 => convex::convex_convex(&core_of(BOX, a, Vec3::ZERO), &core_of(BOX, b, d), margin),
        5 => capsule::box_capsule(
            &core_of(BOX, a, Vec3::ZERO),
            &core_of(CAPSULE, b, d),
            margin,
        ),
        6 => convex::convex_convex(
            &core_of(BOX, a, Vec3::ZERO),
            &core_of(CYLINDER, b, d),
            margin,
        ),
        7 => capsule::capsule_capsule(
            &core_of(CAPSULE, a, Vec3::ZERO),
            &core_of(CAPSULE, b, d),
            margin,
        ),
        8 => convex::convex_convex(
            &core_of(CAPSULE, a, Vec3::ZERO),
            &core_of(CYLINDER, b, d),
            margin,
        ),
        _ => convex::convex_convex(
            &core_of(CYLINDER, a, Vec3::ZERO),
            &core_of(CYLINDER, b, d),
            margin,
        ),
    }
}
// ANCHOR_END: manifold_of_kind

// ANCHOR: flipped
/// The same pair seen from the other body.
#[inline(always)]
fn flipped(m: &Manifold) -> Manifold {
    let mut other = *m;
    other.normal = -m.normal;
    if m.turns == WITH_A {
        other.turns = WITH_B;
    }
    if m.turns == WITH_B {
        other.turns = WITH_A;
    }
    other.round_a = m.round_b;
    other.round_b = m.round_a;
    for k in 0..4 {
        let feature = m.core_a[k].w;
        other.core_a[k] = Vec4::from((m.core_b[k].truncate(), feature));
        other.core_b[k] = Vec4::from((m.core_a[k].truncate(), 0.0));
    }
    other
}
// ANCHOR_END: flipped
