//! Bodies of any shape on the GPU, the whole step there. A pair is a row: it reads both of its bodies and
//! writes its own impulses. A body is a row: it gathers what its pairs did to it, and moves. Rows stay in
//! the order of the scene.

pub mod columns;
mod kernels;
pub mod plan;

use std::time::Duration;

use ch00_scenes::{Scene, State};

pub use columns::Room;
use columns::{allocate, fits, grow, no_mouse, pair_counts, upload};
use kernels::{PairKernels, Sizes};
use plan::{Plan, grid_of};

use super::error::ComputeError;
use crate::bodies::Bodies;
use crate::lanes::forces::{Forces, Spring};
use crate::rows::{GridOf, Mouse, PAIR_STATUS_LEN, PairsOf, Partner, Rigid, status_place};
use crate::rules::Rules;
use crate::stream::{Columns, Gpu, Passes, StreamError, Timer};

/// Bodies of any shape on the GPU.
#[derive(Debug)]
pub struct Pairs {
    columns: Columns,
    kernels: PairKernels,
    plan: Plan,
    rules: Rules,
    grid: GridOf,
    pairs_of: PairsOf,
    room: Room,
    /// What was written last, so that it is written again only when it changes.
    dt: f32,
    /// How many steps were asked for since loading.
    asked: u32,
    state: State,
}

impl Pairs {
    /// Loads a scene.
    ///
    /// # Errors
    /// [`StreamError::TooLarge`] before anything is allocated, with the largest number of bodies that
    /// fits; what else a device can lack; and what no kernel knows.
    pub fn of(gpu: &Gpu, scene: &Scene, rules: Rules) -> Result<Self, ComputeError> {
        Self::with_room(gpu, scene, rules, Room::for_bodies(scene.bodies.len()))
    }

    /// The same, with so much room at first.
    ///
    /// # Errors
    /// As for [`Self::of`].
    pub fn with_room(
        gpu: &Gpu,
        scene: &Scene,
        rules: Rules,
        room: Room,
    ) -> Result<Self, ComputeError> {
        fits(gpu, scene.bodies.len(), room)?;
        let mut bodies = Bodies::of(scene);
        let forces = Forces::of(scene, &mut bodies)
            .map_err(|(what, body)| ComputeError::Unsupported { what, body })?;
        let mut aside: Vec<u32> = forces
            .pivots
            .iter()
            .map(|pivot| pivot.body as u32)
            .collect();
        aside.sort_unstable();
        let plan = Plan {
            pivots: !forces.pivots.is_empty(),
            ..Plan::of(scene, &bodies, &aside)
        };
        let grid = grid_of(&bodies, &plan, room.partners);
        let pairs_of = plan.pairs_of(room.pairs, room.large_pairs);
        let mut columns = Columns::new(gpu);
        allocate(&mut columns, &grid, &pairs_of, room)?;
        upload(&mut columns, scene, &bodies, &forces, &plan)?;
        Ok(Self {
            kernels: PairKernels::of(gpu, &plan)?,
            columns,
            plan,
            rules,
            grid,
            pairs_of,
            room,
            dt: 0.0,
            asked: 0,
            state: State::start_of(scene),
        })
    }

    // ANCHOR: step
    /// Makes steps of `dt` seconds, without waiting for them. Steps for which there is no room are made
    /// when [`Self::settle`] has made more.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn step(&mut self, dt: f32, count: u32) -> Result<(), StreamError> {
        self.set_dt(dt)?;
        let mut passes = Passes::new(&self.columns);
        for number in self.asked..self.asked + count {
            self.kernels.step(&mut passes, &self.sizes(), number)?;
        }
        passes.submit()?;
        self.asked += count;
        Ok(())
    }
    // ANCHOR_END: step

    /// Makes a step and says how long each part took.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn timed_step(
        &mut self,
        dt: f32,
        timer: &mut Timer,
    ) -> Result<Vec<(&'static str, Duration)>, StreamError> {
        self.set_dt(dt)?;
        let mut passes = Passes::timed(&self.columns, timer);
        self.kernels.step(&mut passes, &self.sizes(), self.asked)?;
        passes.submit()?;
        self.asked += 1;
        self.columns.gpu().wait()?;
        Ok(timer.latest(self.columns.gpu()).unwrap_or_default())
    }

    fn sizes(&self) -> Sizes {
        Sizes {
            rows: self.grid.rows as usize,
            starts: self.grid.starts as usize,
            pair_counts: pair_counts(&self.grid, &self.pairs_of),
            larges: self.plan.larges.len(),
            substeps: self.rules.substeps,
        }
    }

    /// Writes the uniforms if the step's length has changed.
    fn set_dt(&mut self, dt: f32) -> Result<(), StreamError> {
        if self.dt.to_bits() == dt.to_bits() {
            return Ok(());
        }
        self.dt = dt;
        self.grid.dt = dt;
        self.columns.write("grid", &[self.grid])?;
        let step = self.rules.step(dt, self.grid.rows as usize);
        self.columns.write("step", &[step])
    }

    // ANCHOR: settle
    /// Waits for all steps that were asked for. If some were not made since something had no room, makes
    /// more and makes them now: nothing is lost. Says how often it had to.
    ///
    /// # Errors
    /// [`StreamError::TooLarge`] or [`StreamError::OutOfMemory`] if the device has no more room; a lost
    /// device.
    pub fn settle(&mut self) -> Result<u32, StreamError> {
        let mut grown = 0;
        loop {
            let status = self.status()?;
            let missing = self.asked - status[status_place("STEPS")];
            if status[status_place("HALTED")] == 0 {
                return Ok(grown);
            }
            self.make_room(&status)?;
            grown += 1;
            self.asked -= missing;
            self.step(self.dt, missing)?;
        }
    }

    /// Makes as much room as was needed, and half as much again.
    fn make_room(&mut self, status: &[u32; PAIR_STATUS_LEN]) -> Result<(), StreamError> {
        let more = |have: usize, name: &str| {
            let needed = status[status_place(name)] as usize;
            if needed > have {
                needed + needed / 2
            } else {
                have
            }
        };
        self.room = Room {
            partners: more(self.room.partners, "NEEDED"),
            pairs: more(self.room.pairs, "PAIRS_NEEDED"),
            large_pairs: more(self.room.large_pairs, "LARGE_NEEDED"),
        };
        grow(&mut self.columns, &self.grid, self.room)?;
        self.grid.room = self.room.partners as u32;
        self.pairs_of.room = self.room.pairs as u32;
        self.pairs_of.large_room = self.room.large_pairs as u32;
        self.columns.write("grid", &[self.grid])?;
        self.columns.write("pairs_of", &[self.pairs_of])?;
        self.columns
            .write_at("status", status_place("HALTED"), &[0_u32])
    }
    // ANCHOR_END: settle

    /// What the kernels say of how it goes: [`status_place`] knows what is where.
    ///
    /// # Errors
    /// A lost device.
    pub fn status(&self) -> Result<[u32; PAIR_STATUS_LEN], StreamError> {
        let read: Vec<u32> = self.columns.read("status")?;
        Ok(std::array::from_fn(|place| read[place]))
    }

    /// Waits for all steps, and reads where every body is.
    ///
    /// # Errors
    /// As for [`Self::settle`].
    pub fn read(&mut self) -> Result<&State, StreamError> {
        self.settle()?;
        let rigids: Vec<Rigid> = self.columns.read("rigids")?;
        self.state.clear();
        for rigid in &rigids {
            self.state.push(
                rigid.position.as_dvec3(),
                rigid.attitude.as_dquat().normalize(),
                rigid.velocity.as_dvec3(),
                rigid.angular_velocity.as_dvec3(),
            );
        }
        Ok(&self.state)
    }

    /// Takes over where bodies are and how they move; what they pressed is forgotten.
    ///
    /// # Errors
    /// As for [`Self::settle`].
    pub fn write(&mut self, state: &State) -> Result<(), StreamError> {
        self.settle()?;
        let mut rigids: Vec<Rigid> = self.columns.read("rigids")?;
        for (row, rigid) in rigids.iter_mut().enumerate().take(state.len()) {
            rigid.position = state.position[row].as_vec3();
            rigid.attitude = state.orientation[row].as_quat().normalize();
            rigid.velocity = state.linear_velocity[row].as_vec3();
            rigid.angular_velocity = state.angular_velocity[row].as_vec3();
        }
        self.columns.write("rigids", &rigids)?;
        for name in ["partners_a", "partners_b"] {
            self.columns.clear(name)?;
        }
        Ok(())
    }

    /// The mouse pulls, or lets go.
    ///
    /// # Errors
    /// A lost device.
    pub fn pull(&mut self, spring: Option<Spring>) -> Result<(), StreamError> {
        let mouse = spring.map_or_else(no_mouse, |spring| Mouse {
            anchor: spring.anchor,
            body: spring.body as u32,
            towards: spring.target,
            mass: spring.mass,
        });
        self.columns.write("mouse", &[mouse])
    }

    /// The device and its columns.
    #[must_use]
    pub fn columns(&self) -> &Columns {
        &self.columns
    }

    /// What the passes are specialised by.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// For how much there is room.
    #[must_use]
    pub fn room(&self) -> Room {
        self.room
    }

    /// Bytes that a body and a pair have in all columns.
    #[must_use]
    pub fn row_bytes(&self) -> [usize; 2] {
        let lists = (self.room.partners + 1) * (2 * size_of::<Partner>() + size_of::<u32>());
        let body = size_of::<Rigid>() + 32 + 2 * 32 + 2 * 4 + 8 * self.plan.kinds.len();
        [body + lists, 176 + 2 * 64 + 96 + 16]
    }
}
