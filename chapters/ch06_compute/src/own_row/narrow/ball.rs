//! A ball and anything: one point, in closed form. The ball is a, at the origin; all is computed in b's
//! own axes.

use glam::{Vec3, Vec4};

use super::Posed;
use super::core::{Core, TINY, outward, to_own, with_sign};
use super::features::CAP_COSINE;
use super::spots::FEATURE;
use crate::norm::Norm;
use crate::rows::{FIXED, Manifold, ROUND, WITH_B};

/// Two core points are the same if they are nearer than this share of the sizes.
pub const SAME: f32 = 1e-6;

/// The row of a ball and the point `core_b` of b, in b's own axes. `normal` is in them if it turns with
/// b, else in the world.
#[inline(always)]
fn one_point(radius: f32, round_b: f32, normal: Vec3, turns: u32, core_b: Vec3) -> Manifold {
    let mut m = Manifold {
        normal,
        turns,
        round_a: radius,
        round_b,
        points: 1,
        ..Manifold::default()
    };
    m.core_a[0] = Vec4::new(0.0, 0.0, 0.0, f32::from_bits(FEATURE));
    m.core_b[0] = Vec4::from((core_b, 0.0));
    m
}

// ANCHOR: ball_ball
/// Two balls; b's centre is at `d`.
#[inline(always)]
#[must_use]
pub fn ball_ball(r1: f32, r2: f32, d: Vec3, margin: f32) -> Manifold {
    let distance = d.norm();
    if distance > r1 + r2 + margin {
        return Manifold::default();
    }
    let mut normal = Vec3::Y;
    if distance > SAME * (r1 + r2) {
        normal = d / distance;
    }
    one_point(r1, r2, normal, ROUND, Vec3::ZERO)
}
// ANCHOR_END: ball_ball

// ANCHOR: ball_capsule
/// A ball and a capsule: two balls, the second where the segment is the nearest.
#[must_use]
pub fn ball_capsule(a: &Posed, b: &Core, margin: f32) -> Manifold {
    let radius = a.size.x;
    let p = to_own(b, -b.centre);
    let core_b = Vec3::new(0.0, p.y.clamp(-b.half.y, b.half.y), 0.0);
    let distance = (core_b - p).norm();
    if distance > radius + b.round + margin {
        return Manifold::default();
    }
    let mut normal = Vec3::X;
    if distance > SAME * (radius + b.round) {
        normal = (core_b - p) / distance;
    }
    one_point(radius, b.round, b.axes * normal, ROUND, core_b)
}
// ANCHOR_END: ball_capsule

// ANCHOR: ball_box
/// A ball and a box: the ball's centre is clamped to the box. A centre inside leaves by the nearest face.
#[inline(always)]
#[must_use]
pub fn ball_box(a: &Posed, b: &Core, margin: f32) -> Manifold {
    let radius = a.size.x;
    let p = to_own(b, -b.centre);
    let mut core_b = p.clamp(-b.half, b.half);
    let between = core_b - p;
    let distance = between.norm();
    if distance > radius + margin {
        return Manifold::default();
    }
    let mut normal = between / distance.max(TINY);
    if distance == 0.0 {
        let way = b.half - p.abs();
        let sides = Vec3::new(
            with_sign(1.0, p.x),
            with_sign(1.0, p.y),
            with_sign(1.0, p.z),
        );
        let mut out = Vec3::new(0.0, 0.0, sides.z);
        if way.x <= way.y && way.x <= way.z {
            out = Vec3::new(sides.x, 0.0, 0.0);
        } else if way.y <= way.z {
            out = Vec3::new(0.0, sides.y, 0.0);
        }
        normal = -out;
        core_b = p + way.x.min(way.y).min(way.z) * out;
    }
    one_point(radius, 0.0, normal, WITH_B, core_b)
}
// ANCHOR_END: ball_box

// ANCHOR: ball_cylinder
/// A ball and a cylinder: the ball's centre is clamped to the cylinder. A centre inside leaves by the
/// nearer of the side and the cap on its half.
///
/// Where the normal runs more outwards than along the axis, the core point is on the axis, where it stays
/// while the cylinder spins, and the normal keeps its direction.
#[must_use]
pub fn ball_cylinder(a: &Posed, b: &Core, margin: f32) -> Manifold {
    let radius = a.size.x;
    let p = to_own(b, -b.centre);
    let out = outward(p);
    let up = Vec3::new(0.0, with_sign(1.0, p.y), 0.0);
    let beyond_side = out.dot(p) - b.half.x;
    let beyond_cap = p.y.abs() - b.half.y;
    let mut way = beyond_side.max(0.0) * out + beyond_cap.max(0.0) * up;
    let distance = way.norm();
    if distance > radius + margin {
        return Manifold::default();
    }
    let mut normal = -way / distance.max(TINY);
    if distance == 0.0 {
        normal = -up;
        way = beyond_cap * up;
        if beyond_side > beyond_cap {
            normal = -out;
            way = beyond_side * out;
        }
    }
    let across = -normal.dot(out);
    if across < CAP_COSINE {
        return one_point(radius, 0.0, normal, WITH_B, p - way);
    }
    let lift = b.half.x / across;
    one_point(
        radius,
        lift,
        b.axes * normal,
        FIXED,
        p - way + lift * normal,
    )
}
// ANCHOR_END: ball_cylinder
