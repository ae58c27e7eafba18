//! Groups of pairs: those of a region, or those with ends on both sides of a cut.

use super::batches::{Batches, Pair, Sorts, Visit};
use super::coloured::{Colours, STILL};
use crate::own_row::body::Gathered;
use crate::rows::Press;
use crate::simd::Real;

/// The pairs of a region, or of a cut.
#[derive(Clone, Debug, Default)]
pub struct Group<R: Real> {
    /// Which ones, in order.
    pub pairs: Vec<u32>,
    /// By pair: which rows of the region its bodies are; [`STILL`] for one that isn't there or doesn't move.
    pub ends: Vec<[u32; 2]>,
    /// Their colours; none where the method needs none.
    pub colours: Colours,
    /// What they press and rub now, in lanes.
    pub batches: Batches<R>,
    /// By row of the region: where its pairs begin in `entries`; one more at the end.
    starts: Vec<u32>,
    /// The pairs of each row, in the order of the other body's ID: twice what it gathers from, and 1 where the
    /// body is b.
    entries: Vec<u32>,
}

impl<R: Real> Group<R> {
    /// Gives the pairs colours; the region has so many rows.
    pub fn paint(&mut self, rows: usize) {
        self.colours.paint(&self.ends, rows);
    }

    /// Puts the pairs into lanes. At least `least` go together.
    pub fn fill<'p>(&mut self, least: usize, pair: impl Fn(usize) -> Pair<'p> + Sync) {
        let sorts = Sorts {
            colours: self.colours.count(),
            alone: self.colours.alone(),
        };
        self.batches.fill(self.pairs.len(), sorts, least, |rank| {
            let (colour, moves) = self.colours.at(rank, &self.ends);
            Pair {
                moves,
                colour,
                ..pair(self.pairs[rank] as usize)
            }
        });
    }

    /// Lists the pairs of each of the region's rows. They come in the order of a, then b, so each list is in the
    /// order of the partner.
    pub fn list(&mut self, rows: usize) {
        let starts = &mut self.starts;
        starts.clear();
        starts.resize(rows + 2, 0);
        // One place further on, so that after the pairs have taken their places each start is right.
        for &row in self.ends.iter().flatten().filter(|row| **row != STILL) {
            starts[row as usize + 2] += 1;
        }
        for row in 2..rows + 2 {
            starts[row] += starts[row - 1];
        }
        self.entries.clear();
        self.entries.resize(starts[rows + 1] as usize, 0);
        for (&[a, b], &place) in self.ends.iter().zip(&self.batches.place) {
            for (row, is_b) in [(a, 0), (b, 1)] {
                if row != STILL {
                    let next = &mut starts[row as usize + 1];
                    self.entries[*next as usize] = 2 * place + is_b;
                    *next += 1;
                }
            }
        }
    }

    // ANCHOR: gather
    /// What its pairs did to a row of the region, in the order of their IDs.
    #[inline]
    #[must_use]
    pub fn gathered(&self, row: usize, press: &[Press]) -> Gathered {
        let mut sum = Gathered::default();
        let (first, end) = (self.starts[row], self.starts[row + 1]);
        for &entry in &self.entries[first as usize..end as usize] {
            sum.add(&press[(entry >> 1) as usize], entry & 1 == 1);
        }
        sum
    }
    // ANCHOR_END: gather

    /// The same for all rows of the region; `rows` are those among all bodies.
    pub fn gather(
        &self,
        rows: &[u32],
        press: &[Press],
        sums: &mut [Gathered],
        more: impl Fn(usize, &mut Gathered),
    ) {
        for ((seat, sum), &row) in sums.iter_mut().enumerate().zip(rows) {
            *sum = self.gathered(seat, press);
            more(row as usize, sum);
        }
    }

    // ANCHOR: forth
    /// Visits the colours one after another. `visit` makes the work for those who have been visited in this
    /// substep before, and for those who will not be again.
    pub fn forth<V: Visit<R>>(&mut self, back: bool, least: usize, visit: impl Fn([bool; 2]) -> V) {
        for colour in 0..self.batches.colours() {
            self.visit(colour, least, &visit([false, !back]));
        }
    }

    /// The way back.
    pub fn back<V: Visit<R>>(&mut self, least: usize, visit: impl Fn([bool; 2]) -> V) {
        for colour in (0..self.batches.colours()).rev() {
            self.visit(colour, least, &visit([true, true]));
        }
    }

    /// Both. Visited twice in a row, the last colour would find nothing to mend.
    pub fn forth_and_back<V: Visit<R>>(
        &mut self,
        back: bool,
        least: usize,
        visit: impl Fn([bool; 2]) -> V,
    ) {
        let last = self.batches.colours().saturating_sub(1);
        for colour in 0..self.batches.colours() {
            self.visit(colour, least, &visit([false, !back || colour == last]));
        }
        if back {
            for colour in (0..last).rev() {
                self.visit(colour, least, &visit([true, true]));
            }
        }
    }
    // ANCHOR_END: forth

    /// Visits the pairs of a colour; those without one go one after the other.
    fn visit(&mut self, colour: usize, least: usize, work: &impl Visit<R>) {
        let alone = self.colours.alone() == Some(colour);
        let least = if alone { usize::MAX } else { least };
        self.batches.visit(colour, least, work);
    }
}
