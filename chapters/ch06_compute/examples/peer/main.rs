//! Our engines beside rapier3d: time and errors of the same scene, from the same start, in one run.
//!
//! `cargo run --release -p ch06_compute --no-default-features --features rapier --example peer --
//! [--scene NAME] [--count N,N,…] [--settle STEPS] [--steps STEPS] [--blocks N] [--threads N,N,…]
//! [--engines NAME[:METHOD],…] [--method NAME] [--substeps N] [--iterations N]
//! [--cone coupled|ranges|both] [--csv FILE]`
//!
//! All load the same scene and make its settling steps, each by itself. Then they take turns, a block of
//! steps each, so that whatever else the machine does falls on all alike. After a block, and outside its
//! time, the state is measured, by one function and from positions and attitudes alone. A line tells an
//! engine on so many threads: the time of a step over all blocks; of the errors that 99 of 100 don't exceed,
//! the median over the blocks, and the largest of all. The last column is its median time over that of
//! rapier's fastest line. Lines go to the standard output and, with `--csv`, into a file.
//!
//! rapier runs with its own settings (4 substeps, which it calls iterations; four SIMD lanes; `parallel`), but
//! nothing sleeps and CCD is off. `--substeps` and `--method` are for our engines, `--iterations` is for
//! rapier. `--cone` says how rapier hears of a ball joint's cone: `coupled` as it is, for which rapier has no
//! lanes, or `ranges` about two axes, whose corners lie outside the cone. To give all of them the machine's
//! widest lanes, set `RUSTFLAGS="-C target-cpu=native"`; the feature `rapier3d/simd8` makes rapier's eight.

mod errors;
mod line;
mod options;
mod runner;

use std::fs::File;
use std::io::Write as _;
use std::process::ExitCode;

use ch00_scenes::{EngineEntry, LoadError, Scene, Settings, State};

use ch06_compute::peer::{Cone, Rapier, Setup};
use errors::Errors;
use line::Line;
use options::Options;
use runner::{Ours, Runner};

type Problem = Box<dyn std::error::Error>;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Problem> {
    let options = Options::of(std::env::args().skip(1))?;
    let mut file = options.csv.as_ref().map(File::create).transpose()?;
    let mut say = |line: &str| -> Result<(), Problem> {
        println!("{line}");
        if let Some(file) = &mut file {
            writeln!(file, "{line}")?;
            file.flush()?;
        }
        Ok(())
    };
    say(&Line::names())?;
    for &count in &options.counts {
        for line in compared(&options, count)? {
            say(&line.values())?;
        }
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

fn compared(options: &Options, count: Option<u64>) -> Result<Vec<Line>, Problem> {
    let scene = Scene::open(&options.scene, count, None)?;
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
