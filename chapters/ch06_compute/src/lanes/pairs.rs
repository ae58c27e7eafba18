//! The pairs of a step: where they touch, and what they pressed in the last step.

mod meet;

use std::ops::Range;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};

use super::batches::{Pair, SHAPES, Sort, Visit, Work};
use super::coloured::{Colours, STILL};
use super::groups::Group;
use super::regions::{NOWHERE, Regions};
use super::sleep::KeptPair;
use super::threads;
use crate::own_row::body::Gathered;
use crate::rows::{Impulse, Manifold, Material, Press};
use crate::rules::Method;
use crate::simd::Real;
use meet::Met;
pub use meet::{Found, between, meet};

/// All pairs that touch or may touch in the step, in the order of their bodies.
#[derive(Clone, Debug, Default)]
pub struct Pairs<R: Real> {
    /// Rows of the two bodies, the smaller first.
    pub bodies: Vec<(usize, usize)>,
    /// Where they touch.
    pub manifold: Vec<Manifold>,
    /// What becomes of them there.
    pub material: Vec<Material>,
    /// What they pressed and rubbed in the last step.
    pub impulse: Vec<Impulse>,
    /// What they have in common with others.
    labels: Vec<Label>,
    /// The group of each, and which of its pairs it is there.
    seats: Vec<[u32; 2]>,
    /// The same pairs in lanes, region by region; the last group may be those with ends in two regions.
    pub groups: Vec<Group<R>>,
    /// What bodies gather, group by group; nothing where they hear of it otherwise.
    pub press: Vec<Press>,
    /// What came of the pairs that were found, some by some.
    met: Vec<Met>,
}

/// By what pairs are sorted.
#[derive(Clone, Copy, Debug, Default)]
struct Label {
    /// The regions of the two bodies; [`NOWHERE`] for one that doesn't move.
    regions: [u16; 2],
    sort: Sort,
}

impl<R: Real> Pairs<R> {
    /// A body is gone, its pairs with it, and those after it have moved up.
    pub fn remove_body(&mut self, row: usize) {
        let moved = |other: usize| if other > row { other - 1 } else { other };
        let kept = |&pair: &usize| self.bodies[pair].0 != row && self.bodies[pair].1 != row;
        let kept: Vec<usize> = (0..self.bodies.len()).filter(kept).collect();
        self.manifold = kept.iter().map(|&pair| self.manifold[pair]).collect();
        self.material = kept.iter().map(|&pair| self.material[pair]).collect();
        self.impulse = kept.iter().map(|&pair| self.impulse[pair]).collect();
        let bodies = kept.iter().map(|&pair| self.bodies[pair]);
        self.bodies = bodies.map(|(a, b)| (moved(a), moved(b))).collect();
        self.groups.clear();
        self.press.clear();
    }

    /// Pairs that have woken are known as they were when they fell asleep. Of the pairs of a step that is past:
    /// nothing more is read of them than what they pressed, and where.
    pub fn recall(&mut self, woken: &mut Vec<KeptPair>) {
        if woken.is_empty() {
            return;
        }
        let mut known: Vec<_> = (0..self.bodies.len())
            .map(|pair| KeptPair::of(self, pair))
            .chain(woken.drain(..))
            .collect();
        known.sort_by_key(|pair| pair.bodies);
        self.bodies = known.iter().map(|pair| pair.bodies).collect();
        self.manifold = known.iter().map(|pair| pair.manifold).collect();
        self.impulse = known.iter().map(|pair| pair.impulse).collect();
    }

    /// Brings what was pressed from the lanes into a row a pair. At least `least` pairs go together.
    pub fn write_back(&mut self, least: usize) {
        let (groups, seats) = (&self.groups, &self.seats);
        threads::each(&mut self.impulse, least, |pair, impulse| {
            let [group, rank] = seats[pair];
            *impulse = groups[group as usize].batches.impulse(rank as usize);
        });
    }

    /// How many pairs found no colour.
    #[must_use]
    pub fn without_colour(&self) -> usize {
        let without = self.groups.iter().map(|group| group.colours.without());
        without.sum()
    }

    /// How many colours there are in the group that has most of them.
    #[must_use]
    pub fn colours(&self) -> usize {
        let colours = self.groups.iter().map(|group| &group.colours);
        let count = |of: &Colours| of.count() - usize::from(of.alone().is_some());
        colours.map(count).max().unwrap_or(0)
    }

    /// How many batches there are of two balls, of a ball and a box that stands, and of others by their points; with
    /// friction, and without.
    #[must_use]
    pub fn counts(&self) -> [[usize; SHAPES]; 2] {
        let mut sums = [[0; SHAPES]; 2];
        for group in &self.groups {
            let counts = group.batches.counts();
            for (sum, count) in sums.iter_mut().flatten().zip(counts.iter().flatten()) {
                *sum += count;
            }
        }
        sums
    }

    /// Bytes of all batches, and of what bodies gather.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let batches = self.groups.iter().map(|group| group.batches.bytes());
        batches.sum::<usize>() + size_of_val(&self.press[..])
    }

    // ANCHOR: share_out
    /// Shares the pairs out among the groups. By own rows a pair with ends in two regions is in both: each
    /// copy reads the same and so presses the same, and no region waits for another. With colours it belongs to the
    /// cut between them. Gives how many there are of these.
    fn share_out(&mut self, regions: &Regions, method: Method) -> usize {
        for group in &mut self.groups {
            group.pairs.clear();
        }
        self.seats.clear();
        let mut torn = 0;
        for (pair, label) in self.labels.iter().enumerate() {
            let [a, b] = label.regions;
            let (a, b) = (a.min(b), a.max(b));
            // What doesn't move is nowhere: the other end decides.
            let b = if b == NOWHERE { a } else { b };
            let home = match method {
                Method::OwnRow => usize::from(a).min(regions.count() - 1),
                Method::Coloured => regions.node([a, b]),
            };
            let pairs = &mut self.groups[home].pairs;
            self.seats.push([home as u32, pairs.len() as u32]);
            pairs.push(pair as u32);
            if a != b {
                torn += 1;
                if method == Method::OwnRow {
                    self.groups[usize::from(b)].pairs.push(pair as u32);
                }
            }
        }
        torn
    }
    // ANCHOR_END: share_out

    /// Puts the pairs into groups and lanes. At least `least` pairs go together.
    fn fill(&mut self, regions: &mut Regions, method: Method, least: usize) {
        let groups = match method {
            Method::OwnRow => regions.count(),
            Method::Coloured => regions.nodes(),
        };
        self.groups.resize_with(groups, Group::default);
        let torn = self.share_out(regions, method);
        regions.hear(self.bodies.len(), torn);
        let mut all = std::mem::take(&mut self.groups);
        let within = if groups > 1 { usize::MAX } else { least };
        threads::each(&mut all, threads::one_by_one(least), |k, group| {
            self.fill_group(k, group, regions, method, within);
        });
        self.groups = all;
        let rows = self.groups.iter().map(|group| group.batches.rows()).sum();
        match method {
            Method::OwnRow => self.press.resize(rows, Press::default()),
            Method::Coloured => self.press.clear(),
        }
    }

    /// Puts the pairs of a group into lanes.
    fn fill_group(
        &self,
        k: usize,
        group: &mut Group<R>,
        regions: &Regions,
        method: Method,
        least: usize,
    ) {
        let (spots, span) = match method {
            Method::OwnRow => (regions.spots(), regions.region(k)),
            Method::Coloured => (regions.spots(), regions.span(k)),
        };
        let rows = span.len();
        let seat = |row: usize, region: u16| match spots[row] as usize {
            spot if region != NOWHERE && span.contains(&spot) => (spot - span.start) as u32,
            _ => STILL,
        };
        let end = |&pair: &u32| {
            let ((a, b), label) = (self.bodies[pair as usize], &self.labels[pair as usize]);
            [seat(a, label.regions[0]), seat(b, label.regions[1])]
        };
        group.ends.clear();
        group.ends.extend(group.pairs.iter().map(end));
        if method == Method::Coloured {
            group.paint(rows);
        }
        group.fill(least, |pair| {
            let (a, b) = self.bodies[pair];
            Pair {
                bodies: (a as u32, b as u32),
                moves: [false; 2],
                sort: self.labels[pair].sort,
                colour: 0,
                manifold: &self.manifold[pair],
                material: &self.material[pair],
                impulse: &self.impulse[pair],
            }
        });
        if method == Method::OwnRow {
            group.list(rows);
        }
    }

    /// Does something with every batch. At least `least` pairs go together.
    pub fn each(&mut self, least: usize, work: &impl Work<R>) {
        if let [group] = &mut self.groups[..] {
            let least = least / R::LANES;
            group.batches.each(&mut self.press, least, work);
            return;
        }
        let rows = self.groups.iter().map(|group| group.batches.rows());
        let press = split(&mut self.press, rows);
        let groups = self.groups.par_iter_mut().zip(press);
        groups
            .with_min_len(threads::one_by_one(least))
            .for_each(|(group, press)| group.batches.each(press, usize::MAX, work));
    }

    // ANCHOR: each_and_gather
    /// Does something with every batch, and then each body sums what its pairs did to it, in the order of
    /// their IDs; and what `more` adds. Whoever has done the pairs of a region has what its bodies gather near
    /// at hand.
    pub fn each_and_gather(
        &mut self,
        work: &impl Work<R>,
        (regions, runs): (&Regions, &[Range<usize>]),
        least: usize,
        sums: &mut [Gathered],
        more: impl Fn(usize, &mut Gathered) + Sync,
    ) {
        if self.groups.len() <= 1 {
            self.each(least, work);
            self.gather((regions, runs), least, sums, more);
            return;
        }
        let rows = self.groups.iter().map(|group| group.batches.rows());
        let press = split(&mut self.press, rows);
        let sums = split(sums, regions.sizes());
        let groups = self.groups.par_iter_mut().zip(press).zip(sums);
        let groups = groups.enumerate().with_min_len(threads::one_by_one(least));
        groups.for_each(|(k, ((group, press), sums))| {
            group.batches.each(press, usize::MAX, work);
            group.gather(regions.rows(k), press, sums, &more);
        });
    }
    // ANCHOR_END: each_and_gather

    /// Each body sums what its pairs did to it.
    pub fn gather(
        &self,
        (regions, runs): (&Regions, &[Range<usize>]),
        least: usize,
        sums: &mut [Gathered],
        more: impl Fn(usize, &mut Gathered) + Sync,
    ) {
        if let [group] = &self.groups[..] {
            threads::each_in(sums, runs, least, |row, sum| {
                *sum = group.gathered(row, &self.press);
                more(row, sum);
            });
            return;
        }
        let mut first = 0;
        for (k, sums) in split(sums, regions.sizes()).into_iter().enumerate() {
            let end = first + self.groups[k].batches.rows();
            let press = &self.press[first..end];
            self.groups[k].gather(regions.rows(k), press, sums, &more);
            first = end;
        }
    }

    /// Visits all pairs. At least `least` pairs of a colour go together.
    pub fn sweep<V: Visit<R>>(
        &mut self,
        back: bool,
        least: usize,
        visit: impl Fn([bool; 2]) -> V + Sync,
    ) {
        sweep(&mut self.groups, back, least / R::LANES, &visit);
    }
}

// ANCHOR: sweep_all
/// Visits the pairs that cross a cut, their colours one after another; then both sides of the cut at once, which
/// have no body in common and colours of their own; and on the way back those of the cut again. What can't be cut
/// any more is a region.
fn sweep<R: Real, V: Visit<R>>(
    groups: &mut [Group<R>],
    back: bool,
    least: usize,
    visit: &(impl Fn([bool; 2]) -> V + Sync),
) {
    let (low, rest) = groups.split_at_mut(groups.len() / 2);
    let Some((cut, high)) = rest.split_first_mut() else {
        return;
    };
    if low.is_empty() {
        cut.forth_and_back(back, least, visit);
        return;
    }
    cut.forth(back, least, visit);
    if least == usize::MAX / R::LANES {
        sweep(low, back, least, visit);
        sweep(high, back, least, visit);
    } else {
        let both = || sweep(low, back, least, visit);
        rayon::join(both, || sweep(high, back, least, visit));
    }
    if back {
        cut.back(least, visit);
    }
}
// ANCHOR_END: sweep_all

/// Cuts rows into pieces.
fn split<T>(mut rows: &mut [T], counts: impl Iterator<Item = usize>) -> Vec<&mut [T]> {
    let piece = |count: usize| {
        let (piece, rest) = std::mem::take(&mut rows).split_at_mut(count);
        rows = rest;
        piece
    };
    counts.map(piece).collect()
}
