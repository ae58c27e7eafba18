//! What is done with a batch of pairs.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

use std::sync::atomic::{AtomicBool, Ordering};

use super::batches::{Batch, Kind, Visit, Work};
use crate::bodies::Bodies;
use crate::own_row::contact::{Before, bounces, press_again, restore_pair, solve_pair};
use crate::own_row::side::{Side, Turns};
use crate::rows::{Press, Step};
use crate::simd::{Mask, Real, Vec3};

/// What held the bodies in the last step, where their points are now.
pub struct PressAgain<'s> {
    /// The bodies.
    pub bodies: &'s Bodies,
    /// Length of a substep, s.
    pub h: f32,
}

impl<R: Real> Work<R> for PressAgain<'_> {
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]) {
        let sides = sides::<R, I, P>(self.bodies, batch);
        let t = I::touching(&batch.contact, &sides[0], &sides[1]);
        press_again(&t, &batch.impulse, sides, self.h).write(rows);
    }
}

/// A substep of the pairs.
pub struct Solve<'s> {
    /// The bodies.
    pub bodies: &'s Bodies,
    /// The numbers of the step.
    pub step: &'s Step,
}

impl<R: Real> Work<R> for Solve<'_> {
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]) {
        let sides = sides::<R, I, P>(self.bodies, batch);
        let t = I::touching(&batch.contact, &sides[0], &sides[1]);
        let [a, b] = batch.rows;
        let given = solve_pair(
            &t,
            &batch.surface,
            &mut batch.impulse,
            &mut batch.approach,
            sides,
            || [before(self.bodies, &a), before(self.bodies, &b)],
            self.step,
        );
        given.write(rows);
    }
}

/// Whether any pair bounces at the end of the step.
pub struct AnyBounces<'s> {
    step: &'s Step,
    any: AtomicBool,
}

impl<'s> AnyBounces<'s> {
    /// None so far.
    #[must_use]
    pub fn of(step: &'s Step) -> Self {
        Self {
            step,
            any: AtomicBool::new(false),
        }
    }

    /// Whether any does.
    #[must_use]
    pub fn any(&self) -> bool {
        self.any.load(Ordering::Relaxed)
    }
}

impl<R: Real> Visit<R> for &AnyBounces<'_> {
    fn visit<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>) {
        if !self.any() && bounces(&batch.approach, &batch.surface, self.step).any() {
            self.any.store(true, Ordering::Relaxed);
        }
    }
}

/// Which pairs bounce.
pub struct Bounces<'s> {
    /// The numbers of the step.
    pub step: &'s Step,
}

impl<R: Real> Work<R> for Bounces<'_> {
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]) {
        let hits = R::ones(bounces(&batch.approach, &batch.surface, self.step));
        for (lane, row) in rows.iter_mut().enumerate() {
            row.counts = hits.lane(lane);
        }
    }
}

/// Restitution.
pub struct Restore<'s> {
    /// The bodies.
    pub bodies: &'s Bodies,
    /// The numbers of the step.
    pub step: &'s Step,
}

impl<R: Real> Work<R> for Restore<'_> {
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]) {
        if bounces_none(rows) {
            return;
        }
        let sides = sides::<R, I, P>(self.bodies, batch);
        let t = I::touching(&batch.contact, &sides[0], &sides[1]);
        restore_pair(&t, &batch.surface, &batch.approach, sides, self.step).write(rows);
    }
}

/// Whether no pair of a batch bounces; then they give nothing.
fn bounces_none(rows: &mut [Press]) -> bool {
    let none = rows.iter().all(|row| row.counts == 0.0);
    if none {
        rows.fill(Press::default());
    }
    none
}

/// The bodies of a batch.
#[inline(always)]
fn sides<R: Real, I: Turns<R>, const P: usize>(
    bodies: &Bodies,
    batch: &Batch<R, P>,
) -> [Side<R, I>; 2] {
    let [a, b] = &batch.rows;
    [Side::of(bodies, a), Side::of(bodies, b)]
}

/// How bodies moved before the last kick.
#[inline(always)]
pub(super) fn before<R: Real>(bodies: &Bodies, rows: &[u32]) -> Before<R> {
    let table: &[[[f32; 4]; 2]] = bytemuck::cast_slice(&bodies.before);
    let [x, y, z, _] = R::of_rows(|lane| table[rows[lane] as usize][0]);
    let [i, j, k, _] = R::of_rows(|lane| table[rows[lane] as usize][1]);
    Before {
        velocity: Vec3::new(x, y, z),
        angular_velocity: Vec3::new(i, j, k),
    }
}
