//! What architecture, method and hardware each bring: the same settled pile with the corrected method on
//! objects and on properties, and with own rows on one thread and on this machine's graphics device. Each
//! changes one thing. They take turns, so that whatever slows the machine down slows all of them.

use std::fmt::Write as _;
use std::time::Instant;

use ch00_scenes::measures::Measures;
use ch00_scenes::{EngineEntry, Scene, Settings, State};

use crate::FindingsError;
use crate::chart::{Bar, Bars, Group};
use crate::columns::built;
use crate::draw;
use crate::lab::{self, Spread, TURN};
use crate::product::{Product, Say};
use crate::stepped::Stepped;
use crate::table::{Table, percent, three_digits};

/// Numbers of balls, and turns that are timed.
pub const COUNTS: [(u64, u32); 2] = [(1000, 20), (10_000, 5)];
/// Steps of each engine before the first that is timed: ten seconds.
const SETTLING: u32 = 600;
/// The engines, each with what it changes.
pub const ENGINES: [(EngineEntry, &str, &str); 4] = [
    (ch04_ragdolls::ENGINE, "corrected on objects", ""),
    (
        ch05_properties::ENGINE,
        "corrected on properties",
        "architecture",
    ),
    (ch06_compute::LANES, "own-row on lanes", "method"),
    (ch06_compute::COMPUTE, "own-row on compute", "hardware"),
];

/// An engine's run of a pile.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// As [`ENGINES`] call it.
    pub name: &'static str,
    /// What it changes beside the run before.
    pub changes: &'static str,
    /// What it ran on.
    pub device: String,
    /// A step, ms: the mean of a turn; of all turns the one in the middle, the least and the largest.
    pub ms: Spread,
    /// Overlap in radii of the smaller ball at the end: 99 of 100 are no deeper.
    pub p99: f64,
    /// The deepest, in radii.
    pub deepest: f64,
    /// Balls outside the box.
    pub escaped: usize,
}

/// All engines' runs of a pile.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Number of balls.
    pub balls: u64,
    /// Steps of each engine before the first that was timed.
    pub settling: u32,
    /// Steps of each engine that were timed.
    pub steps: u32,
    /// In the order of [`ENGINES`].
    pub runs: Vec<Run>,
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a pile can't be loaded, there is no device, or objects and properties come to
/// different states.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let mut samples = Vec::new();
    for (balls, turns) in COUNTS {
        let sample = if quick {
            measured(balls / 20, 1, TURN)?
        } else {
            measured(balls, turns, SETTLING)?
        };
        say(&format!("{} balls", grouped(sample.balls)));
        samples.push(sample);
    }
    Ok(Product {
        charts: vec![chart(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples)),
    })
}

/// Lets a pile settle on each engine, and times as many turns of each.
///
/// # Errors
/// As [`product`].
pub fn measured(balls: u64, turns: u32, settling: u32) -> Result<Sample, FindingsError> {
    let scene = built("pile", Some(balls))?;
    let dt = scene.dt as f32;
    let mut engines = Vec::new();
    for (entry, ..) in ENGINES {
        let mut engine = Stepped::load(entry, &Settings::defaults(), &scene)?;
        engine.steps(dt, settling);
        engines.push(engine);
    }
    let mut times = [const { Vec::new() }; ENGINES.len()];
    for (k, turn) in lab::turns(turns * TURN, ENGINES.len()) {
        let start = Instant::now();
        engines[k].steps(dt, turn);
        times[k].push(1e3 * start.elapsed().as_secs_f64() / f64::from(turn));
    }
    let states: Vec<State> = engines.iter().map(Stepped::state).collect();
    same_bits(&scene, &states[0], &states[1])?;
    let runs = engines.iter().zip(&states).zip(&times).zip(ENGINES);
    Ok(Sample {
        balls,
        settling,
        steps: turns * TURN,
        runs: runs
            .map(|(((engine, state), times), (_, name, changes))| {
                let measures = Measures::of(&scene, state);
                Run {
                    name,
                    changes,
                    device: engine.device(),
                    ms: Spread::of_all(times),
                    p99: measures.penetration.relative.p99,
                    deepest: measures.penetration.relative.deepest,
                    escaped: measures.escaped.unwrap_or(0),
                }
            })
            .collect(),
    })
}

/// Whether properties have the bits of objects.
fn same_bits(scene: &Scene, objects: &State, properties: &State) -> Result<(), FindingsError> {
    if objects.hash() == properties.hash() {
        return Ok(());
    }
    Err(FindingsError::Differs {
        chart: "architecture_method_hardware",
        scene: scene.name.clone(),
        run: ENGINES[1].1.to_owned(),
        what: "the state after the last step".to_owned(),
    })
}

impl Sample {
    /// How many times as fast a run is as the one before it; None of the first.
    fn gain(&self, place: usize) -> Option<f64> {
        let before = self.runs.get(place.checked_sub(1)?)?;
        Some(before.ms.median / self.runs[place].ms.median)
    }
}

/// What the last run of a sample ran on, and the first.
fn machines(samples: &[Sample]) -> [&str; 2] {
    match samples.first().map(|sample| &sample.runs[..]) {
        Some([first, .., last]) => [&last.device, &first.device],
        _ => [""; 2],
    }
}

fn chart(samples: &[Sample]) -> Bars {
    let [gpu, cpu] = machines(samples);
    Bars {
        name: "architecture_method_hardware",
        title: format!(
            "A step of a settled pile: how many times as fast by architecture, by method, by hardware. Compute on {gpu}; the \
             others on one core of {cpu}"
        ),
        label: "time of a step (µs a ball)".to_owned(),
        powers: false,
        parts: vec!["time of a step"],
        groups: samples.iter().map(group).collect(),
    }
}

fn group(sample: &Sample) -> Group {
    let bar = |(place, run): (usize, &Run)| {
        let micros = run.ms.times(1e3 / sample.balls as f64);
        let ms = three_digits(run.ms.median);
        Bar {
            name: run.name.to_owned(),
            lengths: vec![micros.median],
            spread: Some((micros.low, micros.high)),
            note: sample.gain(place).map_or(format!("{ms} ms"), |gain| {
                format!("{ms} ms: × {gain:.2} by {}", run.changes)
            }),
        }
    };
    Group {
        name: format!("{} balls", grouped(sample.balls)),
        bars: sample.runs.iter().enumerate().map(bar).collect(),
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "balls,settling_steps,steps,run,changes,device,ms_a_step,least_ms,largest_ms,times_as_fast,\
        p99_of_r,deepest_of_r,escaped\n"
        .to_owned();
    for sample in samples {
        for (place, run) in sample.runs.iter().enumerate() {
            let gain = sample.gain(place);
            // Writing into a String can't fail.
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{:?},{:?},{:?},{},{:?},{:?},{}",
                sample.balls,
                sample.settling,
                sample.steps,
                run.name,
                run.changes,
                draw::quoted(&run.device),
                run.ms.median,
                run.ms.low,
                run.ms.high,
                gain.map_or(String::new(), |gain| format!("{gain:?}")),
                run.p99,
                run.deepest,
                run.escaped,
            );
        }
    }
    text
}

fn page(samples: &[Sample]) -> String {
    let mut table = Table::new(&[
        "balls",
        "run",
        "ms/step",
        "least … largest",
        "times as fast",
        "by",
        "p99 of R",
        "deepest of R",
        "escaped",
    ]);
    for sample in samples {
        for (place, run) in sample.runs.iter().enumerate() {
            let gain = sample.gain(place);
            table.push(vec![
                grouped(sample.balls),
                run.name.to_owned(),
                three_digits(run.ms.median),
                format!(
                    "{} … {}",
                    three_digits(run.ms.low),
                    three_digits(run.ms.high)
                ),
                gain.map_or("–".to_owned(), |gain| format!("{gain:.2}")),
                run.changes.to_owned(),
                percent(run.p99),
                percent(run.deepest),
                run.escaped.to_string(),
            ]);
        }
    }
    let [gpu, cpu] = machines(samples);
    let settling = samples.first().map_or(0, |sample| sample.settling);
    format!(
        "A pile of balls, settled on each engine for {settling} steps of 1/60 s. Compute on {gpu}; the others \
         on one core of {cpu}. The engines take turns of {TURN} steps; of each turn the mean, and of the turns \
         the one in the middle, the least and the largest. Objects and properties have the same bits after \
         the last step. Overlaps then are relative to the smaller ball's radius R. Times as fast: as the \
         run above.\n\n{table}",
        table = table.markdown(0),
    )
}

/// A number of balls, 12,345.
fn grouped(balls: u64) -> String {
    draw::grouped(&balls.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_engine_runs_the_pile_and_says_what_it_changes() {
        let sample = measured(30, 1, 10).expect("all of them can");
        assert_eq!(sample.runs.len(), ENGINES.len());
        assert!(sample.runs.iter().all(|run| run.ms.low > 0.0), "{sample:?}");
        assert_eq!(sample.runs[0].p99, sample.runs[1].p99, "the same bits");
        let notes: Vec<String> = group(&sample)
            .bars
            .into_iter()
            .map(|bar| bar.note)
            .collect();
        for (note, word) in notes
            .iter()
            .zip(["ms", "architecture", "method", "hardware"])
        {
            assert!(note.ends_with(word), "{notes:?}");
        }
        let device = sample.runs[3].device.clone();
        let samples = [sample];
        assert!(chart(&samples).title.contains(&device));
        assert!(page(&samples).contains(&device));
        assert_eq!(csv(&samples).lines().count(), 1 + ENGINES.len());
    }

    #[test]
    fn steps_on_a_device_are_as_many_as_were_asked_for() {
        let scene = built("pile", Some(5)).expect("a built-in");
        let mut engine =
            Stepped::load(ch06_compute::COMPUTE, &Settings::defaults(), &scene).expect("a device");
        let mut one =
            Stepped::load(ch06_compute::COMPUTE, &Settings::defaults(), &scene).expect("a device");
        engine.steps(scene.dt as f32, TURN + 7);
        for _ in 0..TURN + 7 {
            one.steps(scene.dt as f32, 1);
        }
        assert_eq!(engine.state().hash(), one.state().hash());
    }
}
