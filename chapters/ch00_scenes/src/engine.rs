//! What every engine can do, so that any scene runs on any engine in the window, in the
//! tests and in the laboratory.

use std::time::Duration;

use glam::DVec3;
use thiserror::Error;

use crate::{
    Body, Cell, ColumnInfo, Dissection, Drawing, Edit, Layer, RemoveError, RowId, Scene, State,
    TableError, TableInfo,
};

/// Which mathematics an engine uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    /// As `--method` says it.
    pub name: &'static str,
    /// One sentence for `--help` and `--explain`.
    pub about: &'static str,
}

/// What the user may choose about a run besides the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Name of the method; `None` for the engine's default.
    pub method: Option<String>,
    /// Solver sweeps over the contacts of a step; `None` for the method's measured default.
    pub sweeps: Option<u32>,
    /// Parts of a step; `None` for the method's default.
    pub substeps: Option<u32>,
    /// Threads; `None` for the engine's default.
    pub threads: Option<u32>,
}

impl Settings {
    /// Every choice left to the engine.
    #[must_use]
    pub fn defaults() -> Self {
        Self {
            method: None,
            sweeps: None,
            substeps: None,
            threads: None,
        }
    }

    /// The same with a method.
    #[must_use]
    pub fn with_method(mut self, method: &str) -> Self {
        self.method = Some(method.to_owned());
        self
    }

    /// The same with a number of sweeps.
    #[must_use]
    pub fn with_sweeps(mut self, sweeps: u32) -> Self {
        self.sweeps = Some(sweeps);
        self
    }
}

/// An engine in a chapter's list: its name, what it can do, and how to load a scene into it.
#[derive(Clone, Copy)]
pub struct EngineEntry {
    /// As `--engine` says it: `objects`, `properties`, `lanes` or `compute`.
    pub name: &'static str,
    /// The crate that it comes from.
    pub chapter: &'static str,
    /// Its methods, the default first.
    pub methods: &'static [Method],
    /// Builds the engine with the scene in it.
    pub load: fn(&Scene, &Settings) -> Loaded,
}

/// The outcome of loading a scene into an engine.
pub type Loaded = Result<Box<dyn Engine>, LoadError>;

/// Why an engine can't take a scene.
#[derive(Debug, Error, Clone, PartialEq, Eq)]
pub enum LoadError {
    /// The engine has no such method.
    #[error("engine `{engine}` has no method `{method}`; it has: {known}")]
    UnknownMethod {
        /// Name of the engine.
        engine: &'static str,
        /// What was asked for.
        method: String,
        /// What there is, separated by commas.
        known: String,
    },
    /// The scene holds something that this engine or method doesn't model.
    #[error("engine `{engine}` ({chapter}) can't run scene `{scene}`: {what}{}", index.map(|i| format!(" (index {i})")).unwrap_or_default())]
    Unsupported {
        /// Name of the engine.
        engine: &'static str,
        /// The crate that it comes from.
        chapter: &'static str,
        /// Name of the scene.
        scene: String,
        /// What it doesn't model, and which chapter does.
        what: String,
        /// Index of the body, joint or force.
        index: Option<usize>,
    },
    /// A setting that the method doesn't have or can't take.
    #[error("method `{method}`: `--{setting} {value}`: {why}")]
    Setting {
        /// Name of the method.
        method: &'static str,
        /// Name of the flag.
        setting: &'static str,
        /// What was asked for.
        value: String,
        /// Why that can't be.
        why: String,
    },
}

impl EngineEntry {
    /// Loads a scene, makes `steps` of its steps, and gives the state after them.
    ///
    /// # Errors
    /// [`LoadError`] where the engine can't take the scene.
    pub fn run(&self, scene: &Scene, settings: &Settings, steps: u32) -> Result<State, LoadError> {
        let mut engine = (self.load)(scene, settings)?;
        for _ in 0..steps {
            engine.step(scene.dt as f32);
        }
        let mut state = State::default();
        engine.read_state(&mut state);
        Ok(state)
    }

    /// The method that `settings` name, or the default.
    ///
    /// # Errors
    /// [`LoadError::UnknownMethod`] that lists the known ones.
    pub fn method(&self, settings: &Settings) -> Result<&'static Method, LoadError> {
        let Some(name) = &settings.method else {
            return Ok(&self.methods[0]);
        };
        self.methods
            .iter()
            .find(|method| method.name == name)
            .ok_or_else(|| LoadError::UnknownMethod {
                engine: self.name,
                method: name.clone(),
                known: self
                    .methods
                    .iter()
                    .map(|method| method.name)
                    .collect::<Vec<_>>()
                    .join(", "),
            })
    }
}

/// Who steps, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct EngineInfo {
    /// `objects`, `properties`, `lanes` or `compute`.
    pub engine: &'static str,
    /// The method in use.
    pub method: &'static str,
    /// Threads in use.
    pub threads: u32,
    /// Name of the device; `cpu` for the CPU.
    pub device: String,
    /// Parts of a step.
    pub substeps: u32,
    /// Solver sweeps over the contacts of a step, where the method has them.
    pub sweeps: Option<u32>,
    /// Bytes of a real number in the engine's state: 4 or 8.
    pub real_size: u32,
    /// Below this approach speed a contact doesn't bounce, m/s.
    pub restitution_threshold: f64,
}

/// One property of all bodies, for the overlay's tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The property's name.
    pub name: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// A value a body, in the scene's order.
    pub data: ColumnData,
}

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnData {
    /// One number a row.
    Scalar(Vec<f32>),
    /// Three numbers a row.
    Vector(Vec<[f32; 3]>),
    /// Four numbers a row: x, y, z, w.
    Quaternion(Vec<[f32; 4]>),
    /// Nine numbers a row, column by column.
    Matrix(Vec<[f32; 9]>),
    /// A whole number a row.
    Index(Vec<u32>),
}

/// A contact of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Index of the first body.
    pub a: usize,
    /// Index of the second body.
    pub b: usize,
    /// World position, m.
    pub point: DVec3,
    /// Unit vector from b to a.
    pub normal: DVec3,
    /// How deep the two overlapped when found, m.
    pub depth: f64,
    /// Impulse that a received, N s.
    pub impulse: DVec3,
}

/// What the last step counted. Nothing is skipped in silence: what a step could not do
/// stands in `overflow`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Pairs of bodies that the broad phase found.
    pub pairs: usize,
    /// Contacts that the narrow phase found.
    pub contacts: usize,
    /// Things that a capacity or an iteration limit left undone since loading.
    pub overflow: usize,
}

/// Time that a part of the last step took.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassTime {
    /// The part's name, as in the step function.
    pub name: &'static str,
    /// Wall time.
    pub time: Duration,
}

/// A spring that pulls a body to a point: the mouse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pull {
    /// Index of the body.
    pub body: usize,
    /// Where it is held, in the body's coordinates, m.
    pub anchor: DVec3,
    /// Where it is pulled to, in the world, m.
    pub target: DVec3,
}

/// The table that every engine has.
pub const BODIES: &str = "bodies";

/// The outcome of adding a body in mid-run.
pub type Added = Result<usize, LoadError>;

/// What every engine can do.
pub trait Engine {
    /// Who steps, and how.
    fn info(&self) -> EngineInfo;

    /// Advances the scene by `dt` seconds.
    fn step(&mut self, dt: f32);

    /// Writes where every body is into `state`, in the scene's order.
    fn read_state(&self, state: &mut State);

    /// Takes over the state of another engine that runs the same scene; `dt` is the step
    /// that comes next.
    fn write_state(&mut self, state: &State, dt: f32);

    /// The properties that the overlay can show, in its order.
    fn columns(&self) -> Vec<Column>;

    /// The tables that the overlay can show. An engine that keeps none shows its bodies' columns.
    fn tables(&self) -> Vec<TableInfo> {
        let columns = self.columns();
        vec![TableInfo {
            name: BODIES,
            about: "the bodies' properties, gathered from the objects",
            rows: columns.first().map_or(0, |column| column.data.len()),
            columns: columns.iter().map(ColumnInfo::gathered).collect(),
        }]
    }

    /// The cells of some rows of a column, in the order of `rows`.
    ///
    /// # Errors
    /// [`TableError`] where there is no such table or column, or the plan left it out.
    fn cells(&self, table: &str, column: &str, rows: &[usize]) -> Result<ColumnData, TableError> {
        if table != BODIES {
            return Err(TableError::unknown_table(table, [BODIES]));
        }
        let columns = self.columns();
        let found = columns.iter().find(|known| known.name == column);
        found.map(|found| found.data.of_rows(rows)).ok_or_else(|| {
            TableError::unknown_column(table, column, columns.iter().map(|column| column.name))
        })
    }

    /// The IDs of some rows of a table, in the order of `rows`; rows that there aren't give none.
    fn row_ids(&self, _table: &str, rows: &[usize]) -> Vec<RowId> {
        rows.iter().map(|&row| RowId::first(row as u32)).collect()
    }

    /// Where the row with this ID is now; None once it is gone.
    fn row_of(&self, table: &str, id: RowId) -> Option<usize> {
        let row = id.slot as usize;
        let tables = self.tables();
        let rows = tables.iter().find(|known| known.name == table)?.rows;
        (row < rows && id.generation == 0).then_some(row)
    }

    /// Gives a cell another value; gives the value that it had.
    ///
    /// # Errors
    /// [`TableError`] where there is no such cell, or it can't take the value; nothing has changed
    /// then.
    fn edit(&mut self, edit: &Edit) -> Result<Cell, TableError> {
        Err(TableError::NotEditable {
            table: edit.table.clone(),
            column: edit.column.clone(),
            why: "this engine keeps no columns".to_owned(),
        })
    }

    /// The contacts of the last step.
    fn contacts(&self) -> Vec<ContactPoint> {
        Vec::new()
    }

    /// The pairs of bodies that the broad phase of the last step found, the smaller index first,
    /// in order.
    fn pairs(&self) -> &[(usize, usize)] {
        &[]
    }

    /// What the last step counted.
    fn counters(&self) -> Counters {
        Counters::default()
    }

    /// How long each part of the last step took, in the order of the step.
    fn pass_times(&self) -> Vec<PassTime> {
        Vec::new()
    }

    /// What this engine does with this scene and why, for `--explain`.
    fn explain(&self) -> String;

    /// Draws a layer; nothing where the engine doesn't have it.
    fn layer(&self, _layer: Layer) -> Drawing {
        Drawing::default()
    }

    /// The layers that it can draw, in the order of [`Layer::ALL`].
    fn layers(&self) -> &'static [Layer] {
        &[]
    }

    /// What the narrow phase does with bodies `a` and `b` where they are now, after its
    /// iteration `step`, from 0; past the last, that one. None where the engine has no narrow
    /// phase to look into, or no such pair.
    fn dissect(&self, _a: usize, _b: usize, _step: usize) -> Option<Dissection> {
        None
    }

    /// Adds a body in mid-run; gives its index.
    ///
    /// # Errors
    /// [`LoadError::Unsupported`] where the engine can't.
    fn add_body(&mut self, body: &Body, dt: f32) -> Added;

    /// Removes a body in mid-run; those after it move up by one.
    ///
    /// # Errors
    /// [`RemoveError`] where the engine can't, or a joint or force holds the body; nothing has changed
    /// then.
    fn remove_body(&mut self, _body: usize) -> Result<(), RemoveError> {
        Err(RemoveError::Unsupported {
            engine: self.info().engine,
        })
    }

    /// Pulls a body from now on, or lets go.
    fn pull(&mut self, pull: Option<Pull>);
}
