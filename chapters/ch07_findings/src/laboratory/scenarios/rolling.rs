//! 14: a ball on a slope of 20°, where it rolls, and on one of 60°, where it slips.

use ch00_scenes::Scene;
use glam::DVec3;

use super::{G, ball, floor, of_one_stuff, share};
use crate::laboratory::scenario::{AtTimes, SOME_RATES, Scenario, timed};

/// m.
pub const RADIUS: f64 = 0.5;
/// Of the slope, rad, μ, the way, m, and the spin, rad/s, after 1 s.
const SLOPES: [(f64, f64, f64, f64); 2] = [
    (20.0, 0.5, 1.198_292_002, 4.793_168_009),
    (60.0, 0.3, 3.512_104_606, 7.357_5),
];

pub const SCENARIO: Scenario = Scenario {
    number: 14,
    name: "rolling",
    title: "A ball on a slope",
    watch: "It rolls while tan θ ≤ 7μ/2 and slips beyond, and turns then by what friction is left.",
    error: "way and spin after 1 s on slopes of 20° and 60°, the worst of the four",
    unit: "",
    one_percent: 0.01,
    scale: "of what is exact",
    pass: 1e-3,
    fails: "",
    rates: SOME_RATES,
    scenes: |rate, _| {
        Ok(SLOPES
            .map(|(degrees, friction, _, _): (f64, _, _, _)| {
                timed(scene(degrees.to_radians(), friction), rate, 1.0)
            })
            .into())
    },
    watcher: |scene| {
        let friction = scene.bodies[1].friction;
        Box::new(AtTimes::new([1.0], move |now, _| {
            let known = SLOPES.iter().find(|known| known.1 == friction);
            let (way, spin) = known.map_or((f64::NAN, f64::NAN), |known| (known.2, known.3));
            let state = now.state;
            share(state.position[1].x, way).max(share(-state.angular_velocity[1].z, spin))
        }))
    },
    steps: None,
    page: "ch03_friction",
};

/// A ball on a slope, rad, of some μ. The floor is level and gravity leans: that is the same, and no attitude
/// is rounded.
pub fn scene(slope: f64, friction: f64) -> Scene {
    let mut scene = Scene::new("rolling");
    scene.gravity = DVec3::new(slope.sin(), -slope.cos(), 0.0) * G;
    scene.bodies.push(floor(20.0));
    scene.bodies.push(ball(RADIUS, 1.0, DVec3::Y * RADIUS));
    of_one_stuff(&mut scene, 0.0, friction);
    scene
}
