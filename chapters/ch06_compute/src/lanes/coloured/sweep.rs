//! What is done with a batch of one colour: it reads its bodies as they are by now, and writes them.

use super::Live;
use crate::bodies::Bodies;
use crate::lanes::batches::{self, Batch, Kind};
use crate::lanes::work::before;
use crate::own_row::contact::{Moved, Visit, bounces, press_again, restore_pair, solve_moved};
use crate::own_row::side::Side;
use crate::rows::Step;
use crate::simd::{Mask, Real};

/// What held the bodies in the last step, where their points are now.
pub struct PressAgain<'s> {
    /// The bodies.
    pub bodies: &'s Bodies,
    /// How they move by now.
    pub live: &'s Live,
    /// Length of a substep, s.
    pub h: f32,
}

impl<R: Real> batches::Visit<R> for PressAgain<'_> {
    fn visit<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>) {
        let [a, b] = &batch.rows;
        let sides: [Side<R, I>; 2] = [Side::of(self.bodies, a), Side::of(self.bodies, b)];
        let t = I::touching(&batch.contact, &sides[0], &sides[1]);
        let given = press_again(&t, &batch.impulse, sides, self.h);
        self.live.add(&given, false, a, batch.moves[0]);
        self.live.add(&given, true, b, batch.moves[1]);
    }
}

// ANCHOR: sweep
/// A substep of the pairs of a colour.
pub struct Sweep<'s> {
    /// The bodies.
    pub bodies: &'s Bodies,
    /// How they move by now.
    pub live: &'s Live,
    /// The numbers of the step.
    pub step: &'s Step,
    /// Whether the pairs have been solved in this substep before.
    pub again: bool,
    /// Whether they will not be again.
    pub ends: bool,
}

impl<R: Real> batches::Visit<R> for Sweep<'_> {
    fn visit<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>) {
        let [a, b] = batch.rows;
        let was_impact = if self.again {
            batch.impact.gt(R::splat(0.0))
        } else {
            R::Mask::splat(false)
        };
        let mut visit = Visit::<R, I> {
            moved: [
                self.live.read(self.bodies, &a),
                self.live.read(self.bodies, &b),
            ],
            was_impact,
            ends: self.ends,
        };
        let [one, two] = &visit.moved;
        let t = I::touching(&batch.contact, &one.side, &two.side);
        let given = solve_moved(
            &t,
            &batch.surface,
            &mut batch.impulse,
            &mut batch.approach,
            &mut visit,
            || [before(self.bodies, &a), before(self.bodies, &b)],
            self.step,
        );
        let [one, two] = &visit.moved;
        self.live.write(one, &a, batch.moves[0]);
        self.live.write(two, &b, batch.moves[1]);
        if self.ends {
            self.live.add(&given, false, &a, batch.moves[0]);
            self.live.add(&given, true, &b, batch.moves[1]);
        } else {
            batch.impact = R::splat(1.0) - given.stays;
        }
    }
}
// ANCHOR_END: sweep

/// Restitution of the pairs of a colour.
pub struct Restore<'s> {
    /// The bodies.
    pub bodies: &'s Bodies,
    /// How they move by now.
    pub live: &'s Live,
    /// The numbers of the step.
    pub step: &'s Step,
}

impl<R: Real> batches::Visit<R> for Restore<'_> {
    fn visit<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>) {
        if !bounces(&batch.approach, &batch.surface, self.step).any() {
            return;
        }
        let [a, b] = batch.rows;
        let mut moved: [Moved<R, I>; 2] = [
            self.live.read(self.bodies, &a),
            self.live.read(self.bodies, &b),
        ];
        let sides = moved.map(|body| body.side);
        let t = I::touching(&batch.contact, &sides[0], &sides[1]);
        let given = restore_pair(&t, &batch.surface, &batch.approach, sides, self.step);
        let [one, two] = &mut moved;
        one.side.take(-given.linear, given.angular_a);
        two.side.take(given.linear, given.angular_b);
        self.live.write(one, &a, batch.moves[0]);
        self.live.write(two, &b, batch.moves[1]);
        self.live.add(&given, false, &a, batch.moves[0]);
        self.live.add(&given, true, &b, batch.moves[1]);
    }
}
