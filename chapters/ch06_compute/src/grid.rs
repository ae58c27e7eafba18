//! A uniform grid that has no ends: cells are found by their coordinates modulo the size of a table, so a
//! world of any width needs a table of fixed size, and rows that are near in space are near in the
//! table.
//!
//! Two cells far apart may share a slot of the table. Whoever looks into a slot therefore compares the
//! cell that it looks for with the one in which a row is.

use glam::Vec3;

use crate::rows::Place;

/// Fewest cells along an axis: a row looks at three in each, and they must be three slots.
const FEWEST: u32 = 4;

/// The largest table.
const MOST_SLOTS: u32 = 1 << 23;

/// A body is large if it reaches farther than this many times the median of all that move.
pub const LARGE: f32 = 4.0;

/// Coordinates of a cell.
pub type Cell = [i32; 3];

// ANCHOR: grid
/// Where cells are, and where they are in the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Edge of a cell, m.
    pub edge: f32,
    /// How many slots along x, y and z.
    pub slots: [u32; 3],
}

impl Grid {
    /// The cell in which a point is.
    #[must_use]
    pub fn cell_of(&self, position: Vec3) -> Cell {
        (position / self.edge).floor().to_array().map(|c| c as i32)
    }

    /// The slot of a cell.
    #[must_use]
    pub fn slot_of(&self, cell: Cell) -> usize {
        let [x, y, z] = self.slots;
        let wrap = |c: i32, slots: u32| c.rem_euclid(slots.cast_signed()) as u32;
        ((wrap(cell[2], z) * y + wrap(cell[1], y)) * x + wrap(cell[0], x)) as usize
    }

    /// How many slots there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.slots.iter().map(|&slots| slots as usize).product()
    }
}
// ANCHOR_END: grid

impl Grid {
    /// A grid for these bodies: cells as wide as the widest that isn't large, and slots for the space
    /// in which they are.
    #[must_use]
    pub fn of(places: &[Place], is_small: impl Fn(usize) -> bool) -> Self {
        let rows: Vec<usize> = (0..places.len()).filter(|&row| is_small(row)).collect();
        let widest = rows
            .iter()
            .map(|&row| places[row].reach)
            .fold(0.0, f32::max);
        let edge = if widest > 0.0 { 2.5 * widest } else { 1.0 };
        let places: Vec<Place> = rows.iter().map(|&row| places[row]).collect();
        Self::with_edge(edge, &places)
    }

    /// A grid with cells of this width, with slots for the space in which the bodies are.
    #[must_use]
    pub fn with_edge(edge: f32, places: &[Place]) -> Self {
        let mut low = Vec3::INFINITY;
        let mut high = Vec3::NEG_INFINITY;
        for place in places {
            low = low.min(place.position);
            high = high.max(place.position);
        }
        let extent = (high - low).max(Vec3::ZERO).min(Vec3::splat(1e6));
        let mut slots = extent.to_array().map(|width| slots_over(width / edge));
        let wanted = (4 * places.len().max(16) as u32).min(MOST_SLOTS);
        while slots.iter().product::<u32>() > wanted {
            let Some(most) = slots.iter_mut().filter(|slots| **slots > FEWEST).max() else {
                break;
            };
            *most = most.div_ceil(2);
        }
        Self { edge, slots }
    }
}

/// How much farther than they reach two of the widest may look on the GPU, m: what they may come nearer in a
/// step.
#[must_use]
pub fn margin_of(widest: f32) -> f32 {
    2.0 * widest + 2.0 * crate::rules::MARGIN
}

/// Slots for so many cells: one more, since what lies across a border is in both, and at least [`FEWEST`].
fn slots_over(cells: f32) -> u32 {
    (cells.ceil() as u32 + 1).clamp(FEWEST, MOST_SLOTS)
}

/// The reach beyond which a body is large, m: it is then on a short list, not in the grid.
#[must_use]
pub fn largest_in_grid(mut reaches: Vec<f32>) -> f32 {
    if reaches.is_empty() {
        return 0.0;
    }
    let middle = reaches.len() / 2;
    let (_, median, _) = reaches.select_nth_unstable_by(middle, f32::total_cmp);
    LARGE * *median
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> Grid {
        Grid {
            edge: 0.5,
            slots: [4, 8, 4],
        }
    }

    #[test]
    fn every_cell_of_a_table_has_a_slot_of_its_own() {
        let grid = grid();
        let mut seen = vec![false; grid.count()];
        for z in -2..2 {
            for y in 3..11 {
                for x in 0..4 {
                    let slot = grid.slot_of([x, y, z]);
                    assert!(!std::mem::replace(&mut seen[slot], true));
                }
            }
        }
        assert!(seen.into_iter().all(|seen| seen));
    }

    #[test]
    fn a_point_below_zero_is_in_the_cell_below() {
        let cell = grid().cell_of(Vec3::new(-0.1, 0.6, 0.4));
        assert_eq!(cell, [-1, 1, 0]);
    }

    #[test]
    fn the_three_cells_about_one_are_three_slots_even_of_the_smallest_table() {
        let place = Place {
            reach: 0.2,
            ..Place::default()
        };
        let grid = Grid::of(&[place], |_| true);
        let slots = [-1, 0, 1].map(|x| grid.slot_of([x, 0, 0]));
        assert!(slots[0] != slots[1] && slots[1] != slots[2] && slots[0] != slots[2]);
    }

    #[test]
    fn one_huge_body_among_small_ones_is_large() {
        let mut reaches = vec![0.2; 9];
        reaches.push(5.0);
        assert!(largest_in_grid(reaches) < 5.0);
    }
}
