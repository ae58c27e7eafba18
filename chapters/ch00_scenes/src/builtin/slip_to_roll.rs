//! A ball that slides and comes to roll, scenario 13: radius 0.5 m, 4 m/s, no spin, μ = 0.3.
//!
//! Friction brakes the ball and turns it, until at t = 2v/(7μg) = 0.388 331 s the point that
//! touches the floor is at rest. From then on v = 20/7 m/s and ω = 40/7 rad/s: the angular
//! momentum about a point of the floor is kept, so v is 5/7 of what it was, whatever μ is.
//! After 1 s the ball is at x = 3.079 046 m.

use glam::DVec3;

use super::parts::{floor, of_one_stuff};
use crate::{Body, Scene, Shape};

const RADIUS: f64 = 0.5;

/// The scene: body 0 is the floor, 1 the ball, which moves along x from x = 0.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("slip_to_roll");
    // The ball stays on the floor for 3.7 s.
    scene.steps = 180;
    let shape = Shape::Sphere { radius: RADIUS };
    let ball = Body {
        linear_velocity: DVec3::X * 4.0,
        ..Body::new(shape, 1.0, DVec3::Y * RADIUS)
    };
    let mut lane = floor(6.0, 1.5);
    lane.position.x = 5.0;
    scene.bodies = vec![lane, ball];
    of_one_stuff(&mut scene.bodies, 0.0, 0.3);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Placed, depth};

    #[test]
    fn the_ball_touches_the_floor_exactly() {
        let scene = build();
        let state = State::start_of(&scene);
        let [lane, ball] = [0, 1].map(|i| Placed::new(&scene, &state, i));
        assert_eq!(depth(&lane, &ball), Some(0.0));
    }
}
