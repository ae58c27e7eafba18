//! Engines whose steps can be timed: on the processor a step is done when it returns, on a device when it has been
//! waited for.

use ch00_scenes::{Engine, EngineEntry, LoadError, Scene, Settings, State};
use ch00_shell::Gpu;
use ch06_compute::compute::ComputeEngine;

use crate::lab::{self, TURN};

/// An engine whose steps are waited for.
pub enum Stepped {
    /// On the processor each is done when it returns.
    OneByOne(Box<dyn Engine>),
    /// On a device, where those of a turn are handed over together.
    Together(Box<ComputeEngine>),
}

impl Stepped {
    /// Loads a scene.
    ///
    /// # Errors
    /// [`LoadError`] where the engine can't take the scene or the settings, or there is no device.
    pub fn load(entry: EngineEntry, settings: &Settings, scene: &Scene) -> Result<Self, LoadError> {
        if entry.name == ch06_compute::COMPUTE.name {
            let engine = ComputeEngine::load(scene, settings)?;
            return Ok(Self::Together(Box::new(engine)));
        }
        Ok(Self::OneByOne((entry.load)(scene, settings)?))
    }

    /// Who steps.
    pub fn engine(&self) -> &dyn Engine {
        match self {
            Self::OneByOne(engine) => engine.as_ref(),
            Self::Together(engine) => engine.as_ref(),
        }
    }

    /// Makes so many steps and waits for the last.
    pub fn steps(&mut self, dt: f32, count: u32) {
        match self {
            Self::OneByOne(engine) => (0..count).for_each(|_| engine.step(dt)),
            Self::Together(engine) => {
                let mut left = count;
                while left > 0 {
                    let now = left.min(TURN);
                    engine.steps(dt, now);
                    left -= now;
                }
                engine.finish();
            }
        }
    }

    /// Where everything is.
    pub fn state(&self) -> State {
        let mut state = State::default();
        self.engine().read_state(&mut state);
        state
    }

    /// The name of what it runs on.
    pub fn device(&self) -> String {
        match self {
            Self::OneByOne(_) => lab::processor(),
            Self::Together(engine) => device(engine.info().device),
        }
    }
}

/// A graphics device's name, with a word on one that is none.
fn device(name: String) -> String {
    let is_software = Gpu::shared().is_ok_and(|gpu| gpu.is_software);
    if is_software {
        format!("{name}, software on the processor")
    } else {
        name
    }
}
