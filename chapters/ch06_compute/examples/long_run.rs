//! Does a run that goes on for hours stay what it is? Energy, depths, escapes and memory of `balls` 60 over a
//! million steps, more than four hours of the scene: a line of CSV every so many steps.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example long_run -- [--scene NAME] [--count N]
//! [--method NAME] [--steps N] [--every N] [--csv FILE]`
//!
//! Energy is that of the bodies, kinetic and of their weights above y = 0. Memory is what the system counts as
//! resident, where it says so (`/proc/self/statm`, Linux); pages of 4 KiB. Nothing is kept from line to line.

use std::fs::File;
use std::io::Write as _;

use ch00_scenes::measures::Measures;
use ch00_scenes::{Scene, Settings, State};

type Problem = Box<dyn std::error::Error>;

/// What the command line says.
struct Options {
    scene: String,
    count: u64,
    method: String,
    steps: u32,
    every: u32,
    csv: Option<String>,
}

fn main() -> Result<(), Problem> {
    let options = Options::of(std::env::args().skip(1))?;
    let mut file = options.csv.as_ref().map(File::create).transpose()?;
    let mut say = |line: &str| -> Result<(), Problem> {
        println!("{line}");
        if let Some(file) = &mut file {
            writeln!(file, "{line}")?;
        }
        Ok(())
    };
    let scene = Scene::open(&options.scene, Some(options.count), None)?;
    let settings = Settings {
        threads: Some(1),
        ..Settings::defaults().with_method(&options.method)
    };
    let mut engine = (ch06_compute::LANES.load)(&scene, &settings)?;
    let mut state = State::start_of(&scene);
    say("step,seconds,energy_j,kinetic_energy_j,deepest_m,escaped,not_finite,resident_kib")?;
    let mut step = 0;
    loop {
        let (seconds, found) = (f64::from(step) * scene.dt, Line::of(&scene, &state));
        say(&format!("{step},{seconds:.0},{found}"))?;
        if step == options.steps {
            return Ok(());
        }
        let next = options.steps.min(step + options.every.max(1));
        for _ in step..next {
            engine.step(scene.dt as f32);
        }
        step = next;
        engine.read_state(&mut state);
    }
}

impl Options {
    fn of(mut words: impl Iterator<Item = String>) -> Result<Self, Problem> {
        let mut options = Self {
            scene: "balls".to_owned(),
            count: 60,
            method: "own-row".to_owned(),
            steps: 1_000_000,
            every: 12_500,
            csv: None,
        };
        while let Some(flag) = words.next() {
            let value = words.next();
            let value = value.ok_or_else(|| format!("`{flag}` has no value"))?;
            match flag.as_str() {
                "--scene" => options.scene = value,
                "--count" => options.count = value.parse()?,
                "--method" => options.method = value,
                "--steps" => options.steps = value.parse()?,
                "--every" => options.every = value.parse()?,
                "--csv" => options.csv = Some(value),
                _ => return Err(format!("there is no flag `{flag}`").into()),
            }
        }
        Ok(options)
    }
}

/// What is found of a state.
struct Line {
    measures: Measures,
    resident: Option<u64>,
}

impl Line {
    fn of(scene: &Scene, state: &State) -> Self {
        Self {
            measures: Measures::of(scene, state),
            resident: resident(),
        }
    }
}

impl std::fmt::Display for Line {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Measures {
            conserved,
            penetration,
            escaped,
            not_finite,
            ..
        } = &self.measures;
        let (energy, kinetic) = (conserved.energy(), conserved.kinetic_energy);
        let escaped = escaped.map_or_else(String::new, |count| count.to_string());
        let resident = self
            .resident
            .map_or_else(String::new, |kib| kib.to_string());
        write!(
            f,
            "{energy:.3},{kinetic:.3e},{:.6},{escaped},{not_finite},{resident}",
            penetration.deepest
        )
    }
}

/// What the program holds in memory, KiB, in pages of 4 KiB.
fn resident() -> Option<u64> {
    let statm = std::fs::read_to_string("/proc/self/statm").ok()?;
    let pages: u64 = statm.split_whitespace().nth(1)?.parse().ok()?;
    Some(4 * pages)
}
