//! Bodies that have left their room since the grids were built. They get room anew and are looked for one by
//! one, so that one fast body doesn't cost the others' work.

use super::candidates::Candidates;
use super::level::Row;
use super::{Bound, BroadPhase, Way, bound};
use crate::bodies::Bodies;

/// So many bodies, one of …, may have left their room before all is built anew.
const FEW: usize = 8;

/// The bodies that left, and whom they may touch.
#[derive(Clone, Debug, Default)]
pub struct Leavers {
    /// For how long room was given when the grids were built, s.
    pub time: f32,
    /// Those that left in this step, in order.
    new: Vec<u32>,
    /// All since the grids were built, in order.
    all: Vec<u32>,
    /// Pairs that they are in, in order, the smaller row first.
    added: Vec<[u32; 2]>,
}

impl Leavers {
    /// Takes those that left in this step.
    pub fn hear(&mut self, rows: impl Iterator<Item = u32>) {
        self.new.clear();
        self.new.extend(rows);
    }

    /// All have room again.
    pub fn forget(&mut self) {
        self.all.clear();
        self.added.clear();
    }

    /// Whether it is less work to look for them one by one than to build all anew.
    pub fn are_few(&self, rows: usize, candidates: &Candidates) -> bool {
        FEW * (self.all.len() + self.new.len()) <= rows
            && FEW * self.added.len() <= rows + candidates.count()
    }

    /// Pairs beyond the candidates, in order; some are among these too.
    pub fn added(&self) -> &[[u32; 2]] {
        &self.added
    }
}

// ANCHOR: give_room
/// Gives room to the bodies that left theirs, and looks for whom they may touch: those that have stayed are in the
/// grids, and those that have left before are asked one by one.
pub fn give_room(bodies: &Bodies, broad: &mut BroadPhase) {
    let leavers = &mut broad.leavers;
    if leavers.new.is_empty() {
        return;
    }
    for &row in &leavers.new {
        let (row, time) = (row as usize, leavers.time);
        broad.rooms[row] = bound::roomy(bodies, row, &broad.bounds[row], time);
    }
    leavers.all.extend_from_slice(&leavers.new);
    leavers.all.sort_unstable();
    leavers.all.dedup();
    for &row in &leavers.new {
        let of = |row: u32| Row::of(row, bodies.is_static(row as usize));
        let room: Bound = broad.rooms[row as usize];
        match broad.way {
            Way::Grids => broad.levels.find_all(of(row), &room, &mut leavers.added),
            Way::Tree => broad.tree.find_all(of(row), &room, &mut leavers.added),
        }
        for &other in &leavers.all {
            let idle = of(row).is_static() && of(other).is_static();
            if !idle && room.overlaps(&broad.rooms[other as usize]) {
                leavers.added.push(of(row).with(other));
            }
        }
    }
    leavers.added.sort_unstable();
    leavers.added.dedup();
    let ignored = &broad.ignored;
    leavers
        .added
        .retain(|&[a, b]| a != b && ignored.binary_search(&(a as usize, b as usize)).is_err());
}
// ANCHOR_END: give_room
