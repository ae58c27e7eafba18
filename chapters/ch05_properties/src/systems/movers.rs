//! What contacts and joints can do to bodies while they are resolved: push, nudge, and ask how they
//! move. Three sets of columns can answer: one with turns about any axes, one for balls, and one
//! without turns, for balls that nothing can turn.

#![expect(
    clippy::inline_always,
    reason = "a call would copy matrices for each of a sweep's visits"
)]

use ch00_maths::f32::impulse::{self, Inertia, Mass, Velocity};
use glam::{Mat3, Vec3};

use super::visits::Changes;

// ANCHOR: movers
/// Bodies by row, as the resolution of contacts needs them.
pub trait Movers: Changes {
    /// Two bodies, taken out of their columns for as long as a touch looks at them.
    type Pair: Pair;

    /// Takes two bodies out, with what moves them.
    fn moving_pair(&self, a: usize, b: usize) -> Self::Pair;

    /// Puts back how they move.
    fn set_moving_pair(&mut self, a: usize, b: usize, pair: &Self::Pair);

    /// How far body a's point r₁ has been nudged away from body b's point r₂, m.
    fn nudged_apart(&self, a: usize, r1: Vec3, b: usize, r2: Vec3) -> Vec3;

    /// A positional impulse on body a at r₁, and its opposite on body b at r₂, kg m: moves and turns
    /// them, but leaves velocities.
    fn nudge_apart(&mut self, a: usize, r1: Vec3, b: usize, r2: Vec3, impulse: Vec3);

    /// 1/m, 1/kg.
    fn inverse_mass(&self, row: usize) -> f32;

    /// Makes a shift at most so long, m.
    fn shorten_shift(&mut self, row: usize, longest: f32);
}

// ANCHOR_END: movers

// ANCHOR: pair
/// Two bodies that touch.
pub trait Pair {
    /// v_r: velocity of body 1's point r₁ relative to body 2's point r₂, m/s.
    fn relative_velocity(&self, r1: Vec3, r2: Vec3) -> Vec3;

    /// An impulse on body 1 at r₁, and its opposite on body 2 at r₂, N s.
    fn push(&mut self, r1: Vec3, r2: Vec3, impulse: Vec3);

    /// What a unit impulse along u changes, 1/kg.
    fn response(&self, r1: Vec3, r2: Vec3, u: Vec3) -> f32;

    /// Inverse masses, 1/kg.
    fn inverse_masses(&self) -> [f32; 2];

    /// Velocity of a body's centre, m/s: 0 for body 1, 1 for body 2.
    fn velocity(&self, body: usize) -> Vec3;

    /// An impulse through the centre of one body alone, N s.
    fn push_one(&mut self, body: usize, impulse: Vec3);
}
// ANCHOR_END: pair

// ANCHOR: gliding
/// Bodies that nothing can turn: every impulse goes through their centres.
pub struct Gliding<'a> {
    /// m/s.
    pub velocity: &'a mut [Vec3],
    /// m.
    pub shift: &'a mut [Vec3],
    /// The visit that last changed each.
    pub changed: &'a mut [u32],
    /// 1/kg.
    pub inverse_mass: &'a [f32],
}

/// Two of them.
pub struct GlidingPair {
    v: [Vec3; 2],
    w: [f32; 2],
}

impl Pair for GlidingPair {
    #[inline]
    fn relative_velocity(&self, _r1: Vec3, _r2: Vec3) -> Vec3 {
        self.v[0] - self.v[1]
    }

    #[inline]
    fn push(&mut self, _r1: Vec3, _r2: Vec3, impulse: Vec3) {
        self.v[0] += impulse * self.w[0];
        self.v[1] += -impulse * self.w[1];
    }
    // ANCHOR_END: gliding

    #[inline]
    fn response(&self, _r1: Vec3, _r2: Vec3, _u: Vec3) -> f32 {
        self.w[0] + self.w[1]
    }

    #[inline]
    fn inverse_masses(&self) -> [f32; 2] {
        self.w
    }

    #[inline]
    fn velocity(&self, body: usize) -> Vec3 {
        self.v[body]
    }

    #[inline]
    fn push_one(&mut self, body: usize, impulse: Vec3) {
        self.v[body] += impulse * self.w[body];
    }
}

impl Changes for Gliding<'_> {
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

impl Movers for Gliding<'_> {
    type Pair = GlidingPair;

    #[inline(always)]
    fn moving_pair(&self, a: usize, b: usize) -> GlidingPair {
        GlidingPair {
            v: [self.velocity[a], self.velocity[b]],
            w: [self.inverse_mass[a], self.inverse_mass[b]],
        }
    }

    #[inline(always)]
    fn set_moving_pair(&mut self, a: usize, b: usize, pair: &GlidingPair) {
        self.velocity[a] = pair.v[0];
        self.velocity[b] = pair.v[1];
    }

    #[inline(always)]
    fn nudged_apart(&self, a: usize, _r1: Vec3, b: usize, _r2: Vec3) -> Vec3 {
        self.shift[a] - self.shift[b]
    }

    #[inline(always)]
    fn nudge_apart(&mut self, a: usize, _r1: Vec3, b: usize, _r2: Vec3, impulse: Vec3) {
        self.shift[a] += impulse * self.inverse_mass[a];
        self.shift[b] += -impulse * self.inverse_mass[b];
    }

    #[inline]
    fn inverse_mass(&self, row: usize) -> f32 {
        self.inverse_mass[row]
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
    /// The visit that last changed each.
    pub changed: &'a mut [u32],
    /// 1/kg.
    pub inverse_mass: &'a [f32],
    /// I⁻¹ in world axes, 1/(kg m²).
    pub inverse_inertia: &'a [I],
}

/// Two of them.
pub struct TurningPair<I> {
    moving: [Velocity; 2],
    mass: [Mass<I>; 2],
}

impl<I: Inertia> Pair for TurningPair<I> {
    #[inline]
    fn relative_velocity(&self, r1: Vec3, r2: Vec3) -> Vec3 {
        impulse::relative_velocity(self.moving[0], r1, self.moving[1], r2)
    }

    #[inline]
    fn push(&mut self, r1: Vec3, r2: Vec3, impulse: Vec3) {
        let [one, two] = self.moving;
        self.moving = [
            impulse::applied(one, &self.mass[0], r1, impulse),
            impulse::applied(two, &self.mass[1], r2, -impulse),
        ];
    }
    // ANCHOR_END: turning

    #[inline]
    fn response(&self, r1: Vec3, r2: Vec3, u: Vec3) -> f32 {
        impulse::response(&self.mass[0], r1, &self.mass[1], r2, u)
    }

    #[inline]
    fn inverse_masses(&self) -> [f32; 2] {
        [self.mass[0].inverse_mass, self.mass[1].inverse_mass]
    }

    #[inline]
    fn velocity(&self, body: usize) -> Vec3 {
        self.moving[body].v
    }

    #[inline]
    fn push_one(&mut self, body: usize, impulse: Vec3) {
        self.moving[body] =
            impulse::applied(self.moving[body], &self.mass[body], Vec3::ZERO, impulse);
    }
}

impl<I: Inertia> Changes for Turning<'_, I> {
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

impl<I: Inertia> Movers for Turning<'_, I> {
    type Pair = TurningPair<I>;

    #[inline(always)]
    fn moving_pair(&self, a: usize, b: usize) -> TurningPair<I> {
        TurningPair {
            moving: [self.moving(a), self.moving(b)],
            mass: [self.mass(a), self.mass(b)],
        }
    }

    #[inline(always)]
    fn set_moving_pair(&mut self, a: usize, b: usize, pair: &TurningPair<I>) {
        for (row, moving) in [(a, pair.moving[0]), (b, pair.moving[1])] {
            self.velocity[row] = moving.v;
            self.spin[row] = moving.omega;
        }
    }

    #[inline(always)]
    fn nudged_apart(&self, a: usize, r1: Vec3, b: usize, r2: Vec3) -> Vec3 {
        let one = self.shift[a] + self.turn[a].cross(r1);
        let two = self.shift[b] + self.turn[b].cross(r2);
        one - two
    }

    #[inline(always)]
    fn nudge_apart(&mut self, a: usize, r1: Vec3, b: usize, r2: Vec3, impulse: Vec3) {
        self.nudge(a, r1, impulse);
        self.nudge(b, r2, -impulse);
    }

    #[inline]
    fn inverse_mass(&self, row: usize) -> f32 {
        self.inverse_mass[row]
    }

    #[inline]
    fn shorten_shift(&mut self, row: usize, longest: f32) {
        self.shift[row] = self.shift[row].clamp_length_max(longest);
    }
}

/// What joints do with one body.
impl<I: Inertia> Turning<'_, I> {
    /// How a body answers to impulses.
    #[inline(always)]
    #[must_use]
    pub fn mass(&self, row: usize) -> Mass<I> {
        Mass {
            inverse_mass: self.inverse_mass[row],
            inverse_inertia: self.inverse_inertia[row],
        }
    }

    /// How it moves, as far as it is resolved.
    #[inline(always)]
    #[must_use]
    pub fn moving(&self, row: usize) -> Velocity {
        Velocity {
            v: self.velocity[row],
            omega: self.spin[row],
        }
    }

    /// Velocity of one body's point r₁ relative to another's r₂, m/s.
    #[inline]
    #[must_use]
    pub fn relative_velocity(&self, a: usize, r1: Vec3, b: usize, r2: Vec3) -> Vec3 {
        impulse::relative_velocity(self.moving(a), r1, self.moving(b), r2)
    }

    /// An impulse, N s, at `r` from the centre.
    #[inline]
    pub fn push(&mut self, row: usize, r: Vec3, impulse: Vec3) {
        let moving = impulse::applied(self.moving(row), &self.mass(row), r, impulse);
        self.velocity[row] = moving.v;
        self.spin[row] = moving.omega;
    }

    /// An angular impulse, N m s.
    #[inline]
    pub fn twist(&mut self, row: usize, impulse: Vec3) {
        self.spin[row] += self.inverse_inertia[row].moment(impulse);
    }

    /// A positional impulse, kg m, at `r`: moves and turns, but leaves velocities.
    #[inline(always)]
    pub fn nudge(&mut self, row: usize, r: Vec3, impulse: Vec3) {
        self.shift[row] += impulse * self.inverse_mass[row];
        self.turn[row] += self.inverse_inertia[row].moment(r.cross(impulse));
    }

    /// A positional angular impulse, kg m².
    #[inline]
    pub fn nudge_turn(&mut self, row: usize, impulse: Vec3) {
        self.turn[row] += self.inverse_inertia[row].moment(impulse);
    }
}
