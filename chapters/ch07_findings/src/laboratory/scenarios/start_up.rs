//! 1: a thrown point. Position Verlet that starts half a step off errs by ½ a Δt t for ever.

use ch00_scenes::Scene;
use glam::DVec3;

use super::{G, ball};
use crate::laboratory::scenario::{AtTimes, MANY_RATES, Scenario, timed};

const FROM: DVec3 = DVec3::new(0.0, 10.0, 0.0);
const SPEED: DVec3 = DVec3::new(5.0, 8.0, 0.0);
const SECONDS: f64 = 2.0;

pub const SCENARIO: Scenario = Scenario {
    number: 1,
    name: "start_up",
    title: "A thrown ball",
    watch: "Half a step is lost at the start by whoever takes v for the speed of the step before, and never made up for.",
    error: "distance from the parabola after 2 s",
    unit: "m",
    one_percent: 0.196,
    scale: "of the fall in 2 s, 19.6 m",
    pass: 1e-4,
    fails: "",
    rates: MANY_RATES,
    scenes: |rate, _| Ok(vec![scene(rate)]),
    watcher: |_| {
        Box::new(AtTimes::new([SECONDS], |now, time| {
            now.state.position[0].distance(exact(time))
        }))
    },
    steps: None,
    page: "ch02_rigid_bodies",
};

/// Where it is after so long, s.
pub fn exact(time: f64) -> DVec3 {
    FROM + SPEED * time - DVec3::Y * (0.5 * G * time * time)
}

/// The ball, and nothing else.
pub fn scene(rate: u32) -> Scene {
    let mut scene = Scene::new("start_up");
    let mut body = ball(0.1, 1.0, FROM);
    body.linear_velocity = SPEED;
    scene.bodies.push(body);
    timed(scene, rate, SECONDS)
}
