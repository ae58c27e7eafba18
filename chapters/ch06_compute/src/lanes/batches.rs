//! Pairs in batches: as many as a number has lanes, all with equally many points and normals that turn in
//! the same way, so that no lane waits for another.

use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::own_row::contact::{Contact, Impulses, Surface};
use crate::rows::{Impulse, Manifold, Material, Press};
use crate::simd::{MOST_LANES, Real, array_of};

/// How many ways a normal turns.
const TURNS: usize = 4;

/// The kind of a pair of balls.
const TWO_BALLS: u32 = 0;

/// The most points of a pair.
const MOST_POINTS: usize = 4;

// ANCHOR: batch
/// Pairs, one a lane. Lanes that are left over repeat the last pair; nobody reads what they give.
#[derive(Clone, Copy, Debug)]
pub struct Batch<R: Real, const P: usize> {
    /// Rows of the bodies a, and of the bodies b.
    pub rows: [[u32; MOST_LANES]; 2],
    /// Where they touch.
    pub contact: Contact<R, P>,
    /// What becomes of them there.
    pub surface: Surface<R>,
    /// What they press and rub.
    pub impulse: Impulses<R, P>,
    /// How fast each point came this step, m/s, negative; 0 where it didn't.
    pub approach: [R; P],
}
// ANCHOR_END: batch

/// What is done with a batch, whatever its number of points. `rows` is what its bodies gather, a row a lane.
pub trait Work<R: Real>: Sync {
    /// Does it.
    fn run<const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]);

    /// The same for pairs of balls.
    fn run_balls(&self, batch: &mut Batch<R, 1>, rows: &mut [Press]);
}

/// All batches of a step.
#[derive(Clone, Debug)]
pub struct Batches<R: Real> {
    balls: Vec<Batch<R, 1>>,
    one: Vec<Batch<R, 1>>,
    two: Vec<Batch<R, 2>>,
    three: Vec<Batch<R, 3>>,
    four: Vec<Batch<R, 4>>,
    /// What bodies gather: a row a lane, batch by batch.
    pub press: Vec<Press>,
    /// By pair: its row in `press`.
    pub place: Vec<u32>,
}

impl<R: Real> Default for Batches<R> {
    fn default() -> Self {
        Self {
            balls: Vec::new(),
            one: Vec::new(),
            two: Vec::new(),
            three: Vec::new(),
            four: Vec::new(),
            press: Vec::new(),
            place: Vec::new(),
        }
    }
}

/// What a pair brings into its batch.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'p> {
    /// Rows of its bodies.
    pub bodies: (u32, u32),
    /// Where they touch.
    pub manifold: &'p Manifold,
    /// Of what they are there.
    pub material: Material,
    /// What they pressed in the last step.
    pub impulse: Impulse,
}

/// How many sorts of pairs there are: balls, and the others by points and by how the normal turns.
const SORTS: usize = 1 + TURNS * MOST_POINTS;

/// Which pairs go together.
fn sort_of(manifold: &Manifold) -> usize {
    if manifold.kind == TWO_BALLS {
        return 0;
    }
    1 + (manifold.points as usize - 1) * TURNS + manifold.turns as usize
}

impl<R: Real> Batches<R> {
    // ANCHOR: sort
    /// Puts so many pairs into batches, each sort by itself, in their order.
    /// At least `least` pairs go together.
    pub fn fill<'p>(
        &mut self,
        count: usize,
        least: usize,
        pair: impl Fn(usize) -> Pair<'p> + Sync,
    ) {
        let least = least / R::LANES;
        let mut counts = [0; SORTS];
        for k in 0..count {
            counts[sort_of(pair(k).manifold)] += 1;
        }
        let mut firsts = [0; SORTS];
        let mut rows = 0;
        for (first, count) in firsts.iter_mut().zip(counts) {
            *first = rows;
            rows += usize::div_ceil(count, R::LANES) * R::LANES;
        }
        let mut next = firsts;
        let mut order = vec![u32::MAX; rows];
        self.place.clear();
        for k in 0..count {
            let place = &mut next[sort_of(pair(k).manifold)];
            self.place.push(*place as u32);
            order[*place] = k as u32;
            *place += 1;
        }
        let end = |points: usize| firsts.get(1 + points * TURNS).copied().unwrap_or(rows);
        self.press.clear();
        self.press.resize(rows, Press::default());
        fill(&mut self.balls, least, &order[..end(0)], &pair);
        fill(&mut self.one, least, &order[end(0)..end(1)], &pair);
        fill(&mut self.two, least, &order[end(1)..end(2)], &pair);
        fill(&mut self.three, least, &order[end(2)..end(3)], &pair);
        fill(&mut self.four, least, &order[end(3)..], &pair);
    }
    // ANCHOR_END: sort

    /// How many pairs there are.
    #[must_use]
    pub fn pairs(&self) -> usize {
        self.place.len()
    }

    // ANCHOR: each
    /// Does something with every batch, on as many threads as there are. At least `least` batches go
    /// together: fewer aren't worth another thread.
    pub fn each(&mut self, least: usize, work: &impl Work<R>) {
        let (balls, rest) = self.press.split_at_mut(self.balls.len() * R::LANES);
        let (one, rest) = rest.split_at_mut(self.one.len() * R::LANES);
        let (two, rest) = rest.split_at_mut(self.two.len() * R::LANES);
        let (three, four) = rest.split_at_mut(self.three.len() * R::LANES);
        each(&mut self.balls, balls, least, |batch, rows| {
            work.run_balls(batch, rows);
        });
        each(&mut self.one, one, least, |batch, rows| {
            work.run(batch, rows);
        });
        each(&mut self.two, two, least, |batch, rows| {
            work.run(batch, rows);
        });
        each(&mut self.three, three, least, |batch, rows| {
            work.run(batch, rows);
        });
        each(&mut self.four, four, least, |batch, rows| {
            work.run(batch, rows);
        });
    }
    // ANCHOR_END: each

    /// What a pair has pressed by now.
    #[must_use]
    pub fn impulse(&self, pair: usize) -> Impulse {
        let place = self.place[pair] as usize;
        let (batch, lane) = (place / R::LANES, place % R::LANES);
        let one = self.balls.len();
        let two = one + self.one.len();
        let three = two + self.two.len();
        let four = three + self.three.len();
        if batch < one {
            self.balls[batch].impulse.lane(lane)
        } else if batch < two {
            self.one[batch - one].impulse.lane(lane)
        } else if batch < three {
            self.two[batch - two].impulse.lane(lane)
        } else if batch < four {
            self.three[batch - three].impulse.lane(lane)
        } else {
            self.four[batch - four].impulse.lane(lane)
        }
    }
}

/// Batches of pairs of one number of points.
fn fill<'p, R: Real, const P: usize>(
    batches: &mut Vec<Batch<R, P>>,
    least: usize,
    order: &[u32],
    pair: &(impl Fn(usize) -> Pair<'p> + Sync),
) {
    let lanes = order.par_chunks_exact(R::LANES).with_min_len(least);
    let batch = lanes.map(|lanes| {
        let pair = |lane: usize| {
            let known = lanes[..=lane].iter().rev().find(|pair| **pair != u32::MAX);
            pair(*known.unwrap_or(&lanes[0]) as usize)
        };
        let pairs: [_; MOST_LANES] = array_of(|lane| pair(lane.min(R::LANES - 1)));
        Batch {
            rows: [
                pairs.map(|pair| pair.bodies.0),
                pairs.map(|pair| pair.bodies.1),
            ],
            contact: Contact::of(|lane| pairs[lane].manifold),
            surface: Surface::of(|lane| pairs[lane].material),
            impulse: Impulses::of(|lane| pairs[lane].impulse),
            approach: [R::splat(0.0); P],
        }
    });
    batch.collect_into_vec(batches);
}

fn each<R: Real, const P: usize>(
    batches: &mut [Batch<R, P>],
    press: &mut [Press],
    least: usize,
    work: impl Fn(&mut Batch<R, P>, &mut [Press]) + Sync,
) {
    batches
        .par_iter_mut()
        .zip(press.par_chunks_mut(R::LANES))
        .with_min_len(least)
        .for_each(|(batch, rows)| work(batch, rows));
}
