//! A run as the laboratory makes it: a scene on the book's engine, each step timed alone and looked
//! at when it is over.

use std::time::{Duration, Instant};

use ch00_scenes::{Engine, Scene, Settings, State};
use ch04_ragdolls::ENGINE;

use crate::FindingsError;
use crate::chart::Style;

/// The methods that are compared, with how their curves look.
pub const METHODS: [(&str, Style); 2] =
    [("printed", Style::Printed), ("corrected", Style::Corrected)];

/// What there is to look at after a step.
pub struct Moment<'a> {
    /// Number of the step, from 1.
    pub step: u32,
    /// Since the start, s.
    pub time: f64,
    /// Where everything is.
    pub state: &'a State,
    /// Who made the step.
    pub engine: &'a dyn Engine,
}

/// Makes the scene's steps; gives the time that each took.
///
/// # Errors
/// [`FindingsError::Load`] where the engine can't take the scene.
pub fn run(
    scene: &Scene,
    settings: &Settings,
    mut look: impl FnMut(&Moment),
) -> Result<Vec<Duration>, FindingsError> {
    let mut engine = (ENGINE.load)(scene, settings)?;
    let mut state = State::default();
    let mut times = Vec::with_capacity(scene.steps as usize);
    for step in 1..=scene.steps {
        let start = Instant::now();
        engine.step(scene.dt as f32);
        times.push(start.elapsed());
        engine.read_state(&mut state);
        look(&Moment {
            step,
            time: f64::from(step) * scene.dt,
            state: &state,
            engine: &*engine,
        });
    }
    Ok(times)
}

/// A method with its default number of sweeps.
pub fn by(method: &str) -> Settings {
    Settings::defaults().with_method(method)
}

/// The scene at so many steps a second for so long, s.
pub fn at_rate(scene: Scene, rate: f64, seconds: f64) -> Scene {
    Scene {
        dt: rate.recip(),
        steps: (rate * seconds).round() as u32,
        ..scene
    }
}

/// The one in the middle; of two, the larger. NaN of none.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Steps of a turn, where several engines run the same scene. A processor that has just made the same
/// step for another engine knows by heart which way its branches go, and is up to twice as fast as it
/// would be: the next one must come when it has forgotten.
pub const TURN: u32 = 50;

/// Whose turn it is to make how many steps, until all have made as many. Each is the first in turn.
pub fn turns(steps: u32, engines: usize) -> impl Iterator<Item = (usize, u32)> {
    let rounds = (0..steps.div_ceil(TURN)).zip(0..);
    rounds.flat_map(move |(round, first)| {
        let turn = TURN.min(steps - TURN * round);
        (0..engines).map(move |k| ((first + k) % engines, turn))
    })
}

/// Values in short: the one in the middle, and how far they lie apart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// The one in the middle.
    pub median: f64,
    /// One at the lower end.
    pub low: f64,
    /// One at the upper end.
    pub high: f64,
}

impl Spread {
    /// From the least to the largest.
    pub fn of_all(values: &[f64]) -> Self {
        Self {
            median: median(values.iter().copied()),
            low: values.iter().copied().fold(f64::INFINITY, f64::min),
            high: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        }
    }

    /// Without the lowest and the highest tenth.
    pub fn of_tenths(values: &[f64]) -> Self {
        let mut values = values.to_vec();
        values.sort_by(f64::total_cmp);
        let tenth = values.len() / 10;
        let low = values.get(tenth).copied();
        let high = values.iter().rev().nth(tenth).copied();
        Self {
            median: median(values.iter().copied()),
            low: low.unwrap_or(f64::NAN),
            high: high.unwrap_or(f64::NAN),
        }
    }

    /// The same in another unit.
    pub fn times(self, factor: f64) -> Self {
        Self {
            median: factor * self.median,
            low: factor * self.low,
            high: factor * self.high,
        }
    }

    /// Whether the two have values in common.
    pub fn overlaps(self, other: Self) -> bool {
        self.low <= other.high && other.low <= self.high
    }
}

/// The time that the processor works for this thread, as far as the system tells it, else what passes: what other
/// programs take isn't counted. Linux counts at its ticks, of a few milliseconds.
pub struct Clock {
    worked: Option<f64>,
    start: Instant,
}

impl Clock {
    /// From now on.
    pub fn start() -> Self {
        Self {
            worked: worked(),
            start: Instant::now(),
        }
    }

    /// Since the start, s.
    pub fn seconds(&self) -> f64 {
        match (self.worked, worked()) {
            (Some(before), Some(now)) => now - before,
            _ => self.start.elapsed().as_secs_f64(),
        }
    }
}

/// What the processor has worked for this thread, s.
fn worked() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = text.split(' ').next()?.parse().ok()?;
    Some(1e-9 * nanoseconds)
}

/// What the system calls the processor, as far as it says.
pub fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(':'))
        .map(|(_, name)| name.trim().to_owned());
    let unnamed = || format!("an unnamed {} processor", std::env::consts::ARCH);
    name.filter(|name| !name.is_empty()).unwrap_or_else(unnamed)
}

/// The largest; what is no number is larger than all others. 0 of none.
pub fn worst(values: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
    values.into_iter().fold(0.0, larger)
}

/// The median time of a step, ms.
pub fn median_ms(times: &[Duration]) -> f64 {
    median(times.iter().map(|time| 1e3 * time.as_secs_f64()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_the_worst() {
        assert_eq!(worst([1.0, 3.0, 2.0]), 3.0);
        assert!(worst([1.0, f64::NAN, 2.0]).is_nan());
        assert_eq!(worst([]), 0.0);
    }

    #[test]
    fn all_make_as_many_steps_and_each_is_first_in_turn() {
        let turns: Vec<_> = turns(2 * TURN + 3, 2).collect();
        let wanted = [(0, TURN), (1, TURN), (1, TURN), (0, TURN), (0, 3), (1, 3)];
        assert_eq!(turns, wanted);
    }

    #[test]
    fn the_median_needs_no_order() {
        assert_eq!(median([3.0, 1.0, 2.0]), 2.0);
        assert!(median([]).is_nan());
    }
}
