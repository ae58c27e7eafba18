//! Balls among static boxes and balls, the whole step on the GPU: a ball is a row, solves all of its
//! contacts and writes only itself. A contact is solved twice, once from each end; in return a substep
//! is one pass.

use ch00_scenes::{Scene, State};
use glam::{DQuat, DVec3, Quat, Vec4};

use super::ball_kernels::BallKernels;
use crate::bodies::Bodies;
use crate::grid::{Grid, largest_in_grid, margin_of};
use crate::rows::{Ball, GridOf, Held, Mover, Place, STATUS, Wall};
use crate::rules::{MARGIN, Rules};
use crate::stream::{Columns, Gpu, Passes, StreamError, Timer};

/// For how many neighbours a row has room at first.
pub const ROOM: usize = 24;

/// Most walls: every ball looks at each.
pub const MOST_WALLS: usize = 64;

/// Balls on the GPU.
#[derive(Debug)]
pub struct Balls {
    columns: Columns,
    kernels: BallKernels,
    rules: Rules,
    grid: GridOf,
    /// What was written last, so that it is written again only when it changes.
    dt: f32,
    /// How many steps were recorded since loading.
    steps: u32,
    /// Static bodies: the index in the scene and their pose, which never changes.
    state: State,
    /// By ball: its index in the scene.
    pub(super) rows: usize,
}

impl Balls {
    /// Why this scene is not one of balls among walls; None if it is.
    #[must_use]
    pub fn why_not(scene: &Scene, bodies: &Bodies) -> Option<&'static str> {
        let walls = (0..bodies.rows())
            .filter(|&row| bodies.is_static(row))
            .count();
        let moving = |row: &usize| !bodies.is_static(*row);
        let ball = |row: usize| bodies.solid[row].kind == 0;
        let wall = |row: usize| bodies.solid[row].kind <= 1;
        let reaches = || {
            (0..bodies.rows())
                .filter(moving)
                .map(|row| bodies.place[row].reach)
        };
        let limit = largest_in_grid(reaches().collect());
        if !scene.joints.is_empty() || !scene.forces.is_empty() {
            return Some("it has joints or forces");
        }
        if !(0..bodies.rows()).filter(moving).all(ball) {
            return Some("not all that moves is a ball");
        }
        if !(0..bodies.rows()).filter(|row| !moving(row)).all(wall) {
            return Some("not all that stays is a ball or a box");
        }
        if walls > MOST_WALLS {
            return Some("it has too many static bodies");
        }
        (reaches().any(|reach| reach > limit)).then_some("one ball is much larger than the others")
    }

    /// Loads the balls and walls of a scene.
    ///
    /// # Errors
    /// [`StreamError::TooLarge`] before anything is allocated, and what else a device can lack.
    pub fn of(gpu: &Gpu, scene: &Scene, rules: Rules) -> Result<Self, StreamError> {
        let bodies = Bodies::of(scene);
        let walls = walls_of(&bodies);
        let moving: Vec<usize> = (0..bodies.rows())
            .filter(|&row| !bodies.is_static(row))
            .collect();
        let grid = grid_of(&bodies, &moving, walls.len());
        let mut columns = Columns::new(gpu);
        allocate(&mut columns, &grid, &walls)?;
        let alike = is_alike(&bodies);
        let bounces = bodies
            .material
            .iter()
            .any(|material| material.restitution > 0.0);
        let kernels = BallKernels::of(gpu, alike, bounces)?;
        let mut balls = Self {
            columns,
            kernels,
            rules,
            grid,
            dt: 0.0,
            steps: 0,
            state: State::start_of(scene),
            rows: moving.len(),
        };
        balls.upload(&bodies, &moving)?;
        Ok(balls)
    }

    /// Writes the rows of all balls, in the order of the scene.
    fn upload(&mut self, bodies: &Bodies, moving: &[usize]) -> Result<(), StreamError> {
        let places: Vec<Place> = moving.iter().map(|&row| bodies.place[row]).collect();
        let attitudes: Vec<Quat> = moving.iter().map(|&row| bodies.attitude[row]).collect();
        let movers: Vec<Mover> = moving.iter().map(|&row| mover_of(bodies, row)).collect();
        let balls: Vec<Ball> = moving.iter().map(|&row| ball_of(bodies, row)).collect();
        let names = self.kernels.current();
        self.columns.write(names.places, &places)?;
        self.columns.write(names.movers, &movers)?;
        self.columns.write(names.attitudes, &attitudes)?;
        self.columns.write(names.balls, &balls)
    }

    // ANCHOR: record
    /// Records a step of `dt` seconds.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn record(
        &mut self,
        passes_of: &mut Vec<wgpu::CommandBuffer>,
        dt: f32,
    ) -> Result<(), StreamError> {
        self.set_dt(dt)?;
        let mut passes = Passes::new(&self.columns);
        let starts = self.grid.starts as usize;
        self.kernels
            .step(&mut passes, self.rows, starts, self.rules.substeps)?;
        self.steps += 1;
        passes_of.push(passes.finish());
        Ok(())
    }
    // ANCHOR_END: record

    /// Makes steps of `dt` seconds, without waiting for them.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn step(&mut self, dt: f32, count: u32) -> Result<(), StreamError> {
        let mut recorded = Vec::new();
        for _ in 0..count {
            self.record(&mut recorded, dt)?;
        }
        let gpu = self.columns.gpu();
        gpu.queue.submit(recorded);
        gpu.check()
    }

    /// Makes a step and says how long each part took.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn timed_step(
        &mut self,
        dt: f32,
        timer: &mut Timer,
    ) -> Result<Vec<(&'static str, std::time::Duration)>, StreamError> {
        self.set_dt(dt)?;
        let mut passes = Passes::timed(&self.columns, timer);
        let starts = self.grid.starts as usize;
        self.kernels
            .step(&mut passes, self.rows, starts, self.rules.substeps)?;
        self.steps += 1;
        passes.submit()?;
        self.columns.gpu().wait()?;
        Ok(timer.latest(self.columns.gpu()).unwrap_or_default())
    }

    /// Writes the uniforms if the step's length has changed.
    fn set_dt(&mut self, dt: f32) -> Result<(), StreamError> {
        if self.dt.to_bits() == dt.to_bits() {
            return Ok(());
        }
        self.dt = dt;
        self.grid.dt = dt;
        self.columns.write("grid", &[self.grid])?;
        self.columns
            .write("step", &[self.rules.step(dt, self.rows)])
    }

    /// What the kernels say of how it goes, in the order of [`STATUS`].
    ///
    /// # Errors
    /// A lost device.
    pub fn status(&self) -> Result<[u32; STATUS.len()], StreamError> {
        let read: Vec<u32> = self.columns.read("status")?;
        Ok(std::array::from_fn(|place| read[place]))
    }

    /// Waits for all steps, and reads where every body is.
    ///
    /// # Errors
    /// A lost device.
    pub fn read(&mut self) -> Result<&State, StreamError> {
        let names = self.kernels.current();
        let places: Vec<Place> = self.columns.read(names.places)?;
        let movers: Vec<Mover> = self.columns.read(names.movers)?;
        let attitudes: Vec<Vec4> = self.columns.read(names.attitudes)?;
        let balls: Vec<Ball> = self.columns.read(names.balls)?;
        for (row, ball) in balls.iter().enumerate().take(self.rows) {
            let id = ball.id as usize;
            let q = attitudes[row];
            self.state.position[id] = places[row].position.as_dvec3();
            self.state.linear_velocity[id] = movers[row].velocity.as_dvec3();
            self.state.angular_velocity[id] = DVec3::from(movers[row].angular_velocity);
            let q = DQuat::from_array(q.to_array().map(f64::from));
            self.state.orientation[id] = q.normalize();
        }
        Ok(&self.state)
    }

    /// The device and its columns.
    #[must_use]
    pub fn columns(&self) -> &Columns {
        &self.columns
    }
}

/// The static bodies.
fn walls_of(bodies: &Bodies) -> Vec<Wall> {
    let rows = (0..bodies.rows()).filter(|&row| bodies.is_static(row));
    rows.map(|row| Wall {
        position: bodies.place[row].position,
        kind: bodies.solid[row].kind,
        attitude: bodies.attitude[row],
        size: bodies.solid[row].size,
        restitution: bodies.material[row].restitution,
        friction: bodies.material[row].friction,
        static_friction: bodies.material[row].static_friction,
        id: row as u32,
        spare: 0,
    })
    .collect()
}

fn mover_of(bodies: &Bodies, row: usize) -> Mover {
    Mover {
        velocity: bodies.motion[row].velocity,
        shares: 1.0,
        angular_velocity: bodies.spin[row].angular_velocity,
        inverse_mass: bodies.spin[row].inverse_mass,
    }
}

fn ball_of(bodies: &Bodies, row: usize) -> Ball {
    Ball {
        id: row as u32,
        restitution: bodies.material[row].restitution,
        friction: bodies.material[row].friction,
        static_friction: bodies.material[row].static_friction,
    }
}

/// Whether the surfaces of all bodies that move are alike.
fn is_alike(bodies: &Bodies) -> bool {
    let mut moving = (0..bodies.rows()).filter(|&row| !bodies.is_static(row));
    let first = moving.next().map(|row| bodies.material[row]);
    moving.all(|row| Some(bodies.material[row]) == first)
}

/// The grid of a scene's balls.
fn grid_of(bodies: &Bodies, moving: &[usize], walls: usize) -> GridOf {
    let places: Vec<Place> = moving.iter().map(|&row| bodies.place[row]).collect();
    let grid = Grid::of(&places, |_| true);
    let widest = places.iter().map(|place| place.reach).fold(0.0, f32::max);
    let [slots_x, slots_y, slots_z] = grid.slots;
    GridOf {
        edge: grid.edge,
        slots_x,
        slots_y,
        slots_z,
        rows: moving.len() as u32,
        capacity: moving.len().max(1) as u32,
        room: ROOM as u32,
        walls: walls as u32,
        starts: grid.count() as u32 + 2,
        margin: MARGIN,
        most_margin: margin_of(widest),
        dt: 0.0,
    }
}

/// Makes all columns.
fn allocate(columns: &mut Columns, grid: &GridOf, walls: &[Wall]) -> Result<(), StreamError> {
    let (rows, starts) = (grid.capacity as usize, grid.starts as usize);
    for side in ["a", "b"] {
        columns.add::<Place>(&format!("places_{side}"), rows)?;
        columns.add::<Mover>(&format!("movers_{side}"), rows)?;
        columns.add::<Quat>(&format!("attitudes_{side}"), rows)?;
        columns.add::<Ball>(&format!("balls_{side}"), rows)?;
        columns.add::<u32>(&format!("neighbour_counts_{side}"), rows)?;
        columns.add::<u32>(&format!("neighbours_{side}"), rows * grid.room as usize)?;
        columns.add::<Vec4>(&format!("impulses_{side}"), rows * grid.room as usize)?;
        for name in ["places", "movers", "attitudes", "balls"] {
            columns.set_rows(&format!("{name}_{side}"), grid.rows as usize)?;
        }
    }
    columns.add::<f32>("approaches", rows * grid.room as usize)?;
    columns.add::<Held>("helds", rows)?;
    for name in ["slots", "order", "old_rows"] {
        columns.add::<u32>(name, rows)?;
    }
    for name in ["counts", "starts"] {
        columns.add::<u32>(name, starts)?;
    }
    columns.add::<u32>("blocks", starts.div_ceil(super::ball_kernels::PER_BLOCK))?;
    columns.add::<u32>("status", STATUS.len())?;
    let mut status = [0; STATUS.len()];
    status[3] = u32::MAX;
    columns.write("status", &status)?;
    columns.add::<Wall>("walls", walls.len().max(1))?;
    columns.write("walls", walls)?;
    columns.add_uniform("grid", grid)?;
    columns.add_uniform("step", &crate::rows::Step::default())
}
