//! A heap that settles, and is timed.

use std::time::{Duration, Instant};

use ch00_scenes::measures::Measures;
use ch00_scenes::{Engine, Scene, Settings, State};
use ch06_compute::compute::ComputeEngine;

use crate::line::Line;
use crate::options::{Heap, Options};
use crate::table::Problem;

/// An engine that is timed.
pub trait Timed {
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

/// A heap that has settled, and is timed.
pub struct Settled {
    scene: Scene,
    count: Option<u64>,
    timed: Box<dyn Timed>,
    loading: Duration,
    settling: Duration,
    batches: Vec<Duration>,
}

impl Settled {
    /// One that has made its settling steps.
    pub fn of(options: &Options, heap: Heap) -> Result<Self, Problem> {
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

    /// Times a batch of so many steps.
    pub fn time(&mut self, steps: u32) {
        let start = Instant::now();
        self.steps(steps);
        self.batches.push(start.elapsed() / steps);
    }

    /// Makes some steps, and comes back when the last one is done.
    pub fn steps(&mut self, count: u32) {
        self.timed.steps(self.scene.dt as f32, count);
    }

    /// Its line, with what is left lying.
    pub fn judged(mut self, options: &Options, each: u32) -> Line {
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
