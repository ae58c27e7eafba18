//! Our engines beside rapier3d: time and errors of the same scene, from the same start, in one run.
//!
//! `cargo run --release -p ch06_compute --no-default-features --features rapier --example peer --
//! [--scene NAME[:COUNT],…] [--count N,N,…] [--settle STEPS] [--steps STEPS] [--blocks N] [--threads N,N,…]
//! [--engines NAME[:METHOD],…] [--method NAME] [--substeps N,N,…] [--iterations N]
//! [--cone coupled|ranges|both] [--csv FILE]`
//!
//! All load the same scene and make its settling steps, each by itself. Then they take turns, a block of
//! steps each, so that whatever else the machine does falls on all alike. After a block, and outside its
//! time, the state is measured, by one function and from positions and attitudes alone. A line tells an
//! engine on so many threads: the time of a step over all blocks; of the errors that 99 of 100 don't exceed,
//! the median over the blocks, and the largest of all. The last column is its median time over that of
//! rapier's fastest line. Lines go to the standard output and, with `--csv`, into a file. At the end, and on the
//! standard output only, each scene has its verdict: the fastest of our lines of which no error (99 of 100 depths,
//! gaps between joints, angles beyond limits) is larger than that of rapier's fastest.
//!
//! rapier runs with its own settings (4 substeps, which it calls iterations; four SIMD lanes; `parallel`), but
//! nothing sleeps and CCD is off. `--substeps` and `--method` are for our engines, each with each number of
//! substeps in a line of its own; `--iterations` is for rapier. `--cone` says how rapier hears of a ball joint's
//! cone: `coupled` as it is, for which rapier has no lanes, or `ranges` about two axes, whose corners lie outside
//! the cone. To give all of them the machine's widest lanes, set `RUSTFLAGS="-C target-cpu=native"`; the feature
//! `rapier3d/simd8` makes rapier's eight.

mod errors;
mod line;
mod options;
mod runner;
#[path = "../shared/table.rs"]
mod table;

use std::process::ExitCode;

use ch00_scenes::{EngineEntry, LoadError, Scene, Settings, State};

use ch06_compute::peer::{Cone, Rapier, Setup};
use errors::Errors;
use line::{COLUMNS, Line};
use options::Options;
use runner::{Ours, Runner};
use table::{Problem, Table};

fn main() -> ExitCode {
    table::ended(run())
}

fn run() -> Result<(), Problem> {
    let options = Options::of(std::env::args().skip(1))?;
    let mut table = Table::begin(COLUMNS, options.csv.as_ref())?;
    let mut verdicts = Vec::new();
    for (scene, count) in &options.scenes {
        let lines = compared(&options, scene, *count)?;
        for line in &lines {
            table.add(line)?;
        }
        verdicts.push(line::verdict(&lines));
    }
    for verdict in verdicts {
        println!("{verdict}");
    }
    Ok(())
}

/// An engine's line of the table, while it runs.
struct Entrant {
    runner: Box<dyn Runner>,
    /// Of every timed step, ms.
    times: Vec<f64>,
    /// After every block.
    moments: Vec<Errors>,
}

fn compared(options: &Options, name: &str, count: Option<u64>) -> Result<Vec<Line>, Problem> {
    let scene = Scene::open(name, count, None)?;
    let mut entrants = entrants(options, &scene)?;
    let mut not_timed = Vec::new();
    for entrant in &mut entrants {
        entrant.runner.steps(options.settle, &mut not_timed);
    }
    let mut state = State::default();
    for _ in 0..options.blocks {
        for entrant in &mut entrants {
            let each = options.steps / options.blocks;
            entrant.runner.steps(each, &mut entrant.times);
            entrant.runner.read(&mut state);
            entrant.moments.push(Errors::of(&scene, &state));
        }
    }
    let lines = entrants.into_iter().map(|entrant| Line {
        scene: scene.name.clone(),
        count,
        bodies: scene.bodies.len(),
        joints: scene.joints.len(),
        facts: entrant.runner.facts(),
        settle: options.settle,
        times: errors::sorted(entrant.times.into_iter()),
        moments: entrant.moments,
        of_rapier: 1.0,
    });
    let mut lines: Vec<_> = lines.collect();
    line::compare_with_rapier(&mut lines);
    Ok(lines)
}

fn entrants(options: &Options, scene: &Scene) -> Result<Vec<Entrant>, Problem> {
    let mut runners: Vec<Box<dyn Runner>> = Vec::new();
    for &threads in &options.threads {
        for cone in cones(options, scene) {
            let setup = Setup {
                threads,
                iterations: options.iterations,
                cone: *cone,
                tolerant: true,
                ccd: false,
            };
            runners.push(Box::new(Rapier::load(scene, setup)?));
        }
        for (engine, settings) in &options.engines {
            if let Some(ours) = ours(engine, settings, scene, threads)? {
                runners.push(Box::new(ours));
            }
        }
    }
    let entrant = |runner| Entrant {
        runner,
        times: Vec::new(),
        moments: Vec::new(),
    };
    Ok(runners.into_iter().map(entrant).collect())
}

/// The ways to tell rapier of a cone; without joints they are all the same.
fn cones<'a>(options: &'a Options, scene: &Scene) -> &'a [Cone] {
    if scene.joints.is_empty() {
        &options.cones[..1]
    } else {
        &options.cones
    }
}

/// One of our engines on so many threads; None if it can't run on as many.
fn ours(
    engine: &EngineEntry,
    settings: &Settings,
    scene: &Scene,
    threads: u32,
) -> Result<Option<Ours>, Problem> {
    let settings = Settings {
        threads: Some(threads),
        ..settings.clone()
    };
    let loaded = match (engine.load)(scene, &settings) {
        Err(LoadError::Setting {
            setting: "threads", ..
        }) => None,
        loaded => Some(loaded?),
    };
    let loaded = loaded.filter(|loaded| loaded.info().threads == threads);
    if loaded.is_none() {
        eprintln!("{} doesn't run on {threads} threads", engine.name);
    }
    Ok(loaded.map(|engine| Ours {
        engine,
        dt: scene.dt as f32,
    }))
}
