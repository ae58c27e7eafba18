//! An engine that is compared: what it calls itself, its steps, and where its bodies are.

use std::time::Instant;

use ch00_scenes::{Engine, State};
use ch06_compute::peer::{Cone, Rapier};

/// What an engine says of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facts {
    pub engine: &'static str,
    pub method: &'static str,
    pub threads: u32,
    pub substeps: u32,
}

/// An engine with a scene in it.
pub trait Runner {
    fn facts(&self) -> Facts;

    /// Makes some steps and notes what each took, ms.
    fn steps(&mut self, count: u32, times: &mut Vec<f64>);

    /// Where the bodies are, in the scene's order.
    fn read(&self, state: &mut State);
}

/// Makes some steps and notes what each took, ms.
pub fn timed(count: u32, times: &mut Vec<f64>, mut step: impl FnMut()) {
    for _ in 0..count {
        let start = Instant::now();
        step();
        times.push(1e3 * start.elapsed().as_secs_f64());
    }
}

/// One of our engines.
pub struct Ours {
    pub engine: Box<dyn Engine>,
    /// Time step, s.
    pub dt: f32,
}

impl Runner for Ours {
    fn facts(&self) -> Facts {
        let info = self.engine.info();
        Facts {
            engine: info.engine,
            method: info.method,
            threads: info.threads,
            substeps: info.substeps,
        }
    }

    fn steps(&mut self, count: u32, times: &mut Vec<f64>) {
        timed(count, times, || {
            self.engine.step(self.dt);
            self.engine.finish();
        });
    }

    fn read(&self, state: &mut State) {
        self.engine.read_state(state);
    }
}

impl Runner for Rapier {
    fn facts(&self) -> Facts {
        let setup = self.setup();
        Facts {
            engine: "rapier",
            method: match setup.cone {
                Cone::Coupled => "cones",
                Cone::Ranges => "ranges",
            },
            threads: setup.threads,
            substeps: setup.iterations,
        }
    }

    fn steps(&mut self, count: u32, times: &mut Vec<f64>) {
        self.inside(|world| timed(count, times, || world.step()));
    }

    fn read(&self, state: &mut State) {
        Rapier::read(self, state);
    }
}
