//! Three pairs of balls that collide, scenario 16, without gravity: 1 kg and 0.1 m on 2 kg
//! and 0.2 m, the normal along x, e = 0.8.
//!
//! | pair | before | after |
//! |---|---|---|
//! | sticks, μ = 0.5 | v₁ (3, 1, 0), ω₁ (0, 0, 5) | v₁ (−1.8, 5/7, 0), v₂ (1.4, 1/7, 0), ω₁z −15/7, ω₂z −25/14 |
//! | slips, μ = 0.1 | v₁ (3, 4, 1), ω₁ (0, 10, 5) | v₁ (−1.8, 3.52, 1), v₂ (1.4, 0.24, 0), ω₁ (0, 10, −7), ω₂z −3 |
//! | head-on | v₁ (3, 0, 0) | v₁ (−1.8, 0, 0), v₂ (1.4, 0, 0) |
//!
//! v₂ is (−1, 0, 0) before. The pairs start one step of 1/60 s before they meet, so that a
//! method which moves bodies and then looks for contacts finds them touching, with a normal
//! that is x exactly. They are a micrometre deep then, so that rounding can't leave a gap.

use glam::DVec3;

use super::parts::of_one_stuff;
use crate::{Body, Scene, Shape};

/// Radii of the balls of a pair, m.
const RADII: [f64; 2] = [0.1, 0.2];
/// How deep they overlap after the first step, m.
const DEPTH: f64 = 1e-6;

/// The scene: bodies 0 and 1 stick, 2 and 3 slip, 4 and 5 meet head-on.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("oblique");
    scene.gravity = DVec3::ZERO;
    scene.steps = 60;
    scene.restitution_threshold = Some(0.0);
    let pairs = [
        (0.5, DVec3::new(3.0, 1.0, 0.0), DVec3::Z * 5.0),
        (0.1, DVec3::new(3.0, 4.0, 1.0), DVec3::new(0.0, 10.0, 5.0)),
        (0.5, DVec3::new(3.0, 0.0, 0.0), DVec3::ZERO),
    ];
    for ((friction, velocity, spin), z) in pairs.into_iter().zip([-3.0, 0.0, 3.0]) {
        let mut pair = pair(velocity, spin, scene.dt);
        for body in &mut pair {
            body.position.z += z;
        }
        of_one_stuff(&mut pair, 0.8, friction);
        scene.bodies.extend(pair);
    }
    scene
}

/// Two balls that in `dt` will touch at the origin, the first with this velocity and spin.
fn pair(velocity: DVec3, spin: DVec3, dt: f64) -> [Body; 2] {
    let velocities = [velocity, DVec3::NEG_X];
    let spins = [spin, DVec3::ZERO];
    let centres = [-RADII[0], RADII[1] - DEPTH];
    [0, 1].map(|i| {
        let shape = Shape::Sphere { radius: RADII[i] };
        let place = DVec3::X * centres[i] - velocities[i] * dt;
        Body {
            linear_velocity: velocities[i],
            angular_velocity: spins[i],
            ..Body::new(shape, [1.0, 2.0][i], place)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn after_one_step_each_pair_touches_along_x() {
        let scene = build();
        let places = scene
            .bodies
            .iter()
            .map(|body| body.position + body.linear_velocity * scene.dt);
        let places: Vec<_> = places.collect();
        for pair in places.chunks_exact(2) {
            let between = pair[1] - pair[0];
            assert!(between.distance(DVec3::X * (0.3 - DEPTH)) < 1e-15);
        }
    }

    #[test]
    fn momentum_is_that_of_the_reference() {
        // 3 − 2 = 1 N s along x for each pair.
        let momentum: DVec3 = build()
            .bodies
            .iter()
            .map(|body| body.mass * body.linear_velocity)
            .sum();
        assert_eq!(momentum, DVec3::new(3.0, 5.0, 1.0));
    }
}
