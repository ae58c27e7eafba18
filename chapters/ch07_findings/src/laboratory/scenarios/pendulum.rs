//! 9: a pendulum on a pin, from small swings to nearly upside down.

use ch00_scenes::{Joint, Scene};
use glam::DVec3;

use super::swings::Swings;
use super::{ball, block};
use crate::laboratory::scenario::{SOME_RATES, Scenario, Watch, timed};

/// Amplitudes, rad, and periods, s, of the reference.
const SWINGS: [(f64, f64); 3] = [
    (0.1, 2.007_321_191),
    (1.0, 2.139_137_601),
    (2.0, 2.665_870_943),
];
const HIGH_SWING: (f64, f64) = (3.13, 8.348_257_253);
/// Of the ball, m.
const RADIUS: f64 = 0.1;

pub const SCENARIO: Scenario = Scenario {
    number: 9,
    name: "pendulum",
    title: "A pendulum on a pin",
    watch: "A joint that gives makes the rod longer and the swing slower; one that is mended by speed changes the energy.",
    error: "mean period, the worst of swings of 0.1, 1 and 2 rad",
    unit: "",
    one_percent: 0.01,
    scale: "of the period",
    pass: 1e-3,
    fails: "no swing: it never comes back",
    rates: SOME_RATES,
    scenes: |rate, _| {
        Ok(SWINGS
            .map(|(angle, period)| timed(scene(angle), rate, 4.3 * period))
            .into())
    },
    watcher: swings,
    steps: None,
    page: "ch03_impulses",
};

pub const HIGH: Scenario = Scenario {
    name: "pendulum_high",
    title: "A pendulum that starts 0.01 rad from upside down",
    watch: "Near the top the period grows as the logarithm of the distance, so a small error of energy is a large one of time.",
    error: "mean period of a swing of 3.13 rad",
    pass: 1e-2,
    scenes: |rate, _| Ok(vec![timed(scene(HIGH_SWING.0), rate, 2.3 * HIGH_SWING.1)]),
    ..SCENARIO
};

/// A ball that hangs from a pin by its own matter, so far that it swings like a point on a rod of 1 m.
fn scene(angle: f64) -> Scene {
    // l = arm + ⅖ r² / arm = 1 m.
    let arm = 0.5 * (1.0 + (1.0 - 1.6 * RADIUS * RADIUS).sqrt());
    let mut scene = Scene::new("pendulum");
    let pivot = DVec3::Y * 3.0;
    scene.bodies.push(block(DVec3::splat(0.02), pivot));
    let way = DVec3::new(angle.sin(), -angle.cos(), 0.0) * arm;
    let mut bob = ball(RADIUS, 1.0, pivot + way);
    bob.orientation = glam::DQuat::from_rotation_z(angle);
    scene.bodies.push(bob);
    scene
        .joints
        .push(Joint::pin(0, 1, DVec3::ZERO, DVec3::Y * arm));
    scene
}

/// Looks for the period of the swing that the scene begins.
fn swings(scene: &Scene) -> Box<dyn Watch> {
    let pivot = scene.bodies[0].position;
    let angle = move |bob: DVec3| (bob.x - pivot.x).atan2(pivot.y - bob.y);
    let start = angle(scene.bodies[1].position);
    let all = SWINGS.iter().chain([&HIGH_SWING]);
    let nearest = all.min_by(|a, b| (a.0 - start).abs().total_cmp(&(b.0 - start).abs()));
    let period = nearest.map_or(f64::NAN, |known| known.1);
    Box::new(Swings::new(period, move |state| angle(state.position[1])))
}
