//! Broad phase: which bodies may touch in the step. Rows are sorted into the cells of a grid by
//! counting; bodies much larger than a cell are on a short list.

use ch03_collision::aabb::Aabb;
use ch05_properties::data::shape_of;

use crate::bodies::Bodies;
use crate::grid::{self, Cell, Grid};
use crate::rules::MARGIN;

/// A body is fast if it looks farther than so many cells.
const FAST: f32 = 2.0;

/// What the broad phase keeps: its memory from step to step, and its result.
#[derive(Clone, Debug, Default)]
pub struct BroadPhase {
    /// Reach beyond which a body is large, m.
    largest_in_grid: f32,
    grid: Option<Grid>,
    /// Rows of large bodies, in order.
    large: Vec<u32>,
    /// By slot: where its rows begin in `order`; one more at the end.
    starts: Vec<u32>,
    /// Rows in the order of slots; within a slot in the order of IDs.
    order: Vec<u32>,
    /// By row.
    cell: Vec<Cell>,
    /// By row: where it may be in the step.
    boxes: Vec<Aabb>,
    /// Rows of bodies that may touch, the smaller first, in order.
    pub pairs: Vec<(usize, usize)>,
    /// Pairs that a joint connects, in order: they pass through each other.
    pub ignored: Vec<(usize, usize)>,
    /// Rows of bodies that hang on a fixed point, in order: they touch nothing.
    pub aside: Vec<u32>,
    /// How many bodies were fast in the last step: they looked farther than others.
    pub fast: usize,
}

impl BroadPhase {
    /// Where things stand is looked at anew in the next step: bodies came or went.
    pub fn forget(&mut self) {
        self.grid = None;
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

    /// Rows of the bodies that are too large for the grid.
    #[must_use]
    pub fn large(&self) -> &[u32] {
        &self.large
    }

    /// The grid, once a step has been made.
    #[must_use]
    pub fn grid(&self) -> Option<&Grid> {
        self.grid.as_ref()
    }
}

// ANCHOR: find_pairs
/// The pairs that may touch within `dt`, in order of row. Two bodies that can't move are no pair.
pub fn find_pairs(bodies: &Bodies, dt: f32, broad: &mut BroadPhase) {
    let grid = lay_grid(bodies, broad);
    bound(bodies, dt, broad);
    count_cells(bodies, &grid, broad);
    scan(&mut broad.starts);
    sort_rows(&grid, broad);
    pair_up(bodies, &grid, dt, broad);
}
// ANCHOR_END: find_pairs

/// Chooses the cells, once for a set of bodies.
fn lay_grid(bodies: &Bodies, broad: &mut BroadPhase) -> Grid {
    if let Some(grid) = broad.grid {
        return grid;
    }
    let reaches = (0..bodies.rows()).filter(|&row| !bodies.is_static(row));
    let reaches = reaches.map(|row| bodies.place[row].reach).collect();
    let limit = grid::largest_in_grid(reaches);
    let is_small = |row: usize| bodies.place[row].reach <= limit;
    let grid = Grid::of(&bodies.place, is_small);
    let rows = 0..bodies.rows();
    broad.large = rows
        .filter(|&row| !is_small(row))
        .map(|row| row as u32)
        .collect();
    broad.largest_in_grid = limit;
    broad.grid = Some(grid);
    grid
}

/// How far a body looks beyond itself, m: half the margin, and what it may move.
fn ahead(bodies: &Bodies, row: usize, dt: f32) -> f32 {
    if bodies.is_static(row) {
        return 0.5 * MARGIN;
    }
    let turning = if bodies.solid[row].kind == 0 {
        0.0
    } else {
        bodies.spin[row].angular_velocity.length() * bodies.place[row].reach
    };
    0.5 * MARGIN + (bodies.motion[row].velocity.length() + turning) * dt
}

/// Where each body may be in the step.
fn bound(bodies: &Bodies, dt: f32, broad: &mut BroadPhase) {
    broad.boxes.clear();
    broad.boxes.extend((0..bodies.rows()).map(|row| {
        let solid = &bodies.solid[row];
        let shape = shape_of(solid.kind, solid.size);
        let place = bodies.place[row].position;
        Aabb::of_shape(&shape, place, bodies.attitude[row]).grown(ahead(bodies, row, dt))
    }));
    for &row in &broad.aside {
        broad.boxes[row as usize] = Aabb::EMPTY;
    }
}

// ANCHOR: counting_sort
/// Counts the rows of each slot.
fn count_cells(bodies: &Bodies, grid: &Grid, broad: &mut BroadPhase) {
    broad.starts.clear();
    broad.starts.resize(grid.count() + 1, 0);
    broad.cell.clear();
    for place in &bodies.place {
        let cell = grid.cell_of(place.position);
        broad.cell.push(cell);
        if place.reach <= broad.largest_in_grid {
            broad.starts[grid.slot_of(cell)] += 1;
        }
    }
}

/// Makes counts into starts: each becomes the sum of those before it.
fn scan(counts: &mut [u32]) {
    let mut sum = 0;
    for count in counts {
        sum += std::mem::replace(count, sum);
    }
}

/// Puts each row where its slot begins, behind those that came before it.
fn sort_rows(grid: &Grid, broad: &mut BroadPhase) {
    let mut next = broad.starts.clone();
    broad.order.clear();
    broad
        .order
        .resize(*broad.starts.last().unwrap_or(&0) as usize, 0);
    let large = |row: u32| broad.large.binary_search(&row).is_ok();
    for row in (0..broad.cell.len() as u32).filter(|&row| !large(row)) {
        let place = &mut next[grid.slot_of(broad.cell[row as usize])];
        broad.order[*place as usize] = row;
        *place += 1;
    }
}
// ANCHOR_END: counting_sort

/// Looks for partners of each row: in the cells about it, and on the short list.
fn pair_up(bodies: &Bodies, grid: &Grid, dt: f32, broad: &mut BroadPhase) {
    let mut pairs = std::mem::take(&mut broad.pairs);
    pairs.clear();
    let widest = widest_in_grid(bodies, broad);
    broad.fast = 0;
    for &row in &broad.order {
        // Of two that come together one comes at least half of the way.
        let far = bodies.place[row as usize].reach + 2.0 * ahead(bodies, row as usize, dt) + widest;
        broad.fast += usize::from(far > FAST * grid.edge);
        around(broad, bodies, grid, row, far, |other| {
            if other != row && may_touch(bodies, broad, row, other) {
                pairs.push((row.min(other) as usize, row.max(other) as usize));
            }
        });
        for &other in &broad.large {
            if may_touch(bodies, broad, row, other) {
                pairs.push((row.min(other) as usize, row.max(other) as usize));
            }
        }
    }
    for (k, &row) in broad.large.iter().enumerate() {
        for &other in &broad.large[k + 1..] {
            if may_touch(bodies, broad, row, other) {
                pairs.push((row as usize, other as usize));
            }
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    if !broad.ignored.is_empty() {
        pairs.retain(|pair| broad.ignored.binary_search(pair).is_err());
    }
    broad.pairs = pairs;
}

/// The widest reach in the grid, m.
fn widest_in_grid(bodies: &Bodies, broad: &BroadPhase) -> f32 {
    let reaches = broad
        .order
        .iter()
        .map(|&row| bodies.place[row as usize].reach);
    reaches.fold(0.0, f32::max) + MARGIN
}

// ANCHOR: around
/// Visits the rows in the cells within `far` of a row, m; all rows where that is a short way through them. A
/// fast body looks along all that it may hit in the step.
fn around(
    broad: &BroadPhase,
    bodies: &Bodies,
    grid: &Grid,
    row: u32,
    far: f32,
    mut visit: impl FnMut(u32),
) {
    let position = bodies.place[row as usize].position;
    let low = grid.cell_of(position - far);
    let high = grid.cell_of(position + far);
    let widths: [i64; 3] =
        std::array::from_fn(|axis| i64::from(high[axis]) - i64::from(low[axis]) + 1);
    let fits = (0..3).all(|axis| widths[axis] <= i64::from(grid.slots[axis]));
    let cells: i64 = widths.iter().product();
    if !fits || usize::try_from(cells).is_ok_and(|cells| cells > broad.order.len()) {
        broad.order.iter().copied().for_each(visit);
        return;
    }
    for z in low[2]..=high[2] {
        for y in low[1]..=high[1] {
            for x in low[0]..=high[0] {
                let slot = grid.slot_of([x, y, z]);
                let (first, end) = (broad.starts[slot], broad.starts[slot + 1]);
                let rows = &broad.order[first as usize..end as usize];
                rows.iter()
                    .copied()
                    .filter(|&other| broad.cell[other as usize] == [x, y, z])
                    .for_each(&mut visit);
            }
        }
    }
}
// ANCHOR_END: around

/// Whether two bodies may touch in the step, and one of them can move.
fn may_touch(bodies: &Bodies, broad: &BroadPhase, a: u32, b: u32) -> bool {
    let (a, b) = (a as usize, b as usize);
    let idle = bodies.is_static(a) && bodies.is_static(b);
    !idle && broad.boxes[a].overlaps(&broad.boxes[b])
}
