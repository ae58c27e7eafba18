//! Boxes on slopes about the angle of friction: with μ = 0.5, static and kinetic, a box
//! slips exactly above arctan 0.5 = 26.565°.
//!
//! The slopes are 2° and 0.5° below that angle φ and 0.5° and 2° above it. On the first two
//! a box stays where it is; on the others it gains a = g (sin θ − μ cos θ) = g sin(θ − φ)/cos φ:
//! 0.095 712 m/s² and 0.382 775 m/s², that is 0.191 424 m and 0.765 549 m in 2 s.

use glam::DVec3;

use super::parts::{Slope, floor, of_one_stuff};
use crate::{Body, Scene, Shape};

const FRICTION: f64 = 0.5;
/// Angles of the slopes above the angle of friction, degrees.
const ABOVE: [f64; 4] = [-2.0, -0.5, 0.5, 2.0];
/// Half of the length of a slope, m; a box starts `START` up from its middle.
const HALF_LENGTH: f64 = 2.0;
const START: f64 = 1.2;

/// The scene: slope k of the four, from the flattest, is body 2 k and its box body 2 k + 1;
/// the floor under them is last. Down is towards +x.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("incline");
    scene.steps = 120;
    // Flat, so that it doesn't tip.
    let half_extents = DVec3::new(0.2, 0.1, 0.2);
    for (k, above) in ABOVE.into_iter().enumerate() {
        let angle = libm::atan(FRICTION) + above.to_radians();
        let slope = Slope::new(angle, HALF_LENGTH, 1.1 * (k as f64 - 1.5));
        let place = slope.point(-START, half_extents.y);
        let block = Body {
            orientation: slope.orientation(),
            ..Body::new(Shape::Box { half_extents }, 1.0, place)
        };
        scene.bodies.extend([slope.body(0.4), block]);
    }
    scene.bodies.push(floor(3.0, 3.0));
    of_one_stuff(&mut scene.bodies, 0.0, FRICTION);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Placed, depth};

    #[test]
    fn every_box_lies_flat_on_its_slope() {
        let scene = build();
        let state = State::start_of(&scene);
        for k in 0..4 {
            let [slope, block] = [2 * k, 2 * k + 1].map(|i| Placed::new(&scene, &state, i));
            let depth = depth(&slope, &block).unwrap();
            assert!(depth.abs() < 1e-15, "{depth}");
            assert_eq!(slope.orientation, block.orientation);
        }
    }

    #[test]
    fn weight_pulls_less_than_friction_holds_on_the_first_two_slopes_only() {
        let gains = [0, 2, 4, 6].map(|i| {
            let down = build().bodies[i].orientation * DVec3::X;
            9.81 * (-down.y - FRICTION * down.x)
        });
        assert!(gains[0] < -0.38 && gains[1] < -0.095, "{gains:?}");
        assert!((gains[2] - 0.095_712).abs() < 1e-6, "{gains:?}");
        assert!((gains[3] - 0.382_775).abs() < 1e-6, "{gains:?}");
    }
}
