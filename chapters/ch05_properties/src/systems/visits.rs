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
}

impl Visits {
    /// Before the first visit: everything has just changed, nothing has been looked at.
    pub fn begin(involved: &[u32], seen: [&mut [u32]; 2], movers: &mut impl Movers) -> Self {
        for seen in seen {
            seen.fill(0);
        }
        for &row in involved {
            movers.set_changed(row as usize, 1);
        }
        Self { now: 1 }
    }

    /// Whether one of the two bodies has changed since the visit `seen`.
    #[inline]
    pub fn is_due(seen: u32, a: usize, b: usize, movers: &impl Movers) -> bool {
        movers.changed(a) > seen || movers.changed(b) > seen
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
pub fn order(
    contacts: &Contacts,
    inverse_mass: &[f32],
    touches: &mut Touches,
    scratch: &mut Order,
) {
    let Order {
        found,
        free_at,
        starts,
    } = scratch;
    found.clear();
    free_at.clear();
    free_at.resize(inverse_mass.len(), 0);
    starts.clear();
    starts.push(0);
    let rows = contacts.rows();
    let mut first = 0;
    while first < rows {
        let (a, b) = (contacts.a[first], contacts.b[first]);
        let same = |c: usize| contacts.a[c] == a && contacts.b[c] == b;
        let end = (first + 1..rows).find(|&c| !same(c)).unwrap_or(rows);
        let free = |row: u32| match inverse_mass[row as usize] {
            0.0 => 0,
            _ => free_at[row as usize],
        };
        let level = free(a).max(free(b));
        free_at[a as usize] = level + 1;
        free_at[b as usize] = level + 1;
        starts.resize(starts.len().max(level as usize + 2), 0);
        starts[level as usize + 1] += 1;
        found.push(Touch {
            first: first as u32,
            end: end as u32,
            a,
            b,
            level,
            seen: 0,
        });
        first = end;
    }
    sort_by_level(found, starts, touches);
}
// ANCHOR_END: order

/// Memory of [`order`].
#[derive(Clone, Debug, Default)]
pub struct Order {
    found: Vec<Touch>,
    free_at: Vec<u32>,
    starts: Vec<u32>,
}

/// A counting sort: `starts[level + 1]` holds how many touches a level has.
fn sort_by_level(found: &[Touch], starts: &mut [u32], touches: &mut Touches) {
    for level in 1..starts.len() {
        starts[level] += starts[level - 1];
    }
    touches.clear();
    touches.resize(found.len());
    for touch in found {
        let place = &mut starts[touch.level as usize];
        touches.set(*place as usize, *touch);
        *place += 1;
    }
}
