//! A ball and a cylinder: clamp the ball's centre to the cylinder, and look how far away that is. A
//! centre inside leaves by the nearer of the side and the cap on its half.

use glam::Vec3;

use super::{Placed, Touch};

// ANCHOR: sphere_cylinder
/// The ball at `p` of radius `r1` against the cylinder of radius `r2` that is `half_height`
/// high on both sides, m; found if the gap between them is at most `margin`.
#[must_use]
pub fn sphere_cylinder(
    p: Vec3,
    r1: f32,
    cylinder: &Placed,
    r2: f32,
    half_height: f32,
    margin: f32,
) -> Option<Touch> {
    let centre = cylinder.q.conjugate() * (p - cylinder.p);
    let radial = Vec3::new(centre.x, 0.0, centre.z);
    let out = radial.try_normalize().unwrap_or(Vec3::X);
    let up = Vec3::Y * 1.0_f32.copysign(centre.y);
    let beyond_side = radial.length() - r2;
    let beyond_cap = centre.y.abs() - half_height;
    let (normal, gap) = if beyond_side > 0.0 || beyond_cap > 0.0 {
        let between = out * beyond_side.max(0.0) + up * beyond_cap.max(0.0);
        let distance = between.length();
        (between / distance, distance)
    } else if beyond_side > beyond_cap {
        (out, beyond_side)
    } else {
        (up, beyond_cap)
    };
    if gap > r1 + margin {
        return None;
    }
    let normal = cylinder.q * normal;
    let point = p - normal * (0.5 * (r1 + gap));
    Some(Touch::single(normal, r1 - gap, point))
}
// ANCHOR_END: sphere_cylinder

#[cfg(test)]
mod tests {
    use super::*;
    use ch00_maths::f32::shape::Shape;
    use glam::Quat;

    /// A ball of 0.2 m against an upright cylinder of radius 1 m and height 1 m at the origin.
    fn at(p: Vec3) -> Option<Touch> {
        let shape = Shape::Cylinder {
            radius: 1.0,
            half_height: 0.5,
        };
        let cylinder = Placed {
            shape: &shape,
            p: Vec3::ZERO,
            q: Quat::IDENTITY,
            p_before: Vec3::ZERO,
        };
        sphere_cylinder(p, 0.2, &cylinder, 1.0, 0.5, 0.0)
    }

    #[test]
    fn a_ball_on_the_cap_and_one_at_the_side() {
        let touch = at(Vec3::new(0.5, 0.65, 0.3)).unwrap();
        assert_eq!(touch.normal, Vec3::Y);
        assert!((touch.depth() - 0.05).abs() < 1e-6);
        let touch = at(Vec3::new(0.0, 0.3, -1.15)).unwrap();
        assert_eq!(touch.normal, Vec3::NEG_Z);
        assert!((touch.depth() - 0.05).abs() < 1e-6);
    }

    #[test]
    fn a_ball_at_the_rim_is_pushed_diagonally() {
        let touch = at(Vec3::new(-1.1, 0.6, 0.0)).unwrap();
        assert!((touch.normal - Vec3::new(-1.0, 1.0, 0.0).normalize()).length() < 1e-6);
        assert!((touch.depth() - (0.2 - 0.02_f32.sqrt())).abs() < 1e-6);
    }

    #[test]
    fn a_ball_inside_leaves_by_the_nearer_way() {
        let touch = at(Vec3::new(0.1, -0.3, 0.0)).unwrap();
        assert_eq!(touch.normal, Vec3::NEG_Y);
        assert!((touch.depth() - 0.4).abs() < 1e-6);
        let touch = at(Vec3::new(0.0, 0.1, 0.8)).unwrap();
        assert_eq!(touch.normal, Vec3::Z);
        assert!((touch.depth() - 0.4).abs() < 1e-6);
        assert_eq!(at(Vec3::ZERO).unwrap().normal, Vec3::Y);
    }
}
