//! Bodies of any shape on the GPU, the whole step there. A pair is a row: it reads both of its bodies and
//! writes its own impulses. A body is a row: it gathers what its pairs did to it, and moves. Rows stay in
//! the order of the scene.

pub mod columns;
mod explain;
mod kernels;
pub mod plan;
mod state;

use ch00_scenes::{Counters, Scene};

pub use columns::Room;
use columns::{allocate, fits, grow, pair_counts, upload};
use kernels::{PairKernels, Sizes};
use plan::{Plan, grid_of};

use super::error::ComputeError;
use crate::bodies::Bodies;
use crate::lanes::forces::{Forces, check_fixed_points};
use crate::own_row::tree::Trees;
use crate::rows::{GridOf, PAIR_STATUS_LEN, PairsOf, status_place};
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
    lists: PairsOf,
    room: Room,
    /// What was written last, so that it is written again only when it changes.
    dt: f32,
    /// How many steps were asked for since loading.
    asked: u32,
    /// Those of which it isn't known that they were made: how long, and how many in a row.
    waiting: Vec<(f32, u32)>,
    /// The bodies at the start, with their momenta about what they turn about.
    bodies: Bodies,
    /// Its joints.
    trees: Trees,
    draws: bool,
    /// What the status said when it came down last.
    status: [u32; PAIR_STATUS_LEN],
    /// How often room was made.
    grown: u32,
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
        let unsupported = |(what, body)| ComputeError::Unsupported { what, body };
        check_fixed_points(scene).map_err(unsupported)?;
        let mut bodies = Bodies::of(scene);
        let forces = Forces::of(scene, &mut bodies).map_err(unsupported)?;
        let trees = Trees::of(scene);
        trees.fits()?;
        let plan = Plan::of(scene, &bodies, &forces, &trees);
        let grid = grid_of(&bodies, &plan, room.partners);
        let pairs_of = plan.pairs_of(room.pairs, room.large_pairs);
        let mut columns = Columns::new(gpu);
        allocate(&mut columns, &grid, &pairs_of, room, &plan)?;
        upload(&mut columns, scene, &bodies, &forces, &trees, &plan)?;
        Ok(Self {
            kernels: PairKernels::of(gpu, &plan)?,
            columns,
            plan,
            rules,
            grid,
            lists: pairs_of,
            room,
            dt: f32::NAN,
            asked: 0,
            waiting: Vec::new(),
            bodies,
            trees,
            draws: false,
            status: [0; PAIR_STATUS_LEN],
            grown: 0,
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
        self.note(dt, count);
        Ok(())
    }
    // ANCHOR_END: step

    /// Makes a step, without waiting; `timer` will know how long each part took.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn timed_step(&mut self, dt: f32, timer: &mut Timer) -> Result<(), StreamError> {
        self.set_dt(dt)?;
        let mut passes = Passes::timed(&self.columns, timer);
        self.kernels.step(&mut passes, &self.sizes(), self.asked)?;
        passes.submit()?;
        self.note(dt, 1);
        Ok(())
    }

    /// Keeps in mind that steps were asked for.
    fn note(&mut self, dt: f32, count: u32) {
        self.asked += count;
        match self.waiting.last_mut() {
            Some((last, steps)) if last.to_bits() == dt.to_bits() => *steps += count,
            _ => self.waiting.push((dt, count)),
        }
    }

    fn sizes(&self) -> Sizes {
        Sizes {
            rows: self.grid.rows as usize,
            starts: self.grid.starts as usize,
            pair_counts: pair_counts(&self.grid, &self.lists),
            larges: self.plan.larges.len(),
            nodes: self.trees.nodes.len(),
            substeps: self.rules.substeps,
            draws: self.draws,
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
    /// more and makes them now: nothing is lost.
    ///
    /// # Errors
    /// [`StreamError::TooLarge`] or [`StreamError::OutOfMemory`] if the device has no more room; a lost
    /// device.
    pub fn settle(&mut self) -> Result<(), StreamError> {
        loop {
            let read: Vec<u32> = self.columns.read("status")?;
            self.status = std::array::from_fn(|place| read[place]);
            let missing = self.asked - self.says("STEPS");
            let waiting = last_of(std::mem::take(&mut self.waiting), missing);
            if self.says("HALTED") == 0 {
                return Ok(());
            }
            self.make_room()?;
            self.asked -= missing;
            for (dt, count) in waiting {
                self.step(dt, count)?;
            }
        }
    }

    /// Makes as much room as was needed, and half as much again.
    fn make_room(&mut self) -> Result<(), StreamError> {
        self.grown += 1;
        let more = |have: usize, name: &str| {
            let needed = self.says(name) as usize;
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
        grow(&mut self.columns, &self.grid, &self.plan, self.room)?;
        self.grid.room = self.room.partners as u32;
        self.lists.room = self.room.pairs as u32;
        self.lists.large_room = self.room.large_pairs as u32;
        self.columns.write("grid", &[self.grid])?;
        self.columns.write("pairs_of", &[self.lists])?;
        self.columns
            .write_at("status", status_place("HALTED"), &[0_u32])
    }
    // ANCHOR_END: settle

    /// A number of the status by its name, as it last came down.
    ///
    /// # Panics
    /// If there is no such number.
    #[must_use]
    pub fn says(&self, name: &str) -> u32 {
        self.status[status_place(name)]
    }

    /// What a late look at the status says; true if steps must be made again, which it waits for.
    ///
    /// # Errors
    /// As for [`Self::settle`].
    pub fn take_status(&mut self, status: &[u32]) -> Result<bool, StreamError> {
        if status.len() != PAIR_STATUS_LEN {
            return Ok(false);
        }
        self.status.copy_from_slice(status);
        let halted = self.says("HALTED") != 0;
        if halted {
            self.settle()?;
        }
        Ok(halted)
    }

    /// What the steps counted, as it last came down.
    #[must_use]
    pub fn counters(&self) -> Counters {
        let kinds = status_place("KIND_FIRST") + self.plan.kinds.len();
        Counters {
            pairs: self.status[kinds] as usize,
            contacts: self.says("LIVE") as usize,
            overflow: self.says("NOT_FINITE") as usize,
            ..Counters::default()
        }
    }

    /// The row of the first body that was not finite, and how many rows were in all steps, if any.
    #[must_use]
    pub fn not_finite(&self) -> Option<(u32, u32)> {
        let rows = self.says("NOT_FINITE");
        (rows > 0).then(|| (self.says("FIRST_NOT_FINITE"), rows))
    }

    /// Passes, columns, and bytes a body and a pair.
    #[must_use]
    pub fn explain(&self) -> String {
        explain::explain(self)
    }

    /// How many steps were asked for.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.asked
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

    /// How often more room was made.
    #[must_use]
    pub fn grown(&self) -> u32 {
        self.grown
    }

    /// Cells of the grid along x, y and z, and their edge, m.
    #[must_use]
    pub fn grid(&self) -> ([u32; 3], f32) {
        let grid = &self.grid;
        ([grid.slots_x, grid.slots_y, grid.slots_z], grid.edge)
    }

    /// The kernels' names in the order of a step.
    #[must_use]
    pub fn passes(&self) -> Vec<&'static str> {
        self.kernels.names()
    }
}

/// The last `missing` of steps that wait.
fn last_of(waiting: Vec<(f32, u32)>, mut missing: u32) -> Vec<(f32, u32)> {
    let mut last = Vec::new();
    for (dt, count) in waiting.into_iter().rev() {
        let taken = count.min(missing);
        missing -= taken;
        if taken > 0 {
            last.push((dt, taken));
        }
    }
    last.reverse();
    last
}
