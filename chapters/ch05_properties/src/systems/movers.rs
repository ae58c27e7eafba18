//! What contacts and joints can do to bodies while they are resolved: push, nudge, and ask how they
//! move. Two sets of columns can answer: one with turns, and one without, for balls that nothing can turn.

use ch00_maths::f32::impulse::{self, Inertia, Mass, Velocity};
use glam::{Mat3, Vec3};

// ANCHOR: movers
/// Bodies by row, as the resolution of contacts needs them.
pub trait Movers {
    /// 1/m, 1/kg.
    fn inverse_mass(&self, row: usize) -> f32;

    /// Velocity, m/s, without what a turn adds.
    fn velocity(&self, row: usize) -> Vec3;

    /// Velocity of one body's point r₁ relative to another's r₂, m/s.
    fn relative_velocity(&self, a: usize, r1: Vec3, b: usize, r2: Vec3) -> Vec3;

    /// What a unit impulse along u changes, 1/kg.
    fn response(&self, a: usize, r1: Vec3, b: usize, r2: Vec3, u: Vec3) -> f32;

    /// An impulse, N s, at `r` from the centre.
    fn push(&mut self, row: usize, r: Vec3, impulse: Vec3);

    /// A positional impulse, kg m, at `r`: moves and turns, but leaves velocities.
    fn nudge(&mut self, row: usize, r: Vec3, impulse: Vec3);

    /// Where the point at `r` has been nudged to, m.
    fn nudged(&self, row: usize, r: Vec3) -> Vec3;

    /// Makes a shift at most so long, m.
    fn shorten_shift(&mut self, row: usize, longest: f32);
}
// ANCHOR_END: movers

// ANCHOR: gliding
/// Bodies that nothing can turn: every impulse goes through their centres.
pub struct Gliding<'a> {
    /// m/s.
    pub velocity: &'a mut [Vec3],
    /// m.
    pub shift: &'a mut [Vec3],
    /// 1/kg.
    pub inverse_mass: &'a [f32],
}

impl Movers for Gliding<'_> {
    // ANCHOR_END: gliding
    #[inline]
    fn inverse_mass(&self, row: usize) -> f32 {
        self.inverse_mass[row]
    }

    #[inline]
    fn velocity(&self, row: usize) -> Vec3 {
        self.velocity[row]
    }

    #[inline]
    fn relative_velocity(&self, a: usize, _r1: Vec3, b: usize, _r2: Vec3) -> Vec3 {
        self.velocity[a] - self.velocity[b]
    }

    #[inline]
    fn response(&self, a: usize, _r1: Vec3, b: usize, _r2: Vec3, _u: Vec3) -> f32 {
        self.inverse_mass[a] + self.inverse_mass[b]
    }

    #[inline]
    fn push(&mut self, row: usize, _r: Vec3, impulse: Vec3) {
        self.velocity[row] += impulse * self.inverse_mass[row];
    }

    #[inline]
    fn nudge(&mut self, row: usize, _r: Vec3, impulse: Vec3) {
        self.shift[row] += impulse * self.inverse_mass[row];
    }

    #[inline]
    fn nudged(&self, row: usize, _r: Vec3) -> Vec3 {
        self.shift[row]
    }

    #[inline]
    fn shorten_shift(&mut self, row: usize, longest: f32) {
        self.shift[row] = self.shift[row].clamp_length_max(longest);
    }
}

// ANCHOR: turning
/// Bodies that impulses turn too. `I` is a matrix a body, or a number where all are balls.
pub struct Turning<'a, I = Mat3> {
    /// m/s.
    pub velocity: &'a mut [Vec3],
    /// rad/s, world.
    pub spin: &'a mut [Vec3],
    /// m.
    pub shift: &'a mut [Vec3],
    /// rad.
    pub turn: &'a mut [Vec3],
    /// 1/kg.
    pub inverse_mass: &'a [f32],
    /// I⁻¹ in world axes, 1/(kg m²).
    pub inverse_inertia: &'a [I],
}

impl<I: Inertia> Turning<'_, I> {
    /// How a body answers to impulses.
    #[inline]
    #[must_use]
    pub fn mass(&self, row: usize) -> Mass<I> {
        Mass {
            inverse_mass: self.inverse_mass[row],
            inverse_inertia: self.inverse_inertia[row],
        }
    }
    // ANCHOR_END: turning

    /// How it moves, as far as it is resolved.
    #[inline]
    #[must_use]
    pub fn moving(&self, row: usize) -> Velocity {
        Velocity {
            v: self.velocity[row],
            omega: self.spin[row],
        }
    }

    /// A turning impulse, N m s.
    #[inline]
    pub fn twist(&mut self, row: usize, impulse: Vec3) {
        self.spin[row] += self.inverse_inertia[row].moment(impulse);
    }

    /// A positional turning impulse, kg m².
    #[inline]
    pub fn nudge_turn(&mut self, row: usize, impulse: Vec3) {
        self.turn[row] += self.inverse_inertia[row].moment(impulse);
    }
}

impl<I: Inertia> Movers for Turning<'_, I> {
    #[inline]
    fn inverse_mass(&self, row: usize) -> f32 {
        self.inverse_mass[row]
    }

    #[inline]
    fn velocity(&self, row: usize) -> Vec3 {
        self.velocity[row]
    }

    #[inline]
    fn relative_velocity(&self, a: usize, r1: Vec3, b: usize, r2: Vec3) -> Vec3 {
        impulse::relative_velocity(self.moving(a), r1, self.moving(b), r2)
    }

    #[inline]
    fn response(&self, a: usize, r1: Vec3, b: usize, r2: Vec3, u: Vec3) -> f32 {
        impulse::response(&self.mass(a), r1, &self.mass(b), r2, u)
    }

    #[inline]
    fn push(&mut self, row: usize, r: Vec3, impulse: Vec3) {
        let moving = impulse::applied(self.moving(row), &self.mass(row), r, impulse);
        self.velocity[row] = moving.v;
        self.spin[row] = moving.omega;
    }

    #[inline]
    fn nudge(&mut self, row: usize, r: Vec3, impulse: Vec3) {
        self.shift[row] += impulse * self.inverse_mass[row];
        self.turn[row] += self.inverse_inertia[row].moment(r.cross(impulse));
    }

    #[inline]
    fn nudged(&self, row: usize, r: Vec3) -> Vec3 {
        self.shift[row] + self.turn[row].cross(r)
    }

    #[inline]
    fn shorten_shift(&mut self, row: usize, longest: f32) {
        self.shift[row] = self.shift[row].clamp_length_max(longest);
    }
}
