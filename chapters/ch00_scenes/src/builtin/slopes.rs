//! A ball that rolls and a ball that slips, scenario 14 A: radius 0.5 m, from rest, down
//! slopes of 20° with μ = 0.5 and of 60° with μ = 0.3.
//!
//! A solid ball rolls while tan θ ≤ 7μ/2, which is up to 60.26° and 46.40° here. Rolling,
//! it gains a = 5/7 g sin θ: 1.198 292 m and 4.793 168 rad/s in 1 s. Slipping, it gains
//! a = g (sin θ − μ cos θ) and a spin of 5/2 μ g cos θ / r: 3.512 105 m and 7.3575 rad/s.

use glam::DVec3;

use super::parts::{Slope, floor, of_one_stuff};
use crate::{Body, Scene, Shape};

const RADIUS: f64 = 0.5;
/// Half of the length of a slope, m; a ball starts `START` up from its middle.
const HALF_LENGTH: f64 = 4.0;
const START: f64 = 3.0;

/// The scene: bodies 0 and 1 are the slope of 20° and its ball, 2 and 3 those of 60°; the
/// floor under them is last. Down is towards +x.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("slopes");
    // After 1.4 s the slipping ball is at the end of its slope.
    scene.steps = 80;
    for (degrees, friction, z) in [(20.0_f64, 0.5, -1.2), (60.0, 0.3, 1.2)] {
        let slope = Slope::new(degrees.to_radians(), HALF_LENGTH, z);
        let shape = Shape::Sphere { radius: RADIUS };
        let ball = Body::new(shape, 1.0, slope.point(-START, RADIUS));
        let mut pair = [slope.body(0.8), ball];
        of_one_stuff(&mut pair, 0.0, friction);
        scene.bodies.extend(pair);
    }
    let mut ground = floor(6.0, 3.0);
    ground.position += DVec3::X;
    scene.bodies.push(ground);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Placed, depth};

    #[test]
    fn both_balls_touch_their_slopes() {
        let scene = build();
        let state = State::start_of(&scene);
        for pair in [[0, 1], [2, 3]] {
            let [slope, ball] = pair.map(|i| Placed::new(&scene, &state, i));
            let depth = depth(&slope, &ball).unwrap();
            assert!(depth.abs() < 1e-15, "{depth}");
        }
    }

    #[test]
    fn the_slopes_fall_towards_x_at_their_angles() {
        for (i, degrees) in [(0, 20.0_f64), (2, 60.0)] {
            let down = build().bodies[i].orientation * DVec3::X;
            assert!(down.x > 0.0 && (down.y + degrees.to_radians().sin()).abs() < 1e-15);
        }
    }
}
