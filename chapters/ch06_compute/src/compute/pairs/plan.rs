//! What a scene needs of the kernels for pairs, and nothing more.

use ch00_scenes::{Force, Scene};

use crate::bodies::Bodies;
use crate::grid::{Grid, largest_in_grid};
use crate::lanes::forces::Forces;
use crate::own_row::narrow::{PAIR_KINDS, pair_kind};
use crate::own_row::tree::Trees;
use crate::rows::{
    EULER, GridOf, HINGE, Limit, NONE, Node, OF_LIMIT, PairsOf, Place, Pole, ROD, TWO_RODS,
};
use crate::rules::MARGIN;

/// Edge of a cell, in reaches of the widest body of the grid.
const EDGE: f32 = 2.2;

/// So many cells a body may look ahead and still be found in the grid, in the first step. Then the kernels
/// choose.
pub const CELLS_AHEAD: f32 = 4.0;

/// The most points that a pair of each kind has. Closed forms of balls have one; the others are cut to
/// four.
const MOST_POINTS: [u32; PAIR_KINDS as usize] = [1, 1, 1, 1, 4, 3, 4, 2, 4, 4];

/// How many points the narrow phase finds before it chooses these: a capsule's segment has two ends, and a
/// box may have one point that is deeper.
pub const MOST_SPOTS: [usize; PAIR_KINDS as usize] = [1, 1, 1, 1, 20, 3, 20, 2, 20, 20];

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
    /// Reach beyond which a body is large, m.
    pub largest_in_grid: f32,
    /// The farthest that a body in the grid reaches, m.
    pub widest: f32,
    /// Rows of the large bodies that move, in order.
    pub larges: Vec<u32>,
    /// Joints, and which kinds of them there are.
    pub joints: Jointed,
    /// Whether any body that moves is in no tree.
    pub loose: bool,
    /// Whether any body hangs on a fixed point.
    pub pivots: bool,
    /// How many poles there are. Where there are any, what pulls a body depends on where others are.
    pub poles: usize,
}

/// Joints, and which kinds of them there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Jointed {
    /// Whether there are any.
    pub any: bool,
    /// Hinges of trees.
    pub hinges: usize,
    /// Bodies of trees that hang on rods.
    pub rods: usize,
    /// Angle limits.
    pub limits: usize,
    /// Those of pitch, yaw and roll.
    pub euler: usize,
    /// Joints that close loops.
    pub loops: usize,
    /// The most limits and loops that end at a body.
    pub ends: usize,
}
// ANCHOR_END: plan

impl Jointed {
    fn of(scene: &Scene, trees: &Trees) -> Self {
        let count = |kinds: &[u32]| {
            let nodes = trees.nodes.iter();
            nodes.filter(|node| kinds.contains(&node.kind)).count()
        };
        let is_euler = |limit: &&Limit| limit.kind == EULER;
        let ends = (0..scene.bodies.len()).map(|row| ends_at(trees, row).count());
        Self {
            any: !scene.joints.is_empty(),
            hinges: count(&[HINGE]),
            rods: count(&[ROD, TWO_RODS]),
            limits: trees.limits.len(),
            euler: trees.limits.iter().filter(is_euler).count(),
            loops: trees.loops.len(),
            ends: ends.max().unwrap_or(0),
        }
    }
}

impl Plan {
    /// Of a scene.
    #[must_use]
    pub fn of(scene: &Scene, bodies: &Bodies, forces: &Forces, trees: &Trees) -> Self {
        let mut on_point: Vec<u32> = forces
            .pivots
            .iter()
            .map(|pivot| pivot.body as u32)
            .collect();
        on_point.sort_unstable();
        let moves = |row: &usize| !bodies.is_static(*row);
        let moving: Vec<usize> = (0..bodies.rows()).filter(moves).collect();
        let reach = |row: usize| bodies.place[row].reach;
        let limit = largest_in_grid(moving.iter().map(|&row| reach(row)).collect());
        let kinds = kinds_of(bodies, &on_point);
        let points = kinds.iter().map(|&kind| MOST_POINTS[kind as usize]).max();
        let small = (0..bodies.rows())
            .map(reach)
            .filter(|&reach| reach <= limit);
        let is_large = |row: &u32| reach(*row as usize) > limit && !on_point.contains(row);
        let in_trees = trees.nodes.iter().filter_map(Node::row).count();
        Self {
            points: points.unwrap_or(1),
            kinds,
            bounces: bodies
                .material
                .iter()
                .any(|material| material.restitution > 0.0),
            largest_in_grid: limit,
            widest: small.fold(0.0, f32::max),
            larges: moving
                .iter()
                .map(|&row| row as u32)
                .filter(is_large)
                .collect(),
            joints: Jointed::of(scene, trees),
            loose: moving.len() > in_trees,
            pivots: !forces.pivots.is_empty(),
            poles: poles_of(scene).len(),
        }
    }

    /// Edge of a cell, m.
    fn edge(&self) -> f32 {
        if self.widest > 0.0 {
            EDGE * self.widest
        } else {
            1.0
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
            poles: self.poles as u32,
            before: self.joints.loops as u32,
            limits: self.joints.limits as u32,
            widest: self.widest,
            ..PairsOf::default()
        }
    }

    /// The number of a body among the large ones that move.
    #[must_use]
    pub fn large(&self, row: usize) -> u32 {
        let found = self.larges.binary_search(&(row as u32));
        found.map_or(NONE, |place| place as u32)
    }
}

/// The limits and loops that end at a body, as its list has them: twice the row, one more where the body is
/// b, and a bit for limits.
pub fn ends_at(trees: &Trees, row: usize) -> impl Iterator<Item = u32> {
    let entry = |(row, is_b): (usize, bool)| 2 * row as u32 + u32::from(is_b);
    let limits = trees
        .limit_ends
        .at(row)
        .map(move |end| entry(end) | OF_LIMIT);
    limits.chain(trees.loop_ends.at(row).map(entry))
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
    let small = bodies
        .place
        .iter()
        .filter(|place| place.reach <= plan.largest_in_grid);
    let small: Vec<Place> = small.copied().collect();
    let grid = Grid::with_edge(plan.edge(), &small);
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
        widest: plan.widest,
        ..GridOf::default()
    }
}
