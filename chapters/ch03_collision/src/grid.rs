//! A uniform grid over plain boxes: space in cells of one size, and a list of boxes for each. The
//! other broad phase, beside the KD-tree of `kd_tree.rs`: no tree to build, but one size for all.
//!
//! A box stands in the list of one cell, the one that its lower corner is in. A box that overlaps
//! `wanted` has its lower corner at most its own edge below that of `wanted`, so only the cells from
//! there to the upper corner of `wanted` are looked at. The few boxes that are much larger than the
//! others, such as walls, stand in a list of their own. [Ericson 2005, section 7.1]
//!
//! Nothing is lost to rounding: subtracting, dividing and rounding down all keep numbers in order.

use glam::Vec3;

use crate::aabb::Aabb;

/// A box whose longest edge is this many times that of the median box has no cell.
const WIDE: f32 = 4.0;

/// The least edge of a cell, m, for points.
const SMALLEST: f32 = 1e-6;

/// Bits of the least number of cells along an axis, 4: a small box looks at up to three of them.
const FEWEST_BITS: u32 = 2;
/// Bits of the largest.
const MOST_BITS: u32 = 20;

// ANCHOR: grid
/// The grid. Keeps its memory when it is built anew.
///
/// Space without end is wrapped round it: cells that lie 2ᵇ apart, where b is `bits` of that axis, share
/// a list, so that no box, however far away, costs memory.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Edge of a cell, m: no box with a cell is larger.
    cell: f32,
    /// How many bits of a cell's x, y, z tell its list.
    bits: [u32; 3],
    /// Cell c has the boxes `order[first[c]..first[c + 1]]`.
    first: Vec<u32>,
    order: Vec<u32>,
    /// Boxes that are larger.
    wide: Vec<u32>,
    /// The others, and the cell that each is in.
    small: Vec<u32>,
    homes: Vec<u32>,
}
// ANCHOR_END: grid

impl Default for Grid {
    fn default() -> Self {
        Self {
            cell: 1.0,
            bits: [0; 3],
            first: Vec::new(),
            order: Vec::new(),
            wide: Vec::new(),
            small: Vec::new(),
            homes: Vec::new(),
        }
    }
}

impl Grid {
    // ANCHOR: build
    /// Builds the grid over `boxes`, whose indices it then speaks of.
    pub fn build(&mut self, boxes: &[Aabb]) {
        self.cell = cell_for(boxes);
        self.small.clear();
        self.wide.clear();
        let mut corners = Aabb::EMPTY;
        for (i, one) in boxes.iter().enumerate() {
            // What is no number is nowhere, and any cell will do.
            if longest_edge(one) > self.cell {
                self.wide.push(i as u32);
            } else {
                self.small.push(i as u32);
                corners.min = corners.min.min(one.min);
                corners.max = corners.max.max(one.min);
            }
        }
        self.bits = bits_for(corners.size() / self.cell, boxes.len());
        self.sort_into_cells(boxes);
    }

    // ANCHOR: sort_into_cells
    /// Counting sort: how many boxes each cell has, where each cell's boxes end, then each box
    /// to its place, the last first.
    fn sort_into_cells(&mut self, boxes: &[Aabb]) {
        self.homes.clear();
        for &i in &self.small {
            let home = self.list_of(self.cell_of(boxes[i as usize].min));
            self.homes.push(home as u32);
        }
        self.first.clear();
        let cells = 1 << self.bits.iter().sum::<u32>();
        self.first.resize(cells + 1, 0);
        for &home in &self.homes {
            self.first[home as usize] += 1;
        }
        let mut end = 0;
        for first in &mut self.first {
            end += *first;
            *first = end;
        }
        self.order.resize(self.small.len(), 0);
        for (&i, &home) in self.small.iter().zip(&self.homes).rev() {
            let place = &mut self.first[home as usize];
            *place -= 1;
            self.order[*place as usize] = i;
        }
    }
    // ANCHOR_END: sort_into_cells
    // ANCHOR_END: build

    // ANCHOR: overlapping
    /// Calls `found` with every box that overlaps `wanted`, in no order that means anything.
    pub fn overlapping(&self, boxes: &[Aabb], wanted: &Aabb, mut found: impl FnMut(usize)) {
        let mut look = |list: &[u32]| {
            for &i in list {
                if boxes[i as usize].overlaps(wanted) {
                    found(i as usize);
                }
            }
        };
        look(&self.wide);
        let low = self.cell_of(wanted.min - self.cell);
        let high = self.cell_of(wanted.max);
        // Further on it would come round to the same lists again.
        let end = [0, 1, 2].map(|axis| high[axis].min(low[axis] + (1 << self.bits[axis]) - 1));
        for x in low[0]..=end[0] {
            for y in low[1]..=end[1] {
                for z in low[2]..=end[2] {
                    let list = self.list_of([x, y, z]);
                    look(&self.order[self.first[list] as usize..self.first[list + 1] as usize]);
                }
            }
        }
    }
    // ANCHOR_END: overlapping

    /// The cell that a point is in.
    fn cell_of(&self, point: Vec3) -> [i64; 3] {
        (point / self.cell)
            .to_array()
            .map(|along| i64::from(along.floor() as i32))
    }

    /// Place of a cell's list: the last bits of its coordinates, one after the other.
    fn list_of(&self, cell: [i64; 3]) -> usize {
        let [x, y, z] = [0, 1, 2].map(|axis| cell[axis] as usize & ((1 << self.bits[axis]) - 1));
        (((x << self.bits[1]) | y) << self.bits[2]) | z
    }

    /// Edge of a cell, m.
    #[must_use]
    pub fn cell_size(&self) -> f32 {
        self.cell
    }

    /// How many boxes are larger than a cell.
    #[must_use]
    pub fn wide_count(&self) -> usize {
        self.wide.len()
    }
}

// ANCHOR: cell
/// The longest edge of all boxes, but for those that are [`WIDE`] times as large as the median.
fn cell_for(boxes: &[Aabb]) -> f32 {
    let mut edges: Vec<f32> = boxes.iter().map(longest_edge).collect();
    edges.retain(|edge| (0.0..f32::INFINITY).contains(edge));
    if edges.is_empty() {
        return 1.0;
    }
    let middle = edges.len() / 2;
    let median = *edges.select_nth_unstable_by(middle, f32::total_cmp).1;
    let usual = edges.iter().filter(|&&edge| edge <= WIDE * median);
    let longest = usual.fold(SMALLEST, |longest, &edge| edge.max(longest));
    // The difference of two corners is rounded: this is at least what it was before.
    longest.next_up()
}
// ANCHOR_END: cell

/// Enough bits for corners that reach over `cells` of them, if that is no more than four cells
/// a box.
fn bits_for(cells: Vec3, boxes: usize) -> [u32; 3] {
    let most = (4 * boxes).max(1).ilog2().max(3 * FEWEST_BITS);
    let mut bits = cells.to_array().map(|along| {
        let wanted = (along as u32).clamp(1, 1 << MOST_BITS);
        wanted.next_power_of_two().ilog2().max(FEWEST_BITS)
    });
    while bits.iter().sum::<u32>() > most {
        let widest = (0..3).max_by_key(|&axis| bits[axis]).unwrap_or(0);
        bits[widest] -= 1;
    }
    bits
}

/// m; negative or no number for a box that holds nothing.
fn longest_edge(one: &Aabb) -> f32 {
    one.size().max_element()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brute_force;
    use crate::kd_tree::KdTree;
    use ch00_scenes::random::SplitMix64;

    type Pairs = Vec<(usize, usize)>;

    /// Boxes with edges up to `size(i)` in a cube of 10 m about `centre`.
    fn crowd(n: usize, seed: u64, centre: f32, size: impl Fn(usize) -> f32) -> Vec<Aabb> {
        let mut random = SplitMix64::new(seed);
        let mut number = || random.unit() as f32;
        (0..n)
            .map(|i| {
                let min = centre + 10.0 * Vec3::new(number(), number(), number()) - 5.0;
                Aabb {
                    min,
                    max: min + size(i) * Vec3::new(number(), number(), number()),
                }
            })
            .collect()
    }

    fn by_force(boxes: &[Aabb]) -> Pairs {
        let mut pairs = Pairs::new();
        brute_force::all_pairs(boxes, |i, j| pairs.push((i, j)));
        pairs
    }

    fn by_grid(boxes: &[Aabb]) -> Pairs {
        let mut grid = Grid::default();
        grid.build(boxes);
        sorted(boxes, |wanted, found| {
            grid.overlapping(boxes, wanted, found);
        })
    }

    fn by_tree(boxes: &[Aabb]) -> Pairs {
        let mut tree = KdTree::default();
        tree.build(boxes);
        sorted(boxes, |wanted, found| {
            tree.overlapping(boxes, wanted, found);
        })
    }

    fn sorted(boxes: &[Aabb], ask: impl Fn(&Aabb, &mut dyn FnMut(usize))) -> Pairs {
        let mut pairs = Pairs::new();
        for (i, wanted) in boxes.iter().enumerate() {
            ask(wanted, &mut |j| {
                if j > i {
                    pairs.push((i, j));
                }
            });
        }
        pairs.sort_unstable();
        pairs
    }

    #[track_caller]
    fn all_agree(boxes: &[Aabb]) -> usize {
        let pairs = by_force(boxes);
        assert_eq!(by_grid(boxes), pairs, "grid");
        assert_eq!(by_tree(boxes), pairs, "tree");
        pairs.len()
    }

    #[test]
    fn grid_tree_and_force_find_the_same_pairs() {
        for (n, seed) in [(0, 1), (1, 2), (2, 3), (9, 4), (300, 5), (2000, 6)] {
            all_agree(&crowd(n, seed, 0.0, |_| 0.6));
            all_agree(&crowd(n, seed, -777.7, |_| 0.6));
        }
        assert!(all_agree(&crowd(2000, 6, 0.0, |_| 0.6)) > 300);
    }

    #[test]
    fn they_agree_on_boxes_of_sizes_one_to_fifty() {
        let any_size = |i: usize| 0.1 * 50f32.powf((i % 97) as f32 / 96.0);
        assert!(all_agree(&crowd(1000, 7, 3.0, any_size)) > 1000);
    }

    #[test]
    fn walls_stand_in_the_list_and_are_found() {
        let mut boxes = crowd(500, 8, 0.0, |_| 0.6);
        let floor = Aabb {
            min: Vec3::new(-9.0, -6.0, -9.0),
            max: Vec3::new(9.0, -4.9, 9.0),
        };
        boxes.insert(100, floor);
        let mut grid = Grid::default();
        grid.build(&boxes);
        assert_eq!(grid.wide_count(), 1);
        assert!(grid.cell_size() < 0.601, "{}", grid.cell_size());
        assert!(all_agree(&boxes) > 0);
    }

    #[test]
    fn boxes_that_only_touch_are_found() {
        let row: Vec<Aabb> = (0..40)
            .map(|i| Aabb {
                min: Vec3::X * (i - 20) as f32,
                max: Vec3::X * (i - 19) as f32,
            })
            .collect();
        // Each touches the next, and touching counts.
        assert_eq!(all_agree(&row), 39);
    }

    #[test]
    fn who_is_far_away_costs_no_memory_and_is_found_by_its_neighbour() {
        let mut boxes = crowd(100, 9, 0.0, |_| 0.6);
        for far in [1e6, -1e12, 1e30] {
            boxes.extend([boxes[0], boxes[0]].map(|one| Aabb {
                min: one.min + far,
                max: one.max + far,
            }));
        }
        let mut grid = Grid::default();
        grid.build(&boxes);
        assert!(grid.first.len() <= 4 * boxes.len() + 1);
        all_agree(&boxes);
    }

    #[test]
    fn equal_boxes_points_and_empty_boxes_are_no_trouble() {
        let one = Aabb {
            min: Vec3::ZERO,
            max: Vec3::ONE,
        };
        assert_eq!(all_agree(&vec![one; 100]), 4950);
        let point = Aabb {
            min: Vec3::ONE,
            max: Vec3::ONE,
        };
        assert_eq!(all_agree(&[one, point, point]), 3);
        assert_eq!(all_agree(&[Aabb::EMPTY, one, Aabb::EMPTY, point]), 1);
        assert_eq!(all_agree(&[Aabb::EMPTY; 20]), 0);
    }

    #[test]
    fn what_is_no_number_overlaps_nothing() {
        let mut boxes = crowd(50, 10, 0.0, |_| 2.0);
        boxes[7].min.x = f32::NAN;
        boxes[8].max = Vec3::NAN;
        assert_eq!(by_grid(&boxes), by_force(&boxes));
    }

    #[test]
    fn a_box_larger_than_the_whole_grid_sees_each_box_once() {
        let boxes = crowd(200, 11, 0.0, |_| 0.6);
        let mut grid = Grid::default();
        grid.build(&boxes);
        let mut seen = Vec::new();
        let all = Aabb {
            min: Vec3::splat(-1e9),
            max: Vec3::splat(1e9),
        };
        grid.overlapping(&boxes, &all, |i| seen.push(i));
        seen.sort_unstable();
        assert_eq!(seen, (0..200).collect::<Vec<_>>());
    }
}
