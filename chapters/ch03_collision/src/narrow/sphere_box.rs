//! A ball and a box: clamp the ball's centre to the box, and look how far away that is.
//!
//! That is wrong where the ball has gone too far in a step: the centre is inside the box, or past
//! a corner and behind a face that it never saw. Then the face decides from which it came.

use glam::Vec3;

use super::{Placed, Touch};

// ANCHOR: sphere_box
/// The ball `ball` of this radius against the box `block` with these half-extents, m; found if the
/// gap between them is at most `margin`.
#[must_use]
pub fn sphere_box(
    ball: &Placed,
    radius: f32,
    block: &Placed,
    half: Vec3,
    margin: f32,
) -> Option<Touch> {
    let to_block = block.q.conjugate();
    let centre = to_block * (ball.p - block.p);
    let nearest = centre.clamp(-half, half);
    let between = centre - nearest;
    let squared = between.length_squared();
    let reach = radius + margin;
    if squared > reach * reach {
        return None;
    }
    let before = to_block * (ball.p_before - block.p_before);
    let (normal, gap) = if squared > 0.0 && came_from_there(before, nearest, between, half) {
        let distance = squared.sqrt();
        (between / distance, distance)
    } else {
        way_out(centre, before, half)
    };
    if gap > reach {
        return None;
    }
    let normal = block.q * normal;
    let point = ball.p - normal * (0.5 * (radius + gap));
    Some(Touch::single(normal, radius - gap, point))
}

// ANCHOR_END: sphere_box

// ANCHOR: way_out
/// Whether the centre was in front of the contact plane a step ago, or inside then too.
fn came_from_there(before: Vec3, nearest: Vec3, between: Vec3, half: Vec3) -> bool {
    let was_inside = before.abs().cmple(half).all();
    was_inside || (before - nearest).dot(between) >= 0.0
}

/// The outward normal of the face to leave by, and how far in front of it the centre is, m.
fn way_out(centre: Vec3, before: Vec3, half: Vec3) -> (Vec3, f32) {
    let outside = before.abs() - half;
    let axis = if outside.max_element() > 0.0 {
        outside.max_position()
    } else {
        (centre.abs() - half).max_position()
    };
    let came = if outside[axis] > 0.0 { before } else { centre };
    let side = if came[axis] < 0.0 { -1.0 } else { 1.0 };
    (Vec3::AXES[axis] * side, side * centre[axis] - half[axis])
}
// ANCHOR_END: way_out

#[cfg(test)]
mod tests {
    use super::*;
    use ch00_maths::f32::shape::Shape;
    use glam::Quat;

    const HALF: Vec3 = Vec3::new(2.0, 0.5, 2.0);

    fn at(p: Vec3, p_before: Vec3) -> Option<Touch> {
        let ball = Shape::Sphere { radius: 0.2 };
        let block = Shape::Box { half_extents: HALF };
        let placed = |shape, p, p_before| Placed {
            shape,
            p,
            q: Quat::IDENTITY,
            p_before,
        };
        sphere_box(
            &placed(&ball, p, p_before),
            0.2,
            &placed(&block, Vec3::ZERO, Vec3::ZERO),
            HALF,
            0.0,
        )
    }

    #[test]
    fn a_ball_on_a_face() {
        let p = Vec3::new(0.3, 0.65, 0.0);
        let touch = at(p, p).unwrap();
        assert_eq!(touch.normal, Vec3::Y);
        assert!((touch.depth() - 0.05).abs() < 1e-6);
        assert!((touch.spots()[0].point - Vec3::new(0.3, 0.475, 0.0)).length() < 1e-6);
    }

    #[test]
    fn a_ball_at_an_edge_is_pushed_diagonally() {
        let p = Vec3::new(2.1, 0.6, 0.0);
        let touch = at(p, p).unwrap();
        assert!((touch.normal - Vec3::new(1.0, 1.0, 0.0).normalize()).length() < 1e-6);
        assert!((touch.depth() - (0.2 - 0.02_f32.sqrt())).abs() < 1e-6);
    }

    #[test]
    fn a_ball_that_fell_past_the_middle_leaves_by_the_face_it_came_through() {
        let touch = at(Vec3::new(0.0, -0.3, 0.0), Vec3::new(0.0, 0.9, 0.0)).unwrap();
        assert_eq!(touch.normal, Vec3::Y);
        assert!((touch.depth() - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_ball_that_flew_past_a_corner_is_not_pushed_from_behind() {
        // It came from the right of the block and is now below its lower face, still at its right
        // half.
        let touch = at(Vec3::new(1.8, -0.6, 0.0), Vec3::new(2.5, 0.3, 0.0)).unwrap();
        assert_eq!(touch.normal, Vec3::X);
        assert!((touch.depth() - 0.4).abs() < 1e-6);
    }

    #[test]
    fn a_ball_that_started_inside_leaves_by_the_nearest_face() {
        let p = Vec3::new(1.9, 0.1, 0.0);
        assert_eq!(at(p, p).unwrap().normal, Vec3::X);
    }
}
