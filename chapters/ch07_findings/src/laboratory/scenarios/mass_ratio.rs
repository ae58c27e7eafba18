//! 21: a heavy cube on one of a kilogramme.

use ch00_scenes::{Scene, builtin};

use crate::FindingsError;
use crate::lab::Moment;
use crate::laboratory::scenario::{FEW_RATES, Scenario, Verdict, Watch, timed};

const SECONDS: f64 = 10.0;

pub const HUNDRED: Scenario = Scenario {
    number: 21,
    name: "mass_ratio_100",
    title: "100 kg on 1 kg",
    watch: "The light cube hardly feels the floor push back, for all the weight above: a sweep leaves 99 % of what is missing.",
    error: "sink of the upper cube, the mean of the last second",
    unit: "m",
    one_percent: 0.01,
    scale: "of an edge",
    pass: 1.5e-3,
    fails: "fell: the upper cube is more than 0.5 m from its place",
    rates: FEW_RATES,
    scenes: |rate, _| scenes(100, rate),
    watcher: |_| Box::new(Sink::default()),
    steps: None,
    page: "ch03_limits",
};

pub const THOUSAND: Scenario = Scenario {
    name: "mass_ratio_1000",
    title: "1,000 kg on 1 kg",
    watch: "The light cube hardly feels the floor push back, for all the weight above: a sweep leaves 99.9 % of what is missing.",
    pass: 20e-3,
    scenes: |rate, _| scenes(1000, rate),
    ..HUNDRED
};

fn scenes(ratio: u64, rate: u32) -> Result<Vec<Scene>, FindingsError> {
    let scene = builtin::build("heavy_on_light", Some(ratio), None)?;
    Ok(vec![timed(scene, rate, SECONDS)])
}

/// How far the upper cube is below its place.
#[derive(Default)]
pub struct Sink {
    sum: f64,
    steps: u32,
    fell: bool,
}

impl Watch for Sink {
    fn see(&mut self, now: &Moment) {
        let upper = now.state.position[2];
        self.fell |= (upper.y - 1.5).abs() > 0.5 || upper.x.hypot(upper.z) > 0.5;
        if now.time > SECONDS - 1.0 {
            self.sum += (1.5 - upper.y).abs();
            self.steps += 1;
        }
    }

    fn verdict(&self) -> Verdict {
        if self.fell {
            return Verdict::failed("fell");
        }
        Verdict::of(self.sum / f64::from(self.steps))
    }
}
