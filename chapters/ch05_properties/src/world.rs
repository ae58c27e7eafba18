//! A world: the container of columns, the few numbers that are the same for all rows, and the plan that
//! says what is done with them.

mod change;
mod load;
mod run;
mod state;

pub use change::{BodyId, ChangeError, JointId};

use ch00_maths::f32::drag;
use ch00_scenes::TableError;
use ch03_collision::{Margins, Rules, Span};
use glam::Vec3;

use crate::columns::{AnyColumn, AnyTable};
use crate::data::{Data, place_of};
use crate::plan::{Part, Plan};
use crate::systems::advance::Step;
use crate::systems::broad_phase::BroadPhase;
use crate::systems::narrow_phase::Carried;

/// Which formulas a world is stepped with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// As the report prints them.
    Printed,
    /// With the errata mended.
    Corrected,
}

impl Method {
    /// As `--method` says it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Method::Printed => "printed",
            Method::Corrected => "corrected",
        }
    }
}

// ANCHOR: world
/// Everything that a step reads and writes.
pub struct World {
    /// The columns.
    pub data: Data,
    /// What is done with them.
    pub plan: Plan,
    /// The same for all rows.
    pub surroundings: Surroundings,
    /// The broad phase's memory.
    pub broad: BroadPhase,
    /// What the last step's contacts carried.
    pub carried: Carried,
    /// Rows of the bodies that the last resolution touched, in order.
    pub involved: Vec<u32>,
    /// How long steps were.
    pub steps: Steps,
    /// What was left undone.
    pub counts: Counts,
    /// The system that runs now: no row can be added or removed while one does.
    pub(crate) running: Option<&'static str>,
}

/// What is the same for all rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surroundings {
    /// Which formulas.
    pub method: Method,
    /// Acceleration of all that can move, m/s².
    pub gravity: Vec3,
    /// F, 1/s.
    pub drag: f32,
    /// What the corrected method may choose.
    pub rules: Rules,
}
// ANCHOR_END: world

/// How long steps were.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// The step that runs now, s.
    pub dt: f32,
    /// Δt*, the step before it, s.
    pub before: f32,
    /// How long ago p* and q* are, s.
    pub dt_last: f32,
    /// The last step that was resolved, s; 0 before it.
    pub resolved: f32,
    /// The step that is resolved now, beside the last one.
    pub span: Span,
}

/// What was left undone since loading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Turns too fast to be read.
    pub unread_turns: usize,
    /// Impacts that the sweeps did not get to.
    pub impacts_left: usize,
    /// Touches whose depth the iterations did not get to the end of.
    pub unsure_touches: usize,
}

impl World {
    // ANCHOR: step
    /// Advances by `dt` seconds: runs the plan's systems in order, and calls `after` when each is done.
    pub fn step(&mut self, dt: f32, mut after: impl FnMut(&'static str, &mut Self)) {
        self.steps = Steps {
            dt,
            before: self.steps.dt_last,
            dt_last: dt,
            ..self.steps
        };
        let plan = self.plan.clone();
        for system in plan.systems() {
            self.running = Some(system.name);
            (system.run)(self);
            after(system.name, self);
        }
        self.running = None;
    }
    // ANCHOR_END: step

    // ANCHOR: begin
    /// Resolves what touches at the start, before the first step of `dt` seconds. Bodies that begin on a
    /// floor would else fall for a step before it holds them.
    pub fn begin(&mut self, dt: f32) {
        if self.surroundings.method == Method::Printed {
            return;
        }
        self.steps.dt = dt;
        let plan = self.plan.clone();
        for system in plan.systems().filter(|system| system.also_at_start) {
            (system.run)(self);
        }
        // What holds a body holds it from now on only, and not for half a step already.
        for held in self.data.bodies.held_velocity.iter_mut() {
            *held *= 2.0;
        }
        for held in self.data.bodies.held_spin.iter_mut() {
            *held *= 2.0;
        }
    }
    // ANCHOR_END: begin

    /// Gravity, if that is all that pulls.
    pub(crate) fn gravity(&self) -> Option<Vec3> {
        (!self.plan.has(Part::Forces)).then_some(self.surroundings.gravity)
    }

    /// How long the step is that runs now.
    pub(crate) fn step_now(&self) -> Step {
        let Steps { dt, before, .. } = self.steps;
        let rate = self.surroundings.drag;
        let kept = match self.surroundings.method {
            Method::Printed => drag::printed::kept(rate, dt),
            Method::Corrected => drag::kept(rate, dt),
        };
        Step {
            dt,
            dt_last: before,
            kept,
        }
    }

    /// How near a pair must be to matter. The report's method looks at what overlaps, and at nothing
    /// else.
    pub(crate) fn margins(&self) -> Margins {
        match self.surroundings.method {
            Method::Printed => Margins::default(),
            Method::Corrected => self.surroundings.rules.margins(self.steps.dt),
        }
    }

    // ANCHOR: column
    /// A column by its name, whatever its type: what uploads and tables ask for.
    ///
    /// # Errors
    /// [`TableError`] for a table or column that there isn't, and for one that the plan left out.
    pub fn column(&self, table: &str, column: &str) -> Result<&dyn AnyColumn, TableError> {
        let found = self.data.table(table)?;
        let place = place_of(found, column)?;
        match self.plan.why_left_out(table, column) {
            Some(why) => Err(TableError::LeftOut {
                table: table.to_owned(),
                column: column.to_owned(),
                why: why.to_owned(),
            }),
            None => Ok(found.column(place)),
        }
    }
    // ANCHOR_END: column

    /// The row of a body.
    ///
    /// # Errors
    /// [`TableError::Stale`] once it is gone.
    pub fn row(&self, body: BodyId) -> Result<usize, TableError> {
        let found = self.data.bodies.ids().row(body);
        found.ok_or_else(|| TableError::Stale {
            table: self.data.bodies.name().to_owned(),
            row: body,
        })
    }
}
