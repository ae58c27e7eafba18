//! Pairs in batches: as many as a number has lanes, all with equally many points and normals that turn in
//! the same way, so that no lane waits for another; and, where pairs have colours, all of one colour.

mod kind;
mod set;

use std::ops::Range;

use super::plan::{Part, Plan};
use crate::own_row::contact::{Contact, Impulses, Surface};
use crate::rows::{Impulse, Manifold, Material, Press};
use crate::simd::{MOST_LANES, Real};
use kind::Frictionless;
pub use kind::{Kind, Visit, Work};
pub use set::SHAPES;
use set::Set;

/// How many ways a normal turns.
const TURNS: usize = 4;

/// The kind of a pair of balls.
const TWO_BALLS: u32 = 0;

/// The kind of a ball and a box.
const BALL_AND_BOX: u32 = 1;

/// Two balls, a ball on a box that stands, and the others by their points: first those that rub, then those
/// without friction.
const CLASSES: usize = 2 * SHAPES;

/// The batches of one colour, by class.
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
    /// 1 where what they pressed in the last visit was an impact; for the method of colours.
    pub impact: R,
}
// ANCHOR_END: batch

/// All batches of some pairs.
#[derive(Clone, Debug)]
pub struct Batches<R: Real> {
    rough: Set<R>,
    smooth: Set<R>,
    /// By pair: which lane it is, counted batch by batch. What bodies gather has a row a lane.
    pub place: Vec<u32>,
    /// By colour: its batches.
    parts: Vec<Parts>,
}

impl<R: Real> Default for Batches<R> {
    fn default() -> Self {
        Self {
            rough: Set::default(),
            smooth: Set::default(),
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
    /// What it has in common with others.
    pub sort: Sort,
    /// Its colour.
    pub colour: u8,
    /// Where they touch.
    pub manifold: &'p Manifold,
    /// Of what they are there.
    pub material: &'p Material,
    /// What they pressed in the last step.
    pub impulse: &'p Impulse,
}

/// What pairs of a batch have in common, but for their colour.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sort {
    /// Two balls, a ball on a box that stands, or another pair by its points; and whether it rubs.
    class: u8,
    /// How the normal turns.
    turns: u8,
}

impl Sort {
    /// That of a pair of which one body may be a box that nothing moves.
    #[must_use]
    pub fn of(
        manifold: &Manifold,
        material: &Material,
        plan: Plan,
        stands: impl FnOnce() -> bool,
    ) -> Self {
        let shape = match manifold.kind {
            _ if plan.keeps(Part::Shapes) => 1 + manifold.points as usize,
            TWO_BALLS => 0,
            BALL_AND_BOX if stands() => 1,
            _ => 1 + manifold.points as usize,
        };
        let is_smooth = material.friction == 0.0 && material.static_friction == 0.0;
        let is_smooth = is_smooth && !plan.keeps(Part::Friction);
        Self {
            class: (shape + SHAPES * usize::from(is_smooth)) as u8,
            turns: manifold.turns as u8,
        }
    }
}

/// What sorts of pairs there are: by class, then by their colours, then by how their normals turn.
#[derive(Clone, Copy, Debug)]
pub struct Sorts {
    /// How many colours there are.
    pub colours: usize,
    /// The colour whose pairs go one by one, if there is one.
    pub alone: Option<usize>,
}

impl Sorts {
    /// How many sorts there are.
    fn count(self) -> usize {
        CLASSES * self.colours * TURNS
    }

    /// Which pairs go together.
    fn of(self, pair: &Pair<'_>) -> usize {
        let class = usize::from(pair.sort.class);
        self.first(class, usize::from(pair.colour)) + usize::from(pair.sort.turns)
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
    /// Puts so many pairs into batches, each sort by itself, in their order. Pairs of the colour
    /// [`alone`](Sorts::alone) have a batch each. At least `least` pairs go together.
    pub fn fill<'p>(
        &mut self,
        count: usize,
        sorts: Sorts,
        least: usize,
        pair: impl Fn(usize) -> Pair<'p> + Sync,
    ) {
        let least = least / R::LANES;
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
        let of =
            |class: usize| &order[firsts[sorts.first(class, 0)]..firsts[sorts.first(class + 1, 0)]];
        self.rough.fill(std::array::from_fn(of), least, &pair);
        let of_smooth = |shape: usize| of(SHAPES + shape);
        self.smooth
            .fill(std::array::from_fn(of_smooth), least, &pair);
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

    /// How many lanes there are: so many rows bodies gather from.
    #[must_use]
    pub fn rows(&self) -> usize {
        (self.rough.batches() + self.smooth.batches()) * R::LANES
    }

    // ANCHOR: each
    /// Does something with every batch, on as many threads as there are. At least `least` batches go
    /// together: fewer aren't worth another thread. `press` is what bodies gather.
    pub fn each(&mut self, press: &mut [Press], least: usize, work: &impl Work<R>) {
        let (press, others) = press.split_at_mut(self.rough.batches() * R::LANES);
        self.rough.each(press, least, work);
        self.smooth.each(others, least, &Frictionless(work));
    }
    // ANCHOR_END: each

    /// Visits the batches of a colour.
    pub fn visit(&mut self, colour: usize, least: usize, work: &impl Visit<R>) {
        let parts = &self.parts[colour];
        let of = |first: usize| std::array::from_fn(|shape| parts[first + shape].clone());
        self.rough.visit(of(0), least, work);
        self.smooth.visit(of(SHAPES), least, &Frictionless(work));
    }

    /// How many batches there are of two balls, of a ball and a box that stands, and of others by their points; with
    /// friction, and without.
    #[must_use]
    pub fn counts(&self) -> [[usize; SHAPES]; 2] {
        [&self.rough, &self.smooth].map(Set::lengths)
    }

    /// Bytes of all batches.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.rough.bytes() + self.smooth.bytes()
    }

    /// What a pair has pressed by now.
    #[must_use]
    pub fn impulse(&self, pair: usize) -> Impulse {
        let place = self.place[pair] as usize;
        let (batch, lane) = (place / R::LANES, place % R::LANES);
        match batch.checked_sub(self.rough.batches()) {
            None => self.rough.impulse(batch, lane),
            Some(batch) => self.smooth.impulse(batch, lane),
        }
    }
}
