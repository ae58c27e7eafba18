//! Regions: bodies that lie together in space, so few that all that a substep knows of them fits into the
//! memory that a core has alone.
//!
//! Rows stay in the order of the scene, in which neighbours may stand far apart: in a heap of a hundred thousand
//! balls it is ten thousand rows from one level to the next. So whoever goes through pairs goes through them
//! region by region. Which region a body is in changes no result of own rows; with colours it changes the order
//! in which pairs take turns, and so it depends on where bodies are and on nothing else.

use std::ops::Range;

use crate::bodies::Bodies;
use crate::rows::Place;

/// The most bodies of a region. All that 1024 balls and their contacts read and write in a substep are some
/// 600 KB.
pub const MOST_BODIES: usize = 1024;

/// A body that reaches so many times as far as usual has neighbours in many regions. Such are in one by themselves.
const LARGE: f32 = 8.0;

/// After so many steps bodies are divided anew.
const LASTS: u32 = 64;

/// After so many, if many pairs have ends in two regions.
const LASTS_AT_LEAST: u32 = 8;

/// Bodies by regions.
#[derive(Clone, Debug, Default)]
pub struct Regions {
    /// Rows, region by region and in order within each; behind them those that nothing moves.
    order: Vec<u32>,
    /// By row: its place in `order`.
    spots: Vec<u32>,
    /// By row: its region; [`NOWHERE`] where nothing moves it.
    of: Vec<u16>,
    /// Where each region begins in `order`, and where the last one ends.
    starts: Vec<usize>,
    /// How many of them are halves of halves; what is large is in one more, if there is such.
    leaves: usize,
    /// How many steps ago they were found.
    age: u32,
    /// Whether many pairs have ends in two of them.
    torn: bool,
}

/// The region of what nothing moves.
pub const NOWHERE: u16 = u16::MAX;

impl Regions {
    /// They are found anew in the next step: others move than before.
    pub fn forget(&mut self) {
        self.order.clear();
    }

    /// Hears how many pairs there are, and how many of them have ends in two regions.
    pub fn hear(&mut self, pairs: usize, torn: usize) {
        self.torn = 4 * torn > pairs;
    }

    /// How many there are; one where there are few bodies, and all rows are in it.
    #[must_use]
    pub fn count(&self) -> usize {
        self.starts.len().saturating_sub(1).max(1)
    }

    /// The region of a row; [`NOWHERE`] if nothing moves it.
    #[inline]
    #[must_use]
    pub fn of(&self, row: usize) -> u16 {
        self.of[row]
    }

    /// Places in order of a region's rows.
    #[must_use]
    pub fn region(&self, region: usize) -> Range<usize> {
        self.starts[region]..self.starts[region + 1]
    }

    /// The rows of a region, in order.
    #[must_use]
    pub fn rows(&self, region: usize) -> &[u32] {
        &self.order[self.region(region)]
    }

    /// How many nodes the tree of halves has: an even number belongs to a region, an odd one to a cut, and the one in
    /// the middle to all.
    #[must_use]
    pub fn nodes(&self) -> usize {
        2 * self.leaves - 1
    }

    // ANCHOR: node
    /// The smallest part that has both of two regions: its node in the tree of halves.
    #[must_use]
    pub fn node(&self, [a, b]: [u16; 2]) -> usize {
        let [a, b] = [a, b].map(usize::from);
        if a.max(b) >= self.leaves {
            return self.leaves - 1;
        }
        // Numbered from 1, a node's number is that of any region in it, cut off where its size has a bit.
        let [a, b] = [2 * a + 1, 2 * b + 1];
        let bit = (a ^ b).checked_ilog2().unwrap_or(0);
        (a.max(b) >> bit << bit) - 1
    }

    /// The places in order of the rows that a node has.
    #[must_use]
    pub fn span(&self, node: usize) -> Range<usize> {
        if node == self.leaves - 1 {
            return 0..*self.starts.last().unwrap_or(&0);
        }
        let size = 1 << (node + 1).trailing_zeros();
        let (first, end) = ((node + 1 - size) / 2, (node + 1 + size) / 2);
        self.starts[first]..self.starts[end]
    }
    // ANCHOR_END: node

    /// How many rows each has.
    pub fn sizes(&self) -> impl Iterator<Item = usize> {
        self.starts.windows(2).map(|ends| ends[1] - ends[0])
    }

    /// By row: its place among all, region by region.
    #[must_use]
    pub fn spots(&self) -> &[u32] {
        &self.spots
    }

    /// Finds them, if nobody knows them or it is long ago. Whether it did.
    pub fn find(&mut self, bodies: &Bodies) -> bool {
        self.age += 1;
        let old = self.age >= LASTS || self.torn && self.age >= LASTS_AT_LEAST;
        if self.order.len() == bodies.rows() && (!old || self.count() == 1) {
            return false;
        }
        (self.age, self.torn) = (0, false);
        let rows = 0..bodies.rows() as u32;
        let moving = rows.clone().filter(|&row| bodies.moves(row as usize));
        self.order.clear();
        self.order.extend(moving);
        self.starts.clear();
        self.of.clear();
        self.of.resize(rows.len(), NOWHERE);
        if self.order.len() > MOST_BODIES {
            self.divide(bodies);
            self.order
                .extend(rows.filter(|&row| self.of[row as usize] == NOWHERE));
        } else {
            for &row in &self.order {
                self.of[row as usize] = 0;
            }
            self.starts.extend([0, rows.len()]);
            self.leaves = 1;
            self.order.clear();
            self.order.extend(rows);
        }
        self.spots.resize(self.order.len(), 0);
        for (spot, &row) in self.order.iter().enumerate() {
            self.spots[row as usize] = spot as u32;
        }
        true
    }

    /// Divides the bodies that move.
    fn divide(&mut self, bodies: &Bodies) {
        let moving = self.order.len();
        let reach = |row: &u32| bodies.place[*row as usize].reach;
        let usual = self.order.iter().map(reach).sum::<f32>() / moving as f32;
        let is_large = |row: &u32| reach(row) > LARGE * usual;
        let large: Vec<u32> = self.order.iter().copied().filter(is_large).collect();
        self.order.retain(|row| !is_large(row));
        let small = self.order.len();
        let count = small.div_ceil(MOST_BODIES).next_power_of_two();
        self.leaves = count;
        self.starts.extend((0..=count).map(|k| k * small / count));
        divide(&mut self.order, &self.starts, &bodies.place);
        if !large.is_empty() {
            self.order.extend(large);
            self.starts.push(moving);
        }
        for (region, ends) in self.starts.windows(2).enumerate() {
            for &row in &self.order[ends[0]..ends[1]] {
                self.of[row as usize] = region as u16;
            }
        }
    }
}

// ANCHOR: divide
/// Halves the bodies where they lie farthest apart, again and again. `starts` says where each region shall begin,
/// and where the last one shall end, counted from any number.
fn divide(rows: &mut [u32], starts: &[usize], place: &[Place]) {
    let regions = starts.len() - 1;
    if regions == 1 {
        rows.sort_unstable();
        return;
    }
    let at = |row: &u32, axis: usize| place[*row as usize].position[axis];
    let extent = |axis: usize| {
        let along = rows.iter().map(|row| at(row, axis));
        let low = along.clone().fold(f32::INFINITY, f32::min);
        along.fold(f32::NEG_INFINITY, f32::max) - low
    };
    let extents = [0, 1, 2].map(extent);
    let longest = (0..3).max_by(|&one, &other| extents[one].total_cmp(&extents[other]));
    let axis = longest.unwrap_or(0);
    let half = starts[regions / 2] - starts[0];
    rows.select_nth_unstable_by(half, |one, other| {
        let order = at(one, axis).total_cmp(&at(other, axis));
        order.then(one.cmp(other))
    });
    let (low, high) = rows.split_at_mut(half);
    divide(low, &starts[..=regions / 2], place);
    divide(high, &starts[regions / 2..], place);
}
// ANCHOR_END: divide
