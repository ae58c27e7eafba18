//! Runs a scenario with a contender at a rate, and times it.

use std::time::{Duration, Instant};

use ch00_scenes::{LoadError, Scene, Settings, State};

use super::cell::{Cell, End};
use super::contenders::Contender;
use super::scenario::{Scenario, Verdict};
use crate::FindingsError;
use crate::lab::{Moment, median, worst};

/// The most runs that a time is the median of.
const MOST_RUNS: u32 = 5;
/// Nothing is run again once this has been spent on it, s.
const ENOUGH: f64 = 0.5;

/// What one run gave.
struct Run {
    verdict: Verdict,
    /// Spent in steps.
    spent: Duration,
    /// Time that passed in the scene, s.
    passed: f64,
    substeps: u32,
    sweeps: u32,
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
        let mut verdict = Verdict::of(0.0);
        let (mut spent, mut passed) = (0.0, 0.0);
        for scene in &scenes {
            let run = match run(scenario, scene, &contender.settings(), contender, rate) {
                Ok(run) => run,
                Err(why) => {
                    cell.end = End::Cannot(why.to_string());
                    return Ok(cell);
                }
            };
            verdict = worse(verdict, run.verdict);
            spent += run.spent.as_secs_f64();
            passed += run.passed;
            (cell.substeps, cell.sweeps) = (run.substeps, run.sweeps);
        }
        costs.push(spent / passed);
        all += spent;
        cell.runs += 1;
        cell.error = verdict.error;
        cell.end = verdict
            .failed
            .map_or(End::Measured, |how| End::Failed(how.to_owned()));
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
    let mut engine = (contender.engine.load)(scene, settings)?;
    let mut watch = (scenario.watcher)(scene);
    let mut state = State::default();
    let (mut spent, mut time) = (Duration::ZERO, 0.0);
    let steps = match scenario.steps {
        Some(steps) => steps(rate),
        None => vec![scene.dt; scene.steps as usize],
    };
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
            time: if scenario.steps.is_some() {
                time
            } else {
                f64::from(step) * scene.dt
            },
            state: &state,
            engine: &*engine,
        });
    }
    let info = engine.info();
    Ok(Run {
        verdict: verdict.unwrap_or_else(|| watch.verdict()),
        spent,
        passed: time,
        substeps: info.substeps,
        sweeps: info.sweeps.unwrap_or(0),
    })
}
