//! 2: the same throw in steps of which every second is twice as long.

use glam::DVec3;

use super::start_up;
use crate::lab::Moment;
use crate::laboratory::scenario::{MANY_RATES, Scenario, Verdict, Watch};

pub const SCENARIO: Scenario = Scenario {
    number: 2,
    name: "uneven_steps",
    title: "A thrown ball in uneven steps",
    watch: "A step whose length changes is taken for a change of speed by a method that stores where it was, not how fast it is.",
    error: "distance from the parabola after 2 s of steps of Δt and 2Δt in turn",
    unit: "m",
    one_percent: 0.196,
    scale: "of the fall in 2 s, 19.6 m",
    pass: 1e-4,
    fails: "",
    rates: MANY_RATES,
    scenes: |rate, _| Ok(vec![start_up::scene(rate)]),
    watcher: |_| Box::new(AtTheEnd { last: DVec3::NAN }),
    steps: Some(steps),
    page: "errata",
};

/// Of 1/rate and 2/rate in turn, as many as fill two seconds.
fn steps(rate: u32) -> Vec<f64> {
    let short = f64::from(rate).recip();
    let pairs = (2.0 / (3.0 * short)).round() as usize;
    [short, 2.0 * short].repeat(pairs)
}

struct AtTheEnd {
    last: DVec3,
}

impl Watch for AtTheEnd {
    fn see(&mut self, now: &Moment) {
        self.last = now.state.position[0] - start_up::exact(now.time);
    }

    fn verdict(&self) -> Verdict {
        Verdict::of(self.last.length())
    }
}
