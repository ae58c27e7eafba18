//! No more than the scene needs: which systems run and which columns exist, derived from the scene
//! alone.
//!
//! What is left out must be without effect on what is kept, bit for bit: a test runs every scene both
//! ways.

mod columns;
mod explain;
mod needs;
mod systems;

pub use columns::needs_of;
pub use explain::explain;
pub use systems::{SYSTEMS, System};

use ch00_scenes::Scene;

use crate::data::Data;
use crate::world::Method;

// ANCHOR: part
/// A part of the engine that a scene may not need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The corrected method.
    Corrected,
    /// The printed method.
    Printed,
    /// Something can turn.
    Turning,
    /// Something that moves isn't a ball, or is joined: its inertia has axes.
    Axes,
    /// All that turns are free balls: one number of inertia does for each.
    Round,
    /// Something is turned, even if it stays so.
    Orientations,
    /// Two bodies could touch.
    Collisions,
    /// Contacts are resolved by the corrected method, or joints by either.
    Resolution,
    /// Somebody bounces.
    Bouncing,
    /// Somebody rubs.
    Friction,
    /// Bodies are joined.
    Joints,
    /// Some of them by rods.
    Rods,
    /// Some of them within angles.
    Limits,
    /// Something pulls beside gravity.
    Forces,
    /// Some of it the mouse.
    Mouse,
    /// Some bodies hang on a point.
    FixedPoints,
    /// Boxes about what can't move are made in every step.
    Obstacles,
    /// Sweeps visit bodies that haven't changed since a visit that found nothing.
    IdleVisits,
}
// ANCHOR_END: part

impl Part {
    /// All of them.
    pub const ALL: [Part; 18] = [
        Part::Corrected,
        Part::Printed,
        Part::Turning,
        Part::Axes,
        Part::Round,
        Part::Orientations,
        Part::Collisions,
        Part::Resolution,
        Part::Bouncing,
        Part::Friction,
        Part::Joints,
        Part::Rods,
        Part::Limits,
        Part::Forces,
        Part::Mouse,
        Part::FixedPoints,
        Part::Obstacles,
        Part::IdleVisits,
    ];

    /// What it is called where it is left out.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Part::Corrected => "the corrected method",
            Part::Printed => "the printed method",
            Part::Turning => "turning",
            Part::Axes => "axes of inertia",
            Part::Round => "inertia in one number",
            Part::Orientations => "orientations",
            Part::Collisions => "collisions",
            Part::Resolution => "resolution",
            Part::Bouncing => "bouncing",
            Part::Friction => "friction",
            Part::Joints => "joints",
            Part::Rods => "rods",
            Part::Limits => "angle limits",
            Part::Forces => "forces",
            Part::Mouse => "the mouse",
            Part::FixedPoints => "fixed points",
            Part::Obstacles => "boxes of obstacles in every step",
            Part::IdleVisits => "visits that find nothing",
        }
    }

    /// Why a scene doesn't need it, where it doesn't.
    #[must_use]
    pub fn why_not(self) -> &'static str {
        match self {
            Part::Corrected => "the method is the printed one",
            Part::Printed => "the method is the corrected one",
            Part::Turning => "all that moves are balls without friction and without spin",
            Part::Axes => "all that moves are balls, and nothing joins them",
            Part::Round => "not all that moves are balls that turn freely",
            Part::Orientations => "nothing is turned and nothing can turn",
            Part::Collisions => "no two bodies could touch",
            Part::Resolution => "nothing touches and nothing is joined",
            Part::Bouncing => "no body that could touch another has a restitution above 0",
            Part::Friction => "no two bodies that could touch both have friction",
            Part::Joints => "nothing is joined",
            Part::Rods => "no joint keeps a distance",
            Part::Limits => "no joint limits an angle",
            Part::Forces => "gravity alone pulls, and that is the same for all",
            Part::Mouse => "the mouse drags nothing",
            Part::FixedPoints => "nothing hangs on a fixed point",
            Part::Obstacles => "what can't move keeps its box",
            Part::IdleVisits => "where nothing has changed since, they would find nothing again",
        }
    }
}

// ANCHOR: plan
/// Which parts a run has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    has: [bool; Part::ALL.len()],
}

impl Plan {
    /// What this scene needs.
    #[must_use]
    pub fn of(scene: &Scene, method: Method) -> Self {
        Self::from(|part| needs::needs(scene, method, part))
    }

    /// All that the method has, whatever the scene.
    #[must_use]
    pub fn full(method: Method) -> Self {
        Self::from(|part| match part {
            Part::Corrected | Part::Friction => method == Method::Corrected,
            Part::Printed => method == Method::Printed,
            Part::Round => false,
            _ => true,
        })
    }
    // ANCHOR_END: plan

    fn from(has: impl Fn(Part) -> bool) -> Self {
        let has = Part::ALL.map(has);
        Self { has }.settled()
    }

    /// One of two parts stands for the other's absence.
    fn settled(mut self) -> Self {
        self.has[Part::Round as usize] = self.has(Part::Turning) && !self.has(Part::Axes);
        self
    }

    /// The same with one part more, and with those that it can't do without.
    #[must_use]
    pub fn with(mut self, part: Part) -> Self {
        let needs: &[Part] = match part {
            Part::Turning => &[Part::Orientations],
            Part::Axes | Part::Friction | Part::Forces => &[Part::Turning],
            Part::Joints => &[Part::Axes, Part::Resolution],
            Part::Rods | Part::Limits => &[Part::Joints],
            Part::Mouse => &[Part::Forces],
            Part::FixedPoints => &[Part::Forces, Part::Axes],
            Part::Collisions => &[Part::Resolution],
            _ => &[],
        };
        self.has[part as usize] = true;
        let with_all = needs.iter().fold(self, |plan, &needed| plan.with(needed));
        with_all.settled()
    }

    /// What either has.
    #[must_use]
    pub fn joined(&self, other: &Self) -> Self {
        Self::from(|part| self.has(part) || other.has(part))
    }

    /// Whether it has a part.
    #[must_use]
    pub fn has(&self, part: Part) -> bool {
        self.has[part as usize]
    }

    /// Whether it has all of these.
    #[must_use]
    pub fn has_all(&self, parts: &[Part]) -> bool {
        parts.iter().all(|&part| self.has(part))
    }

    /// Parts of the method that this scene doesn't need.
    pub fn left_out(&self) -> impl Iterator<Item = Part> {
        let method = if self.has(Part::Printed) {
            Method::Printed
        } else {
            Method::Corrected
        };
        let full = Self::full(method);
        Part::ALL
            .into_iter()
            .filter(move |&part| full.has(part) && !self.has(part))
    }

    /// Why a column was left out; None if it wasn't.
    #[must_use]
    pub fn why_left_out(&self, table: &str, column: &str) -> Option<&'static str> {
        let needed = needs_of(table, column).iter();
        let missing = needed.copied().find(|&part| !self.has(part));
        missing.map(Part::why_not)
    }

    /// The systems that run, in order.
    pub fn systems(&self) -> impl Iterator<Item = &'static System> {
        SYSTEMS.iter().filter(|system| self.has_all(system.needs))
    }

    /// The systems of the method that have nothing to do in this scene.
    pub fn idle_systems(&self) -> impl Iterator<Item = &'static System> {
        let other = if self.has(Part::Printed) {
            Part::Corrected
        } else {
            Part::Printed
        };
        SYSTEMS
            .iter()
            .filter(move |system| !system.needs.contains(&other) && !self.has_all(system.needs))
    }

    // ANCHOR: apply
    /// Allocates the columns that it needs and drops the others.
    pub fn apply(&self, data: &mut Data) {
        for table in data.tables_mut() {
            let rows = table.rows();
            for (place, spec) in table.specs().iter().enumerate() {
                let kept = self.has_all(needs_of(table.name(), spec.name));
                table.column_mut(place).set_kept(kept, rows);
            }
        }
    }
    // ANCHOR_END: apply
}
