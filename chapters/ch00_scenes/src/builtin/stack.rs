//! A tower of cubes on a floor, scenario 20 (there of 15): edge 1 m, 1 kg each, exactly
//! touching, μ = 0.5, e = 0.
//!
//! It should stand for ever: centres at k + ½ m, and n cubes load the contact under cube k
//! with (n − k) g. A sequential solver that starts from nothing leaves cos²(π/2n) of the
//! error at each sweep, 0.9 for 5 cubes and 0.989 for 15.

use glam::DVec3;

use super::parts::{floor, of_one_stuff};
use crate::{Body, Scene, Shape};

const EDGE: f64 = 1.0;

/// The scene: body 0 is the floor, body k + 1 cube k from below.
pub(super) fn build(cubes: u64) -> Scene {
    tower("stack", (0..cubes).map(|_| 1.0))
}

/// Cubes of these masses, kg, from below, in a scene of this name.
pub(super) fn tower(name: &str, masses: impl Iterator<Item = f64>) -> Scene {
    let mut scene = Scene::new(name);
    scene.bodies.push(floor(3.0, 3.0));
    let half_extents = DVec3::splat(EDGE / 2.0);
    let mut height = EDGE / 2.0;
    for mass in masses {
        let centre = DVec3::Y * height;
        let cube = Body::new(Shape::Box { half_extents }, mass, centre);
        scene.bodies.push(cube);
        height += EDGE;
    }
    of_one_stuff(&mut scene.bodies, 0.0, 0.5);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Placed, depth};

    #[test]
    fn each_cube_touches_the_one_below_exactly() {
        let scene = build(100);
        let state = State::start_of(&scene);
        for i in 1..scene.bodies.len() {
            let [below, above] = [i - 1, i].map(|i| Placed::new(&scene, &state, i));
            assert_eq!(depth(&below, &above), Some(0.0), "cube {i}");
        }
    }

    #[test]
    fn fifteen_cubes_stand_as_in_the_reference() {
        let scene = build(15);
        assert_eq!(scene.bodies[15].position, DVec3::Y * 14.5);
        let weight: f64 = scene.bodies.iter().map(|body| body.mass * 9.81).sum();
        assert!((weight - 147.15).abs() < 1e-12, "{weight}");
    }
}
