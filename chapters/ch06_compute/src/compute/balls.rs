//! Balls among static boxes and balls, the whole step on the GPU: a ball is a row, solves all of its
//! contacts and writes only itself. A contact is solved twice, once from each end; in return a substep
//! is one pass.

mod columns;
mod explain;
mod kernels;
mod sides;
mod why_not;

pub use kernels::BallKernels;

use ch00_scenes::{Counters, Scene, State};
use glam::Quat;

use crate::bodies::Bodies;
use crate::rows::{Ball, GridOf, Mouse, Mover, Place, STATUS};
use crate::rules::Rules;
use crate::stream::{Columns, Gpu, Passes, StreamError, Timer};
use columns::{allocate, grid_of, is_alike, moving, scan_in, walls_of};
use kernels::Sizes;

/// For how many neighbours a row has room at first.
pub const ROOM: usize = 24;

/// Balls on the GPU.
#[derive(Debug)]
pub struct Balls {
    columns: Columns,
    kernels: BallKernels,
    rules: Rules,
    grid: GridOf,
    /// How many balls there are.
    rows: usize,
    /// The length of step that stands in the uniforms, s.
    dt: f32,
    /// How many steps were handed to the device since loading.
    steps: u32,
    /// What all bodies are, for when they are put elsewhere.
    bodies: Bodies,
    /// Where they were put last; static ones are still there.
    start: State,
    draws: bool,
    pulls: bool,
    /// How many rows were not finite, the first of them, and how many were fast, as it last came down.
    seen: [u32; 3],
    /// How often room was made for more neighbours.
    grown: u32,
}

impl Balls {
    /// Why this scene is not one of balls among walls; None if it is.
    #[must_use]
    pub fn why_not(scene: &Scene, bodies: &Bodies) -> Option<&'static str> {
        why_not::why_not(scene, bodies)
    }

    /// Loads the balls and walls of a scene.
    ///
    /// # Errors
    /// [`StreamError::TooLarge`] before anything is allocated, and what else a device can lack.
    pub fn of(gpu: &Gpu, scene: &Scene, rules: Rules) -> Result<Self, StreamError> {
        Self::with_room(gpu, scene, rules, ROOM)
    }

    /// The same with room for so many neighbours at first.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn with_room(
        gpu: &Gpu,
        scene: &Scene,
        rules: Rules,
        room: usize,
    ) -> Result<Self, StreamError> {
        let bodies = Bodies::of(scene);
        let (walls, moving) = (walls_of(&bodies), moving(&bodies));
        let mut grid = grid_of(&bodies, &moving, walls.len());
        grid.room = room as u32;
        let mut columns = Columns::new(gpu);
        allocate(&mut columns, &grid, &walls, bodies.rows())?;
        let bounces = bodies
            .material
            .iter()
            .any(|material| material.restitution > 0.0);
        let kernels = BallKernels::of(gpu, moving.len(), is_alike(&bodies), bounces)?;
        let mut balls = Self {
            columns,
            kernels,
            rules,
            grid,
            rows: moving.len(),
            dt: f32::NAN,
            steps: 0,
            start: State::start_of(scene),
            bodies,
            draws: false,
            pulls: false,
            seen: [0, u32::MAX, 0],
            grown: 0,
        };
        let bodies = balls.bodies.clone();
        balls.upload(&bodies, &moving)?;
        Ok(balls)
    }

    /// Writes the rows of all balls, in the order of the scene.
    fn upload(&mut self, bodies: &Bodies, moving: &[usize]) -> Result<(), StreamError> {
        let names = self.kernels.current();
        columns::write(&mut self.columns, names, bodies, moving)?;
        if self.draws {
            self.write_drawn()?;
        }
        Ok(())
    }

    // ANCHOR: step
    /// Makes steps of `dt` seconds, without waiting for them.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn step(&mut self, dt: f32, count: u32) -> Result<(), StreamError> {
        self.set_dt(dt)?;
        let sizes = self.sizes();
        let mut passes = Passes::new(&self.columns);
        for _ in 0..count {
            self.kernels.step(&mut passes, &sizes)?;
        }
        self.steps += count;
        passes.submit()
    }
    // ANCHOR_END: step

    /// Makes a step, without waiting; `timer` will know how long each part took.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn timed_step(&mut self, dt: f32, timer: &mut Timer) -> Result<(), StreamError> {
        self.set_dt(dt)?;
        let sizes = self.sizes();
        let mut passes = Passes::timed(&self.columns, timer);
        self.kernels.step(&mut passes, &sizes)?;
        self.steps += 1;
        passes.submit()
    }

    fn sizes(&self) -> Sizes {
        Sizes {
            rows: self.rows,
            starts: self.grid.starts as usize,
            substeps: self.rules.substeps,
            dt: self.dt,
            draws: self.draws,
            pulls: self.pulls,
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
        self.columns.write("scan", &[scan_in(&self.grid)])?;
        let step = self.rules.step(dt, self.rows);
        self.columns.write("step", &[step])
    }

    /// What the kernels say of how it goes, in the order of [`STATUS`].
    ///
    /// # Errors
    /// A lost device.
    pub fn status(&self) -> Result<[u32; STATUS.len()], StreamError> {
        let read: Vec<u32> = self.columns.read("status")?;
        Ok(std::array::from_fn(|place| read[place]))
    }

    // ANCHOR: settle
    /// Waits for all steps, and makes those again for whose neighbours there was no room, with more.
    ///
    /// # Errors
    /// A lost device, or no memory for so much room.
    pub fn settle(&mut self) -> Result<(), StreamError> {
        loop {
            let [needed, not_finite, first, fast, steps] = self.status()?;
            self.seen = [not_finite, first, fast];
            self.kernels.made_but((self.steps - steps) as usize);
            if needed <= self.grid.room {
                return Ok(());
            }
            self.make_room(needed)?;
            for (number, (dt, sides)) in self.kernels.take_waiting().into_iter().enumerate() {
                self.set_dt(dt)?;
                let sizes = self.sizes();
                let mut passes = Passes::new(&self.columns);
                if number == 0 {
                    self.kernels.again(&mut passes, &sizes, sides)?;
                } else {
                    self.kernels.step(&mut passes, &sizes)?;
                }
                passes.submit()?;
            }
        }
    }
    // ANCHOR_END: settle

    /// Makes room for so many neighbours a ball, and some more.
    fn make_room(&mut self, needed: u32) -> Result<(), StreamError> {
        self.grown += 1;
        let room = needed.next_multiple_of(8);
        let rows = self.grid.capacity as usize * room as usize;
        for side in ["a", "b"] {
            self.columns.reserve(&format!("neighbours_{side}"), rows)?;
            self.columns.reserve(&format!("impulses_{side}"), rows)?;
        }
        self.columns.reserve("approaches", rows)?;
        self.grid.room = room;
        self.dt = f32::NAN;
        self.columns.write_at("status", 0, &[0_u32])
    }

    /// Waits for all steps, and writes where every body is into `state`.
    ///
    /// # Errors
    /// A lost device.
    pub fn read(&mut self, state: &mut State) -> Result<(), StreamError> {
        self.settle()?;
        let names = self.kernels.current();
        let places: Vec<Place> = self.columns.read(names.places)?;
        let movers: Vec<Mover> = self.columns.read(names.movers)?;
        let attitudes: Vec<Quat> = self.columns.read(names.attitudes)?;
        let balls: Vec<Ball> = self.columns.read(names.balls)?;
        state.clone_from(&self.start);
        for (row, ball) in balls.iter().enumerate().take(self.rows) {
            let id = ball.id as usize;
            state.position[id] = places[row].position.as_dvec3();
            state.orientation[id] = attitudes[row].as_dquat().normalize();
            state.linear_velocity[id] = movers[row].velocity.as_dvec3();
            state.angular_velocity[id] = movers[row].angular_velocity.as_dvec3();
        }
        Ok(())
    }

    /// Takes over where bodies are and how they move; what they pressed is forgotten.
    ///
    /// # Errors
    /// A lost device.
    pub fn write(&mut self, state: &State) -> Result<(), StreamError> {
        self.settle()?;
        self.start.clone_from(state);
        let mut bodies = self.bodies.clone();
        bodies.write(state);
        let moving = moving(&bodies);
        self.upload(&bodies, &moving)?;
        self.columns.clear("neighbour_counts_a")?;
        self.columns.clear("neighbour_counts_b")
    }

    /// Draws from now on: a row [`Drawn`](crate::rows::Drawn) a body, in column `drawn`, and a row [`Seen`](crate::rows::Seen) in `seen`.
    ///
    /// # Errors
    /// No memory for them.
    pub fn draw(&mut self) -> Result<(), StreamError> {
        self.draws = true;
        self.write_drawn()
    }

    /// Writes the rows for drawing as if all had stood still.
    fn write_drawn(&mut self) -> Result<(), StreamError> {
        columns::write_drawn(&mut self.columns, &self.start)
    }

    /// The mouse pulls at a ball from now on, or lets go.
    ///
    /// # Errors
    /// A lost device.
    pub fn pull(&mut self, mouse: Option<Mouse>) -> Result<(), StreamError> {
        self.pulls = mouse.is_some();
        self.columns.write("mouse", &[mouse.unwrap_or_default()])
    }

    /// What a late look at the status says; true if steps must be made again, which it waits for.
    ///
    /// # Errors
    /// A lost device.
    pub fn take_status(&mut self, status: &[u32]) -> Result<bool, StreamError> {
        let &[needed, not_finite, first, fast, _] = status else {
            return Ok(false);
        };
        self.seen = [not_finite, first, fast];
        if needed > self.grid.room {
            self.settle()?;
            return Ok(true);
        }
        Ok(false)
    }

    /// What the steps counted, as it last came down.
    #[must_use]
    pub fn counters(&self) -> Counters {
        Counters {
            overflow: self.seen[0] as usize,
            ..Counters::default()
        }
    }

    /// Passes, columns, and bytes a body.
    #[must_use]
    pub fn explain(&self) -> String {
        explain::explain(self)
    }

    /// How many steps were handed to the device.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.steps
    }

    /// The device and its columns.
    #[must_use]
    pub fn columns(&self) -> &Columns {
        &self.columns
    }

    /// The ID of the first body that was not finite, and how many rows were in all steps, if any.
    #[must_use]
    pub fn not_finite(&self) -> Option<(u32, u32)> {
        (self.seen[0] > 0).then_some((self.seen[1], self.seen[0]))
    }

    /// How many balls there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The kernels of a step.
    #[must_use]
    pub fn kernels(&self) -> &BallKernels {
        &self.kernels
    }

    /// How often room was made for more neighbours.
    #[must_use]
    pub fn grown(&self) -> u32 {
        self.grown
    }

    /// How many rows moved farther in a step than the grid looks, in all steps, as it last came down.
    #[must_use]
    pub fn fast(&self) -> u32 {
        self.seen[2]
    }

    /// For how many neighbours a ball has room.
    #[must_use]
    pub fn room(&self) -> u32 {
        self.grid.room
    }

    /// Cells of the grid along x, y and z, and their edge, m.
    #[must_use]
    pub fn grid(&self) -> ([u32; 3], f32) {
        let grid = &self.grid;
        ([grid.slots_x, grid.slots_y, grid.slots_z], grid.edge)
    }
}
