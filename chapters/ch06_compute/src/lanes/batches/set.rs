//! Batches by the shapes of their pairs.

use std::ops::Range;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use super::{Batch, Kind, Pair, Visit, Work};
use crate::own_row::contact::{Contact, Impulses, Surface};
use crate::own_row::side::Standing;
use crate::rows::{Impulse, Press};
use crate::simd::{MOST_LANES, Real, Round, Symmetric, array_of};

/// The most points of a pair.
const MOST_POINTS: usize = 4;

/// Two balls, a ball on a box that stands, and the others by their points.
pub const SHAPES: usize = 2 + MOST_POINTS;

/// Some batches of each.
pub type Shapes = [Range<usize>; SHAPES];

/// Batches by the shapes of their pairs.
#[derive(Clone, Debug)]
pub struct Set<R: Real> {
    balls: Vec<Batch<R, 1>>,
    walls: Vec<Batch<R, 1>>,
    one: Vec<Batch<R, 1>>,
    two: Vec<Batch<R, 2>>,
    three: Vec<Batch<R, 3>>,
    four: Vec<Batch<R, 4>>,
}

impl<R: Real> Default for Set<R> {
    fn default() -> Self {
        Self {
            balls: Vec::new(),
            walls: Vec::new(),
            one: Vec::new(),
            two: Vec::new(),
            three: Vec::new(),
            four: Vec::new(),
        }
    }
}

impl<R: Real> Set<R> {
    /// Puts pairs into batches. `order` gives for each lane the number of its pair, or none.
    pub fn fill<'p>(
        &mut self,
        order: [&[u32]; SHAPES],
        least: usize,
        pair: &(impl Fn(usize) -> Pair<'p> + Sync),
    ) {
        let [balls, walls, one, two, three, four] = order;
        fill(&mut self.balls, least, balls, pair);
        fill(&mut self.walls, least, walls, pair);
        fill(&mut self.one, least, one, pair);
        fill(&mut self.two, least, two, pair);
        fill(&mut self.three, least, three, pair);
        fill(&mut self.four, least, four, pair);
    }

    /// How many batches there are of each shape.
    pub fn lengths(&self) -> [usize; SHAPES] {
        [
            self.balls.len(),
            self.walls.len(),
            self.one.len(),
            self.two.len(),
            self.three.len(),
            self.four.len(),
        ]
    }

    /// How many batches there are.
    pub fn batches(&self) -> usize {
        self.lengths().iter().sum()
    }

    /// Bytes of all batches.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.balls[..])
            + size_of_val(&self.walls[..])
            + size_of_val(&self.one[..])
            + size_of_val(&self.two[..])
            + size_of_val(&self.three[..])
            + size_of_val(&self.four[..])
    }

    /// Does something with all batches; `press` has a row a lane.
    pub fn each(&mut self, press: &mut [Press], least: usize, work: &impl Work<R>) {
        let (balls, rest) = press.split_at_mut(self.balls.len() * R::LANES);
        let (walls, rest) = rest.split_at_mut(self.walls.len() * R::LANES);
        let (one, rest) = rest.split_at_mut(self.one.len() * R::LANES);
        let (two, rest) = rest.split_at_mut(self.two.len() * R::LANES);
        let (three, four) = rest.split_at_mut(self.three.len() * R::LANES);
        each::<R, Round<R>, 1>(&mut self.balls, balls, least, work);
        each::<R, Standing<R>, 1>(&mut self.walls, walls, least, work);
        each::<R, Symmetric<R>, 1>(&mut self.one, one, least, work);
        each::<R, Symmetric<R>, 2>(&mut self.two, two, least, work);
        each::<R, Symmetric<R>, 3>(&mut self.three, three, least, work);
        each::<R, Symmetric<R>, 4>(&mut self.four, four, least, work);
    }

    /// Visits some batches.
    pub fn visit(&mut self, parts: Shapes, least: usize, work: &impl Visit<R>) {
        let [balls, walls, one, two, three, four] = parts;
        visit::<R, Round<R>, 1>(&mut self.balls[balls], least, work);
        visit::<R, Standing<R>, 1>(&mut self.walls[walls], least, work);
        visit::<R, Symmetric<R>, 1>(&mut self.one[one], least, work);
        visit::<R, Symmetric<R>, 2>(&mut self.two[two], least, work);
        visit::<R, Symmetric<R>, 3>(&mut self.three[three], least, work);
        visit::<R, Symmetric<R>, 4>(&mut self.four[four], least, work);
    }

    /// What the pair in a lane of a batch has pressed by now; batches of all shapes are counted on.
    pub fn impulse(&self, batch: usize, lane: usize) -> Impulse {
        let walls = self.balls.len();
        let one = walls + self.walls.len();
        let two = one + self.one.len();
        let three = two + self.two.len();
        let four = three + self.three.len();
        if batch < walls {
            self.balls[batch].impulse.lane(lane)
        } else if batch < one {
            self.walls[batch - walls].impulse.lane(lane)
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
        let mut last = pair(0);
        let pairs: [_; MOST_LANES] = array_of(|lane| {
            if (1..R::LANES).contains(&lane) {
                last = pair(lane);
            }
            last
        });
        Batch {
            rows: [
                array_of(|lane| pairs[lane].bodies.0),
                array_of(|lane| pairs[lane].bodies.1),
            ],
            moves: [0, 1].map(|side| {
                let real = |lane: &usize| lanes[*lane] != u32::MAX && pairs[*lane].moves[side];
                (0..R::LANES)
                    .filter(real)
                    .fold(0, |bits, lane| bits | 1 << lane)
            }),
            contact: Contact::of(|lane| pairs[lane].manifold),
            surface: Surface::of(|lane| pairs[lane].material),
            impulse: Impulses::of(|lane| pairs[lane].impulse),
            approach: [R::splat(0.0); P],
            impact: R::splat(0.0),
        }
    });
    batch.collect_into_vec(batches);
}

fn each<R: Real, I: Kind<R, P>, const P: usize>(
    batches: &mut [Batch<R, P>],
    press: &mut [Press],
    least: usize,
    work: &impl Work<R>,
) {
    if batches.len() < least {
        let rows = press.chunks_mut(R::LANES);
        for (batch, rows) in batches.iter_mut().zip(rows) {
            work.run::<I, P>(batch, rows);
        }
        return;
    }
    let rows = press.par_chunks_mut(R::LANES);
    let batches = batches.par_iter_mut().zip(rows).with_min_len(least);
    batches.for_each(|(batch, rows)| work.run::<I, P>(batch, rows));
}

fn visit<R: Real, I: Kind<R, P>, const P: usize>(
    batches: &mut [Batch<R, P>],
    least: usize,
    work: &impl Visit<R>,
) {
    if batches.len() < least {
        for batch in batches {
            work.visit::<I, P>(batch);
        }
        return;
    }
    let batches = batches.par_iter_mut().with_min_len(least);
    batches.for_each(|batch| work.visit::<I, P>(batch));
}
