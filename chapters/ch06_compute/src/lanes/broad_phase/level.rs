//! One grid: cells of one width in a table without ends, and in each the boxes of which the lower corner
//! is there.

use super::Bound;

/// Coordinates of a cell.
pub type Cell = [i32; 3];

/// Fewest bits of the number of slots along an axis: three cells side by side are three slots.
const FEWEST_BITS: u32 = 2;

/// Most bits along an axis.
const MOST_BITS: u32 = 20;

/// No cell is farther out, so that its neighbours have coordinates too.
const FARTHEST: f32 = 1e9;

/// A row, and in the highest bit whether its body can't move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row(u32);

const STATIC: u32 = 1 << 31;

impl Row {
    /// The row of a body.
    pub fn of(row: u32, is_static: bool) -> Self {
        Self(row | if is_static { STATIC } else { 0 })
    }

    /// Whether the body can't move.
    #[inline]
    pub fn is_static(self) -> bool {
        self.0 & STATIC != 0
    }

    /// The row without it.
    #[inline]
    pub fn row(self) -> u32 {
        self.0 & !STATIC
    }

    /// The pair with another row, the smaller first.
    #[inline]
    pub fn with(self, other: u32) -> [u32; 2] {
        [self.row().min(other), self.row().max(other)]
    }
}

/// A grid.
#[derive(Clone, Debug, Default)]
pub struct Level {
    /// Edge of a cell, m, and 1 over it.
    pub edge: f32,
    pub inverse: f32,
    /// Whether it has so few bodies that they are on the list of large ones.
    pub listed: bool,
    count: usize,
    low: Cell,
    high: Cell,
    /// How many bits of a cell's x, y, z tell its slot.
    bits: [u32; 3],
    /// By slot: where its bodies begin; two more at the end.
    starts: Vec<u32>,
    /// In the order of slots, within a slot in the order of rows.
    pub rows: Vec<Row>,
    cells: Vec<Cell>,
    pub bounds: Vec<Bound>,
}

/// The cell that a point is in.
#[inline]
pub fn cell_of(point: [f32; 3], inverse: f32) -> Cell {
    point.map(|along| {
        let cell = (along * inverse).clamp(-FARTHEST, FARTHEST);
        let towards_zero = cell as i32;
        towards_zero - i32::from((towards_zero as f32) > cell)
    })
}

impl Level {
    /// How many bodies it has.
    pub fn bodies(&self) -> usize {
        self.count
    }

    /// Empties it; cells are `edge` wide from now on, m.
    pub fn clear(&mut self, edge: f32) {
        self.edge = edge;
        self.inverse = 1.0 / edge;
        self.count = 0;
        self.low = [i32::MAX; 3];
        self.high = [i32::MIN; 3];
        self.starts.clear();
        self.rows.clear();
        self.cells.clear();
        self.bounds.clear();
    }

    /// Counts a body in, and how far the cells reach.
    pub fn count(&mut self, cell: Cell) {
        self.count += 1;
        self.low = std::array::from_fn(|axis| self.low[axis].min(cell[axis]));
        self.high = std::array::from_fn(|axis| self.high[axis].max(cell[axis]));
    }

    /// Makes a table with slots for all cells, if these are no more than four a body.
    pub fn lay_table(&mut self) {
        let most = (4 * self.count).ilog2().max(3 * FEWEST_BITS);
        self.bits = std::array::from_fn(|axis| {
            let width = self.high[axis].abs_diff(self.low[axis]) + 1;
            let bits = width.min(1 << MOST_BITS).next_power_of_two().ilog2();
            bits.max(FEWEST_BITS)
        });
        while self.bits.iter().sum::<u32>() > most {
            let widest = (0..3).max_by_key(|&axis| self.bits[axis]).unwrap_or(0);
            self.bits[widest] -= 1;
        }
        let slots = 1 << self.bits.iter().sum::<u32>();
        self.starts.resize(slots + 2, 0);
        self.rows.resize(self.count, Row::default());
        self.cells.resize(self.count, Cell::default());
        self.bounds.resize(self.count, Bound::EMPTY);
    }

    /// The slot of a cell: the last bits of its coordinates, one after the other.
    #[inline]
    fn slot_of(&self, cell: Cell) -> usize {
        self.line_of(cell[1], cell[2]) | self.along(cell[0])
    }

    /// The first slot of a line of slots along x.
    #[inline]
    fn line_of(&self, y: i32, z: i32) -> usize {
        let [x_bits, y_bits, z_bits] = self.bits;
        let y = y as usize & ((1 << y_bits) - 1);
        let z = z as usize & ((1 << z_bits) - 1);
        ((z << y_bits) | y) << x_bits
    }

    /// How far along its line a slot is.
    #[inline]
    fn along(&self, x: i32) -> usize {
        x as usize & ((1 << self.bits[0]) - 1)
    }

    // ANCHOR: counting_sort
    /// Counts the bodies of each slot, two places further on: [`Self::scan`] and [`Self::put`] each bring
    /// the counts one back.
    pub fn count_slot(&mut self, cell: Cell) {
        let slot = self.slot_of(cell);
        self.starts[slot + 2] += 1;
    }

    /// Makes counts into starts: each becomes the sum of those before it.
    pub fn scan(&mut self) {
        let mut sum = 0;
        for count in &mut self.starts {
            sum += *count;
            *count = sum;
        }
    }

    /// Puts a body where its slot begins, behind those that came before it.
    pub fn put(&mut self, cell: Cell, row: u32, is_static: bool, bound: Bound) {
        let slot = self.slot_of(cell);
        let next = &mut self.starts[slot + 1];
        let at = *next as usize;
        *next += 1;
        self.rows[at] = Row::of(row, is_static);
        self.cells[at] = cell;
        self.bounds[at] = bound;
    }
    // ANCHOR_END: counting_sort
}

// ANCHOR: half
/// The lines of cells that follow a cell: half of those about it, so that of two bodies one looks.
const FOLLOWING: [[i32; 2]; 4] = [[1, 0], [-1, 1], [0, 1], [1, 1]];

impl Level {
    /// Pairs of a body with those that follow it: in its own cell, in the next, and in the lines that follow.
    pub fn find_following(&self, at: usize, found: &mut Vec<[u32; 2]>) {
        let (row, bound) = (self.rows[at], self.bounds[at]);
        let [x, y, z] = self.cells[at];
        let own = self.line_of(y, z) | self.along(x);
        let next = self.line_of(y, z) | self.along(x + 1);
        if next == own + 1 {
            self.look(at + 1, self.starts[next + 1] as usize, row, &bound, found);
        } else {
            self.look(at + 1, self.starts[own + 1] as usize, row, &bound, found);
            self.look_in(next, next, row, &bound, found);
        }
        for [up, on] in FOLLOWING {
            self.look_along([x - 1, x + 1], y + up, z + on, row, &bound, found);
        }
    }
    // ANCHOR_END: half

    /// Pairs of a body of another level, or of one that has left its room, with all here.
    pub fn find_overlapping(&self, row: Row, bound: &Bound, found: &mut Vec<[u32; 2]>) {
        let low = cell_of(bound.low(), self.inverse).map(|cell| cell - 1);
        let high = cell_of(bound.high(), self.inverse);
        let width = |axis: usize| high[axis].abs_diff(low[axis]) as u64 + 1;
        let fits = (0..3).all(|axis| width(axis) <= 1 << self.bits[axis]);
        if !fits || width(1) * width(2) > self.count as u64 {
            self.look(0, self.count, row, bound, found);
            return;
        }
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                self.look_along([low[0], high[0]], y, z, row, bound, found);
            }
        }
    }

    /// Looks through cells along x, no more than the line has slots: these follow each other except where
    /// the line comes round.
    #[inline]
    fn look_along(
        &self,
        [low, high]: [i32; 2],
        y: i32,
        z: i32,
        row: Row,
        bound: &Bound,
        found: &mut Vec<[u32; 2]>,
    ) {
        let line = self.line_of(y, z);
        let (first, last) = (self.along(low), self.along(high));
        if first <= last {
            self.look_in(line | first, line | last, row, bound, found);
        } else {
            let end = (1 << self.bits[0]) - 1;
            self.look_in(line | first, line | end, row, bound, found);
            self.look_in(line, line | last, row, bound, found);
        }
    }

    /// Looks through slots that follow each other.
    #[inline]
    fn look_in(
        &self,
        first: usize,
        last: usize,
        row: Row,
        bound: &Bound,
        found: &mut Vec<[u32; 2]>,
    ) {
        let (first, end) = (self.starts[first], self.starts[last + 1]);
        self.look(first as usize, end as usize, row, bound, found);
    }

    /// Pairs with the bodies at `first..end`.
    #[inline]
    fn look(&self, first: usize, end: usize, row: Row, bound: &Bound, found: &mut Vec<[u32; 2]>) {
        for (other, near) in self.rows[first..end].iter().zip(&self.bounds[first..end]) {
            if bound.overlaps(near) && !(row.is_static() && other.is_static()) {
                found.push(row.with(other.row()));
            }
        }
    }
}
