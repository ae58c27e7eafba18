//! An engine for the shell's own tests: points that fall freely, each step exact.
//!
//! p += v Δt + ½ g Δt², v += g Δt. The method `heavy` falls twice as fast, so that tests see
//! a change of engine, and removes no bodies, so that they see a refusal.

mod beside;
mod resident;
mod tables;

use ch00_scenes::{
    Added, Body, Cell, Column, ColumnData, Edit, Engine, EngineEntry, EngineInfo, LoadError,
    Method, Pull, RemoveError, RowId, Scene, Settings, Shape, State, TableError, TableInfo,
};
use glam::{DQuat, DVec3, Vec3};

use crate::Session;
use crate::chapter::Chapter;
use crate::gpu::Gpu;
use tables::Ids;

pub(crate) use beside::Falls;
pub(crate) use resident::{GLANCES, RESIDENT};
pub(crate) use tables::{FARTHEST, PAIRS};

/// The engine of [`CHAPTER`].
pub(crate) const FALLING: EngineEntry = EngineEntry {
    name: "falling",
    chapter: "ch00_shell",
    methods: &[
        Method {
            name: "light",
            about: "falls with gravity",
        },
        Method {
            name: "heavy",
            about: "falls with twice gravity",
        },
    ],
    load,
};

/// A chapter that can let things fall.
pub(crate) const CHAPTER: Chapter = Chapter {
    name: "ch00_shell",
    title: "Falling",
    about: "Points fall.",
    engines: &[FALLING],
    default_scene: "pair",
    scenes: &["pair", "bounce"],
};

/// Most bodies that the engine takes, so that tests see a refusal.
pub(crate) const MOST_BODIES: usize = 20_000;

/// A ball, 10 m up and so far to the side.
pub(crate) fn ball(across: f64) -> Body {
    let shape = Shape::Sphere { radius: 0.1 };
    Body::new(shape, 1.0, DVec3::new(across, 10.0, 0.0))
}

/// So many balls at rest, 10 m up, a metre apart; gravity is 8 m/s², a step ¼ s.
pub(crate) fn scene_of_balls(count: usize) -> Scene {
    let mut scene = Scene::new("balls in a row");
    scene.gravity = DVec3::new(0.0, -8.0, 0.0);
    scene.dt = 0.25;
    scene.bodies = (0..count).map(|i| ball(i as f64)).collect();
    scene
}

/// These balls, about to fall.
pub(crate) fn balls(count: usize) -> Session {
    Session::new(scene_of_balls(count), FALLING, Settings::defaults()).expect("they can fall")
}

/// The same on the device, in a window.
pub(crate) fn resident_balls(count: usize) -> Session {
    Session::new(scene_of_balls(count), RESIDENT, Settings::defaults())
        .expect("they can fall")
        .in_window()
}

/// Loses the device that is open.
pub(crate) fn lose_device() {
    let gpu = Gpu::shared().expect("it is open");
    gpu.device.destroy();
    let outcome = gpu.device.poll(wgpu::PollType::wait_indefinitely());
    outcome.expect("nothing is left to do");
}

struct Falling {
    method: &'static str,
    gravity: Vec3,
    ids: Ids,
    moves: Vec<bool>,
    position: Vec<Vec3>,
    velocity: Vec<Vec3>,
}

fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    let method = FALLING.method(settings)?.name;
    let scale = if method == "heavy" { 2.0 } else { 1.0 };
    let mut engine = Falling {
        method,
        gravity: scene.gravity.as_vec3() * scale,
        ids: Ids::default(),
        moves: Vec::new(),
        position: Vec::new(),
        velocity: Vec::new(),
    };
    for body in &scene.bodies {
        engine.add_body(body, 0.0)?;
    }
    Ok(Box::new(engine))
}

impl Engine for Falling {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: FALLING.name,
            method: self.method,
            threads: 1,
            device: "cpu".to_owned(),
            substeps: 1,
            sweeps: None,
            real_size: 4,
            restitution_threshold: 0.0,
        }
    }

    fn step(&mut self, dt: f32) {
        for i in 0..self.position.len() {
            if self.moves[i] {
                self.position[i] += self.velocity[i] * dt + 0.5 * self.gravity * dt * dt;
                self.velocity[i] += self.gravity * dt;
            }
        }
    }

    fn read_state(&self, state: &mut State) {
        state.clear();
        for (position, velocity) in self.position.iter().zip(&self.velocity) {
            let (position, velocity) = (position.as_dvec3(), velocity.as_dvec3());
            state.push(position, DQuat::IDENTITY, velocity, DVec3::ZERO);
        }
    }

    fn write_state(&mut self, state: &State, _dt: f32) {
        self.position = state.position.iter().map(|p| p.as_vec3()).collect();
        self.velocity = state.linear_velocity.iter().map(|v| v.as_vec3()).collect();
    }

    fn columns(&self) -> Vec<Column> {
        Vec::new()
    }

    fn tables(&self) -> Vec<TableInfo> {
        self.table_infos()
    }

    fn cells(&self, table: &str, column: &str, rows: &[usize]) -> Result<ColumnData, TableError> {
        self.cells_of(table, column, rows)
    }

    fn row_ids(&self, table: &str, rows: &[usize]) -> Vec<RowId> {
        self.ids_of(table, rows)
    }

    fn row_of(&self, table: &str, id: RowId) -> Option<usize> {
        self.row_with(table, id)
    }

    fn edit(&mut self, edit: &Edit) -> Result<Cell, TableError> {
        self.change(edit)
    }

    fn explain(&self) -> String {
        "Each point falls on its own.".to_owned()
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        if self.position.len() == MOST_BODIES {
            return Err(LoadError::Unsupported {
                engine: FALLING.name,
                chapter: FALLING.chapter,
                scene: "test".to_owned(),
                what: format!("more than {MOST_BODIES} bodies"),
                index: None,
            });
        }
        self.ids.add();
        self.moves.push(!body.is_static());
        self.position.push(body.position.as_vec3());
        self.velocity.push(body.linear_velocity.as_vec3());
        Ok(self.position.len() - 1)
    }

    fn remove_body(&mut self, body: usize) -> Result<(), RemoveError> {
        if self.method == "heavy" {
            let engine = FALLING.name;
            return Err(RemoveError::Unsupported { engine });
        }
        self.ids.remove(body);
        self.moves.remove(body);
        self.position.remove(body);
        self.velocity.remove(body);
        Ok(())
    }

    fn pull(&mut self, _pull: Option<Pull>) {}
}
