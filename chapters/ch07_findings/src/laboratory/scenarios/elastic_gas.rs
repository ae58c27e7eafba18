//! 18: balls in a box without gravity, that lose nothing in collisions: a gas, whose energy stays.

use ch00_scenes::Scene;
use ch00_scenes::State;
use ch00_scenes::measures::Conserved;
use ch00_scenes::random::SplitMix64;
use glam::DVec3;

use super::{ball, block, of_one_stuff};
use crate::laboratory::scenario::{Always, SOME_RATES, Scenario, timed};

/// Along an edge.
const EDGE: u32 = 5;
const RADIUS: f64 = 0.025;
/// Half of the room that the balls have, m.
const HALF: f64 = 0.25;

pub const SCENARIO: Scenario = Scenario {
    number: 18,
    name: "elastic_gas",
    title: "A gas of 125 balls",
    watch: "Every collision that is found late, or pushed apart, heats or cools it a little; thousands of them add up.",
    error: "change of energy in one second, the worst of all steps",
    unit: "",
    one_percent: 0.01,
    scale: "of the energy",
    pass: 0.01,
    fails: "heated: the energy has changed by more than 100 %",
    rates: SOME_RATES,
    scenes: |rate, _| Ok(vec![timed(scene(), rate, 1.0)]),
    watcher: |scene| {
        let scene = scene.clone();
        let at_first = Conserved::of(&scene, &State::start_of(&scene)).kinetic_energy;
        Box::new(Always::new(
            move |now| {
                let energy = Conserved::of(&scene, now.state).kinetic_energy;
                (energy / at_first - 1.0).abs()
            },
            (1.0, "heated"),
        ))
    },
    steps: None,
    page: "ch03_impulses",
};

/// Balls of equal speed, √3 m/s, in all directions, between six walls.
fn scene() -> Scene {
    let mut scene = Scene::new("elastic_gas");
    scene.gravity = DVec3::ZERO;
    scene.restitution_threshold = Some(0.0);
    for axis in DVec3::AXES {
        for side in [-1.0, 1.0] {
            let half = DVec3::splat(HALF + 1.0) - axis * (HALF + 0.5);
            scene.bodies.push(block(half, axis * (side * (HALF + 0.5))));
        }
    }
    let mut random = SplitMix64::new(42);
    let place = |k: u32| (f64::from(k) - f64::from(EDGE - 1) / 2.0) * 2.0 * HALF / f64::from(EDGE);
    for k in 0..EDGE * EDGE * EDGE {
        let at = [k % EDGE, k / EDGE % EDGE, k / EDGE / EDGE].map(place);
        let mut body = ball(RADIUS, 1.0, DVec3::from(at));
        let mut way = || 2.0 * random.unit() - 1.0;
        let along = DVec3::new(way(), way(), way()).normalize_or(DVec3::X);
        body.linear_velocity = along * 3f64.sqrt();
        scene.bodies.push(body);
    }
    of_one_stuff(&mut scene, 1.0, 0.0);
    scene
}
