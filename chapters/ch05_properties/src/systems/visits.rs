//! Which visits of a sweep can be left out without changing a bit, and in which order the others go.
//!
//! A visit whose two bodies haven't changed since it last found nothing to do would find nothing again.
//! And two visits that share no body that can move may change places.

use super::movers::Movers;
use crate::columns::{AnyTable, Table};
use crate::data::{Contacts, Touch, Touches};

// ANCHOR: visits
/// Numbers the visits of a system's sweeps.
pub struct Visits {
    now: u32,
    /// Whether idle ones are made too.
    every: bool,
}

impl Visits {
    /// Before the first visit: everything has just changed, nothing has been looked at.
    pub fn begin(
        every: bool,
        involved: &[u32],
        seen: [&mut [u32]; 2],
        movers: &mut impl Movers,
    ) -> Self {
        for seen in seen {
            seen.fill(0);
        }
        for &row in involved {
            movers.set_changed(row as usize, 1);
        }
        Self { now: 1, every }
    }

    /// Whether one of the two bodies has changed since the visit `seen`.
    #[inline]
    pub fn is_due(&self, seen: u32, a: usize, b: usize, movers: &impl Movers) -> bool {
        self.every || movers.changed(a) > seen || movers.changed(b) > seen
    }

    /// Notes a visit to two bodies, and whether it changed them; gives its number. What changed them looks
    /// at them again in the next sweep.
    #[inline]
    pub fn note(&mut self, a: usize, b: usize, has_changed: bool, movers: &mut impl Movers) -> u32 {
        let seen = self.now;
        if has_changed {
            self.now += 1;
            movers.set_changed(a, self.now);
            movers.set_changed(b, self.now);
        }
        seen
    }
}
// ANCHOR_END: visits

// ANCHOR: order
/// Lists the touches so that each comes after those before it that share a body which can move, and as
/// early as it can. Neighbours in the list then have nothing to do with each other: a processor works at
/// several at once.
pub fn order(contacts: &Contacts, inverse_mass: &[f32], touches: &mut Touches, order: &mut Order) {
    order.begin(inverse_mass.len());
    let mut first = 0;
    while first < contacts.rows() {
        let (a, b, end) = run_from(contacts, first);
        let can_move = |&row: &u32| inverse_mass[row as usize] != 0.0;
        let movers = [a, b].into_iter().filter(can_move);
        let free_at = movers.map(|row| order.free_at[row as usize]);
        let level = free_at.max().unwrap_or(0);
        order.free_at[a as usize] = level + 1;
        order.free_at[b as usize] = level + 1;
        order.add(Touch {
            first: first as u32,
            end: end as u32,
            a,
            b,
            level,
            seen: 0,
        });
        first = end;
    }
    order.sort_by_level(touches);
}
// ANCHOR_END: order

/// Lists the touches in the order of rows, all on one level: chapter 3's order.
pub fn list(contacts: &Contacts, touches: &mut Touches, order: &mut Order) {
    order.begin(0);
    let mut first = 0;
    while first < contacts.rows() {
        let (a, b, end) = run_from(contacts, first);
        order.add(Touch {
            first: first as u32,
            end: end as u32,
            a,
            b,
            ..Touch::default()
        });
        first = end;
    }
    order.sort_by_level(touches);
}

/// The bodies of a contact, and where the run of contacts between the same two ends.
fn run_from(contacts: &Contacts, first: usize) -> (u32, u32, usize) {
    let (a, b) = (contacts.a[first], contacts.b[first]);
    let rows = contacts.rows();
    let other = |&c: &usize| contacts.a[c] != a || contacts.b[c] != b;
    (a, b, (first + 1..rows).find(other).unwrap_or(rows))
}

/// Memory of [`order`].
#[derive(Clone, Debug, Default)]
pub struct Order {
    found: Vec<Touch>,
    /// The first level at which a body is free again.
    free_at: Vec<u32>,
    /// How many touches each level has, one place further; then where it starts.
    starts: Vec<u32>,
}

impl Order {
    fn begin(&mut self, bodies: usize) {
        self.found.clear();
        self.free_at.clear();
        self.free_at.resize(bodies, 0);
        self.starts.clear();
        self.starts.push(0);
    }

    fn add(&mut self, touch: Touch) {
        let place = touch.level as usize + 1;
        if self.starts.len() <= place {
            self.starts.resize(place + 1, 0);
        }
        self.starts[place] += 1;
        self.found.push(touch);
    }

    /// A counting sort.
    fn sort_by_level(&mut self, touches: &mut Touches) {
        for level in 1..self.starts.len() {
            self.starts[level] += self.starts[level - 1];
        }
        touches.resize(self.found.len());
        for touch in &self.found {
            let place = &mut self.starts[touch.level as usize];
            touches.set(*place as usize, *touch);
            *place += 1;
        }
    }
}
