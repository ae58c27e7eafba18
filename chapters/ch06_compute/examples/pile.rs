//! How long a step of a settled heap takes, and how good the heap is: a line of CSV for each size.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example pile -- [--engine NAME]
//! [--method NAME] [--scene NAME] [--counts N,N,…] [--settle STEPS] [--steps STEPS] [--substeps N]
//! [--threads N,N,…] [--turns N] [--csv FILE] [--sleeping]`
//!
//! A scene is loaded, makes its settling steps, and then the timed ones in five batches, of which the
//! median, the fastest and the slowest are told, ms a step. Nothing is read back before a batch is done.
//! What is left lying is measured from scene and state alone. Lines go to the standard output and, with
//! `--csv`, into a file. With `--sleeping` a second heap of each size may sleep; it has a second line.
//!
//! With `--turns` all heaps settle first, and then take turns, a batch of the timed steps each and so many times: what
//! else the machine does in the meantime is shared among them.

#[path = "shared/table.rs"]
mod table;

use std::process::ExitCode;
use std::time::{Duration, Instant};

use ch00_scenes::measures::Measures;
use ch00_scenes::{Engine, EngineEntry, Scene, Settings, State};
use ch01_hierarchy::styles::report::processor;
use ch06_compute::compute::ComputeEngine;
use table::{Column, Problem, Table, short};

/// What `--engine` can name, the default first.
const ENGINES: &[EngineEntry] = &[
    ch06_compute::LANES,
    ch06_compute::COMPUTE,
    ch05_properties::ENGINE,
    ch04_ragdolls::ENGINE,
];

/// Of the timed steps, where heaps take no turns.
const BATCHES: u32 = 5;

fn main() -> ExitCode {
    table::ended(run())
}

fn run() -> Result<(), Problem> {
    let options = Options::of(std::env::args().skip(1))?;
    let mut table = Table::begin(COLUMNS, options.csv.as_ref())?;
    let heaps = options.heaps();
    let together = if options.turns.is_some() {
        heaps.len()
    } else {
        1
    };
    for heaps in heaps.chunks(together) {
        for line in measured(&options, heaps)? {
            table.add(&line)?;
        }
    }
    Ok(())
}

// What the command line says.

struct Options {
    engine: EngineEntry,
    scene: String,
    /// The scene's own count where there is none.
    counts: Vec<Option<u64>>,
    settle: u32,
    steps: u32,
    settings: Settings,
    /// As the engine chooses where there is none.
    threads: Vec<Option<u32>>,
    /// How many, if heaps take turns.
    turns: Option<u32>,
    csv: Option<String>,
    /// Whether there is a heap that may sleep beside the one that may not.
    sleeping: bool,
}

/// What is to be timed.
#[derive(Clone, Copy)]
struct Heap {
    count: Option<u64>,
    threads: Option<u32>,
    sleeping: bool,
}

impl Options {
    fn of(mut words: impl Iterator<Item = String>) -> Result<Self, Problem> {
        let mut options = Self {
            engine: ENGINES[0],
            scene: "pile".to_owned(),
            counts: vec![None],
            settle: 600,
            steps: 200,
            settings: Settings::defaults(),
            threads: vec![None],
            turns: None,
            csv: None,
            sleeping: false,
        };
        while let Some(flag) = words.next() {
            if flag == "--sleeping" {
                options.sleeping = true;
                continue;
            }
            let Some(value) = words.next() else {
                return Err(format!("`{flag}` has no value").into());
            };
            options
                .set(&flag, &value)
                .map_err(|problem| format!("`{flag} {value}`: {problem}"))?;
        }
        Ok(options)
    }

    fn set(&mut self, flag: &str, value: &str) -> Result<(), Problem> {
        match flag {
            "--engine" => self.engine = engine_of(value)?,
            "--scene" => value.clone_into(&mut self.scene),
            "--counts" => {
                let counts = value.split(',').map(|count| count.trim().parse().map(Some));
                self.counts = counts.collect::<Result<_, _>>()?;
            }
            "--settle" => self.settle = value.parse()?,
            "--steps" => self.steps = value.parse()?,
            "--method" => self.settings.method = Some(value.to_owned()),
            "--substeps" => self.settings.substeps = Some(value.parse()?),
            "--threads" => {
                let threads = value.split(',').map(|count| count.trim().parse().map(Some));
                self.threads = threads.collect::<Result<_, _>>()?;
            }
            "--turns" => self.turns = Some(value.parse::<std::num::NonZero<u32>>()?.get()),
            "--csv" => self.csv = Some(value.to_owned()),
            _ => return Err("there is no such flag".into()),
        }
        Ok(())
    }

    /// All heaps, in the order of their lines.
    fn heaps(&self) -> Vec<Heap> {
        let mut heaps = Vec::new();
        for &threads in &self.threads {
            for &count in &self.counts {
                for sleeping in [false, true] {
                    if self.sleeping || !sleeping {
                        heaps.push(Heap {
                            count,
                            threads,
                            sleeping,
                        });
                    }
                }
            }
        }
        heaps
    }
}

fn engine_of(name: &str) -> Result<EngineEntry, Problem> {
    let found = ENGINES.iter().find(|engine| engine.name == name);
    let known = || ENGINES.iter().map(|engine| engine.name).collect::<Vec<_>>();
    let unknown = || format!("there are these engines: {}", known().join(", "));
    Ok(*found.ok_or_else(unknown)?)
}

// A run.

/// An engine that is timed.
trait Timed {
    fn engine(&self) -> &dyn Engine;

    /// Makes some steps, and comes back when the last one is done.
    fn steps(&mut self, dt: f32, count: u32);
}

/// An engine whose steps are done when they return.
struct OneByOne(Box<dyn Engine>);

impl Timed for OneByOne {
    fn engine(&self) -> &dyn Engine {
        self.0.as_ref()
    }

    fn steps(&mut self, dt: f32, count: u32) {
        for _ in 0..count {
            self.0.step(dt);
        }
    }
}

/// Steps on a device: handed over together, and waited for once.
struct Queued(ComputeEngine);

/// As many steps are recorded into one submission.
const TOGETHER: u32 = 50;

impl Timed for Queued {
    fn engine(&self) -> &dyn Engine {
        &self.0
    }

    fn steps(&mut self, dt: f32, count: u32) {
        let mut left = count;
        while left > 0 {
            let now = left.min(TOGETHER);
            self.0.steps(dt, now);
            left -= now;
        }
        self.0.finish();
    }
}

fn load(options: &Options, heap: Heap, scene: &Scene) -> Result<Box<dyn Timed>, Problem> {
    let settings = Settings {
        sleeping: heap.sleeping,
        threads: heap.threads,
        ..options.settings.clone()
    };
    if options.engine.name == ch06_compute::COMPUTE.name {
        let engine = ComputeEngine::load(scene, &settings)?;
        return Ok(Box::new(Queued(engine)));
    }
    let engine = (options.engine.load)(scene, &settings)?;
    Ok(Box::new(OneByOne(engine)))
}

/// Lets heaps settle, times them in turns, and judges what is left lying.
fn measured(options: &Options, heaps: &[Heap]) -> Result<Vec<Line>, Problem> {
    let running = heaps.iter().map(|heap| Running::settled(options, *heap));
    let mut running = running.collect::<Result<Vec<_>, _>>()?;
    let turns = options.turns.unwrap_or(BATCHES);
    let each = (options.steps / turns).max(1);
    for _ in 0..turns {
        for heap in &mut running {
            if heaps.len() > 1 {
                // The caches still hold the tables of the heap before.
                heap.steps(1);
            }
            let start = Instant::now();
            heap.steps(each);
            heap.batches.push(start.elapsed() / each);
        }
    }
    let lines = running.into_iter();
    Ok(lines.map(|heap| heap.judged(options, each)).collect())
}

/// A heap that is being timed.
struct Running {
    scene: Scene,
    count: Option<u64>,
    timed: Box<dyn Timed>,
    loading: Duration,
    settling: Duration,
    batches: Vec<Duration>,
}

impl Running {
    /// One that has made its settling steps.
    fn settled(options: &Options, heap: Heap) -> Result<Self, Problem> {
        let scene = Scene::open(&options.scene, heap.count, None)?;
        let start = Instant::now();
        let mut timed = load(options, heap, &scene)?;
        let loading = start.elapsed();
        let start = Instant::now();
        timed.steps(scene.dt as f32, options.settle);
        Ok(Self {
            count: heap.count,
            timed,
            loading,
            settling: start.elapsed(),
            batches: Vec::new(),
            scene,
        })
    }

    fn steps(&mut self, count: u32) {
        self.timed.steps(self.scene.dt as f32, count);
    }

    /// Its line, with what is left lying.
    fn judged(mut self, options: &Options, each: u32) -> Line {
        self.batches.sort_unstable();
        let mut state = State::default();
        self.timed.engine().read_state(&mut state);
        Line {
            measures: Measures::of(&self.scene, &state),
            fastest: fastest(&state),
            settle: options.settle,
            steps: each * self.batches.len() as u32,
            count: self.count,
            loading: self.loading,
            settling: self.settling,
            batches: self.batches,
            timed: self.timed,
            scene: self.scene,
        }
    }
}

/// The largest speed, m/s.
fn fastest(state: &State) -> f64 {
    let speeds = state.linear_velocity.iter().map(|v| v.length());
    speeds.fold(0.0, f64::max)
}

// A line of the table.

struct Line {
    scene: Scene,
    count: Option<u64>,
    settle: u32,
    steps: u32,
    loading: Duration,
    settling: Duration,
    /// Time of a step in each batch, the shortest first.
    batches: Vec<Duration>,
    timed: Box<dyn Timed>,
    measures: Measures,
    fastest: f64,
}

const COLUMNS: &[Column<Line>] = &[
    ("scene", |line| line.scene.name.clone()),
    ("count", |line| optional(line.count)),
    ("bodies", |line| line.scene.bodies.len().to_string()),
    ("joints", |line| line.scene.joints.len().to_string()),
    ("engine", |line| {
        line.timed.engine().info().engine.to_owned()
    }),
    ("method", |line| {
        line.timed.engine().info().method.to_owned()
    }),
    ("device", |line| device(line.timed.engine())),
    ("threads", |line| {
        line.timed.engine().info().threads.to_string()
    }),
    ("substeps", |line| {
        line.timed.engine().info().substeps.to_string()
    }),
    ("sweeps", |line| optional(line.timed.engine().info().sweeps)),
    ("dt_s", |line| line.scene.dt.to_string()),
    ("load_s", |line| seconds(line.loading)),
    ("settle_steps", |line| line.settle.to_string()),
    ("settle_s", |line| seconds(line.settling)),
    ("timed_steps", |line| line.steps.to_string()),
    ("ms_median", |line| ms(line.batches[line.batches.len() / 2])),
    ("ms_fastest", |line| ms(line.batches[0])),
    (
        "ms_slowest",
        |line| ms(line.batches[line.batches.len() - 1]),
    ),
    ("pairs", |line| {
        line.timed.engine().counters().pairs.to_string()
    }),
    ("contacts", |line| {
        line.timed.engine().counters().contacts.to_string()
    }),
    ("overflow", |line| {
        line.timed.engine().counters().overflow.to_string()
    }),
    ("kinetic_energy_j_a_body", |line| {
        let bodies = line.scene.dynamic_count() as f64;
        short(line.measures.conserved.kinetic_energy / bodies)
    }),
    ("fastest_m_s", |line| short(line.fastest)),
    ("escaped", |line| optional(line.measures.escaped)),
    ("not_finite", |line| line.measures.not_finite.to_string()),
    ("touching", |line| {
        line.measures.penetration.pairs_touching.to_string()
    }),
    ("not_measured", |line| {
        line.measures.penetration.pairs_not_measured.to_string()
    }),
    ("p50_of_r", |line| {
        short(line.measures.penetration.relative.p50)
    }),
    ("p99_of_r", |line| {
        short(line.measures.penetration.relative.p99)
    }),
    ("max_of_r", |line| {
        short(line.measures.penetration.relative.deepest)
    }),
    ("p99_m", |line| short(line.measures.penetration.p99)),
    ("max_m", |line| short(line.measures.penetration.deepest)),
    ("separation_m", |line| {
        optional(line.measures.joint_separation.map(short))
    }),
    ("limit_excess_rad", |line| {
        optional(line.measures.limit_excess.map(short))
    }),
    ("asleep", |line| {
        line.timed.engine().counters().asleep.to_string()
    }),
];

/// The name of what it runs on, without the commas that separate columns.
fn device(engine: &dyn Engine) -> String {
    let name = engine.info().device;
    let name = if name == "cpu" {
        processor().unwrap_or(name)
    } else {
        name
    };
    name.replace(',', ";")
}

fn optional(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn seconds(time: Duration) -> String {
    format!("{:.3}", time.as_secs_f64())
}

fn ms(time: Duration) -> String {
    format!("{:.4}", 1e3 * time.as_secs_f64())
}
