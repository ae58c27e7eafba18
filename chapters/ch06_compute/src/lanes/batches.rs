//! Pairs in batches: as many as a number has lanes, all with equally many points and normals that turn in
//! the same way, so that no lane waits for another; and, where pairs have colours, all of one colour.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

use std::ops::Range;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::own_row::contact::{Contact, Impulses, Surface, Touching, touching, touching_balls};
use crate::own_row::side::{Side, Standing, Turns};
use crate::rows::{Impulse, Manifold, Material, Press};
use crate::simd::{MOST_LANES, Real, Round, Symmetric, array_of};

/// How many ways a normal turns.
const TURNS: usize = 4;

/// The kind of a pair of balls.
const TWO_BALLS: u32 = 0;

/// The kind of a ball and a box.
pub(super) const BALL_AND_BOX: u32 = 1;

/// The most points of a pair.
const MOST_POINTS: usize = 4;

/// Two balls, a ball on a box that stands, and the others by their points.
const CLASSES: usize = 2 + MOST_POINTS;

/// Batches of the pairs of one colour, by class.
type Parts = [Range<usize>; CLASSES];

// ANCHOR: batch
/// Pairs, one a lane. Lanes that are left over repeat the last pair; nobody reads what they give.
#[derive(Clone, Copy, Debug)]
pub struct Batch<R: Real, const P: usize> {
    /// Rows of the bodies a, and of the bodies b.
    pub rows: [[u32; MOST_LANES]; 2],
    /// A bit a lane: whether its body a moves, and whether its body b does; 0 in lanes that are left over.
    pub moves: [u32; 2],
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

// ANCHOR: kind
/// What a pair needs to know of its bodies depends on its kind; it is told by how they turn.
pub trait Kind<R: Real, const P: usize>: Turns<R> {
    /// Where the points are now.
    fn touching(contact: &Contact<R, P>, a: &Side<R, Self>, b: &Side<R, Self>) -> Touching<R, P>;
}

/// Bodies of any shape.
impl<R: Real, const P: usize> Kind<R, P> for Symmetric<R> {
    #[inline(always)]
    fn touching(contact: &Contact<R, P>, a: &Side<R>, b: &Side<R>) -> Touching<R, P> {
        touching(contact, a, b)
    }
}

/// Two balls.
impl<R: Real> Kind<R, 1> for Round<R> {
    #[inline(always)]
    fn touching(contact: &Contact<R, 1>, a: &Side<R, Self>, b: &Side<R, Self>) -> Touching<R, 1> {
        touching_balls(contact, a, b)
    }
}
/// A ball on a box that stands.
impl<R: Real> Kind<R, 1> for Standing<R> {
    #[inline(always)]
    fn touching(contact: &Contact<R, 1>, a: &Side<R, Self>, b: &Side<R, Self>) -> Touching<R, 1> {
        touching(contact, a, b)
    }
}
// ANCHOR_END: kind

/// What is done with a batch of any kind, whatever its number of points.
pub trait Work<R: Real>: Sync {
    /// Does it. `rows` is what the bodies gather, a row a lane.
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]);
}

/// All batches of a step.
#[derive(Clone, Debug)]
pub struct Batches<R: Real> {
    balls: Vec<Batch<R, 1>>,
    walls: Vec<Batch<R, 1>>,
    one: Vec<Batch<R, 1>>,
    two: Vec<Batch<R, 2>>,
    three: Vec<Batch<R, 3>>,
    four: Vec<Batch<R, 4>>,
    /// What bodies gather: a row a lane, batch by batch.
    pub press: Vec<Press>,
    /// By pair: its row in `press`.
    pub place: Vec<u32>,
    /// By colour: its batches.
    parts: Vec<Parts>,
}

impl<R: Real> Default for Batches<R> {
    fn default() -> Self {
        Self {
            balls: Vec::new(),
            walls: Vec::new(),
            one: Vec::new(),
            two: Vec::new(),
            three: Vec::new(),
            four: Vec::new(),
            press: Vec::new(),
            place: Vec::new(),
            parts: Vec::new(),
        }
    }
}

/// What a pair brings into its batch.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'p> {
    /// Rows of its bodies.
    pub bodies: (u32, u32),
    /// Whether they move.
    pub moves: [bool; 2],
    /// Whether it is a ball on a box that stands.
    pub stands: bool,
    /// Its colour.
    pub colour: u8,
    /// Where they touch.
    pub manifold: &'p Manifold,
    /// Of what they are there.
    pub material: &'p Material,
    /// What they pressed in the last step.
    pub impulse: &'p Impulse,
}

/// What sorts of pairs there are: balls and others by their points, then by
/// their colours, then by how their normals turn.
#[derive(Clone, Copy, Debug)]
struct Sorts {
    /// How many colours there are.
    colours: usize,
    /// The colour whose pairs go one by one, if there is one.
    alone: Option<usize>,
}

impl Sorts {
    /// How many sorts there are.
    fn count(self) -> usize {
        CLASSES * self.colours * TURNS
    }

    /// Which pairs go together.
    fn of(self, pair: &Pair<'_>) -> usize {
        let manifold = pair.manifold;
        let class = match manifold.kind {
            TWO_BALLS => 0,
            _ if pair.stands => 1,
            _ => 1 + manifold.points as usize,
        };
        self.first(class, usize::from(pair.colour)) + manifold.turns as usize
    }

    /// The first sort of a class and a colour.
    fn first(self, class: usize, colour: usize) -> usize {
        (class * self.colours + colour) * TURNS
    }

    /// How many rows each pair of a sort takes, where numbers have so many lanes.
    fn rows(self, sort: usize, lanes: usize) -> usize {
        let colour = sort / TURNS % self.colours;
        if self.alone == Some(colour) { lanes } else { 1 }
    }
}

impl<R: Real> Batches<R> {
    // ANCHOR: sort
    /// Puts so many pairs of so many colours into batches, each sort by itself, in their order. Pairs of the
    /// colour `alone` have a batch each. At least `least` pairs go together.
    pub fn fill<'p>(
        &mut self,
        count: usize,
        (colours, alone): (usize, Option<usize>),
        least: usize,
        pair: impl Fn(usize) -> Pair<'p> + Sync,
    ) {
        let least = least / R::LANES;
        let sorts = Sorts { colours, alone };
        let sort_of: Vec<u32> = (0..count).map(|k| sorts.of(&pair(k)) as u32).collect();
        let mut firsts = vec![0; sorts.count() + 1];
        for &sort in &sort_of {
            firsts[sort as usize] += sorts.rows(sort as usize, R::LANES);
        }
        let mut rows = 0;
        for first in &mut firsts {
            let many = usize::div_ceil(*first, R::LANES) * R::LANES;
            *first = rows;
            rows += many;
        }
        let mut next = firsts.clone();
        let mut order = vec![u32::MAX; rows];
        self.place.clear();
        for (k, &sort) in sort_of.iter().enumerate() {
            let next = &mut next[sort as usize];
            self.place.push(*next as u32);
            order[*next] = k as u32;
            *next += sorts.rows(sort as usize, R::LANES);
        }
        // ANCHOR_END: sort
        self.part(sorts, &firsts);
        self.press.resize(rows, Press::default());
        let of = |class: usize| firsts[sorts.first(class, 0)]..firsts[sorts.first(class + 1, 0)];
        fill(&mut self.balls, least, &order[of(0)], &pair);
        fill(&mut self.walls, least, &order[of(1)], &pair);
        fill(&mut self.one, least, &order[of(2)], &pair);
        fill(&mut self.two, least, &order[of(3)], &pair);
        fill(&mut self.three, least, &order[of(4)], &pair);
        fill(&mut self.four, least, &order[of(5)], &pair);
    }

    /// Notes which batches each colour has; `firsts` are the first rows of all sorts.
    fn part(&mut self, sorts: Sorts, firsts: &[usize]) {
        let part = |class: usize, colour: usize| {
            let at = |sort: usize| (firsts[sort] - firsts[sorts.first(class, 0)]) / R::LANES;
            let first = sorts.first(class, colour);
            at(first)..at(first + TURNS)
        };
        self.parts.clear();
        let parts = (0..sorts.colours).map(|colour| std::array::from_fn(|k| part(k, colour)));
        self.parts.extend(parts);
    }

    /// How many colours there are.
    #[must_use]
    pub fn colours(&self) -> usize {
        self.parts.len()
    }

    /// How many pairs there are.
    #[must_use]
    pub fn pairs(&self) -> usize {
        self.place.len()
    }

    // ANCHOR: each
    /// Does something with every batch, on as many threads as there are. At least `least` batches go
    /// together: fewer aren't worth another thread.
    pub fn each(&mut self, least: usize, work: &impl Work<R>) {
        let all = [
            0..self.balls.len(),
            0..self.walls.len(),
            0..self.one.len(),
            0..self.two.len(),
            0..self.three.len(),
            0..self.four.len(),
        ];
        self.each_in(all, least, work);
    }

    /// The same with the batches of one colour.
    pub fn each_of(&mut self, colour: usize, least: usize, work: &impl Work<R>) {
        self.each_in(self.parts[colour].clone(), least, work);
    }

    fn each_in(&mut self, parts: Parts, least: usize, work: &impl Work<R>) {
        let [in_balls, in_walls, in_one, in_two, in_three, in_four] = parts;
        let (balls, rest) = self.press.split_at_mut(self.balls.len() * R::LANES);
        let (walls, rest) = rest.split_at_mut(self.walls.len() * R::LANES);
        let (one, rest) = rest.split_at_mut(self.one.len() * R::LANES);
        let (two, rest) = rest.split_at_mut(self.two.len() * R::LANES);
        let (three, four) = rest.split_at_mut(self.three.len() * R::LANES);
        each_in::<R, Round<R>, 1>(&mut self.balls, balls, in_balls, least, work);
        each_in::<R, Standing<R>, 1>(&mut self.walls, walls, in_walls, least, work);
        each_in::<R, Symmetric<R>, 1>(&mut self.one, one, in_one, least, work);
        each_in::<R, Symmetric<R>, 2>(&mut self.two, two, in_two, least, work);
        each_in::<R, Symmetric<R>, 3>(&mut self.three, three, in_three, least, work);
        each_in::<R, Symmetric<R>, 4>(&mut self.four, four, in_four, least, work);
    }
    // ANCHOR_END: each

    /// What a pair has pressed by now.
    #[must_use]
    pub fn impulse(&self, pair: usize) -> Impulse {
        let place = self.place[pair] as usize;
        let (batch, lane) = (place / R::LANES, place % R::LANES);
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
        }
    });
    batch.collect_into_vec(batches);
}

fn each_in<R: Real, I: Kind<R, P>, const P: usize>(
    batches: &mut [Batch<R, P>],
    press: &mut [Press],
    part: Range<usize>,
    least: usize,
    work: &impl Work<R>,
) {
    let press = &mut press[part.start * R::LANES..part.end * R::LANES];
    let batches = &mut batches[part];
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
