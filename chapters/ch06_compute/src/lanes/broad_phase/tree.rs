//! A bounding volume hierarchy, as columns, without pointers. Boxes are halved at the median of their centres,
//! again and again, so that those which are near each other lie together; a node is nothing but the box about
//! all that is below it.
//!
//! The tree is complete. Node `i` of level `d` has the places from `i n / 2ᵈ` to `(i + 1) n / 2ᵈ`, so neither places
//! nor children are stored: those of node `k` are `2 k + 1` and `2 k + 2`.

use std::ops::Range;

use rayon::prelude::*;

use super::level::Row;
use super::{Bound, bound};

/// Places of a leaf, at most.
const LEAF: usize = 8;

/// Boxes this many times as wide as the median are on the list of large ones …
const LARGE: f32 = 16.0;

/// … unless they are more than one of so many.
const FEW: usize = 64;

/// The order of the last step is good enough as long as the leaves are together no more than this many times as
/// large as they were when boxes were put in order.
const LOOSE: f32 = 1.25;

/// Leaves that one thread takes at a time.
const CHUNK: usize = 64;

/// A box to be put in order: its centre, twice, and its row.
#[derive(Clone, Copy, Debug)]
struct Point {
    centre: [f32; 3],
    row: Row,
}

/// The tree. Keeps its memory when it is built anew.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// Levels below the root.
    depth: u32,
    /// By node: the box about all below it.
    nodes: Vec<Bound>,
    /// By place: whose box is there.
    rows: Vec<Row>,
    /// By place: the box.
    bounds: Vec<Bound>,
    points: Vec<Point>,
    /// Sum of the edges of the leaves when they were put in order, m.
    size: f32,
    /// Rows that are nowhere.
    nowhere: Vec<u32>,
    /// Rows that aren't in the tree, and their boxes.
    large: Vec<Row>,
    large_bounds: Vec<Bound>,
    /// How often boxes were put in order, and how often the order of an earlier step was good enough.
    pub sorted: usize,
    pub refitted: usize,
}

impl Tree {
    /// Sorts the boxes, or makes the old order fit them. `anew` says that rows may be others' now.
    pub fn build(&mut self, boxes: &[Bound], anew: bool, is_static: impl Fn(usize) -> bool) {
        let is_nowhere = |row: &u32| boxes[*row as usize] == Bound::EMPTY;
        if !anew && self.nowhere.iter().all(is_nowhere) {
            self.refit(boxes);
            if self.leaf_size() <= LOOSE * self.size {
                self.refitted += 1;
                return;
            }
        }
        self.sorted += 1;
        self.choose(boxes, is_static);
        self.depth = self.points.len().div_ceil(LEAF).max(1).ilog2();
        if self.points.len() > LEAF << self.depth {
            self.depth += 1;
        }
        for level in 0..self.depth {
            for node in 0..1 << level {
                let places = self.places(level, node);
                let middle = self.places(level + 1, 2 * node).end - places.start;
                halve(&mut self.points[places], middle);
            }
        }
        self.rows.clear();
        self.rows.extend(self.points.iter().map(|point| point.row));
        self.refit(boxes);
        self.size = self.leaf_size();
    }

    /// Who is in the tree, and who is on the list.
    fn choose(&mut self, boxes: &[Bound], is_static: impl Fn(usize) -> bool) {
        let most = LARGE * median_extent(boxes);
        let known = |row: &usize| boxes[*row] != Bound::EMPTY;
        let nowhere = (0..boxes.len()).filter(|row| !known(row));
        self.nowhere.clear();
        self.nowhere.extend(nowhere.map(|row| row as u32));
        let is_large = |row: &usize| boxes[*row].extent() > most;
        let row = |row: usize| Row::of(row as u32, is_static(row));
        self.large.clear();
        let large = (0..boxes.len()).filter(known).filter(is_large);
        self.large.extend(large.map(row));
        if FEW * self.large.len() > boxes.len().max(32 * FEW) {
            self.large.clear();
        }
        let listed = !self.large.is_empty();
        let inside = (0..boxes.len()).filter(known);
        let inside = inside.filter(|row| !(listed && is_large(row)));
        self.points.clear();
        self.points.extend(inside.map(|at| Point {
            centre: boxes[at].twice_the_centre(),
            row: row(at),
        }));
    }

    /// The places of a node.
    fn places(&self, level: u32, node: usize) -> Range<usize> {
        let at = |node: usize| ((node as u64 * self.points.len() as u64) >> level) as usize;
        at(node)..at(node + 1)
    }

    // ANCHOR: refit
    /// Puts the boxes where the order has them; then each leaf is the box about its own, and each node that about
    /// its two halves.
    fn refit(&mut self, boxes: &[Bound]) {
        let of = |row: &Row| boxes[row.row() as usize];
        self.bounds.clear();
        self.bounds.extend(self.rows.iter().map(of));
        self.large_bounds.clear();
        self.large_bounds.extend(self.large.iter().map(of));
        let leaves = 1 << self.depth;
        self.nodes.resize(2 * leaves - 1, Bound::EMPTY);
        for leaf in 0..leaves {
            let own = &self.bounds[self.places(self.depth, leaf)];
            self.nodes[leaves - 1 + leaf] = own.iter().fold(Bound::EMPTY, Bound::joined);
        }
        for node in (0..leaves - 1).rev() {
            self.nodes[node] = self.nodes[2 * node + 1].joined(&self.nodes[2 * node + 2]);
        }
    }
    // ANCHOR_END: refit

    /// The edges of all leaves, summed, m.
    fn leaf_size(&self) -> f32 {
        let leaves = &self.nodes[(1 << self.depth) - 1..];
        let known = leaves.iter().filter(|leaf| **leaf != Bound::EMPTY);
        known.map(Bound::edges).sum()
    }

    /// Rows of the bodies that aren't in the tree, in order.
    pub fn large(&self) -> impl Iterator<Item = u32> {
        self.large.iter().map(|row| row.row())
    }

    /// How many bodies are in the tree, and how many leaves it has.
    pub fn size(&self) -> (usize, usize) {
        (self.rows.len(), 1 << self.depth)
    }

    /// All pairs of boxes that overlap, of which one can move, each once, the smaller row first.
    pub fn find(&self, threads: bool, found: &mut Vec<Vec<[u32; 2]>>) {
        let leaves: usize = 1 << self.depth;
        found.resize_with(leaves.div_ceil(CHUNK) + 1, Vec::new);
        let find = |(k, found): (usize, &mut Vec<[u32; 2]>)| {
            found.clear();
            for leaf in k * CHUNK..leaves.min((k + 1) * CHUNK) {
                self.find_for(leaf, found);
            }
        };
        let (last, others) = found.split_last_mut().expect("one more than the chunks");
        if threads {
            others.par_iter_mut().enumerate().for_each(find);
        } else {
            others.iter_mut().enumerate().for_each(find);
        }
        last.clear();
        for (k, (&row, bound)) in self.large.iter().zip(&self.large_bounds).enumerate() {
            let others = self.large[k + 1..].iter().zip(&self.large_bounds[k + 1..]);
            look(row, bound, others, last);
        }
    }

    // ANCHOR: find_leaf
    /// Pairs of a leaf's boxes with each other, with those of the leaves that follow it, and with the large ones.
    fn find_for(&self, leaf: usize, found: &mut Vec<[u32; 2]>) {
        let own = self.places(self.depth, leaf);
        let about = self.nodes[(1 << self.depth) - 1 + leaf];
        for at in own.clone() {
            let (row, bound) = (self.rows[at], &self.bounds[at]);
            self.look_at(row, bound, at + 1..own.end, found);
            look(row, bound, self.large.iter().zip(&self.large_bounds), found);
        }
        self.visit(&about, leaf + 1, |other, others| {
            for at in own.clone() {
                if self.bounds[at].overlaps(other) {
                    self.look_at(self.rows[at], &self.bounds[at], others.clone(), found);
                }
            }
        });
    }
    // ANCHOR_END: find_leaf

    /// Pairs of a box with all that were sorted, itself among them.
    pub fn find_all(&self, row: Row, bound: &Bound, found: &mut Vec<[u32; 2]>) {
        self.visit(bound, 0, |_, places| {
            self.look_at(row, bound, places, found);
        });
        look(row, bound, self.large.iter().zip(&self.large_bounds), found);
    }

    // ANCHOR: visit
    /// Visits the leaves that overlap a box, from the leaf `first` on: their boxes, and their places.
    fn visit(&self, wanted: &Bound, first: usize, mut leaf: impl FnMut(&Bound, Range<usize>)) {
        // A level leaves one half waiting.
        let mut waiting = [(0, 0, 0); 2 * u32::BITS as usize];
        let mut left = 1;
        while left > 0 {
            left -= 1;
            let (node, level, number) = waiting[left];
            let last = ((number + 1) << (self.depth - level)) - 1;
            if last < first || !self.nodes[node].overlaps(wanted) {
                continue;
            }
            if level == self.depth {
                leaf(&self.nodes[node], self.places(level, number));
                continue;
            }
            waiting[left] = (2 * node + 2, level + 1, 2 * number + 1);
            waiting[left + 1] = (2 * node + 1, level + 1, 2 * number);
            left += 2;
        }
    }
    // ANCHOR_END: visit

    #[inline]
    fn look_at(&self, row: Row, bound: &Bound, at: Range<usize>, found: &mut Vec<[u32; 2]>) {
        let others = self.rows[at.clone()].iter().zip(&self.bounds[at]);
        look(row, bound, others, found);
    }
}

/// Pairs of a box with some others.
#[inline]
fn look<'o>(
    row: Row,
    bound: &Bound,
    others: impl Iterator<Item = (&'o Row, &'o Bound)>,
    found: &mut Vec<[u32; 2]>,
) {
    for (other, near) in others {
        if bound.overlaps(near) && !(row.is_static() && other.is_static()) {
            found.push(row.with(other.row()));
        }
    }
}

// ANCHOR: halve
/// Orders points so that the first `middle` are those of lower centres, along the axis along which the centres are
/// farthest apart. Equal ones are told apart by row, so that there is one order.
fn halve(points: &mut [Point], middle: usize) {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for point in points.iter() {
        for axis in 0..3 {
            low[axis] = low[axis].min(point.centre[axis]);
            high[axis] = high[axis].max(point.centre[axis]);
        }
    }
    let wide = |axis: &usize| high[*axis] - low[*axis];
    let longest = (0..3).max_by(|a, b| wide(a).total_cmp(&wide(b)));
    let axis = longest.unwrap_or(0);
    if middle < points.len() {
        points.select_nth_unstable_by(middle, |a, b| {
            let order = a.centre[axis].total_cmp(&b.centre[axis]);
            order.then(a.row.row().cmp(&b.row.row()))
        });
    }
}
// ANCHOR_END: halve

/// The median of the longest edges of the boxes, m.
fn median_extent(boxes: &[Bound]) -> f32 {
    let mut extents = bound::some_extents(boxes);
    if extents.is_empty() {
        return f32::INFINITY;
    }
    let middle = extents.len() / 2;
    *extents.select_nth_unstable_by(middle, f32::total_cmp).1
}
