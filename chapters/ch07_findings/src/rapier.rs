//! rapier3d as an engine of the laboratory, behind the feature `rapier`: the same scenes, the same measures,
//! on one thread. `shipped` is as it comes; `unswept` is the same without its continuous collision detection;
//! `tuned` is without it too, has 16 substeps, which it calls iterations, for 4, and mends overlaps that it would
//! leave alone. None lets anything sleep.

use std::sync::Mutex;

use ch00_scenes::{
    Added, Body, Column, Engine, EngineEntry, EngineInfo, LoadError, Loaded, Method, Pull, Scene,
    Settings, State,
};
use ch06_compute::peer::{Cone, Rapier, Setup};

/// The entry in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "rapier",
    chapter: "ch07_findings",
    methods: &[SHIPPED, UNSWEPT, TUNED],
    load,
};

const SHIPPED: Method = Method {
    name: "shipped",
    about: "rapier3d 0.36.1 with its own settings",
};
const UNSWEPT: Method = Method {
    name: "unswept",
    about: "rapier3d 0.36.1 with its own settings, without its continuous collision detection",
};
const TUNED: Method = Method {
    name: "tuned",
    about: "rapier3d 0.36.1 with 16 iterations and no allowed overlap, without continuous collision detection",
};

/// A run.
struct Run {
    method: &'static Method,
    // Its world isn't shared between threads; nobody does, but an engine has to say so.
    world: Mutex<Rapier>,
    iterations: u32,
}

fn load(scene: &Scene, settings: &Settings) -> Loaded {
    let method = ENGINE.method(settings)?;
    let tolerant = *method != TUNED;
    let setup = Setup {
        threads: settings.threads.unwrap_or(1),
        iterations: settings.substeps.unwrap_or(if tolerant { 4 } else { 16 }),
        cone: Cone::Coupled,
        tolerant,
        ccd: *method == SHIPPED,
    };
    let world = Rapier::load(scene, setup).map_err(|why| refused(scene, why.to_string()))?;
    Ok(Box::new(Run {
        method,
        iterations: setup.iterations,
        world: Mutex::new(world),
    }))
}

fn refused(scene: &Scene, what: String) -> LoadError {
    LoadError::Unsupported {
        engine: ENGINE.name,
        chapter: ENGINE.chapter,
        scene: scene.name.clone(),
        what,
        index: None,
    }
}

impl Engine for Run {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: ENGINE.name,
            method: self.method.name,
            threads: 1,
            device: "cpu".to_owned(),
            substeps: self.iterations,
            sweeps: None,
            real_size: 4,
            restitution_threshold: 0.0,
        }
    }

    fn step(&mut self, dt: f32) {
        if let Ok(rapier) = self.world.get_mut() {
            rapier.inside(|world| {
                world.integration_parameters.dt = dt;
                world.step();
            });
        }
    }

    fn read_state(&self, state: &mut State) {
        if let Ok(rapier) = self.world.lock() {
            rapier.read(state);
        }
    }

    fn write_state(&mut self, _state: &State, _dt: f32) {}

    fn columns(&self) -> Vec<Column> {
        Vec::new()
    }

    fn explain(&self) -> String {
        format!("{}: {}\n", self.method.name, self.method.about)
    }

    fn add_body(&mut self, _body: &Body, _dt: f32) -> Added {
        let nothing = Scene::new("a run");
        Err(refused(&nothing, "bodies in mid-run".to_owned()))
    }

    fn pull(&mut self, _pull: Option<Pull>) {}
}
