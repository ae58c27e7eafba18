//! How long each part of a step takes.

use ch00_scenes::PassTime;
use web_time::Instant;

/// Notes the time since the last note, under a name.
pub struct PassClock {
    since: Instant,
    times: Vec<PassTime>,
}

impl PassClock {
    /// Starts to count.
    #[must_use]
    pub fn start() -> Self {
        Self {
            since: Instant::now(),
            times: Vec::with_capacity(8),
        }
    }

    /// What was done since the last note was `name`.
    pub fn note(&mut self, name: &'static str) {
        let now = Instant::now();
        let time = now - self.since;
        self.since = now;
        self.times.push(PassTime { name, time });
    }

    /// All notes, in order.
    #[must_use]
    pub fn times(self) -> Vec<PassTime> {
        self.times
    }
}
