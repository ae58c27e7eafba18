//! Engine `compute`: what the window, the tests and the laboratory see of a step on the GPU.

use std::cell::{Cell, RefCell};

use ch00_scenes::{
    Added, BODIES, Body, Column, ColumnData, ColumnInfo, Counters, Drawing, Engine, EngineEntry,
    EngineInfo, Layer, LoadError, PassTime, Pull, RemoveError, Scene, Settings, State, TableError,
    TableInfo,
};

use super::device::{Device, open};
use super::driver::Driver;
use super::error::ComputeError;
use super::late::Late;
use super::layers;
use crate::lanes::forces::{check_fixed_points, check_no_push};
use crate::lanes::unsupported;
use crate::rows::Mouse;
use crate::rules::{METHOD, Rules};
use crate::stream::{StreamError, Timer};

/// The entry of engine `compute` in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "compute",
    chapter: "ch06_compute",
    methods: &[crate::lanes::OWN_ROW],
    load,
};

/// Parts of a step whose times are measured.
const MOST_TIMED: u32 = 64;

/// A run on the GPU.
pub struct ComputeEngine {
    driver: RefCell<Driver>,
    scene: Scene,
    rules: Rules,
    device: Device,
    /// The last state that came down.
    state: RefCell<State>,
    late: Late,
    timer: Timer,
    times: Vec<PassTime>,
    steps: u32,
    failed: Cell<Option<StreamError>>,
    #[cfg(feature = "window")]
    resident: Option<ch00_shell::Resident>,
}

/// Loads any scene; one of orbits alone goes to chapter 1.
fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    if !scene.orbits.is_empty() {
        return (ch01_hierarchy::ENGINE.load)(scene, &Settings::defaults());
    }
    Ok(Box::new(ComputeEngine::load(scene, settings)?))
}

/// What a device lacks, as a reason why a scene can't be loaded.
fn lacks(scene: &Scene, error: &ComputeError) -> LoadError {
    LoadError::Unsupported {
        engine: ENGINE.name,
        chapter: ENGINE.chapter,
        scene: scene.name.clone(),
        what: format!("{error}. Engine `lanes` makes the same steps on the CPU"),
        index: None,
    }
}

impl ComputeEngine {
    /// Loads a scene without orbits on the device that this program has open.
    ///
    /// # Errors
    /// [`LoadError`] for an unknown method, a setting that it lacks, what it doesn't model, no device, and
    /// more bodies than the device has room for.
    pub fn load(scene: &Scene, settings: &Settings) -> Result<Self, LoadError> {
        settings.refuse_sleeping(ENGINE.method(settings)?.name)?;
        let rules = Rules::of(scene, settings)?;
        Rules::check_resolution(scene).map_err(|why| unsupported(ENGINE.name, scene, why))?;
        check_fixed_points(scene).map_err(|why| unsupported(ENGINE.name, scene, why))?;
        check_no_push(scene).map_err(|why| unsupported(ENGINE.name, scene, why))?;
        let device = open().map_err(|error| lacks(scene, &error.into()))?;
        Self::load_on(device, scene, rules).map_err(|error| lacks(scene, &error))
    }

    fn load_on(device: Device, scene: &Scene, rules: Rules) -> Result<Self, ComputeError> {
        let mut driver = Driver::of(&device.gpu, scene, rules)?;
        if device.is_windows {
            driver.draw()?;
        }
        Ok(Self {
            #[cfg(feature = "window")]
            resident: Some(device.resident(driver.columns())?),
            late: Late::of(&driver, 0),
            timer: Timer::new(&device.gpu, MOST_TIMED),
            driver: RefCell::new(driver),
            state: RefCell::new(State::start_of(scene)),
            scene: scene.clone(),
            rules,
            device,
            times: Vec::new(),
            steps: 0,
            failed: Cell::new(None),
        })
    }

    /// Makes many steps with one submission, without waiting.
    pub fn steps(&mut self, dt: f32, count: u32) {
        self.steps += count;
        let made = self.driver.get_mut().step(dt, count);
        self.note(made);
    }

    /// The rows on the device.
    pub fn driver(&mut self) -> &mut Driver {
        self.driver.get_mut()
    }

    /// Takes over the times that have come down.
    fn take_times(&mut self) {
        if let Some(parts) = self.timer.latest(&self.device.gpu) {
            let time = |(name, time)| PassTime { name, time };
            self.times = parts.into_iter().map(time).collect();
        }
    }

    /// Keeps the first error.
    fn note<T>(&self, result: Result<T, StreamError>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(error) => {
                let first = self.failed.take().unwrap_or(error);
                self.failed.set(Some(first));
                None
            }
        }
    }

    fn has_failed(&self) -> bool {
        let failed = self.failed.take();
        let has = failed.is_some();
        self.failed.set(failed);
        has
    }

    /// Loads the scene as it is now, with the bodies where they are.
    fn reload(&mut self, state: &State) -> Result<(), LoadError> {
        let mut anew = Self::load_on(self.device.clone(), &self.scene, self.rules)
            .map_err(|error| lacks(&self.scene, &error))?;
        anew.steps = self.steps;
        anew.write_state(state, self.scene.dt as f32);
        *self = anew;
        Ok(())
    }
}

impl Engine for ComputeEngine {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: ENGINE.name,
            method: METHOD,
            threads: 1,
            device: self.device.gpu.name.clone(),
            substeps: self.rules.substeps,
            sweeps: None,
            real_size: 4,
            restitution_threshold: f64::from(self.rules.restitution_threshold),
        }
    }

    fn step(&mut self, dt: f32) {
        if self.has_failed() {
            return;
        }
        self.steps += 1;
        let made = self.driver.get_mut().timed_step(dt, &mut self.timer);
        self.note(made);
        self.take_times();
    }

    fn finish(&mut self) {
        let settled = self.driver.get_mut().settle();
        self.note(settled);
        self.take_times();
    }

    fn read_state(&self, state: &mut State) {
        if !self.has_failed() {
            let mut last = self.state.borrow_mut();
            let mut now = State::default();
            let read = self.driver.borrow_mut().read(&mut now);
            if self.note(read).is_some() {
                *last = now;
                self.late.known.set(Some(self.steps));
            }
        }
        state.clone_from(&self.state.borrow());
    }

    // ANCHOR: glance
    fn glance(&mut self, state: &mut State) -> Option<u64> {
        if self.has_failed() {
            state.clone_from(&self.state.borrow());
            return Some(0);
        }
        let mut late = std::mem::take(&mut self.late);
        let found = late.glance(self.driver.get_mut(), self.steps);
        self.late = late;
        let (step, now) = self.note(found)??;
        *self.state.borrow_mut() = now;
        state.clone_from(&self.state.borrow());
        Some(u64::from(self.steps - step))
    }
    // ANCHOR_END: glance

    #[cfg(feature = "window")]
    fn resident(&self) -> Option<&dyn std::any::Any> {
        self.resident
            .as_ref()
            .map(|resident| resident as &dyn std::any::Any)
    }

    fn failure(&self) -> Option<String> {
        let checked = self.device.gpu.check();
        self.note(checked);
        let failed = self.failed.take();
        let why = failed.as_ref().map(ToString::to_string);
        self.failed.set(failed);
        why
    }

    fn write_state(&mut self, state: &State, _dt: f32) {
        self.late.forget();
        self.late.known.set(Some(self.steps));
        self.state.get_mut().clone_from(state);
        let written = self.driver.get_mut().write(state);
        self.note(written);
    }

    fn columns(&self) -> Vec<Column> {
        let mut state = State::default();
        state.clone_from(&self.state.borrow());
        let vectors = |of: &[glam::DVec3]| {
            ColumnData::Vector(of.iter().map(|v| v.as_vec3().to_array()).collect())
        };
        let turns = state.orientation.iter().map(|q| q.as_quat().to_array());
        vec![
            Column {
                name: "p",
                unit: "m",
                about: "World position, as it last came down.",
                data: vectors(&state.position),
            },
            Column {
                name: "q",
                unit: "",
                about: "Body to world, as it last came down.",
                data: ColumnData::Quaternion(turns.collect()),
            },
            Column {
                name: "v",
                unit: "m/s",
                about: "World velocity, as it last came down.",
                data: vectors(&state.linear_velocity),
            },
            Column {
                name: "ω",
                unit: "rad/s",
                about: "World angular velocity, as it last came down.",
                data: vectors(&state.angular_velocity),
            },
        ]
    }

    fn tables(&self) -> Vec<TableInfo> {
        let columns = self.columns();
        let mut all = vec![TableInfo {
            name: BODIES,
            about: "Where bodies are and how they move, as it last came down.",
            rows: self.scene.bodies.len(),
            columns: columns.iter().map(ColumnInfo::gathered).collect(),
        }];
        all.extend(self.late.tables.info(self.driver.borrow().columns()));
        all
    }

    fn cells(&self, table: &str, column: &str, rows: &[usize]) -> Result<ColumnData, TableError> {
        if table != BODIES {
            let step = self.late.known.get();
            return self.late.tables.cells(table, column, rows, step);
        }
        let columns = self.columns();
        let found = columns.iter().find(|known| known.name == column);
        found.map(|found| found.data.of_rows(rows)).ok_or_else(|| {
            TableError::unknown_column(table, column, columns.iter().map(|column| column.name))
        })
    }

    fn lacks_cells(&self) -> bool {
        !self.has_failed() && self.late.tables.lacks(self.late.known.get())
    }

    fn layers(&self) -> &'static [Layer] {
        layers::LAYERS
    }

    fn layer(&self, layer: Layer) -> Drawing {
        let (edge, largest) = self.driver.borrow().cells();
        layers::draw(layer, &self.scene, &self.state.borrow(), edge, largest)
    }

    fn counters(&self) -> Counters {
        self.driver.borrow().counters()
    }

    fn pass_times(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    fn explain(&self) -> String {
        let passes = self.driver.borrow().explain();
        let moving = self.scene.dynamic_count();
        format!(
            "scene `{}` by own rows on {}: {moving} bodies that move, {} that don't, {} joints; {} substeps a step\n{passes}",
            self.scene.name,
            self.device.gpu.name,
            self.scene.bodies.len() - moving,
            self.scene.joints.len(),
            self.rules.substeps
        )
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        let mut state = State::default();
        self.read_state(&mut state);
        state.push(
            body.position,
            body.orientation,
            body.linear_velocity,
            body.angular_velocity,
        );
        self.scene.bodies.push(body.clone());
        if let Err(error) = self.reload(&state) {
            self.scene.bodies.pop();
            return Err(error);
        }
        Ok(self.scene.bodies.len() - 1)
    }

    fn remove_body(&mut self, body: usize) -> Result<(), RemoveError> {
        self.scene.check_removal(body)?;
        let mut state = State::default();
        self.read_state(&mut state);
        let last = self.scene.clone();
        self.scene.remove_body(body)?;
        state.position.remove(body);
        state.orientation.remove(body);
        state.linear_velocity.remove(body);
        state.angular_velocity.remove(body);
        self.reload(&state).map_err(|_| {
            self.scene = last;
            RemoveError::Unsupported {
                engine: ENGINE.name,
            }
        })
    }

    fn pull(&mut self, pull: Option<Pull>) {
        let mouse = pull.map(|pull| Mouse {
            anchor: pull.anchor.as_vec3(),
            body: pull.body as u32,
            towards: pull.target.as_vec3(),
            mass: self.scene.bodies[pull.body].mass as f32,
        });
        let pulled = self.driver.get_mut().pull(mouse);
        self.note(pulled);
    }
}
