//! Runs a scenario with a contender at a rate, and times it.

use std::time::{Duration, Instant};

use ch00_scenes::{EngineEntry, LoadError, Scene, Settings, State};

use super::cell::{Cell, End};
use super::contenders::Contender;
use super::scenario::{Scenario, Verdict, Watch};
use crate::FindingsError;
use crate::lab::{Moment, median, worst};

/// The most runs that a time is the median of.
const MOST_RUNS: u32 = 5;
/// Nothing is run again once this has been spent on it, s.
const ENOUGH: f64 = 0.5;

/// What one run gave, or several.
pub struct Run {
    /// How it ended.
    pub verdict: Verdict,
    /// Spent in steps, s.
    pub spent: f64,
    /// Time that passed in the scene, s.
    pub passed: f64,
    /// Parts of a step.
    pub substeps: u32,
    /// Sweeps of a part; 0 where there are none.
    pub sweeps: u32,
}

impl Default for Run {
    fn default() -> Self {
        Self {
            verdict: Verdict::of(0.0),
            spent: 0.0,
            passed: 0.0,
            substeps: 0,
            sweeps: 0,
        }
    }
}

// ANCHOR: measure
/// One cell: all scenes of the scenario, of which the worst counts, as often as it takes for the time.
///
/// # Errors
/// [`FindingsError`] where a scene can't be built.
pub fn measure(
    scenario: &Scenario,
    contender: &Contender,
    rate: u32,
    quick: bool,
) -> Result<Cell, FindingsError> {
    let scenes = (scenario.scenes)(rate, quick)?;
    let mut cell = blank(scenario, contender, rate);
    let (mut costs, mut all) = (Vec::new(), 0.0);
    let runs = if quick { 1 } else { MOST_RUNS };
    while cell.runs < runs && all < ENOUGH {
        let run = match run_all(scenario, &scenes, contender, rate) {
            Ok(run) => run,
            Err(why) => {
                cell.end = End::Cannot(why.to_string());
                return Ok(cell);
            }
        };
        costs.push(run.spent / run.passed);
        all += run.spent;
        (cell.substeps, cell.sweeps) = (run.substeps, run.sweeps);
        cell.runs += 1;
        cell.error = run.verdict.error;
        let failed = run.verdict.failed.map(|how| End::Failed(how.to_owned()));
        cell.end = failed.unwrap_or(End::Measured);
    }
    cell.cost = median(costs);
    Ok(cell)
}
// ANCHOR_END: measure

fn blank(scenario: &Scenario, contender: &Contender, rate: u32) -> Cell {
    Cell {
        scenario: scenario.name.to_owned(),
        contender: contender.name.to_owned(),
        rate,
        substeps: 0,
        sweeps: 0,
        error: f64::INFINITY,
        cost: 0.0,
        runs: 0,
        end: End::Measured,
    }
}

/// All scenes, one after the other: the times together, and the worst verdict.
fn run_all(
    scenario: &Scenario,
    scenes: &[Scene],
    contender: &Contender,
    rate: u32,
) -> Result<Run, LoadError> {
    let mut all = Run::default();
    for scene in scenes {
        let one = run(scenario, scene, &contender.settings(), contender, rate)?;
        all = Run {
            verdict: worse(all.verdict, one.verdict),
            spent: all.spent + one.spent,
            passed: all.passed + one.passed,
            ..one
        };
    }
    Ok(all)
}

fn worse(one: Verdict, other: Verdict) -> Verdict {
    Verdict {
        error: worst([one.error, other.error]),
        failed: one.failed.or(other.failed),
    }
}

fn run(
    scenario: &Scenario,
    scene: &Scene,
    settings: &Settings,
    contender: &Contender,
    rate: u32,
) -> Result<Run, LoadError> {
    let mut watch = (scenario.watcher)(scene);
    let steps = scenario.steps.map(|steps| steps(rate));
    watched(scene, steps, contender.engine, settings, &mut *watch)
}

/// Runs a scene, in steps of its own or of these lengths, s, and lets somebody look at every step.
///
/// # Errors
/// [`LoadError`] where the engine can't take the scene or the settings.
pub fn watched(
    scene: &Scene,
    steps: Option<Vec<f64>>,
    engine: EngineEntry,
    settings: &Settings,
    watch: &mut dyn Watch,
) -> Result<Run, LoadError> {
    let mut engine = (engine.load)(scene, settings)?;
    let mut state = State::default();
    let (mut spent, mut time) = (Duration::ZERO, 0.0);
    let even = steps.is_none();
    let steps = steps.unwrap_or_else(|| vec![scene.dt; scene.steps as usize]);
    let mut verdict = None;
    for (step, dt) in (1..).zip(&steps) {
        let start = Instant::now();
        engine.step(*dt as f32);
        spent += start.elapsed();
        time += dt;
        engine.read_state(&mut state);
        if state.not_finite() > 0 {
            verdict = Some(Verdict::failed("NaN"));
            break;
        }
        watch.see(&Moment {
            step,
            time: if even {
                f64::from(step) * scene.dt
            } else {
                time
            },
            state: &state,
            engine: &*engine,
        });
    }
    let info = engine.info();
    Ok(Run {
        verdict: verdict.unwrap_or_else(|| watch.verdict()),
        spent: spent.as_secs_f64(),
        passed: time,
        substeps: info.substeps,
        sweeps: info.sweeps.unwrap_or(0),
    })
}
