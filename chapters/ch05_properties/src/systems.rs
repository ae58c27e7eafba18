//! The systems: plain functions over the columns that they name. None knows the container, none keeps
//! anything between two calls.
//!
//! Their order is [`crate::plan`]'s.

pub mod advance;
pub mod broad_phase;
pub mod contacts;
pub mod forces;
pub mod joints;
pub mod movers;
pub mod narrow_phase;
pub mod printed;
pub mod resolving;
pub mod velocities;
pub mod visits;

use glam::Vec3;

/// A row of a column that the plan may have left out: then it is the type's zero for all.
#[inline]
pub(crate) fn or_zero<T: Copy + Default>(column: &[T], row: usize) -> T {
    column.get(row).copied().unwrap_or_default()
}

// ANCHOR: pull
/// What pulls each body, m/s²: gravity alone, or a column that forces wrote.
#[derive(Clone, Copy)]
pub enum Pull<'a> {
    /// The same for all that can move.
    Gravity(Vec3),
    /// A row each.
    Forces(&'a [Vec3]),
}

impl<'a> Pull<'a> {
    /// Gravity, if that is all there is, or the column.
    #[must_use]
    pub fn of(gravity: Option<Vec3>, acceleration: &'a [Vec3]) -> Self {
        gravity.map_or(Pull::Forces(acceleration), Pull::Gravity)
    }

    /// On the body in this row. What can't move isn't pulled.
    #[inline]
    #[must_use]
    pub fn on(self, row: usize, inverse_mass: f32) -> Vec3 {
        match self {
            Pull::Gravity(_) if inverse_mass == 0.0 => Vec3::ZERO,
            Pull::Gravity(gravity) => gravity,
            Pull::Forces(acceleration) => acceleration[row],
        }
    }
}
// ANCHOR_END: pull
