//! An engine for the shell's own tests: points that fall freely, each step exact.
//!
//! p += v Δt + ½ g Δt², v += g Δt. The method `heavy` falls twice as fast, so that tests see
//! a change of engine.

use ch00_scenes::{
    Added, Body, Column, ColumnData, Engine, EngineEntry, EngineInfo, LoadError, Method, Pull,
    Scene, Settings, State,
};
use glam::{DQuat, Vec3};

use crate::chapter::Chapter;

/// The only engine of [`CHAPTER`].
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

struct Falling {
    method: &'static str,
    gravity: Vec3,
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
            state.push(position, DQuat::IDENTITY, velocity, glam::DVec3::ZERO);
        }
    }

    fn write_state(&mut self, state: &State, _dt: f32) {
        self.position = state.position.iter().map(|p| p.as_vec3()).collect();
        self.velocity = state.linear_velocity.iter().map(|v| v.as_vec3()).collect();
    }

    fn columns(&self) -> Vec<Column> {
        vec![Column {
            name: "position",
            unit: "m",
            about: "Where the point is.",
            data: ColumnData::Vector(self.position.iter().map(Vec3::to_array).collect()),
        }]
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
        self.moves.push(!body.is_static());
        self.position.push(body.position.as_vec3());
        self.velocity.push(body.linear_velocity.as_vec3());
        Ok(self.position.len() - 1)
    }

    fn pull(&mut self, _pull: Option<Pull>) {}
}
