//! A KD-tree over plain boxes: space is halved at the median along its longest axis, again and
//! again, so that a search looks only where something can be. Report 7, broad step.
//!
//! A box that is wider than half of its cell stays at the cell itself: a floor would otherwise
//! stretch every cell on its way down. Each cell knows the box about all that is in or below it.

use crate::aabb::Aabb;

/// A cell with at most this many boxes is not divided further.
const LEAF: usize = 8;

/// A cell: some boxes of its own, and two halves or none.
#[derive(Clone, Copy, Debug)]
struct Cell {
    bounds: Aabb,
    /// Its own boxes: a range of `order`.
    first: u32,
    end: u32,
    /// The two halves' places in `cells`; 0 for none, since the root is nobody's half.
    halves: [u32; 2],
}

/// The tree. Keeps its memory when it is built anew.
#[derive(Clone, Debug, Default)]
pub struct KdTree {
    cells: Vec<Cell>,
    order: Vec<u32>,
}

impl KdTree {
    // ANCHOR: build
    /// Builds the tree over `boxes`, whose indices it then speaks of.
    pub fn build(&mut self, boxes: &[Aabb]) {
        self.cells.clear();
        self.order.clear();
        self.order.extend(0..boxes.len() as u32);
        if !boxes.is_empty() {
            self.divide(boxes, 0, boxes.len());
        }
    }

    /// Makes a cell of `order[first..end]` and returns its place.
    fn divide(&mut self, boxes: &[Aabb], first: usize, end: usize) -> u32 {
        let place = self.cells.len();
        let bounds = bounds_of(boxes, &self.order[first..end]);
        self.cells.push(Cell {
            bounds,
            first: first as u32,
            end: end as u32,
            halves: [0, 0],
        });
        if end - first > LEAF {
            let axis = bounds.size().max_position();
            let own = self.keep_wide_ones(boxes, first, end, axis, 0.5 * bounds.size()[axis]);
            if end - own > LEAF {
                let middle = self.split_at_median(boxes, own, end, axis);
                self.cells[place].end = own as u32;
                let low = self.divide(boxes, own, middle);
                let high = self.divide(boxes, middle, end);
                self.cells[place].halves = [low, high];
            }
        }
        place as u32
    }
    // ANCHOR_END: build

    /// Moves the boxes that are wider than `width` along `axis` to the front; returns where the
    /// others begin.
    fn keep_wide_ones(
        &mut self,
        boxes: &[Aabb],
        first: usize,
        end: usize,
        axis: usize,
        width: f32,
    ) -> usize {
        let mut own = first;
        for i in first..end {
            if boxes[self.order[i] as usize].size()[axis] > width {
                self.order.swap(own, i);
                own += 1;
            }
        }
        own
    }

    /// Orders `order[first..end]` so that the lower half of the centres comes first; returns
    /// where the upper half begins. Equal centres are told apart by index.
    fn split_at_median(&mut self, boxes: &[Aabb], first: usize, end: usize, axis: usize) -> usize {
        let middle = (end - first) / 2;
        self.order[first..end].select_nth_unstable_by(middle, |&i, &j| {
            let centre = |k: u32| boxes[k as usize].min[axis] + boxes[k as usize].max[axis];
            centre(i).total_cmp(&centre(j)).then(i.cmp(&j))
        });
        first + middle
    }

    // ANCHOR: overlapping
    /// Calls `found` with every box that overlaps `wanted`, in no order that means anything.
    pub fn overlapping(&self, boxes: &[Aabb], wanted: &Aabb, mut found: impl FnMut(usize)) {
        let mut waiting = [0u32; 64];
        let mut left = usize::from(!self.cells.is_empty());
        while left > 0 {
            left -= 1;
            let cell = &self.cells[waiting[left] as usize];
            if !cell.bounds.overlaps(wanted) {
                continue;
            }
            for &i in &self.order[cell.first as usize..cell.end as usize] {
                if boxes[i as usize].overlaps(wanted) {
                    found(i as usize);
                }
            }
            if cell.halves[0] != 0 {
                // Halving 2³² boxes goes 32 deep, and each level leaves one half waiting.
                waiting[left] = cell.halves[0];
                waiting[left + 1] = cell.halves[1];
                left += 2;
            }
        }
    }
    // ANCHOR_END: overlapping

    /// The cells' bounds with how deep each lies, the root first: for the overlay.
    #[must_use]
    pub fn cells(&self) -> Vec<(Aabb, u32)> {
        let mut out = Vec::with_capacity(self.cells.len());
        let mut waiting = Vec::new();
        if !self.cells.is_empty() {
            waiting.push((0, 0));
        }
        while let Some((place, depth)) = waiting.pop() {
            let cell = &self.cells[place as usize];
            out.push((cell.bounds, depth));
            if cell.halves[0] != 0 {
                waiting.extend(cell.halves.map(|half| (half, depth + 1)));
            }
        }
        out
    }
}

/// The smallest box about some of `boxes`.
fn bounds_of(boxes: &[Aabb], some: &[u32]) -> Aabb {
    some.iter()
        .fold(Aabb::EMPTY, |bounds, &i| bounds.joined(&boxes[i as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ch00_scenes::random::SplitMix64;
    use glam::Vec3;

    /// Boxes of very different sizes, some equal, in a cube of 10 m.
    fn crowd(n: usize, seed: u64) -> Vec<Aabb> {
        let mut random = SplitMix64::new(seed);
        let mut number = || random.unit() as f32;
        (0..n)
            .map(|i| {
                let min = 10.0 * Vec3::new(number(), number(), number());
                let size = if i % 17 == 0 { 8.0 } else { 0.4 };
                Aabb {
                    min,
                    max: min + size * Vec3::new(number(), number(), number()),
                }
            })
            .collect()
    }

    #[test]
    fn the_tree_finds_what_brute_force_finds() {
        for (n, seed) in [(0, 1), (1, 2), (8, 3), (9, 4), (300, 5), (2000, 6)] {
            let boxes = crowd(n, seed);
            let mut tree = KdTree::default();
            tree.build(&boxes);
            for wanted in &boxes {
                let mut found = Vec::new();
                tree.overlapping(&boxes, wanted, |i| found.push(i));
                found.sort_unstable();
                let all: Vec<usize> = (0..n).filter(|&i| boxes[i].overlaps(wanted)).collect();
                assert_eq!(found, all);
            }
        }
    }

    #[test]
    fn equal_boxes_end_the_division() {
        let boxes = vec![
            Aabb {
                min: Vec3::ZERO,
                max: Vec3::ONE
            };
            1000
        ];
        let mut tree = KdTree::default();
        tree.build(&boxes);
        let mut found = 0;
        tree.overlapping(&boxes, &boxes[0], |_| found += 1);
        assert_eq!(found, 1000);
    }
}
