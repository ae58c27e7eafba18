//! Two balls: they touch where their centres are no further apart than their radii add up to.

use glam::Vec3;

use super::Touch;

// ANCHOR: sphere_sphere
/// Ball of radius `r1` at `p1` against ball of radius `r2` at `p2`, m; found if the gap between
/// them is at most `margin`.
///
/// Balls with the same centre part upwards: no direction is better, and this one is the same
/// on every machine.
#[must_use]
pub fn sphere_sphere(p1: Vec3, r1: f32, p2: Vec3, r2: f32, margin: f32) -> Option<Touch> {
    let between = p1 - p2;
    let squared = between.length_squared();
    let reach = r1 + r2 + margin;
    if squared > reach * reach {
        return None;
    }
    let distance = squared.sqrt();
    let normal = if distance > 0.0 {
        between / distance
    } else {
        Vec3::Y
    };
    let depth = r1 + r2 - distance;
    let point = p2 + normal * (r2 - 0.5 * depth);
    Some(Touch::single(normal, depth, point))
}
// ANCHOR_END: sphere_sphere

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_that_overlap_by_a_tenth() {
        let touch = sphere_sphere(Vec3::X * 0.9, 0.5, Vec3::ZERO, 0.5, 0.0).unwrap();
        assert_eq!(touch.normal, Vec3::X);
        assert!((touch.depth() - 0.1).abs() < 1e-6);
        assert!((touch.spots()[0].point - Vec3::X * 0.45).length() < 1e-6);
    }

    #[test]
    fn touching_exactly_counts_and_a_hair_apart_does_not() {
        assert!(sphere_sphere(Vec3::X, 0.5, Vec3::ZERO, 0.5, 0.0).is_some());
        assert!(sphere_sphere(Vec3::X * 1.000_001, 0.5, Vec3::ZERO, 0.5, 0.0).is_none());
    }

    #[test]
    fn a_gap_within_the_margin_is_a_negative_depth() {
        let touch = sphere_sphere(Vec3::X * 1.01, 0.5, Vec3::ZERO, 0.5, 0.02).unwrap();
        assert!((touch.depth() + 0.01).abs() < 1e-6);
        assert!((touch.spots()[0].point - Vec3::X * 0.505).length() < 1e-6);
    }

    #[test]
    fn balls_with_one_centre_part_upwards() {
        let touch = sphere_sphere(Vec3::ONE, 0.5, Vec3::ONE, 0.25, 0.0).unwrap();
        assert_eq!(touch.normal, Vec3::Y);
        assert_eq!(touch.depth(), 0.75);
    }
}
