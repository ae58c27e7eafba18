//! What is done with a batch of one colour: it reads its bodies as they are by now, and writes them.

use super::Live;
use crate::bodies::Bodies;
use crate::lanes::batches::{Batch, Kind, Work};
use crate::lanes::work::{before, bounces_none};
use crate::own_row::contact::{Given, Moved, Visit, restore_pair, solve_moved};
use crate::rows::{Press, Step};
use crate::simd::{MOST_LANES, Mask, Real, array_of};

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

impl<R: Real> Work<R> for Sweep<'_> {
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]) {
        let [a, b] = batch.rows;
        let was_impact = if self.again {
            R::of(|lane| rows[lane].stays).same(R::splat(0.0))
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
        if self.again {
            write_more(&given, rows);
        } else {
            given.write(rows);
        }
        let [one, two] = &visit.moved;
        self.live.write(one, &a, batch.moves[0]);
        self.live.write(two, &b, batch.moves[1]);
    }
}
// ANCHOR_END: sweep

/// Writes what a pair does after all, with its pushes added to those it has given already: impulses are sums
/// by themselves, pushes start from nothing at every visit.
fn write_more<R: Real>(given: &Given<R>, rows: &mut [Press]) {
    let old: [Press; MOST_LANES] = array_of(|lane| rows.get(lane).copied().unwrap_or_default());
    given.write(rows);
    for (row, old) in rows.iter_mut().zip(old) {
        row.push += old.push;
        row.push_a += old.push_a;
        row.push_b += old.push_b;
    }
}

/// Restitution of the pairs of a colour.
pub struct Restore<'s> {
    /// The bodies.
    pub bodies: &'s Bodies,
    /// How they move by now.
    pub live: &'s Live,
    /// The numbers of the step.
    pub step: &'s Step,
}

impl<R: Real> Work<R> for Restore<'_> {
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]) {
        if bounces_none(rows) {
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
        given.write(rows);
        let [one, two] = &mut moved;
        one.side.take(-given.linear, given.angular_a);
        two.side.take(given.linear, given.angular_b);
        self.live.write(one, &a, batch.moves[0]);
        self.live.write(two, &b, batch.moves[1]);
    }
}
