//! Poses that joints put back at once: p* and q* stay, so that velocities follow.

use ch00_maths::f32::impulse::Mass;
use ch00_maths::f32::rotation;
use glam::{Mat3, Quat, Vec3};

use crate::systems::visits::Changes;

/// The columns that joints correct.
pub struct Poses<'a> {
    /// p, m.
    pub position: &'a mut [Vec3],
    /// q.
    pub orientation: &'a mut [Quat],
    /// 1/m, 1/kg.
    pub inverse_mass: &'a [f32],
    /// The inverse moments, 1/(kg m²).
    pub inverse_moments: &'a [Vec3],
    /// I⁻¹ in world axes, as they were when the last step was resolved, 1/(kg m²).
    pub inverse_inertia: &'a mut [Mat3],
    /// The visit that last moved each.
    pub changed: &'a mut [u32],
}

impl Changes for Poses<'_> {
    #[inline]
    fn changed(&self, row: usize) -> u32 {
        self.changed[row]
    }

    #[inline]
    fn set_changed(&mut self, row: usize, visit: u32) {
        if self.inverse_mass[row] != 0.0 {
            self.changed[row] = visit;
        }
    }
}

impl Poses<'_> {
    /// Where a body is.
    #[inline]
    pub(super) fn pose(&self, row: usize) -> (Vec3, Quat) {
        (self.position[row], self.orientation[row])
    }

    /// How it answers to impulses.
    #[inline]
    pub(super) fn mass(&self, row: usize) -> Mass {
        Mass {
            inverse_mass: self.inverse_mass[row],
            inverse_inertia: self.inverse_inertia[row],
        }
    }

    /// Turns its inertia to where it is now.
    pub(super) fn weigh(&mut self, row: usize) {
        let (w, moments) = (self.inverse_mass[row], self.inverse_moments[row]);
        self.inverse_inertia[row] = Mass::new(w, moments, self.orientation[row]).inverse_inertia;
    }

    /// Carries out a positional impulse, kg m, at `r` from its centre, and a turning one, kg m².
    #[inline]
    pub(super) fn displace(&mut self, row: usize, r: Vec3, impulse: Vec3, turning: Vec3) {
        let turn = self.inverse_inertia[row] * (r.cross(impulse) + turning);
        self.position[row] += impulse * self.inverse_mass[row];
        if turn != Vec3::ZERO {
            self.orientation[row] = rotation::turned(self.orientation[row], turn);
        }
    }

    /// Moves and turns it as the report prints it.
    pub(super) fn displace_printed(&mut self, row: usize, shift: Vec3, turn: Vec3) {
        self.position[row] += shift;
        self.orientation[row] = rotation::printed::turned(self.orientation[row], turn);
    }
}
