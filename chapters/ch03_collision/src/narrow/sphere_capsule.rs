//! A ball and a capsule: the capsule is a row of balls along its axis, and only the nearest of them
//! matters.

use glam::Vec3;

use super::segment::Segment;
use super::{Placed, Touch};

// ANCHOR: sphere_capsule
/// The ball at `p` of radius `r1` against the capsule of radius `r2` whose axis reaches to
/// `half_height` on both sides, m; found if the gap between them is at most `margin`.
#[must_use]
pub fn sphere_capsule(
    p: Vec3,
    r1: f32,
    capsule: &Placed,
    r2: f32,
    half_height: f32,
    margin: f32,
) -> Option<Touch> {
    let up = capsule.q * Vec3::Y;
    let axis = Segment {
        centre: capsule.p - p,
        half: up * half_height,
    };
    let nearest = axis.at(axis.nearest_to(Vec3::ZERO));
    let distance = nearest.length();
    if distance > r1 + r2 + margin {
        return None;
    }
    let normal = if distance > ON_AXIS * half_height {
        -nearest / distance
    } else {
        sideways(up)
    };
    let depth = r1 + r2 - distance;
    let point = p - normal * (r1 - 0.5 * depth);
    Some(Touch::single(normal, depth, point))
}
// ANCHOR_END: sphere_capsule

/// Closer to an axis than this share of its length, the direction away from it is only rounding.
pub const ON_AXIS: f32 = 1e-6;

// ANCHOR: sideways
/// The way out for what sits on an axis: as steeply up as possible at a right angle to it, and
/// along x if the axis is upright.
#[must_use]
pub fn sideways(axis: Vec3) -> Vec3 {
    (Vec3::Y - axis * axis.y).try_normalize().unwrap_or(Vec3::X)
}
// ANCHOR_END: sideways

#[cfg(test)]
mod tests {
    use super::*;
    use ch00_maths::f32::shape::Shape;
    use glam::Quat;

    /// A ball of 0.5 m against an upright capsule of 0.25 m, 1 m + 1 m long, at the origin.
    fn at(p: Vec3, margin: f32) -> Option<Touch> {
        let shape = Shape::Capsule {
            radius: 0.25,
            half_height: 1.0,
        };
        let capsule = Placed {
            shape: &shape,
            p: Vec3::ZERO,
            q: Quat::IDENTITY,
            p_before: Vec3::ZERO,
        };
        sphere_capsule(p, 0.5, &capsule, 0.25, 1.0, margin)
    }

    #[test]
    fn a_ball_beside_the_straight_part() {
        let touch = at(Vec3::new(0.7, 0.3, 0.0), 0.0).unwrap();
        assert_eq!(touch.normal, Vec3::X);
        assert!((touch.depth() - 0.05).abs() < 1e-6);
        assert!((touch.spots()[0].point - Vec3::new(0.225, 0.3, 0.0)).length() < 1e-6);
    }

    #[test]
    fn a_ball_over_the_cap() {
        let touch = at(Vec3::new(0.0, 1.76, 0.0), 0.02).unwrap();
        assert_eq!(touch.normal, Vec3::Y);
        assert!((touch.depth() + 0.01).abs() < 1e-6);
        assert!(at(Vec3::new(0.0, 1.76, 0.0), 0.0).is_none());
    }

    #[test]
    fn a_ball_on_the_axis_leaves_sideways() {
        let touch = at(Vec3::Y * 0.5, 0.0).unwrap();
        assert_eq!(touch.normal, Vec3::X);
        assert_eq!(touch.depth(), 0.75);
    }
}
