//! The method of colours: Gauss–Seidel over the contacts.
//!
//! Pairs that share no body that moves have one colour and go together, in lanes and on threads, with the
//! whole masses of their bodies; one colour after another, each from what the last one left. The formulas of
//! a pair are those of the own-row method, and so is all that isn't a contact. Whoever solves the pairs of a
//! colour in whatever order gets the same bits.

mod colours;
mod live;
mod sweep;

pub use colours::{Colours, MOST_COLOURS, STILL};
pub use live::Live;

use super::Lanes;
use super::threads;
use crate::rows::Step;
use crate::simd::Real;
use sweep::{PressAgain, Restore, Sweep};

impl<R: Real> Lanes<R> {
    /// What held the bodies in the last step, where their points are now.
    pub(super) fn press_colours(&mut self, step: &Step) {
        let least = self.least();
        self.live.fill(&self.bodies, least);
        let (bodies, live) = (&self.bodies, &self.live);
        let again = |_| PressAgain {
            bodies,
            live,
            h: step.h,
        };
        self.pairs.sweep(false, least, again);
        self.gather_live();
    }

    // ANCHOR: solve_colours
    /// The pairs go through their colours, and where [`Rules::back`](crate::rules::Rules::back) says so back
    /// again; then limits and loops write their own impulses, from what that made of the bodies.
    pub(super) fn solve_colours(&mut self, step: &Step) {
        let least = self.least();
        self.live.fill(&self.bodies, least);
        let (bodies, live) = (&self.bodies, &self.live);
        let visit = |[again, ends]: [bool; 2]| Sweep {
            bodies,
            live,
            step,
            again,
            ends,
        };
        self.pairs.sweep(self.rules.back, least, visit);
        self.gather_live();
        if !self.joints.is_empty() {
            self.exchange();
            for (held, sum) in self.bodies.held.iter_mut().zip(&self.gathered) {
                *held = sum.held;
            }
            self.joints.solve_rows(&self.bodies, step.h);
            self.gather_live();
        }
    }
    // ANCHOR_END: solve_colours

    /// Every body takes what its pairs gave it; then its limits and loops.
    fn gather_live(&mut self) {
        let (least, runs) = (self.least(), self.bodies.runs());
        let (live, joints) = (&self.live, &self.joints);
        threads::each_in(&mut self.gathered, runs, least, |row, sum| {
            *sum = live.gathered(row);
            joints.gather(row, sum);
            sum.share_among_limits();
        });
    }

    // ANCHOR: restore_colours
    /// Restitution, once at the end of a step, a colour after another.
    pub(super) fn restore_colours(&mut self, step: &Step) {
        let least = self.least();
        self.live.fill(&self.bodies, least);
        let (bodies, live) = (&self.bodies, &self.live);
        let restore = |_| Restore { bodies, live, step };
        self.pairs.sweep(false, least, restore);
        let (least, runs) = (self.least(), self.bodies.runs());
        threads::each_in(&mut self.gathered, runs, least, |row, sum| {
            *sum = live.gathered(row);
        });
        self.take_up();
    }
    // ANCHOR_END: restore_colours
}
