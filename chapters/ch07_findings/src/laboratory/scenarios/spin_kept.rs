//! 6: a ball that spins about its axis, undisturbed, should go on. XPBD's reading of the spin loses a share of
//! it in every step.

use ch00_scenes::Scene;
use glam::DVec3;

use super::{ball, share};
use crate::laboratory::scenario::{AtTimes, MANY_RATES, Scenario, timed};

const SPIN: f64 = 10.0;

pub const SCENARIO: Scenario = Scenario {
    number: 6,
    name: "spin_kept",
    title: "A ball that spins",
    watch: "Reading the spin from two attitudes by the sine of half the angle takes a little of it away each time.",
    error: "loss of spin in one second, of 10 rad/s",
    unit: "",
    one_percent: 0.01,
    scale: "of the spin",
    pass: 1e-4,
    fails: "",
    rates: MANY_RATES,
    scenes: |rate, _| Ok(vec![timed(spinning(SPIN), rate, 1.0)]),
    watcher: |_| {
        Box::new(AtTimes::new([1.0], |now, _| {
            share(now.state.angular_velocity[0].y, SPIN)
        }))
    },
    steps: None,
    page: "errata",
};

/// A ball that spins about y, rad/s.
pub fn spinning(spin: f64) -> Scene {
    let mut scene = Scene::new("spinning");
    scene.gravity = DVec3::ZERO;
    let mut body = ball(0.1, 1.0, DVec3::ZERO);
    body.angular_velocity = DVec3::Y * spin;
    scene.bodies.push(body);
    scene
}
