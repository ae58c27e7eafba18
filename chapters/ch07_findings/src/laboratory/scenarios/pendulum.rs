//! 9: a pendulum on a pin, from small swings to nearly upside down.

use ch00_scenes::{Joint, Scene};
use glam::DVec3;

use super::{ball, block, share};
use crate::lab::Moment;
use crate::laboratory::scenario::{SOME_RATES, Scenario, Verdict, Watch, timed};

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
    pass: 1e-3,
    rates: SOME_RATES,
    scenes: |rate, _| {
        Ok(SWINGS
            .map(|(angle, period)| timed(scene(angle), rate, 4.3 * period))
            .into())
    },
    watcher: |scene| Box::new(Swings::of(scene)),
    steps: None,
    page: "ch03_impulses",
};

pub const HIGH: Scenario = Scenario {
    name: "pendulum_high",
    title: "A pendulum that starts 0.01 rad from upside down",
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

/// When it goes through the lowest point.
struct Swings {
    pivot: DVec3,
    period: f64,
    /// Time and side after the last step.
    last: Option<(f64, f64)>,
    /// Times, s.
    crossings: Vec<f64>,
}

impl Swings {
    fn of(scene: &Scene) -> Self {
        let pivot = scene.bodies[0].position;
        let way = scene.bodies[1].position - pivot;
        let angle = way.x.atan2(-way.y);
        let all = SWINGS.iter().chain([&HIGH_SWING]);
        let nearest = all.min_by(|a, b| (a.0 - angle).abs().total_cmp(&(b.0 - angle).abs()));
        Self {
            pivot,
            period: nearest.map_or(f64::NAN, |known| known.1),
            last: None,
            crossings: Vec::new(),
        }
    }
}

impl Watch for Swings {
    fn see(&mut self, now: &Moment) {
        let way = now.state.position[1] - self.pivot;
        let side = way.x.atan2(-way.y);
        if let Some((time, last)) = self.last
            && last * side < 0.0
            && last.abs() < 1.5
        {
            self.crossings
                .push(time + (now.time - time) * last / (last - side));
        }
        self.last = Some((now.time, side));
    }

    fn verdict(&self) -> Verdict {
        let halves = self.crossings.len().saturating_sub(1) / 2 * 2;
        if halves == 0 {
            return Verdict::failed("no swing");
        }
        let mean = 2.0 * (self.crossings[halves] - self.crossings[0]) / halves as f64;
        Verdict::of(share(mean, self.period))
    }
}
