//! A body as the narrow phase computes with it: a core, rounded by a radius. A ball's core is its centre,
//! a capsule's the segment within; a box and a cylinder are cores themselves, with radius 0.
//!
//! Coordinates are along the world's axes, from the first body's centre: far from the world's origin an
//! f32 has few digits left for a distance, and here it has them all.

use glam::{Mat3, Vec3};

use super::Posed;
use crate::norm::Norm;

/// The kinds of bodies.
pub const BALL: u32 = 0;
/// A box.
pub const BOX: u32 = 1;
/// A capsule about its y.
pub const CAPSULE: u32 = 2;
/// A cylinder about its y.
pub const CYLINDER: u32 = 3;

/// Longer than anything, m.
pub const HUGE: f32 = 3e38;

/// Shorter than anything, m, and no subnormal number, even times a size.
pub const TINY: f32 = 1e-30;

/// Rounding of a support point, as a share of the coordinates.
const ROUNDING: f32 = 5e-7;

/// Lengths that differ by less than this share of the smaller body's size count as equal: a tremor must
/// not change which points there are.
const SLACK: f32 = 5e-4;

// ANCHOR: core
/// A body's core.
#[derive(Clone, Copy, Debug)]
pub struct Core {
    /// Where its centre is, m.
    pub centre: Vec3,
    /// Of the body.
    pub kind: u32,
    /// How far it reaches along its own axes, m.
    pub half: Vec3,
    /// How far the body's surface is outside of it, m.
    pub round: f32,
    /// Its own axes, in the world.
    pub axes: Mat3,
}

/// The core of a body of this kind, seen from somewhere.
#[must_use]
pub fn core_of(kind: u32, body: &Posed, centre: Vec3) -> Core {
    let size = body.size;
    let (half, round) = match kind {
        BALL => (Vec3::ZERO, size.x),
        BOX => (size, 0.0),
        CAPSULE => (Vec3::new(0.0, size.y, 0.0), size.x),
        _ => (Vec3::new(size.x, size.y, size.x), 0.0),
    };
    Core {
        centre,
        kind,
        half,
        round,
        axes: Mat3::from_quat(body.attitude),
    }
}
// ANCHOR_END: core

/// A vector in the core's own axes.
#[must_use]
pub fn to_own(core: &Core, v: Vec3) -> Vec3 {
    Vec3::new(
        core.axes.x_axis.dot(v),
        core.axes.y_axis.dot(v),
        core.axes.z_axis.dot(v),
    )
}

// ANCHOR: support
/// The point of the core that is furthest along `direction`, which needn't be a unit vector.
#[must_use]
pub fn support(core: &Core, direction: Vec3) -> Vec3 {
    let d = to_own(core, direction);
    let mut own = Vec3::new(
        with_sign(core.half.x, d.x),
        with_sign(core.half.y, d.y),
        with_sign(core.half.z, d.z),
    );
    if core.kind == CYLINDER {
        let out = outward(d) * core.half.x;
        own = Vec3::new(out.x, own.y, out.z);
    }
    core.centre + core.axes * own
}

/// The unit vector from the axis y along d.
#[must_use]
pub fn outward(d: Vec3) -> Vec3 {
    let across = (d.x * d.x + d.z * d.z).sqrt();
    if across > 0.0 {
        Vec3::new(d.x / across, 0.0, d.z / across)
    } else {
        Vec3::X
    }
}

/// `size` with the sign of `d`; positive for both zeros.
#[must_use]
pub fn with_sign(size: f32, d: f32) -> f32 {
    if d < 0.0 { -size } else { size }
}
// ANCHOR_END: support

// ANCHOR: separation
/// How far the core reaches from its centre along a unit vector, m: as far on one side as on the other.
#[must_use]
pub fn half_width(core: &Core, n: Vec3) -> f32 {
    let d = to_own(core, n).abs();
    if core.kind == CYLINDER {
        return (d.x * d.x + d.z * d.z).sqrt() * core.half.x + d.y * core.half.y;
    }
    d.dot(core.half)
}

/// How far apart two bodies are along a unit vector from a to b, m; negative by the way that b has to go
/// along it until they touch. Over all directions the largest is their distance.
#[must_use]
pub fn separation(a: &Core, b: &Core, n: Vec3) -> f32 {
    let between = (b.centre - a.centre).dot(n);
    between - half_width(a, n) - half_width(b, n) - a.round - b.round
}
// ANCHOR_END: separation

/// Radius of the ball about the centre that holds the core, m.
#[must_use]
pub fn reach(core: &Core) -> f32 {
    if core.kind == CYLINDER {
        return (core.half.x * core.half.x + core.half.y * core.half.y).sqrt();
    }
    core.half.norm()
}

/// The smallest half extent of a body, m.
#[must_use]
pub fn thin(core: &Core) -> f32 {
    if core.round > 0.0 {
        core.round
    } else {
        core.half.min_element()
    }
}

/// How large the smaller of two bodies is, m.
#[must_use]
pub fn smaller_size(a: &Core, b: &Core) -> f32 {
    (reach(a) + a.round).min(reach(b) + b.round)
}

/// How large the coordinates of support points may be, m.
#[must_use]
pub fn extent(a: &Core, b: &Core) -> f32 {
    (b.centre - a.centre).norm() + reach(a) + reach(b)
}

/// By how much a computed length may be off, m.
#[must_use]
pub fn rounding(a: &Core, b: &Core) -> f32 {
    ROUNDING * extent(a, b)
}

/// Lengths that differ by less count as equal, m.
#[must_use]
pub fn slack(a: &Core, b: &Core) -> f32 {
    SLACK * smaller_size(a, b) + rounding(a, b)
}
