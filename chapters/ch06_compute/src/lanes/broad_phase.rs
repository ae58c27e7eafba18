//! Broad phase: which bodies may touch in the step. Boxes are sorted by counting into grids, one for each size of
//! body, or put into a tree. They have room for some steps, so what is found stays true until a body leaves its box.

mod bound;
mod candidates;
mod choice;
mod leavers;
mod level;
mod levels;
#[cfg(test)]
mod tests;
mod tree;

use std::ops::Range;

use ch03_collision::aabb::Aabb;
use rayon::prelude::*;

use crate::bodies::Bodies;
pub use bound::Bound;
use candidates::Candidates;
pub use choice::{UNEQUAL, Way};
use leavers::Leavers;
use levels::Levels;
use tree::Tree;

/// A body is fast if it looks this many times as far as it reaches.
const FAST: f32 = 2.0;

/// Fewer rows than these are quicker done by one thread than shared.
const THREADED: usize = 2048;

/// Of so many bodies the mean speed is taken.
const SAMPLE: usize = 1024;

/// Rows that one thread takes at a time.
const CHUNK: usize = 512;

/// What the broad phase keeps: its memory from step to step, and its result.
#[derive(Clone, Debug, Default)]
pub struct BroadPhase {
    /// By row: where it may be in the step.
    bounds: Vec<Bound>,
    /// By row: the same with room for some steps, as they were when the candidates were found.
    rooms: Vec<Bound>,
    way: Way,
    /// How candidates are looked for, whatever the sizes are.
    forced: Option<Way>,
    /// How many times as wide as a small box a large one is, where the sizes were looked at.
    spread: f32,
    levels: Levels,
    tree: Tree,
    /// What each thread found.
    found: Vec<Vec<[u32; 2]>>,
    candidates: Candidates,
    /// Rows of bodies that may touch, the smaller first, in order.
    pub pairs: Vec<(usize, usize)>,
    /// Pairs that a joint connects, in order: they pass through each other.
    pub ignored: Vec<(usize, usize)>,
    /// Rows of bodies that hang on a fixed point, in order: they touch nothing.
    pub aside: Vec<u32>,
    /// How many bodies were fast in the last step: they looked farther than others.
    pub fast: usize,
    /// In how many steps candidates were looked for anew.
    pub rebuilds: usize,
    /// In how many steps those of an earlier step were enough, but for bodies that had left their room.
    pub reuses: usize,
    leavers: Leavers,
}

impl BroadPhase {
    /// Where things stand is looked at anew in the next step: bodies came or went.
    pub fn forget(&mut self) {
        self.rooms.clear();
    }

    /// Candidates are looked for in this way from now on, whatever the sizes are.
    pub fn force(&mut self, way: Way) {
        self.forced = Some(way);
        self.forget();
    }

    /// Looks at the sizes of bodies, before there is a step.
    pub fn look_at(&mut self, bodies: &Bodies) {
        let about = (0..bodies.rows()).map(|row| bound::about(bodies, row, 0.0));
        self.bounds = about.collect();
        self.choose();
    }

    /// Chooses how candidates are looked for.
    fn choose(&mut self) {
        self.spread = choice::spread(&self.bounds);
        self.way = self.forced.unwrap_or_else(|| choice::of(self.spread));
    }

    /// How candidates are looked for; how many times as wide as a small box a large one is; and whether that was
    /// the reason.
    #[must_use]
    pub fn way(&self) -> (Way, f32, bool) {
        (self.way, self.spread, self.forced.is_none())
    }

    /// A body is gone, and those after it have moved up.
    pub fn remove_body(&mut self, row: usize) {
        let moved = |other: usize| if other > row { other - 1 } else { other };
        for pair in &mut self.ignored {
            *pair = (moved(pair.0), moved(pair.1));
        }
        for other in &mut self.aside {
            *other = moved(*other as usize) as u32;
        }
        self.forget();
    }

    /// Rows of the bodies that are too large for the grids or the tree.
    #[must_use]
    pub fn large(&self) -> Vec<u32> {
        match self.way {
            Way::Grids => self.levels.large().to_vec(),
            Way::Tree => self.tree.large().collect(),
        }
    }

    /// How many bodies are in the tree, and how many leaves it has.
    #[must_use]
    pub fn tree(&self) -> (usize, usize) {
        self.tree.size()
    }

    /// How often the tree was sorted, and how often an older order fitted well enough.
    #[must_use]
    pub fn sorted_and_refitted(&self) -> (usize, usize) {
        (self.tree.sorted, self.tree.refitted)
    }

    /// The grids, from the finest: the edge of a cell, m, and how many bodies.
    pub fn grids(&self) -> impl Iterator<Item = (f32, usize)> {
        self.levels.sizes()
    }

    /// Rows of the bodies whose boxes of the last step overlap this one's.
    pub fn near(&self, bodies: &Bodies, row: usize) -> impl Iterator<Item = usize> {
        let own = bound::about(bodies, row, 0.0);
        let boxes = self.bounds.iter().enumerate();
        boxes.filter_map(move |(other, bound)| bound.overlaps(&own).then_some(other))
    }

    /// Where each body may be in the step: empty if it touches nothing.
    #[must_use]
    pub fn boxes(&self) -> Vec<Aabb> {
        let of = |bound: &Bound| Aabb {
            min: bound.low().into(),
            max: bound.high().into(),
        };
        self.bounds.iter().map(of).collect()
    }

    /// How many pairs are near enough to be looked at in each step.
    #[must_use]
    pub fn candidates(&self) -> usize {
        self.candidates.count()
    }
}

// ANCHOR: find_pairs
/// The pairs that may touch within `dt`, in order of row. Two bodies that can't move are no pair, and one that
/// isn't at a finite place has none.
pub fn find_pairs(bodies: &Bodies, dt: f32, broad: &mut BroadPhase) {
    let known = broad.rooms.len() == bodies.rows();
    let rows = if known { bodies.awake() } else { bodies.rows() };
    // Outside of a run's threads Rayon would wake its own, as many as there are cores.
    let threads = rows >= THREADED && rayon::current_thread_index().is_some();
    let all = 0..bodies.rows();
    let all = std::slice::from_ref(&all);
    let runs = if known { bodies.runs() } else { all };
    bound(bodies, runs, dt, threads, broad);
    if known && broad.leavers.are_few(bodies.rows(), &broad.candidates) {
        broad.reuses += 1;
        leavers::give_room(bodies, broad);
    } else {
        broad.rebuilds += 1;
        broad.leavers.forget();
        if !known {
            broad.choose();
        }
        make_room(bodies, dt, threads, broad);
        let (rooms, found) = (&broad.rooms, &mut broad.found);
        match broad.way {
            Way::Grids => {
                broad.levels.build(rooms, |row| bodies.is_static(row));
                broad.levels.find(threads, found);
            }
            Way::Tree => {
                broad.tree.build(rooms, !known, |row| bodies.is_static(row));
                broad.tree.find(threads, found);
            }
        }
        let candidates = &mut broad.candidates;
        candidates.take(&broad.found, bodies.rows(), &broad.ignored);
    }
    let (candidates, added) = (&mut broad.candidates, broad.leavers.added());
    candidates.still(&broad.bounds, added, threads, &mut broad.pairs);
}
// ANCHOR_END: find_pairs

/// Where each body of some runs of rows may be in the step, and which have left the room that they had.
fn bound(bodies: &Bodies, runs: &[Range<usize>], dt: f32, threads: bool, broad: &mut BroadPhase) {
    let rows = bodies.rows();
    broad.bounds.resize(rows, Bound::EMPTY);
    broad.rooms.resize(rows, Bound::EMPTY);
    let (aside, rooms) = (&broad.aside, &broad.rooms);
    let of_chunk = |first: usize, bounds: &mut [Bound]| {
        let (mut fast, mut leavers) = (0, Vec::new());
        for (row, bound) in (first..).zip(bounds) {
            *bound = if aside.is_empty() || aside.binary_search(&(row as u32)).is_err() {
                bound::about(bodies, row, dt)
            } else {
                Bound::EMPTY
            };
            if !rooms[row].holds(bound) {
                leavers.push(row as u32);
            }
            fast += usize::from(bound::ahead(bodies, row, dt) > FAST * bodies.place[row].reach);
        }
        (fast, leavers)
    };
    let mut told: Vec<(usize, Vec<u32>)> = Vec::new();
    for run in runs {
        let first = |k: usize| run.start + k * CHUNK;
        let bounds = &mut broad.bounds[run.clone()];
        if threads {
            let chunks = bounds.par_chunks_mut(CHUNK).enumerate();
            told.par_extend(chunks.map(|(k, bounds)| of_chunk(first(k), bounds)));
        } else {
            let chunks = bounds.chunks_mut(CHUNK).enumerate();
            told.extend(chunks.map(|(k, bounds)| of_chunk(first(k), bounds)));
        }
    }
    broad.fast = told.iter().map(|(fast, _)| fast).sum();
    broad
        .leavers
        .hear(told.into_iter().flat_map(|(_, leavers)| leavers));
}

/// Gives each body room.
fn make_room(bodies: &Bodies, dt: f32, threads: bool, broad: &mut BroadPhase) {
    let step = bodies.rows().div_ceil(SAMPLE).max(1);
    let sampled = (0..bodies.rows()).step_by(step);
    let speeds = sampled.map(|row| bound::speed_in_reaches(bodies, row));
    let (count, sum) = speeds
        .filter(|&speed| speed.is_finite() && speed > 0.0)
        .fold((0.0, 0.0), |(count, sum), speed| (count + 1.0, sum + speed));
    let time = bound::time_of_room(sum / count, dt);
    broad.leavers.time = time;
    let bounds = &broad.bounds;
    let of_chunk = |(k, rooms): (usize, &mut [Bound])| {
        for (row, room) in (k * CHUNK..).zip(rooms) {
            *room = bound::roomy(bodies, row, &bounds[row], time);
        }
    };
    if threads {
        broad
            .rooms
            .par_chunks_mut(CHUNK)
            .enumerate()
            .for_each(of_chunk);
    } else {
        broad.rooms.chunks_mut(CHUNK).enumerate().for_each(of_chunk);
    }
}
