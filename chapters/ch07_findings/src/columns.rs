//! What the layout alone changes: objects (chapter 4), all columns, and no more columns than the scene
//! needs (chapter 5), on the same scenes with the same bits. The engines take turns, so that whatever slows
//! the machine down slows all of them.

use std::fmt::Write as _;
use std::time::Instant;

use ch00_scenes::{Engine, Scene, Settings, State, builtin};
use ch05_properties::PropertiesEngine;
use ch05_properties::plan::Plan;

use crate::FindingsError;
use crate::chart::{Bar, Bars, Group, Picture};
use crate::draw;
use crate::lab::{self, Spread, TURN};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// A scene, its count, and steps that are timed.
pub const SCENES: [(&str, u64, u32); 4] = [
    ("balls", 1000, 300),
    ("balls", 10_000, 200),
    ("smooth_balls", 10_000, 200),
    ("ragdolls", 80, 300),
];
/// The engines in the order of the tables.
pub const ENGINES: [&str; 3] = ["objects", "all columns", "planned"];
/// What passes of different engines are for, in the order of a step.
pub const PARTS: [&str; 7] = [
    "update",
    "joints put back",
    "forces",
    "broad phase",
    "narrow phase",
    "resolve",
    "scene graph",
];

/// Which of [`PARTS`] a pass of any engine belongs to.
fn part_of(pass: &str) -> usize {
    match pass {
        "objects update" | "advance positions" | "advance orientations" | "hold fixed points" => 0,
        "constraint update" | "correct joints" => 1,
        "objects gather" | "gather forces" => 2,
        "broad phase" => 3,
        "narrow phase" | "list touches" => 4,
        "scene graph" => 6,
        _ => 5,
    }
}

/// How long something took, ms: median, and a tenth of the steps below and above.
#[derive(Clone, Debug, PartialEq)]
pub struct Timed {
    /// The step, a part of it or a pass.
    pub name: &'static str,
    /// Over all steps.
    pub ms: Spread,
}

/// An engine's run of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// One of [`ENGINES`].
    pub engine: &'static str,
    /// The whole step.
    pub step: Spread,
    /// Each of [`PARTS`].
    pub parts: Vec<Timed>,
    /// Each pass, as the engine calls it.
    pub passes: Vec<Timed>,
}

/// All engines' runs of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Name of the scene and how many there are of what it counts.
    pub scene: String,
    /// Bodies that move.
    pub bodies: usize,
    /// Steps that were timed.
    pub steps: u32,
    /// In the order of [`ENGINES`].
    pub runs: Vec<Run>,
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a scene can't be loaded or the engines come to different states.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let mut samples = Vec::new();
    for (name, count, steps) in SCENES {
        let (count, steps) = if quick {
            (count / 10, steps / 5)
        } else {
            (count, steps)
        };
        let sample = measured(name, count, steps)?;
        say(&format!("{}, {steps} steps", sample.scene));
        samples.push(sample);
    }
    Ok(Product {
        charts: pictures(&samples),
        csv: csv(&samples),
        page: Some(page(&samples)),
    })
}

/// A built-in scene of this size.
///
/// # Errors
/// [`FindingsError`] where there is none.
pub fn built(name: &str, count: Option<u64>) -> Result<Scene, FindingsError> {
    Ok(builtin::build(name, count, None)?)
}

/// Runs a scene on all engines, in turn.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded or the engines come to different states.
pub fn measured(name: &str, count: u64, steps: u32) -> Result<Sample, FindingsError> {
    let scene = built(name, Some(count))?;
    let mut engines = engines(&scene)?;
    let mut clocks = [const { Clock::new() }; ENGINES.len()];
    for (k, turn) in lab::turns(steps, ENGINES.len()) {
        for _ in 0..turn {
            let start = Instant::now();
            engines[k].step(scene.dt as f32);
            let ms = 1e3 * start.elapsed().as_secs_f64();
            clocks[k].note(ms, engines[k].as_ref());
        }
    }
    same_states(&scene, &engines)?;
    let runs = ENGINES.iter().zip(&clocks);
    Ok(Sample {
        scene: format!("{name}, {}", draw::grouped(&count.to_string())),
        bodies: scene.dynamic_count(),
        steps,
        runs: runs.map(|(engine, clock)| clock.run(engine)).collect(),
    })
}

/// The scene in all of [`ENGINES`].
fn engines(scene: &Scene) -> Result<[Box<dyn Engine>; ENGINES.len()], FindingsError> {
    let settings = Settings::defaults();
    let full = |_: &Scene, method| Plan::full(method);
    Ok([
        (ch04_ragdolls::ENGINE.load)(scene, &settings)?,
        Box::new(PropertiesEngine::load_with(scene, &settings, full)?),
        Box::new(PropertiesEngine::load(scene, &settings)?),
    ])
}

/// Whether all engines have the first one's state, bit for bit.
fn same_states(scene: &Scene, engines: &[Box<dyn Engine>]) -> Result<(), FindingsError> {
    let state = |engine: &dyn Engine| {
        let mut state = State::default();
        engine.read_state(&mut state);
        state
    };
    let first = state(engines[0].as_ref()).hash();
    for (engine, name) in engines.iter().zip(ENGINES).skip(1) {
        if state(engine.as_ref()).hash() != first {
            return Err(FindingsError::Differs {
                chart: "columns",
                scene: scene.name.clone(),
                run: name.to_owned(),
                what: "the state after the last step".to_owned(),
            });
        }
    }
    Ok(())
}

/// Times of an engine's steps so far, ms.
struct Clock {
    steps: Vec<f64>,
    parts: [Vec<f64>; PARTS.len()],
    passes: Vec<(&'static str, Vec<f64>)>,
}

impl Clock {
    const fn new() -> Self {
        Self {
            steps: Vec::new(),
            parts: [const { Vec::new() }; PARTS.len()],
            passes: Vec::new(),
        }
    }

    /// Notes a step and what the engine says of its passes.
    fn note(&mut self, step: f64, engine: &dyn Engine) {
        self.steps.push(step);
        let mut parts = [0.0; PARTS.len()];
        for (place, pass) in engine.pass_times().into_iter().enumerate() {
            let ms = 1e3 * pass.time.as_secs_f64();
            parts[part_of(pass.name)] += ms;
            if place == self.passes.len() {
                self.passes.push((pass.name, Vec::new()));
            }
            self.passes[place].1.push(ms);
        }
        for (times, ms) in self.parts.iter_mut().zip(parts) {
            times.push(ms);
        }
    }

    fn run(&self, engine: &'static str) -> Run {
        let timed = |name, times: &[f64]| Timed {
            name,
            ms: Spread::of_tenths(times),
        };
        let parts = PARTS.iter().zip(&self.parts);
        let passes = self.passes.iter();
        Run {
            engine,
            step: Spread::of_tenths(&self.steps),
            parts: parts.map(|(name, times)| timed(*name, times)).collect(),
            passes: passes.map(|(name, times)| timed(*name, times)).collect(),
        }
    }
}

impl Sample {
    /// Time of a step on objects over this run's.
    fn times_faster(&self, run: &Run) -> f64 {
        self.runs[0].step.median / run.step.median
    }
}

/// Balls and ragdolls apart: a body of a ragdoll takes five times as long as a ball.
fn pictures(samples: &[Sample]) -> Vec<Picture> {
    let (ragdolls, balls): (Vec<_>, Vec<_>) = samples
        .iter()
        .partition(|sample| sample.scene.starts_with("ragdolls"));
    let title = |things: &str| format!("A step of {things} in three layouts, with the same bits");
    vec![
        bars("columns", title("balls"), &balls).into(),
        bars("columns_ragdolls", title("ragdolls"), &ragdolls).into(),
    ]
}

/// Of [`PARTS`], those that are drawn by themselves; the others are drawn as one.
const DRAWN: [usize; 5] = [0, 1, 3, 4, 5];

fn bars(name: &'static str, title: String, samples: &[&Sample]) -> Bars {
    let mut parts: Vec<&'static str> = DRAWN.map(|part| PARTS[part]).to_vec();
    parts.push("the rest");
    Bars {
        name,
        title,
        label: "median time of a step (µs a body that moves)".to_owned(),
        powers: false,
        parts,
        groups: samples.iter().map(|sample| group(sample)).collect(),
    }
}

fn group(sample: &Sample) -> Group {
    let bar = |run: &Run| {
        let micros = |part: usize| 1e3 * run.parts[part].ms.median / sample.bodies as f64;
        let mut lengths = DRAWN.map(micros).to_vec();
        let others = (0..PARTS.len()).filter(|part| !DRAWN.contains(part));
        lengths.push(others.map(micros).sum());
        Bar {
            name: run.engine.to_owned(),
            lengths,
            spread: None,
            note: format!("{} ms", three_digits(run.step.median)),
        }
    };
    Group {
        name: sample.scene.clone(),
        bars: sample.runs.iter().map(bar).collect(),
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text =
        "scene,bodies,steps,engine,what,name,median_ms,tenth_ms,nine_tenths_ms\n".to_owned();
    for sample in samples {
        let scene = draw::quoted(&sample.scene);
        for run in &sample.runs {
            let mut line = |what: &str, name: &str, ms: Spread| {
                // Writing into a String can't fail.
                let _ = writeln!(
                    text,
                    "{scene},{},{},{},{what},{name},{:?},{:?},{:?}",
                    sample.bodies, sample.steps, run.engine, ms.median, ms.low, ms.high,
                );
            };
            line("step", "step", run.step);
            for part in &run.parts {
                line("part", part.name, part.ms);
            }
            for pass in &run.passes {
                line("pass", pass.name, pass.ms);
            }
        }
    }
    text
}

fn page(samples: &[Sample]) -> String {
    let mut headings = vec!["scene", "engine", "ms/step", "times as fast"];
    headings.extend(DRAWN.map(|part| PARTS[part]));
    let mut table = Table::new(&headings);
    for sample in samples {
        for run in &sample.runs {
            let mut cells = vec![
                sample.scene.clone(),
                run.engine.to_owned(),
                three_digits(run.step.median),
                format!("{:.2}", sample.times_faster(run)),
            ];
            cells.extend(DRAWN.map(|part| milliseconds(run.parts[part].ms.median)));
            table.push(cells);
        }
    }
    format!(
        "Method `corrected` on one core of {cpu}; {steps} steps of 1/60 s from the start, falling and \
         settling. The engines take turns of {TURN} steps, and after the last one all have the same state, bit \
         for bit. Times are medians over the steps, ms: of the step, and of its parts, whose medians \
         needn't add up to it. Update: where bodies move on; with objects also where they tell the scene \
         graph.\n\n{table}",
        cpu = lab::processor(),
        steps = steps_of(samples),
        table = table.markdown(2),
    )
}

/// A time that may be too short to tell, or none.
fn milliseconds(ms: f64) -> String {
    if ms == 0.0 {
        "–".to_owned()
    } else if ms < 1e-3 {
        "< 0.001".to_owned()
    } else {
        three_digits(ms)
    }
}

/// `300`, or `200 or 300`.
fn steps_of(samples: &[Sample]) -> String {
    let mut steps: Vec<u32> = samples.iter().map(|sample| sample.steps).collect();
    steps.sort_unstable();
    steps.dedup();
    let steps: Vec<String> = steps.iter().map(u32::to_string).collect();
    steps.join(" or ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_engines_run_the_same_steps_and_every_pass_has_its_part() {
        for (name, count) in [("balls", 20), ("smooth_balls", 20), ("ragdolls", 1)] {
            let sample = measured(name, count, 20).expect("the same bits");
            let [objects, full, planned] = &sample.runs[..] else {
                panic!("three engines");
            };
            assert!(planned.passes.len() <= full.passes.len());
            assert_eq!(objects.passes.len(), 7, "chapter 4's passes");
            for run in &sample.runs {
                let parts: f64 = run.parts.iter().map(|part| part.ms.median).sum();
                assert!(parts > 0.0 && run.step.median > 0.0, "{run:?}");
            }
            let graph = |run: &Run| run.parts[6].ms.median;
            assert_eq!((graph(full), graph(planned)), (0.0, 0.0));
        }
    }

    #[test]
    fn a_bar_a_run_and_a_row_a_run() {
        let sample = measured("balls", 10, 5).expect("it loads");
        let bars = group(&sample).bars;
        assert_eq!(bars.len(), ENGINES.len());
        let micros: f64 = bars[0].lengths.iter().sum();
        let parts: f64 = sample.runs[0].parts.iter().map(|part| part.ms.median).sum();
        assert!((micros - 100.0 * parts).abs() < 1e-6 * micros, "ten balls");
        let page = page(&[sample]);
        assert!(page.contains("| balls, 10 | planned "), "{page}");
    }
}
