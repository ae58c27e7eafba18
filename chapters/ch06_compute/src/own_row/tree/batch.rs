//! Trees of one shape, a tree a lane: what a node is stands once, what its numbers are stands eight times.
//!
//! All ragdolls of a scene are such trees. A lane whose tree is missing repeats the last one; what it finds
//! is not looked at.

use std::collections::BTreeMap;

use bytemuck::{Pod, Zeroable};
use glam::Vec3 as Row;
use rayon::prelude::*;

use std::ops::Range;

use super::{Bone, Fitting, Heft, Rate, Trees, Walked, children, solve_tree};
use crate::bodies::Bodies;
use crate::rows::{Held, NONE, Node};
use crate::simd::{MOST_LANES, Real, Vec3};

/// Fewer batches than this are not worth a second thread's waking up: a batch of ragdolls takes some 10 µs.
const FEW: usize = 8;

// ANCHOR: limb
/// A node of trees of one shape, a tree a lane.
#[derive(Clone, Debug)]
pub struct Limb<R> {
    /// Free, pin, hinge, rod or two rods.
    pub kind: u32,
    /// Place in the tree of its parent, if that is in it.
    pub parent: Option<usize>,
    /// Places of its children.
    pub children: Range<usize>,
    /// Rows of the bodies.
    pub rows: [u32; MOST_LANES],
    /// Rows of those that they hang on.
    pub parent_rows: [u32; MOST_LANES],
    /// Rows of those that the second rod hangs on.
    pub second_rows: [u32; MOST_LANES],
    /// Where the joint sits.
    pub fitting: Fitting<R>,
    /// How hard the body is to move.
    pub heft: Heft<R>,
    /// What the joint gave the body in the last substep, N s; the parent got the opposite.
    pub impulse: Vec3<R>,
}
// ANCHOR_END: limb

// ANCHOR: solved
/// What a solve makes of a body of a tree: the row that the body takes over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Solved {
    /// Its velocity, m/s.
    pub velocity: Row,
    /// Its angular velocity, rad/s.
    pub spin: Row,
    /// Velocity of its push, m/s.
    pub push: Row,
    /// Angular velocity of its push, rad/s.
    pub turning_push: Row,
    /// With what its joints hold it: impulse through its origin, N s.
    pub linear: Row,
    /// Turning impulse about its origin, N m s.
    pub angular: Row,
    /// Unused.
    pub spare: [f32; 2],
}
// ANCHOR_END: solved

/// So few trees that are left of a shape are solved one by one: eight lanes take as long as three trees.
const LEFT: usize = 3;

/// As many trees of one shape as there are lanes, or fewer.
#[derive(Clone, Debug)]
pub struct Batch<R> {
    /// The nodes of the shape, parents before children and siblings side by side.
    pub nodes: Vec<Limb<R>>,
    /// Where in [`Trees::nodes`] each tree begins.
    starts: Vec<usize>,
    /// By node, and by lane within it.
    solved: Vec<Solved>,
}

/// Where a body finds what a solve made of it.
#[derive(Clone, Copy, Debug)]
struct Seat {
    /// No batch, where the body is in no tree.
    batch: u32,
    row: u32,
}

const NOWHERE: Seat = Seat {
    batch: NONE,
    row: NONE,
};

/// All trees of a scene.
#[derive(Clone, Debug, Default)]
pub struct Batches<R> {
    all: Vec<Batch<R>>,
    /// Trees of whose shape there are few, each by itself.
    alone: Vec<Batch<f32>>,
    /// By body.
    seats: Vec<Seat>,
    /// What one thread has in hand.
    walked: Vec<Walked<R>>,
    walked_alone: Vec<Walked<f32>>,
}

impl<R: Real> Limb<R> {
    /// Of the nodes at `at` of trees that begin at these nodes.
    fn of(nodes: &[Node], starts: &[usize], at: usize, bodies: &Bodies) -> Self {
        let start = |lane: usize| starts[lane.min(starts.len() - 1)];
        let node = |lane: usize| &nodes[start(lane) + at];
        let place = |node: usize| node - start(0);
        let Range { start: first, end } = children(node(0));
        Self {
            kind: node(0).kind,
            parent: (node(0).parent != NONE).then(|| place(node(0).parent as usize)),
            children: if first == end {
                0..0
            } else {
                place(first)..place(end)
            },
            rows: std::array::from_fn(|lane| node(lane).body),
            parent_rows: std::array::from_fn(|lane| node(lane).parent_body),
            second_rows: std::array::from_fn(|lane| node(lane).second_parent),
            fitting: Fitting::of(node),
            heft: Heft::of(bodies, |lane| node(lane).body as usize),
            impulse: Vec3::of(|lane| node(lane).impulse),
        }
    }
}

impl<R: Real> Batch<R> {
    /// Of trees of so many nodes that begin at these nodes.
    fn of(nodes: &[Node], starts: &[usize], count: usize, bodies: &Bodies) -> Self {
        let limb = |at| Limb::of(nodes, starts, at, bodies);
        Self {
            nodes: (0..count).map(limb).collect(),
            starts: starts.to_vec(),
            solved: vec![Solved::default(); count * R::LANES],
        }
    }

    /// Writes what a solve makes of a node's bodies.
    #[inline(always)]
    pub(super) fn write(&mut self, node: usize, bone: &Bone<R>, change: [Rate<R>; 2]) {
        let heft = &self.nodes[node].heft;
        let [moved, pushed] = change;
        let (rate, push) = (bone.rate.plus(moved), bone.push.plus(pushed));
        let linear = moved.velocity * heft.mass;
        let angular = bone.attitude.moment(heft.moments, moved.spin);
        let (v, w, p, t) = (rate.velocity, rate.spin, push.velocity, push.spin);
        let spare = R::splat(0.0);
        let columns = [
            [v.x, v.y, v.z, w.x],
            [w.y, w.z, p.x, p.y],
            [p.z, t.x, t.y, t.z],
            [linear.x, linear.y, linear.z, angular.x],
            [angular.y, angular.z, spare, spare],
        ];
        let rows = &mut self.solved[node * R::LANES..][..R::LANES];
        let rows: &mut [[[f32; 4]; 5]] = bytemuck::cast_slice_mut(rows);
        for (part, columns) in columns.into_iter().enumerate() {
            for (row, numbers) in rows.iter_mut().zip(R::to_rows(columns)) {
                row[part] = numbers;
            }
        }
    }
}

impl<R: Real> Batch<R> {
    /// Tells its bodies where they sit, if it is batch number `index`.
    fn seat(&self, index: usize, seats: &mut [Seat]) {
        for (at, node) in self.nodes.iter().enumerate() {
            for lane in 0..self.starts.len() {
                seats[node.rows[lane] as usize] = Seat {
                    batch: index as u32,
                    row: (at * R::LANES + lane) as u32,
                };
            }
        }
    }

    fn forget(&mut self) {
        for node in &mut self.nodes {
            node.impulse = Vec3::zero();
        }
    }

    fn write_back(&self, nodes: &mut [Node]) {
        for (at, node) in self.nodes.iter().enumerate() {
            for (lane, start) in self.starts.iter().enumerate() {
                nodes[start + at].impulse = node.impulse.lane(lane);
            }
        }
    }

    /// Rows behind a body that is gone have moved up.
    fn move_up(&mut self, body: usize) {
        for node in &mut self.nodes {
            for rows in [&mut node.rows, &mut node.parent_rows, &mut node.second_rows] {
                for row in rows {
                    if *row != NONE && *row as usize > body {
                        *row -= 1;
                    }
                }
            }
        }
    }
}

impl<R: Real> Batches<R> {
    /// The trees of a scene, those of one shape together. They start from the impulses of their nodes.
    #[must_use]
    pub fn of(trees: &Trees, bodies: &Bodies) -> Self {
        Self::of_those(trees, bodies, |_| true)
    }

    /// Some of them.
    #[must_use]
    pub fn of_those(trees: &Trees, bodies: &Bodies, chosen: impl Fn(&[Node]) -> bool) -> Self {
        let mut batches = Self {
            seats: vec![NOWHERE; bodies.rows()],
            ..Self::default()
        };
        for mut starts in of_one_shape(trees) {
            starts.retain(|&tree| chosen(&trees.nodes[trees.trees[tree].clone()]));
            if starts.is_empty() {
                continue;
            }
            let count = trees.trees[starts[0]].len();
            let starts: Vec<_> = starts.iter().map(|&tree| trees.trees[tree].start).collect();
            for starts in starts.chunks(R::LANES) {
                if starts.len() <= LEFT {
                    let one = |start| Batch::of(&trees.nodes, &[start], count, bodies);
                    batches.alone.extend(starts.iter().map(|&start| one(start)));
                } else {
                    let batch = Batch::of(&trees.nodes, starts, count, bodies);
                    batches.all.push(batch);
                }
            }
        }
        for (index, batch) in batches.all.iter().enumerate() {
            batch.seat(index, &mut batches.seats);
        }
        for (index, batch) in batches.alone.iter().enumerate() {
            batch.seat(batches.all.len() + index, &mut batches.seats);
        }
        batches
    }

    /// How many batches there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.all.len() + self.alone.len()
    }

    // ANCHOR: solve
    /// Solves all trees; each batch writes its own rows, in any order and on any thread.
    pub fn solve(&mut self, bodies: &Bodies, joined: &[Held], h: f32) {
        solve_all(&mut self.all, &mut self.walked, bodies, joined, h);
        solve_all(&mut self.alone, &mut self.walked_alone, bodies, joined, h);
    }
    // ANCHOR_END: solve

    /// What the last solve made of a body; none if it is in no tree.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, row: usize) -> Option<&Solved> {
        let seat = self.seats[row];
        let (batch, row) = (seat.batch as usize, seat.row as usize);
        match self.all.get(batch) {
            Some(batch) => batch.solved.get(row),
            None => self.alone.get(batch - self.all.len())?.solved.get(row),
        }
    }

    /// Every body of a tree takes over what the solve made of it.
    pub fn apply(&self, bodies: &mut Bodies, joined: &mut [Held]) {
        for (row, joined) in joined.iter_mut().enumerate() {
            if let Some(solved) = self.at(row) {
                solved.apply(row, bodies, joined);
            }
        }
    }

    /// Forgets what held in the last substep.
    pub fn forget(&mut self) {
        self.all.iter_mut().for_each(Batch::forget);
        self.alone.iter_mut().for_each(Batch::forget);
    }

    /// Tells the nodes of the scene what their joints gave.
    pub fn write_back(&self, nodes: &mut [Node]) {
        self.all.iter().for_each(|batch| batch.write_back(nodes));
        self.alone.iter().for_each(|batch| batch.write_back(nodes));
    }

    /// A body without joints came.
    pub fn add_body(&mut self) {
        self.seats.push(NOWHERE);
    }

    /// A body without joints is gone: those after it have moved up.
    pub fn remove_body(&mut self, body: usize) {
        self.seats.remove(body);
        self.all.iter_mut().for_each(|batch| batch.move_up(body));
        self.alone.iter_mut().for_each(|batch| batch.move_up(body));
    }
}

/// Solves batches, in any order and on any thread.
fn solve_all<R: Real>(
    batches: &mut [Batch<R>],
    walked: &mut Vec<Walked<R>>,
    bodies: &Bodies,
    joined: &[Held],
    h: f32,
) {
    let solve = |walked: &mut Vec<Walked<R>>, batch: &mut Batch<R>| {
        solve_tree(batch, bodies, joined, walked, h);
    };
    // Outside of a run's threads Rayon would wake its own, as many as there are cores.
    if batches.len() < FEW || rayon::current_thread_index().is_none() {
        for batch in batches {
            solve(walked, batch);
        }
    } else {
        let batches = batches.par_iter_mut().with_min_len(FEW / 2);
        batches.for_each_init(Vec::new, solve);
    }
}

impl Solved {
    // ANCHOR: apply
    /// The body takes over how it moves, and with what its joints hold it, in the place of what they gave
    /// it at the start of the substep.
    #[inline(always)]
    pub fn apply(&self, row: usize, bodies: &mut Bodies, joined: &mut Held) {
        bodies.motion[row].velocity = self.velocity;
        bodies.spin[row].angular_velocity = self.spin;
        bodies.push[row].velocity = self.push;
        bodies.push[row].angular_velocity = self.turning_push;
        bodies.momentum[row] += self.angular - joined.angular;
        joined.linear = self.linear;
        joined.angular = self.angular;
    }
    // ANCHOR_END: apply
}

/// The trees of each shape: those whose nodes are of the same kinds and hang on the same places. Shapes
/// come in the order of their first trees.
fn of_one_shape(trees: &Trees) -> Vec<Vec<usize>> {
    let mut known = BTreeMap::new();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (tree, nodes) in trees.trees.iter().enumerate() {
        let hangs_on = |node: &Node| node.parent.wrapping_sub(nodes.start as u32);
        let place = |node: &Node| (node.kind, (node.parent != NONE).then(|| hangs_on(node)));
        let shape: Vec<_> = trees.nodes[nodes.clone()].iter().map(place).collect();
        let group = *known.entry(shape).or_insert(groups.len());
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(tree);
    }
    groups
}
