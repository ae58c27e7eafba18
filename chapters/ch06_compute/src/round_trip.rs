//! The naive way to a GPU: every frame the state goes up, a kernel runs over it, and the state comes down
//! again. What it computes are chapter 5's systems `positions` and `orientations`; what it costs is the way.

use std::time::Duration;

use ch05_properties::data::Bodies;
use ch05_properties::systems::advance::Step;
use glam::Vec3;
use web_time::Instant;

use crate::rows::rows;
use crate::stream::{Columns, Gpu, Kernel, Passes, StreamError, Timer, source};

/// What changes from frame to frame.
const STATE: [&str; 4] = [
    "position",
    "last_position",
    "orientation",
    "last_orientation",
];
/// What goes up once.
const CONSTANT: [&str; 2] = ["inverse_mass", "inertia"];

rows! {
    /// What all bodies advance by.
    pub struct Advance {
        /// Acceleration of all that can move.
        gravity: Vec3, "g", "m/s²";
        /// Length of this step.
        dt: f32, "Δt", "s";
        /// Length of the step before.
        dt_last: f32, "Δt*", "s";
        /// The share of a velocity that drag leaves.
        kept: f32, "f", "";
        /// How many bodies there are.
        rows: u32, "", "";
        /// Unused.
        spare: u32, "", "";
    }
}

/// Where the time of a frame went, as it looks from here: each part was waited for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// State up.
    pub upload: Duration,
    /// Kernels, with their start and the wait for their end.
    pub compute: Duration,
    /// State down.
    pub download: Duration,
    /// The kernels alone, by the GPU's own clock; None if it has none.
    pub kernels: Option<Duration>,
}

/// Advances bodies on the GPU that live on the CPU.
#[derive(Debug)]
pub struct RoundTrip {
    columns: Columns,
    positions: Kernel,
    orientations: Kernel,
    timer: Timer,
}

impl RoundTrip {
    // ANCHOR: new
    /// Compiles the kernels and takes up what doesn't change.
    ///
    /// # Errors
    /// [`StreamError::TooLarge`] for more bodies than fit; [`StreamError::Kernel`].
    pub fn new(gpu: &Gpu, bodies: &Bodies) -> Result<Self, StreamError> {
        let mut columns = Columns::new(gpu);
        columns.upload(bodies, &CONSTANT)?;
        columns.add_uniform("advance", &Advance::default())?;
        let source = source("ch06_integrate")?;
        let kernel = |entry| Kernel::new(gpu, entry, &source, entry, &[]);
        Ok(Self {
            columns,
            positions: kernel("positions")?,
            orientations: kernel("orientations")?,
            timer: Timer::new(gpu, 1),
        })
    }
    // ANCHOR_END: new

    // ANCHOR: step
    /// Advances the bodies by a step: up, over them, down.
    ///
    /// # Errors
    /// [`StreamError::Failed`]; the bodies are then as they were.
    pub fn step(
        &mut self,
        bodies: &mut Bodies,
        gravity: Vec3,
        step: Step,
    ) -> Result<(), StreamError> {
        let rows = self.upload(bodies, gravity, step)?;
        let mut passes = Passes::new(&self.columns);
        passes.run(&self.positions, rows)?;
        passes.run(&self.orientations, rows)?;
        passes.submit()?;
        self.columns.download(bodies, &STATE)
    }
    // ANCHOR_END: step

    /// The same, with a wait after each part to see what it takes. Together they take longer than
    /// [`Self::step`], which waits once.
    ///
    /// # Errors
    /// As for [`Self::step`].
    pub fn step_in_parts(
        &mut self,
        bodies: &mut Bodies,
        gravity: Vec3,
        step: Step,
    ) -> Result<Parts, StreamError> {
        let gpu = self.columns.gpu().clone();
        let mut last = Instant::now();
        let mut lap = || {
            let start = std::mem::replace(&mut last, Instant::now());
            last.duration_since(start)
        };
        let rows = self.upload(bodies, gravity, step)?;
        gpu.queue.submit([]);
        gpu.wait()?;
        let upload = lap();
        let mut passes = Passes::timed(&self.columns, &mut self.timer);
        passes.section("kernels");
        passes.run(&self.positions, rows)?;
        passes.run(&self.orientations, rows)?;
        passes.submit()?;
        gpu.wait()?;
        let compute = lap();
        self.columns.download(bodies, &STATE)?;
        Ok(Parts {
            upload,
            compute,
            download: lap(),
            kernels: self.timer.latest(&gpu).map(|times| times[0].1),
        })
    }

    /// Takes the state up; gives how many bodies there are.
    fn upload(&mut self, bodies: &Bodies, gravity: Vec3, step: Step) -> Result<usize, StreamError> {
        let rows = bodies.position.len();
        let advance = Advance {
            gravity,
            dt: step.dt,
            dt_last: step.dt_last,
            kept: step.kept,
            rows: rows as u32,
            spare: 0,
        };
        if self.columns.info("bodies_inertia")?.rows != rows {
            self.columns.upload(bodies, &CONSTANT)?;
        }
        self.columns.write("advance", &[advance])?;
        self.columns.upload(bodies, &STATE)?;
        Ok(rows)
    }

    /// Bytes of a body that go up and come down, both together, in a frame.
    #[must_use]
    pub fn bytes_a_body(&self) -> usize {
        let state = self.columns.list().filter(|info| {
            STATE
                .iter()
                .any(|name| info.name.strip_prefix("bodies_") == Some(name))
        });
        2 * state.map(|info| info.row_bytes).sum::<usize>()
    }
}
