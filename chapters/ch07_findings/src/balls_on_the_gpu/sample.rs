//! What the kept table holds of an engine with so many balls.

use super::{COMPUTE, KINDS, ON_THREADS, SCENE};
use crate::FindingsError;
use crate::kept::Line;

/// What was measured of an engine with so many balls.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// One of [`KINDS`].
    pub engine: String,
    /// Its method.
    pub method: String,
    /// What it ran on.
    pub device: String,
    /// On so many threads.
    pub threads: u32,
    /// How many balls.
    pub balls: f64,
    /// Steps before the first that was timed.
    pub settling: u32,
    /// A step, ms: the batch in the middle, the fastest and the slowest.
    pub ms: [f64; 3],
    /// Overlap in radii: 99 of 100 are no deeper.
    pub p99: f64,
    /// The deepest, in radii.
    pub deepest: f64,
    /// Balls outside the box, and of numbers that are not finite.
    pub gone: u64,
}

impl Sample {
    /// A line of the table.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] for another scene, an unknown engine, or what is no number.
    pub fn of(line: Line) -> Result<Self, FindingsError> {
        line.one_of("engine", &KINDS.map(|kind| kind.engine))?;
        line.one_of("scene", &[SCENE])?;
        let threads = line.number("threads")?;
        let engine = match line.text("engine")? {
            "lanes" if threads > 1 => ON_THREADS,
            engine => engine,
        };
        Ok(Self {
            engine: engine.to_owned(),
            threads,
            method: line.text("method")?.to_owned(),
            device: line.text("device")?.to_owned(),
            balls: line.positive("count")?,
            settling: line.number("settle_steps")?,
            ms: [
                line.positive("ms_median")?,
                line.positive("ms_fastest")?,
                line.positive("ms_slowest")?,
            ],
            p99: line.number("p99_of_r")?,
            deepest: line.number("max_of_r")?,
            gone: line.number::<u64>("escaped")? + line.number::<u64>("not_finite")?,
        })
    }

    /// Engines in the order of [`KINDS`], and the balls of each in order: a number that grows along.
    #[must_use]
    pub fn place(&self) -> f64 {
        let kind = KINDS.iter().position(|kind| kind.engine == self.engine);
        1e12 * kind.unwrap_or(KINDS.len()) as f64 + self.balls
    }
}

/// The samples of an engine.
pub fn of<'a>(samples: &'a [Sample], engine: &str) -> impl Iterator<Item = &'a Sample> {
    samples.iter().filter(move |sample| sample.engine == engine)
}

/// Steps before the first that was timed: `300`, or `300 to 900`.
pub fn settling<'a>(samples: impl Iterator<Item = &'a Sample>) -> String {
    let mut steps: Vec<u32> = samples.map(|sample| sample.settling).collect();
    steps.sort_unstable();
    match steps[..] {
        [first, .., last] if first < last => format!("{first} to {last}"),
        [first, ..] => first.to_string(),
        [] => "no".to_owned(),
    }
}

/// What an engine, or each of the others, ran on.
fn devices(samples: &[Sample], is_wanted: fn(&str) -> bool) -> String {
    let wanted = samples.iter().filter(|sample| is_wanted(&sample.engine));
    let mut names: Vec<&str> = wanted.map(|sample| sample.device.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    if names.is_empty() {
        "nothing".to_owned()
    } else {
        names.join(" and ")
    }
}

/// The machines of all samples, in words.
pub fn machines(samples: &[Sample]) -> String {
    let gpu = devices(samples, |engine| engine == COMPUTE);
    let cpu = devices(samples, |engine| engine != COMPUTE);
    let threads = of(samples, ON_THREADS).map(|sample| sample.threads).max();
    let more = threads.map_or_else(String::new, |count| format!(" or {count}"));
    format!("{gpu}, and one thread{more} of {cpu}")
}
