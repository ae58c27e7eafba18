//! From how many bodies on a round trip is worth it.

use super::sample::Sample;
use crate::draw;

/// Where two curves meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Crossover {
    /// The round trip takes less from so many bodies on.
    At(f64),
    /// It takes less from the fewest on.
    Below(f64),
    /// It doesn't up to the most.
    Beyond(f64),
}

impl Crossover {
    /// From how many bodies on the round trip takes less time: between two samples, along a line through
    /// them with both axes by powers of ten.
    #[must_use]
    pub fn of(samples: &[Sample]) -> Self {
        let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
            return Crossover::Beyond(0.0);
        };
        let gain = |sample: &Sample| sample.gain().ln();
        if gain(first) >= 0.0 {
            return Crossover::Below(first.bodies);
        }
        let mut pairs = samples.windows(2);
        let found = pairs.find(|pair| gain(&pair[0]) < 0.0 && gain(&pair[1]) >= 0.0);
        found.map_or(Crossover::Beyond(last.bodies), |pair| {
            let [before, after] = [&pair[0], &pair[1]].map(gain);
            let [few, many] = [&pair[0], &pair[1]].map(|sample| sample.bodies.ln());
            Crossover::At((few - before * (many - few) / (after - before)).exp())
        })
    }

    /// In words.
    #[must_use]
    pub fn text(self) -> String {
        match self {
            Crossover::At(bodies) => format!("worth it from about {} bodies on", grouped(bodies)),
            Crossover::Below(bodies) => {
                format!("worth it from {} bodies on, or fewer", grouped(bodies))
            }
            Crossover::Beyond(bodies) => format!("not worth it up to {} bodies", grouped(bodies)),
        }
    }
}

/// A number of bodies, 12,345.
#[must_use]
pub fn grouped(bodies: f64) -> String {
    draw::grouped(&format!("{:.0}", bodies.floor()))
}
