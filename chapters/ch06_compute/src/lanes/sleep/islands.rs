//! Islands: bodies that hang together by contacts and joints.

use super::calm::{Calm, TIME};
use crate::bodies::Bodies;

/// Sets of rows that are joined two by two. A set is named by its smallest row, so it is the same set in
/// whatever order they are joined.
#[derive(Clone, Debug, Default)]
pub struct Islands {
    /// By row: a row of the same island that isn't larger; itself if it is the smallest.
    towards: Vec<u32>,
    /// By island: whether something fixed holds it up.
    held: Vec<bool>,
    /// By island: whether one of its bodies moves.
    restless: Vec<bool>,
}

impl Islands {
    /// So many rows, each an island.
    pub fn start(&mut self, rows: usize) {
        self.towards.clear();
        self.towards.extend(0..rows as u32);
        self.held.clear();
        self.held.resize(rows, false);
        self.restless.clear();
        self.restless.resize(rows, false);
    }

    // ANCHOR: islands
    /// The island of a row.
    pub fn of(&mut self, mut row: u32) -> u32 {
        while self.towards[row as usize] != row {
            let next = self.towards[row as usize];
            // Half of the way is cut off for those who come later.
            self.towards[row as usize] = self.towards[next as usize];
            row = next;
        }
        row
    }

    /// Two bodies hang together. What is fixed connects nobody, but holds.
    pub fn join(&mut self, bodies: &Bodies, (a, b): (usize, usize), presses: bool) {
        match [a, b].map(|row| bodies.is_static(row)) {
            [false, false] => {
                let (a, b) = (self.of(a as u32), self.of(b as u32));
                self.towards[a.max(b) as usize] = a.min(b);
            }
            [true, false] => self.held[b] |= presses && bodies.is_fixed(a),
            [false, true] => self.held[a] |= presses && bodies.is_fixed(b),
            [true, true] => {}
        }
    }
    // ANCHOR_END: islands

    /// Tells each island what its bodies are, when all are joined.
    pub fn tell(&mut self, calm: &[Calm]) {
        for (row, calm) in calm.iter().enumerate() {
            let island = self.of(row as u32) as usize;
            self.held[island] |= self.held[row];
            self.restless[island] |= calm.time < TIME;
        }
    }

    /// Whether the island of a row may sleep: something holds it, and all of its bodies have been calm for
    /// long enough.
    pub fn may_sleep(&mut self, row: usize) -> bool {
        let island = self.of(row as u32) as usize;
        self.held[island] && !self.restless[island]
    }
}
