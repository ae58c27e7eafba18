//! 19: 216 heavy balls without friction or bounce, let go in a cube: they run out into a layer.

use ch00_scenes::Scene;
use ch00_scenes::random::SplitMix64;
use glam::DVec3;

use super::{ball, floor, of_one_stuff};
use crate::lab::Moment;
use crate::laboratory::scenario::{FEW_RATES, Scenario, Verdict, Watch, timed};

const RADIUS: f64 = 0.1;
const SPACING: f64 = 0.21;

pub const SCENARIO: Scenario = Scenario {
    number: 19,
    name: "pile",
    title: "216 balls run out of a cube",
    watch: "All overlaps are squared and summed, so one ball that sinks counts more than a hundred that touch.",
    error: "sum of squared overlaps, the mean over all steps",
    unit: "m²",
    one_percent: 2.16e-4,
    scale: "as if 216 balls overlapped by 1 % of their radius each",
    pass: 0.0152,
    fails: "",
    rates: FEW_RATES,
    scenes: |rate, quick| Ok(vec![timed(scene(), rate, if quick { 3.0 } else { 10.0 })]),
    watcher: |_| Box::new(Overlaps { sum: 0.0, steps: 0 }),
    steps: None,
    page: "ch03_contacts",
};

fn scene() -> Scene {
    let mut scene = Scene::new("pile");
    scene.bodies.push(floor(30.0));
    let mut random = SplitMix64::new(42);
    for (i, j, k) in places() {
        let mut jitter = || 1e-3 * random.unit();
        let at = DVec3::new(f64::from(i), f64::from(j), f64::from(k)) * SPACING;
        let at = at + DVec3::new(jitter(), jitter() + 0.101, jitter());
        scene.bodies.push(ball(RADIUS, 10.0, at));
    }
    of_one_stuff(&mut scene, 0.0, 0.0);
    scene
}

fn places() -> impl Iterator<Item = (u32, u32, u32)> {
    (0..216).map(|n| (n / 36, n / 6 % 6, n % 6))
}

struct Overlaps {
    sum: f64,
    steps: u32,
}

impl Watch for Overlaps {
    fn see(&mut self, now: &Moment) {
        let balls = &now.state.position[1..];
        let squared = |overlap: f64| overlap.max(0.0).powi(2);
        for (k, one) in balls.iter().enumerate() {
            self.sum += squared(RADIUS - one.y);
            for other in &balls[k + 1..] {
                let apart = one.distance_squared(*other);
                if apart < 4.0 * RADIUS * RADIUS {
                    self.sum += squared(2.0 * RADIUS - apart.sqrt());
                }
            }
        }
        self.steps += 1;
    }

    fn verdict(&self) -> Verdict {
        Verdict::of(self.sum / f64::from(self.steps))
    }
}
