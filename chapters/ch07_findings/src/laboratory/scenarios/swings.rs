//! The mean period of something that swings: from when it goes through the middle, between two steps by a
//! straight line.

use ch00_scenes::State;

use super::share;
use crate::lab::Moment;
use crate::laboratory::scenario::{Verdict, Watch};

/// Farther than this from the middle a change of sign is no way through it, rad: the pendulum went over the top.
const OVER: f64 = 1.5;

/// Compares a mean period with the exact one.
pub struct Swings<S> {
    /// s.
    period: f64,
    /// How far out it is, and on which side.
    side: S,
    /// Time and side after the last step.
    last: Option<(f64, f64)>,
    /// When it was in the middle, s.
    crossings: Vec<f64>,
}

impl<S: Fn(&State) -> f64> Swings<S> {
    /// Nothing seen yet.
    pub fn new(period: f64, side: S) -> Self {
        Self {
            period,
            side,
            last: None,
            crossings: Vec::new(),
        }
    }
}

impl<S: Fn(&State) -> f64> Watch for Swings<S> {
    fn see(&mut self, now: &Moment) {
        let side = (self.side)(now.state);
        if let Some((time, last)) = self.last
            && last * side < 0.0
            && last.abs() < OVER
        {
            let middle = time + (now.time - time) * last / (last - side);
            self.crossings.push(middle);
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
