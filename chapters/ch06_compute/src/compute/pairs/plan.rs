//! What a scene needs of the kernels for pairs, and nothing more.

use ch00_scenes::{Force, Scene};

use crate::bodies::Bodies;
use crate::grid::{Grid, LARGE, largest_in_grid, margin_of};
use crate::lanes::forces::Forces;
use crate::own_row::narrow::{PAIR_KINDS, pair_kind};
use crate::rows::{GridOf, NONE, PairsOf, Place, Pole};
use crate::rules::MARGIN;

/// A body that is too large for the grid.
pub const TOO_LARGE: u32 = 1;
/// A body that touches nothing.
pub const ASIDE: u32 = 2;

/// The most points that a pair of each kind has. Closed forms of balls have one; the others are cut to
/// four.
const MOST_POINTS: [u32; PAIR_KINDS as usize] = [1, 1, 1, 1, 4, 3, 4, 2, 4, 4];

// ANCHOR: plan
/// What the passes of a scene are specialised by.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    /// The kinds of pairs that it can have, in order.
    pub kinds: Vec<u32>,
    /// The most points of a pair.
    pub points: u32,
    /// Whether anything bounces.
    pub bounces: bool,
    /// Whether any bodies pass through each other.
    pub ignores: bool,
    /// Rows of the large bodies that move, in order.
    pub larges: Vec<u32>,
    /// Reach beyond which a body is large, m.
    pub largest_in_grid: f32,
    /// Whether any body hangs on a fixed point.
    pub pivots: bool,
    /// How many poles there are. Where there are any, what pulls a body depends on where others are.
    pub poles: usize,
}
// ANCHOR_END: plan

impl Plan {
    /// Of a scene.
    #[must_use]
    pub fn of(scene: &Scene, bodies: &Bodies, forces: &Forces) -> Self {
        let mut aside: Vec<u32> = forces
            .pivots
            .iter()
            .map(|pivot| pivot.body as u32)
            .collect();
        aside.sort_unstable();
        let moving: Vec<usize> = (0..bodies.rows())
            .filter(|&row| !bodies.is_static(row))
            .collect();
        let reaches = moving.iter().map(|&row| bodies.place[row].reach).collect();
        let limit = largest_in_grid(reaches);
        let kinds = kinds_of(bodies, &aside);
        let points = kinds.iter().map(|&kind| MOST_POINTS[kind as usize]).max();
        let is_large = |row: &u32| bodies.place[*row as usize].reach > limit;
        let larges = moving.iter().map(|&row| row as u32).filter(is_large);
        Self {
            points: points.unwrap_or(1),
            kinds,
            bounces: bodies
                .material
                .iter()
                .any(|material| material.restitution > 0.0),
            ignores: !scene.joints.is_empty(),
            larges: larges.filter(|row| !aside.contains(row)).collect(),
            largest_in_grid: limit,
            pivots: !forces.pivots.is_empty(),
            poles: poles_of(scene).len(),
        }
    }

    /// Where each kind of pair is listed, four bits a kind: kinds 0 to 7, and the others.
    fn slots(&self) -> [u32; 2] {
        let mut slots = [0; 2];
        for (slot, &kind) in self.kinds.iter().enumerate() {
            slots[kind as usize / 8] |= (slot as u32) << (4 * (kind % 8));
        }
        slots
    }

    /// The uniform that says how pairs are listed.
    #[must_use]
    pub fn pairs_of(&self, room: usize, large_room: usize) -> PairsOf {
        let [low_slots, high_slots] = self.slots();
        PairsOf {
            room: room as u32,
            kinds: self.kinds.len() as u32,
            larges: self.larges.len() as u32,
            large_room: large_room as u32,
            low_slots,
            high_slots,
            fast: 0.25 * margin_of(self.largest_in_grid / LARGE),
            poles: self.poles as u32,
        }
    }

    /// The number of a body among the large ones that move.
    #[must_use]
    pub fn large(&self, row: usize) -> u32 {
        let found = self.larges.binary_search(&(row as u32));
        found.map_or(NONE, |place| place as u32)
    }
}

/// The magnetic poles of a scene.
#[must_use]
pub fn poles_of(scene: &Scene) -> Vec<Pole> {
    let mut all = Vec::new();
    for (index, force) in scene.forces.iter().enumerate() {
        if let Force::Magnets { poles, softening } = force {
            all.extend(poles.iter().map(|pole| Pole {
                place: pole.position.as_vec3(),
                body: pole.body as u32,
                strength: pole.strength as f32,
                softening: *softening as f32,
                force: index as u32,
                spare: 0,
            }));
        }
    }
    all
}

/// The kinds of pairs of which at least one body moves.
fn kinds_of(bodies: &Bodies, aside: &[u32]) -> Vec<u32> {
    let mut moves = [false; 4];
    let mut is_there = [false; 4];
    for row in 0..bodies.rows() {
        if aside.binary_search(&(row as u32)).is_err() {
            let kind = bodies.solid[row].kind as usize;
            is_there[kind] = true;
            moves[kind] |= !bodies.is_static(row);
        }
    }
    let mut kinds = Vec::new();
    for a in (0..4).filter(|&a| moves[a]) {
        for b in (0..4).filter(|&b| is_there[b]) {
            kinds.push(pair_kind(a as u32, b as u32));
        }
    }
    kinds.sort_unstable();
    kinds.dedup();
    kinds
}

/// The grid of a scene's bodies that aren't large.
#[must_use]
pub fn grid_of(bodies: &Bodies, plan: &Plan, room: usize) -> GridOf {
    let is_small = |row: usize| bodies.place[row].reach <= plan.largest_in_grid;
    let grid = Grid::of(&bodies.place, is_small);
    let reaches = bodies.place.iter().map(|place: &Place| place.reach);
    let [slots_x, slots_y, slots_z] = grid.slots;
    GridOf {
        edge: grid.edge,
        slots_x,
        slots_y,
        slots_z,
        rows: bodies.rows() as u32,
        capacity: bodies.rows().max(1) as u32,
        room: room as u32,
        starts: grid.count() as u32 + 2,
        margin: MARGIN,
        most_margin: margin_of(plan.largest_in_grid / LARGE),
        widest: reaches.fold(0.0, f32::max),
        ..GridOf::default()
    }
}
