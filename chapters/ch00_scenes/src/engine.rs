//! What every engine can do, so that any scene runs on any engine in the window, in the
//! tests and in the laboratory.

mod shown;

use std::any::Any;

use glam::DVec3;
use thiserror::Error;

use crate::{
    Body, Cell, ColumnInfo, Dissection, Drawing, Edit, Layer, RemoveError, RowId, Scene, State,
    TableError, TableInfo,
};

pub use shown::{Column, ColumnData, ContactPoint, Counters, EngineInfo, PassTime};

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
    /// Whether bodies that have come to rest may sleep.
    pub sleeping: bool,
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
            sleeping: false,
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

    /// What a method says in which nobody sleeps.
    ///
    /// # Errors
    /// [`LoadError::Setting`] if somebody shall.
    pub fn refuse_sleeping(&self, method: &'static str) -> Result<(), LoadError> {
        if !self.sleeping {
            return Ok(());
        }
        Err(LoadError::Setting {
            method,
            setting: "sleeping",
            value: String::new(),
            why: "bodies sleep in engine `lanes` (chapter 6) alone".to_owned(),
        })
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
    #[error("method `{method}`: `--{setting}{}{value}`: {why}", if value.is_empty() { "" } else { " " })]
    Setting {
        /// Name of the method.
        method: &'static str,
        /// Name of the flag.
        setting: &'static str,
        /// What was asked for; nothing where the flag has no value.
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

    /// Waits until the steps are made, where [`Self::step`] only hands them to a device.
    fn finish(&mut self) {}

    /// Writes where every body is after the last step into `state`, in the scene's order. An engine on
    /// a device waits for it; one that has failed writes the last state that came back.
    fn read_state(&self, state: &mut State);

    /// The same without waiting, for a window. An engine on a device is called once or more a frame
    /// until the state has come: the first call asks for the state after the last step; the one that
    /// finds it there writes it and gives how many steps were made since; None until then. The call
    /// after that asks again. What was asked for before bodies or states were changed from outside
    /// is dropped.
    fn glance(&mut self, state: &mut State) -> Option<u64> {
        self.read_state(state);
        Some(0)
    }

    /// Whether somebody has asked for cells that only the next [`Self::glance`] can bring.
    fn lacks_cells(&self) -> bool {
        false
    }

    /// What a renderer can draw the bodies from without asking for their state, where they are kept
    /// on a device; whoever draws knows its type (`ch00_shell::Resident`).
    fn resident(&self) -> Option<&dyn Any> {
        None
    }

    /// Why the engine can't go on, such as a device that was lost; its steps do nothing then.
    fn failure(&self) -> Option<String> {
        None
    }

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
