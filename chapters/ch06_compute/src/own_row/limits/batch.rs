//! Limits of one kind, a limit a lane.
//!
//! A lane whose limit is missing repeats the last one; what it finds is not looked at.

use rayon::prelude::*;

use super::{Bounds, Turning, solve_limit};
use crate::bodies::Bodies;
use crate::own_row::side::Side;
use crate::rows::{Limit, Turned};
use crate::simd::{MOST_LANES, Real, Vec3};

/// Fewer batches than this are not worth a second thread's waking up: a batch takes about 1 µs.
const FEW: usize = 64;

/// As many limits of one kind as there are lanes, or fewer.
#[derive(Clone, Debug)]
struct Batch<R> {
    /// Rows of the bodies that they are measured in.
    a: [u32; MOST_LANES],
    /// Rows of those that turn.
    b: [u32; MOST_LANES],
    bounds: Bounds<R>,
    /// How many limits there are.
    count: usize,
}

/// Limits of one kind that follow each other.
#[derive(Clone, Debug)]
struct Run<R> {
    /// The first of them.
    first: usize,
    /// How many there are.
    count: usize,
    batches: Vec<Batch<R>>,
}

/// All limits of a scene.
#[derive(Clone, Debug, Default)]
pub struct Limits<R> {
    /// Those that are solved: a run a kind, where none sleeps.
    runs: Vec<Run<R>>,
    /// By limit: what it does to its bodies.
    pub turned: Vec<Turned>,
}

impl<R: Real> Batch<R> {
    fn of(limits: &[Limit]) -> Self {
        let limit = |lane: usize| &limits[lane.min(limits.len() - 1)];
        Self {
            a: std::array::from_fn(|lane| limit(lane).a),
            b: std::array::from_fn(|lane| limit(lane).b),
            bounds: Bounds::of(limit),
            count: limits.len(),
        }
    }

    /// What its limits do in a substep, in the place of what they did in the last.
    fn solve(&mut self, bodies: &Bodies, turned: &mut [Turned], h: f32) {
        let sides = [Side::of(bodies, &self.a), Side::of(bodies, &self.b)];
        let rows: &mut [[[f32; 4]; 2]] = bytemuck::cast_slice_mut(turned);
        let [x, y, z, counts] = R::of_rows(|lane| rows[lane.min(self.count - 1)][0]);
        let before = Turning {
            turning: Vec3::new(x, y, z),
            counts,
            ..Turning::default()
        };
        let now = solve_limit(&mut self.bounds, &before, sides, h);
        let (Vec3 { x, y, z }, push) = (now.turning, now.push);
        let first = R::to_rows([x, y, z, now.counts]);
        let second = R::to_rows([push.x, push.y, push.z, R::splat(0.0)]);
        for (row, (first, second)) in rows.iter_mut().zip(first.into_iter().zip(second)) {
            *row = [first, second];
        }
    }
}

impl<R: Real> Limits<R> {
    /// Limits, of which those of one kind lie together. They start from the impulses that they have.
    #[must_use]
    pub fn of(limits: &[Limit]) -> Self {
        let mut all = Self {
            runs: Vec::new(),
            turned: vec![Turned::default(); limits.len()],
        };
        all.group(limits, |_| true);
        all
    }

    /// From now on those alone are solved that are awake. They start from the impulses that they have.
    pub fn group(&mut self, limits: &[Limit], is_awake: impl Fn(&Limit) -> bool) {
        self.runs.clear();
        let alike = |a: &Limit, b: &Limit| (a.kind, is_awake(a)) == (b.kind, is_awake(b));
        let mut first = 0;
        for limits in limits.chunk_by(alike) {
            if is_awake(&limits[0]) {
                self.runs.push(Run {
                    first,
                    count: limits.len(),
                    batches: limits.chunks(R::LANES).map(Batch::of).collect(),
                });
            }
            first += limits.len();
        }
    }

    // ANCHOR: solve
    /// Solves all limits; each writes its own row, in any order and on any thread.
    pub fn solve(&mut self, bodies: &Bodies, h: f32) {
        for run in &mut self.runs {
            let turned = &mut self.turned[run.first..run.first + run.count];
            let batches = &mut run.batches;
            let solve = |(batch, turned): (&mut Batch<R>, &mut [Turned])| {
                batch.solve(bodies, turned, h);
            };
            // Outside of a run's threads Rayon would wake its own, as many as there are cores.
            if batches.len() < FEW || rayon::current_thread_index().is_none() {
                let rows = turned.chunks_mut(R::LANES);
                batches.iter_mut().zip(rows).for_each(solve);
            } else {
                let rows = turned.par_chunks_mut(R::LANES);
                let batches = batches.par_iter_mut().zip(rows);
                batches.with_min_len(FEW / 2).for_each(solve);
            }
        }
    }
    // ANCHOR_END: solve

    /// Forgets what held in the last substep.
    pub fn forget(&mut self) {
        self.turned.fill(Turned::default());
        for batch in self.batches_mut() {
            batch.bounds.impulses = Vec3::zero();
        }
    }

    /// Tells the limits of the scene what held each of their turns.
    pub fn write_back(&self, limits: &mut [Limit]) {
        for run in &self.runs {
            let impulses = run.batches.iter().flat_map(|batch| {
                let impulses = batch.bounds.impulses;
                (0..batch.count).map(move |lane| impulses.lane(lane))
            });
            for (limit, impulses) in limits[run.first..].iter_mut().zip(impulses) {
                limit.impulses = impulses;
            }
        }
    }

    fn batches_mut(&mut self) -> impl Iterator<Item = &mut Batch<R>> {
        self.runs.iter_mut().flat_map(|run| &mut run.batches)
    }

    /// A body without joints is gone: those after it have moved up.
    pub fn remove_body(&mut self, body: usize) {
        for batch in self.batches_mut() {
            for row in batch.a.iter_mut().chain(&mut batch.b) {
                if *row as usize > body {
                    *row -= 1;
                }
            }
        }
    }
}
