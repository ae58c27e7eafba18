//! The method of colours: Gauss–Seidel over the contacts.
//!
//! Pairs that share no body that moves have one colour and go together, in lanes and on threads, with the
//! whole masses of their bodies; one colour after another, each from what the last one left. The formulas of
//! a pair are those of the own-row method, and so is all that isn't a contact. Whoever solves the pairs of a
//! colour in whatever order gets the same bits.

mod colours;
mod live;
mod sweep;

pub use colours::{Colours, MOST_COLOURS};
pub use live::Live;

use super::Lanes;
use super::movers::Movers;
use crate::rows::Step;
use crate::simd::Real;
use sweep::{Restore, Sweep};

impl<R: Real> Lanes<R> {
    // ANCHOR: solve_colours
    /// The pairs go through their colours, and where [`Rules::back`](crate::rules::Rules::back) says so back
    /// again; then limits and loops write their own impulses, from what that made of the bodies.
    pub(super) fn solve_colours(&mut self, step: &Step) {
        let least = self.least();
        self.live.fill(&self.bodies, least);
        let colours = self.pairs.batches.colours();
        // Solved twice in a row, the last colour would find nothing to mend.
        let last = colours - 1;
        for colour in 0..colours {
            self.sweep(colour, [false, !self.rules.back || colour == last], step);
        }
        if self.rules.back {
            for colour in (0..last).rev() {
                self.sweep(colour, [true, true], step);
            }
        }
        self.gather();
        if !self.joints.is_empty() {
            self.exchange();
            for (held, sum) in self.bodies.held.iter_mut().zip(&self.gathered) {
                *held = sum.held;
            }
            self.joints.solve_rows(&self.bodies, step.h);
            self.gather();
        }
    }

    fn sweep(&mut self, colour: usize, [again, ends]: [bool; 2], step: &Step) {
        let least = self.least_of(colour);
        let sweep = Sweep {
            bodies: &self.bodies,
            live: &self.live,
            step,
            again,
            ends,
        };
        self.pairs.batches.each_of(colour, least, &sweep);
    }
    // ANCHOR_END: solve_colours

    /// The fewest batches of a colour that go together: those without a colour go one after the other.
    fn least_of(&self, colour: usize) -> usize {
        if self.pairs.colours.alone() == Some(colour) {
            usize::MAX
        } else {
            self.least_in_lanes()
        }
    }

    // ANCHOR: restore_colours
    /// Restitution, once at the end of a step, a colour after another.
    pub(super) fn restore_colours(&mut self, step: &Step) {
        let least = self.least();
        self.live.fill(&self.bodies, least);
        for colour in 0..self.pairs.batches.colours() {
            let least = self.least_of(colour);
            let restore = Restore {
                bodies: &self.bodies,
                live: &self.live,
                step,
            };
            self.pairs.batches.each_of(colour, least, &restore);
        }
        self.gather_pairs();
        let least = self.least_in_lanes();
        let gathered = &self.gathered;
        let mut movers = Movers::of(&mut self.bodies, least);
        movers.each::<R>(|block| block.take_up::<R>(gathered));
    }
    // ANCHOR_END: restore_colours
}
