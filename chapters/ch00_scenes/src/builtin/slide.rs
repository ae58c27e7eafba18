//! Boxes that slide to rest in different directions, scenario 15: 4 m/s, μ = 0.5, every 7.5°
//! from x to −z.
//!
//! Each should stop after v²/(2μg) = 1.630 989 m and 0.815 494 s, straight on. They start on
//! a circle of 4 m and move outwards, so that they should stop on one of 5.630 989 m: a solver
//! that limits friction along x and along z by itself bends the arc inwards, at 45° by
//! 0.48 m. Every box lies along its own way, so nothing but such a solver tells them apart.

use glam::{DQuat, DVec3};

use super::parts::{floor, of_one_stuff};
use crate::{Body, Scene, Shape};

/// How many boxes, and the angle between two of them, degrees.
const BOXES: u32 = 13;
const BETWEEN: f64 = 7.5;
const START_RADIUS: f64 = 4.0;

/// The scene: body 0 is the floor, body k + 1 the box that moves at 7.5° · k.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("slide");
    scene.steps = 90;
    let mut ground = floor(4.0, 4.0);
    ground.position += DVec3::new(3.0, 0.0, -3.0);
    scene.bodies.push(ground);
    // Low, so that it can't tip.
    let half_extents = DVec3::new(0.15, 0.05, 0.15);
    scene.bodies.extend((0..BOXES).map(|k| {
        let orientation = DQuat::from_rotation_y((BETWEEN * f64::from(k)).to_radians());
        let ahead = orientation * DVec3::X;
        let place = START_RADIUS * ahead + half_extents.y * DVec3::Y;
        Body {
            orientation,
            linear_velocity: 4.0 * ahead,
            ..Body::new(Shape::Box { half_extents }, 1.0, place)
        }
    }));
    of_one_stuff(&mut scene.bodies, 0.0, 0.5);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::Penetration;

    #[test]
    fn the_boxes_lie_on_the_floor_and_don_t_touch_each_other() {
        let scene = build();
        let found = Penetration::of(&scene, &State::start_of(&scene));
        // Rounding may leave a box 1e-17 m deep in the floor.
        assert!(found.deepest < 1e-15, "{found:?}");
    }

    #[test]
    fn the_last_box_moves_towards_minus_z() {
        let velocity = build().bodies[13].linear_velocity;
        assert!(velocity.distance(DVec3::NEG_Z * 4.0) < 1e-15, "{velocity}");
    }
}
