//! The two ways of a step on the GPU: balls, whose contacts are rows of their bodies, and everything else,
//! where a pair is a row.

use ch00_scenes::{Counters, Scene, State};

use super::balls::Balls;
use super::error::ComputeError;
use super::pairs::Pairs;
use crate::bodies::Bodies;
use crate::rows::Mouse;
use crate::rules::Rules;
use crate::stream::{Columns, Gpu, StreamError, Timer};

/// A scene on the GPU.
#[derive(Debug)]
pub enum Driver {
    /// Balls among static boxes and balls.
    Balls(Box<Balls>),
    /// Bodies of any shape, with joints and forces.
    Pairs(Box<Pairs>),
}

impl Driver {
    /// Loads a scene in the way that it allows.
    ///
    /// # Errors
    /// What the device can lack, and what the scene has too much of.
    pub fn of(gpu: &Gpu, scene: &Scene, rules: Rules) -> Result<Self, ComputeError> {
        if Balls::why_not(scene, &Bodies::of(scene)).is_none() {
            return Ok(Self::Balls(Box::new(Balls::of(gpu, scene, rules)?)));
        }
        Ok(Self::Pairs(Box::new(Pairs::of(gpu, scene, rules)?)))
    }
}

/// Hands a call to whichever it is.
macro_rules! either {
    ($driver:expr, $one:ident => $call:expr) => {
        match $driver {
            Driver::Balls($one) => $call,
            Driver::Pairs($one) => $call,
        }
    };
}

impl Driver {
    /// Makes steps of `dt` seconds, without waiting for them.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn step(&mut self, dt: f32, count: u32) -> Result<(), StreamError> {
        either!(self, one => one.step(dt, count))
    }

    /// Makes a step, without waiting; `timer` will know how long each part took.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn timed_step(&mut self, dt: f32, timer: &mut Timer) -> Result<(), StreamError> {
        either!(self, one => one.timed_step(dt, timer))
    }

    /// Waits for all steps, and makes those again for which there was no room.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn settle(&mut self) -> Result<(), StreamError> {
        either!(self, one => one.settle())
    }

    /// Waits for all steps, and writes where every body is into `state`.
    ///
    /// # Errors
    /// A lost device.
    pub fn read(&mut self, state: &mut State) -> Result<(), StreamError> {
        either!(self, one => one.read(state))
    }

    /// Takes over where bodies are and how they move.
    ///
    /// # Errors
    /// A lost device.
    pub fn write(&mut self, state: &State) -> Result<(), StreamError> {
        either!(self, one => one.write(state))
    }

    /// Writes rows for drawing from now on.
    ///
    /// # Errors
    /// No memory for them.
    pub fn draw(&mut self) -> Result<(), StreamError> {
        either!(self, one => one.draw())
    }

    /// The mouse pulls from now on, or lets go.
    ///
    /// # Errors
    /// A lost device.
    pub fn pull(&mut self, mouse: Option<Mouse>) -> Result<(), StreamError> {
        either!(self, one => one.pull(mouse))
    }

    /// What a late look at the status says; true if steps must be made again.
    ///
    /// # Errors
    /// A lost device.
    pub fn take_status(&mut self, status: &[u32]) -> Result<bool, StreamError> {
        either!(self, one => one.take_status(status))
    }

    /// What the steps counted, as it last came down.
    #[must_use]
    pub fn counters(&self) -> Counters {
        either!(self, one => one.counters())
    }

    /// Passes, columns, and bytes a body.
    #[must_use]
    pub fn explain(&self) -> String {
        either!(self, one => one.explain())
    }

    /// Edge of the grid's cells, and the farthest that a body in them reaches, m.
    #[must_use]
    pub fn cells(&self) -> (f32, f32) {
        match self {
            Self::Balls(balls) => (balls.grid().1, f32::INFINITY),
            Self::Pairs(pairs) => (pairs.grid().1, pairs.plan().largest_in_grid),
        }
    }

    /// The device and its columns.
    #[must_use]
    pub fn columns(&self) -> &Columns {
        either!(self, one => one.columns())
    }
}
