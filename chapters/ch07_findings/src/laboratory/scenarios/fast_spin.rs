//! 7: spins that come near or past half a turn a step, and what is read of them.

use ch00_scenes::Scene;

use super::share;
use super::spin_kept::spinning;
use crate::lab::Moment;
use crate::laboratory::scenario::{AtTimes, MANY_RATES, Scenario, timed};

/// rad/s; half a turn in 1/60 s is 188.5.
const SPINS: [f64; 6] = [100.0, 180.0, 200.0, 300.0, 376.0, 377.0];

pub const SCENARIO: Scenario = Scenario {
    number: 7,
    name: "fast_spin",
    title: "Balls that spin at up to 60 turns a second",
    watch: "Past half a turn a step a spin that is read from attitudes is another one; at a whole turn it stands still.",
    error: "spin after a tenth of a second, the worst of 100 to 377 rad/s",
    unit: "",
    one_percent: 0.01,
    scale: "of the spin",
    pass: 1e-4,
    fails: "",
    rates: MANY_RATES,
    scenes: |rate, _| Ok(SPINS.map(|spin| timed(spinning(spin), rate, 0.1)).into()),
    watcher: |scene| Box::new(spin_read(scene)),
    steps: None,
    page: "errata",
};

/// The error of the spin that is read after a tenth of a second, as a share of what it is.
pub fn spin_read(scene: &Scene) -> AtTimes<impl Fn(&Moment, f64) -> f64 + use<>> {
    let spin = scene.bodies[0].angular_velocity.y;
    AtTimes::new([0.1], move |now, _| {
        share(now.state.angular_velocity[0].y, spin)
    })
}
