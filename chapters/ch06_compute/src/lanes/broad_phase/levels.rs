//! Grids for boxes of all sizes: a level for each size, with cells twice as wide as the one below.
//!
//! A box is in the cell of its lower corner, in the lowest level in which it reaches over two cells
//! along each axis at most. So of two in one level that overlap the cells are the same or next to each other;
//! and of a larger one the cells that a smaller one must look through are three along each axis at
//! most. That holds in f32 too, since subtracting, multiplying and rounding down keep numbers in order.

use rayon::prelude::*;

use super::level::{Cell, Level, Row, cell_of};
use super::{Bound, bound};

/// How much wider cells are than those of the level below.
const WIDER: f32 = 2.0;

/// A level with no more bodies is none: they are on the list of large ones.
const LISTED: usize = 16;

/// How many levels there may be; what is larger is on the list.
const MOST_LEVELS: usize = 16;

/// The lowest level is for boxes up to this many times as large as the median.
const USUAL: f32 = 2.0;

/// Bodies that one thread takes at a time.
const CHUNK: usize = 512;

/// No level: the list, or nowhere.
const LARGE: u8 = 254;
const NOWHERE: u8 = 255;

/// All levels. Keeps its memory when it is built anew.
#[derive(Clone, Debug, Default)]
pub struct Levels {
    grids: Vec<Level>,
    /// By row: its level, and its cell there.
    homes: Vec<(u8, Cell)>,
    /// Rows that are in no level, and their boxes.
    large: Vec<u32>,
    large_bounds: Vec<Bound>,
    large_static: Vec<bool>,
}

impl Levels {
    /// Sorts the boxes into levels and cells.
    pub fn build(&mut self, bounds: &[Bound], is_static: impl Fn(usize) -> bool) {
        let edge = usual_edge(bounds);
        self.grids.resize_with(MOST_LEVELS, Level::default);
        let mut width = edge;
        for level in &mut self.grids {
            level.clear(width);
            width *= WIDER;
        }
        self.homes.clear();
        for bound in bounds {
            let home = self.home_of(bound);
            if let Some(level) = self.grids.get_mut(home.0 as usize) {
                level.count(home.1);
            }
            self.homes.push(home);
        }
        self.large.clear();
        for level in &mut self.grids {
            level.listed = level.bodies() <= LISTED;
            if !level.listed {
                level.lay_table();
            }
        }
        for (row, (level, cell)) in self.homes.iter_mut().enumerate() {
            match self.grids.get_mut(*level as usize) {
                Some(at) if !at.listed => at.count_slot(*cell),
                None if *level == NOWHERE => {}
                _ => {
                    *level = LARGE;
                    self.large.push(row as u32);
                }
            }
        }
        self.grids.iter_mut().for_each(Level::scan);
        for (row, (level, cell)) in self.homes.iter().enumerate() {
            if let Some(level) = self.grids.get_mut(*level as usize) {
                level.put(*cell, row as u32, is_static(row), bounds[row]);
            }
        }
        self.grids.retain(|level| !level.listed);
        self.large_bounds.clear();
        let boxes = self.large.iter().map(|&row| bounds[row as usize]);
        self.large_bounds.extend(boxes);
        self.large_static.clear();
        let fixed = self.large.iter().map(|&row| is_static(row as usize));
        self.large_static.extend(fixed);
    }

    /// The lowest level for a box, and its cell there.
    fn home_of(&self, bound: &Bound) -> (u8, Cell) {
        if *bound == Bound::EMPTY {
            return (NOWHERE, Cell::default());
        }
        let extent = bound.extent();
        for (k, level) in self.grids.iter().enumerate() {
            if extent <= level.edge {
                let low = cell_of(bound.low(), level.inverse);
                let high = cell_of(bound.high(), level.inverse);
                if (0..3).all(|axis| high[axis] - low[axis] <= 1) {
                    return (k as u8, low);
                }
            }
        }
        (LARGE, Cell::default())
    }

    /// Rows of the bodies that are in no level, in order.
    #[must_use]
    pub fn large(&self) -> &[u32] {
        &self.large
    }

    /// Edge of the cells, m, and number of bodies of each level.
    pub fn sizes(&self) -> impl Iterator<Item = (f32, usize)> {
        self.grids.iter().map(|level| (level.edge, level.bodies()))
    }

    // ANCHOR: find
    /// All pairs of boxes that overlap, of which one can move, each once, the smaller row first.
    pub fn find(&self, threads: bool, found: &mut Vec<Vec<[u32; 2]>>) {
        let chunks: Vec<(usize, usize)> = (0..self.grids.len())
            .flat_map(|k| (0..self.grids[k].bodies().div_ceil(CHUNK)).map(move |c| (k, c * CHUNK)))
            .collect();
        found.resize_with(chunks.len() + 1, Vec::new);
        let find = |(&(k, first), found): (&(usize, usize), &mut Vec<[u32; 2]>)| {
            found.clear();
            self.find_for(k, first, found);
        };
        let (last, others) = found.split_last_mut().expect("one more than the chunks");
        if threads {
            chunks.par_iter().zip(others).for_each(find);
        } else {
            chunks.iter().zip(others).for_each(find);
        }
        last.clear();
        self.find_among_large(last);
    }

    /// Pairs of some bodies of a level: with those that follow them there, with all in the other levels in which
    /// they are the ones to look, and with the large ones.
    fn find_for(&self, k: usize, first: usize, found: &mut Vec<[u32; 2]>) {
        let level = &self.grids[k];
        let end = level.bodies().min(first + CHUNK);
        for at in first..end {
            level.find_following(at, found);
            let (row, bound) = (level.rows[at], level.bounds[at]);
            for above in self.grids[k + 1..]
                .iter()
                .filter(|above| !looks_down(above, level))
            {
                above.find_overlapping(row, &bound, found);
            }
            for below in self.grids[..k]
                .iter()
                .filter(|below| looks_down(level, below))
            {
                below.find_overlapping(row, &bound, found);
            }
            self.find_large(row, &bound, found);
        }
    }
    // ANCHOR_END: find

    /// Pairs of a box with all that were sorted, itself among them.
    pub fn find_all(&self, row: Row, bound: &Bound, found: &mut Vec<[u32; 2]>) {
        for level in &self.grids {
            level.find_overlapping(row, bound, found);
        }
        self.find_large(row, bound, found);
    }

    fn find_large(&self, row: Row, bound: &Bound, found: &mut Vec<[u32; 2]>) {
        for (j, other) in self.large_bounds.iter().enumerate() {
            if bound.overlaps(other) && !(row.is_static() && self.large_static[j]) {
                found.push(row.with(self.large[j]));
            }
        }
    }

    fn find_among_large(&self, found: &mut Vec<[u32; 2]>) {
        for (j, one) in self.large_bounds.iter().enumerate() {
            for k in j + 1..self.large.len() {
                let idle = self.large_static[j] && self.large_static[k];
                if !idle && one.overlaps(&self.large_bounds[k]) {
                    found.push([self.large[j], self.large[k]]);
                }
            }
        }
    }
}

/// Whether the bodies of the coarser of two grids look into the finer: that is fewer lines of cells than
/// when those of the finer look at three by three each.
fn looks_down(coarse: &Level, fine: &Level) -> bool {
    let across = coarse.edge / fine.edge + 2.0;
    coarse.bodies() as f32 * across * across < 9.0 * fine.bodies() as f32
}

/// The largest edge of the usual boxes, m.
fn usual_edge(bounds: &[Bound]) -> f32 {
    let mut extents = bound::some_extents(bounds);
    if extents.is_empty() {
        return 1.0;
    }
    let middle = extents.len() / 2;
    let median = *extents.select_nth_unstable_by(middle, f32::total_cmp).1;
    let usual = extents.into_iter().filter(|&e| e <= USUAL * median);
    // A little more: boxes whose corners were rounded are in their level all the same.
    1.001 * usual.fold(0.0, f32::max)
}
