//! The columns of pairs: made, filled, and made larger.

use super::super::scan::{blocks, scan_of};
use super::plan::{CELLS_AHEAD, Plan, ends_at, poles_of};
use crate::bodies::Bodies;
use crate::lanes::forces::Forces;
use crate::own_row::tree::Trees;
use crate::rows::{
    Before, Bound, Contact, Drawn, GridOf, Held, Holding, IN_GRID, LARGE, Limit, Memory, Mouse,
    NONE, Node, ON_POINT, PAIR_STATUS_LEN, PairsOf, Partner, Pivot, Pole, Pressed, Rigid, Seen,
    Step, Total, Turned, status_place,
};
use crate::stream::{Columns, Gpu, StreamError};
use ch00_scenes::Scene;
use glam::Vec3;

/// For how much there is room at first. It grows on demand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// Partners of a body.
    pub partners: usize,
    /// Pairs.
    pub pairs: usize,
    /// Pairs of large bodies that move.
    pub large_pairs: usize,
}

impl Room {
    /// For so many bodies.
    #[must_use]
    pub fn for_bodies(bodies: usize) -> Self {
        Self {
            partners: 16,
            pairs: (3 * bodies).max(256),
            large_pairs: 256,
        }
    }
}

/// Columns of which a body needs more than one row, or of which the row is large: bytes a body.
fn bytes_a_body(room: Room) -> [(&'static str, usize); 3] {
    [
        ("rigids", size_of::<Rigid>()),
        ("partners_a", (room.partners + 1) * size_of::<Partner>()),
        ("incidents", (room.partners + 1) * size_of::<u32>()),
    ]
}

// ANCHOR: fits
/// Whether the device has room for so many bodies, and for how many it has.
///
/// # Errors
/// [`StreamError::TooLarge`], before anything is allocated.
pub fn fits(gpu: &Gpu, bodies: usize, room: Room) -> Result<(), StreamError> {
    let columns = bytes_a_body(room).into_iter();
    let most = |(column, bytes): (&'static str, usize)| (gpu.most_rows(bytes), column, bytes);
    let least = columns.map(most).min();
    match least {
        Some((most, column, row_bytes)) if bodies as u64 > most => Err(StreamError::TooLarge {
            column: column.to_owned(),
            asked: bodies as u64,
            row_bytes: row_bytes as u64,
            most,
            device: gpu.name.clone(),
        }),
        _ => Ok(()),
    }
}
// ANCHOR_END: fits

/// Makes all columns.
///
/// # Errors
/// [`StreamError::TooLarge`], [`StreamError::OutOfMemory`].
pub fn allocate(
    columns: &mut Columns,
    grid: &GridOf,
    pairs_of: &PairsOf,
    room: Room,
    plan: &Plan,
) -> Result<(), StreamError> {
    let (rows, starts) = (grid.capacity as usize, grid.starts as usize);
    let pair_counts = pair_counts(grid, pairs_of);
    columns.add::<Rigid>("rigids", rows)?;
    columns.add::<Holding>("holdings", rows)?;
    columns.add::<Before>("befores", if plan.bounces { rows } else { 1 })?;
    columns.add::<Bound>("bounds", rows)?;
    columns.add::<Bound>("sorted", rows)?;
    for name in ["slots", "order"] {
        columns.add::<u32>(name, rows)?;
    }
    for name in ["counts", "starts"] {
        columns.add::<u32>(name, starts)?;
    }
    for name in ["pair_counts", "pair_starts"] {
        columns.add::<u32>(name, pair_counts)?;
    }
    columns.add::<u32>("blocks", blocks(starts.max(pair_counts)))?;
    for side in ["a", "b"] {
        columns.add::<Partner>(&format!("partners_{side}"), (room.partners + 1) * rows)?;
        columns.add::<Memory>(&format!("memories_{side}"), room.pairs)?;
    }
    columns.add::<u32>("incidents", (room.partners + plan.joints.ends + 2) * rows)?;
    columns.add::<Contact>("touches", room.pairs)?;
    columns.add::<Pressed>("presses", plan.joints.loops + room.pairs)?;
    columns.add::<[u32; 4]>("live", room.pairs)?;
    columns.add::<u32>("large_pairs", room.large_pairs)?;
    columns.add::<Total>("totals", pairs_of.larges as usize)?;
    let indirect = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::INDIRECT;
    columns.add_for::<[u32; 3]>("groups", pairs_of.kinds as usize + 2, indirect)?;
    columns.add::<Drawn>("drawn", rows)?;
    columns.add::<Seen>("seen", rows)?;
    columns.add::<u32>("status", PAIR_STATUS_LEN)?;
    let mut status = [0; PAIR_STATUS_LEN];
    status[status_place("FIRST_NOT_FINITE")] = u32::MAX;
    status[status_place("LOOK")] = (CELLS_AHEAD * grid.edge).to_bits();
    columns.write("status", &status)?;
    add_uniforms(columns, grid, pairs_of)
}

fn add_uniforms(
    columns: &mut Columns,
    grid: &GridOf,
    pairs_of: &PairsOf,
) -> Result<(), StreamError> {
    columns.add_uniform("grid", grid)?;
    columns.add_uniform("pairs_of", pairs_of)?;
    columns.add_uniform("cell_scan", &scan_of(grid.starts as usize))?;
    columns.add_uniform("pair_scan", &scan_of(pair_counts(grid, pairs_of)))?;
    columns.add_uniform("step", &Step::default())?;
    columns.add_uniform("mouse", &no_mouse())
}

/// A mouse that holds nothing.
#[must_use]
pub fn no_mouse() -> Mouse {
    Mouse {
        body: NONE,
        ..Mouse::default()
    }
}

/// How many counts of pairs there are: of each kind by body, of each large body that moves by body, and
/// the end.
#[must_use]
pub fn pair_counts(grid: &GridOf, pairs_of: &PairsOf) -> usize {
    (pairs_of.kinds + pairs_of.larges) as usize * grid.rows as usize + 1
}

/// Writes the rows of all bodies, and what doesn't change.
///
/// # Errors
/// What the device can lack.
pub fn upload(
    columns: &mut Columns,
    scene: &Scene,
    bodies: &Bodies,
    forces: &Forces,
    trees: &Trees,
    plan: &Plan,
) -> Result<(), StreamError> {
    let lists = ignored_lists(scene, bodies.rows());
    let seats = seats_of(bodies.rows(), forces, trees);
    let mut first = 0;
    let mut rigids = Vec::with_capacity(bodies.rows());
    for (row, list) in lists.iter().enumerate() {
        let is_on_point = forces.pivots.iter().any(|pivot| pivot.body == row);
        rigids.push(Rigid {
            role: role_of(bodies, plan, row, is_on_point),
            large: plan.large(row),
            ignored: first,
            ignored_count: list.len() as u32,
            ends: ends_at(trees, row).count() as u32,
            seat: seats[row],
            ..rigid_of(bodies, row)
        });
        first += list.len() as u32;
    }
    columns.write("rigids", &rigids)?;
    write_momenta(columns, bodies)?;
    let ignored = lists.concat();
    columns.add::<u32>("ignored", ignored.len())?;
    columns.write("ignored", &ignored)?;
    let pivots: Vec<Pivot> = forces.pivots.iter().map(pivot_of).collect();
    columns.add::<Pivot>("pivots", pivots.len())?;
    columns.write("pivots", &pivots)?;
    let poles = poles_of(scene);
    columns.add::<Pole>("poles", poles.len())?;
    columns.write("poles", &poles)?;
    upload_joints(columns, bodies.rows(), trees)
}

/// Writes trees, limits and loops as if nothing had held yet.
///
/// # Errors
/// What the device can lack.
pub fn upload_joints(
    columns: &mut Columns,
    bodies: usize,
    trees: &Trees,
) -> Result<(), StreamError> {
    if !columns.has("nodes") {
        columns.add::<Node>("nodes", trees.nodes.len())?;
        columns.add::<Held>("joined", trees.nodes.len())?;
        columns.add::<Limit>("limits", trees.limits.len())?;
        columns.add::<Turned>("turned", trees.limits.len())?;
        columns.add::<Node>("loops", trees.loops.len())?;
    }
    columns.write("nodes", &rooted(trees))?;
    columns.write("joined", &vec![Held::default(); trees.nodes.len()])?;
    columns.write("limits", &trees.limits)?;
    columns.write("loops", &trees.loops)?;
    columns.write("turned", &vec![Turned::default(); trees.limits.len()])?;
    columns.write_at("presses", 0, &vec![Pressed::default(); trees.loops.len()])?;
    columns.write_at("incidents", 0, &first_incidents(bodies, trees))
}

/// The nodes of all trees, which know their roots.
fn rooted(trees: &Trees) -> Vec<Node> {
    let mut nodes = trees.nodes.clone();
    for tree in &trees.trees {
        for node in &mut nodes[tree.clone()] {
            node.root = tree.start as u32;
        }
    }
    nodes
}

/// The beginnings of the lists of all bodies: the limits and loops that end there.
fn first_incidents(bodies: usize, trees: &Trees) -> Vec<u32> {
    let mut incidents = vec![0; bodies];
    for row in 0..bodies {
        for (k, entry) in ends_at(trees, row).enumerate() {
            let at = (k + 1) * bodies + row;
            incidents.resize(incidents.len().max((k + 2) * bodies), 0);
            incidents[at] = entry;
            incidents[row] = k as u32 + 1;
        }
    }
    incidents
}

/// By body: its node, or its row among those on a fixed point.
fn seats_of(bodies: usize, forces: &Forces, trees: &Trees) -> Vec<u32> {
    let mut seats = vec![NONE; bodies];
    for (seat, node) in trees.nodes.iter().enumerate() {
        if let Some(row) = node.row() {
            seats[row] = seat as u32;
        }
    }
    for (seat, pivot) in forces.pivots.iter().enumerate() {
        seats[pivot.body] = seat as u32;
    }
    seats
}

/// Nothing holds any body, and each turns as it does.
///
/// # Errors
/// A lost device.
pub fn write_momenta(columns: &mut Columns, bodies: &Bodies) -> Result<(), StreamError> {
    let holding = |&momentum: &Vec3| Holding {
        momentum,
        ..Holding::default()
    };
    let holdings: Vec<Holding> = bodies.momentum.iter().map(holding).collect();
    columns.write("holdings", &holdings)
}

fn pivot_of(pivot: &crate::lanes::forces::Pivot) -> Pivot {
    Pivot {
        point: pivot.point,
        mass: pivot.mass,
        arm: pivot.arm,
        body: pivot.body as u32,
    }
}

/// By body: the rows of those that joints connect it to, in order.
fn ignored_lists(scene: &Scene, bodies: usize) -> Vec<Vec<u32>> {
    let mut lists = vec![Vec::new(); bodies];
    for joint in &scene.joints {
        let (a, b) = joint.bodies();
        lists[a].push(b as u32);
        lists[b].push(a as u32);
    }
    for list in &mut lists {
        list.sort_unstable();
        list.dedup();
    }
    lists
}

fn role_of(bodies: &Bodies, plan: &Plan, row: usize, is_aside: bool) -> u32 {
    if is_aside {
        return ON_POINT;
    }
    if bodies.place[row].reach > plan.largest_in_grid {
        LARGE
    } else {
        IN_GRID
    }
}

/// A body's row, as far as it follows from the body alone.
fn rigid_of(bodies: &Bodies, row: usize) -> Rigid {
    let (place, motion, spin) = (&bodies.place[row], &bodies.motion[row], &bodies.spin[row]);
    let (solid, material) = (&bodies.solid[row], &bodies.material[row]);
    Rigid {
        position: place.position,
        reach: place.reach,
        attitude: bodies.attitude[row],
        velocity: motion.velocity,
        shares: 1.0,
        angular_velocity: spin.angular_velocity,
        inverse_mass: spin.inverse_mass,
        inverse_inertia: solid.inverse_inertia,
        kind: solid.kind,
        size: solid.size,
        restitution: material.restitution,
        friction: material.friction,
        static_friction: material.static_friction,
        ..Rigid::default()
    }
}

/// Makes more room.
///
/// # Errors
/// [`StreamError::TooLarge`], [`StreamError::OutOfMemory`].
pub fn grow(
    columns: &mut Columns,
    grid: &GridOf,
    plan: &Plan,
    room: Room,
) -> Result<(), StreamError> {
    let rows = grid.capacity as usize;
    for name in ["partners_a", "partners_b"] {
        columns.reserve(name, (room.partners + 1) * rows)?;
    }
    columns.reserve("incidents", (room.partners + plan.joints.ends + 2) * rows)?;
    for name in ["memories_a", "memories_b", "touches", "live"] {
        columns.reserve(name, room.pairs)?;
    }
    columns.reserve("presses", plan.joints.loops + room.pairs)?;
    columns.reserve("large_pairs", room.large_pairs)
}
