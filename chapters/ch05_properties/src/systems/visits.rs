//! Which visits of a sweep can be left out without changing a bit: a visit whose two bodies haven't
//! changed since it last found nothing to do would find nothing again.

use crate::columns::{AnyTable, Table};
use crate::data::{Contacts, Touch, Touches};

/// Bodies that note which visit last changed them.
pub trait Changes {
    /// The visit that last changed a body.
    fn changed(&self, row: usize) -> u32;

    /// Notes that a visit changed a body. What can't move never changes.
    fn set_changed(&mut self, row: usize, visit: u32);
}

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
        movers: &mut impl Changes,
    ) -> Self {
        for seen in seen {
            seen.fill(0);
        }
        for &row in involved {
            movers.set_changed(row as usize, 1);
        }
        Self { now: 1, every }
    }

    // ANCHOR: visits
    /// Whether one of the two bodies has changed since the visit `seen`.
    #[inline]
    pub fn is_due(&self, seen: u32, a: usize, b: usize, movers: &impl Changes) -> bool {
        self.every || movers.changed(a) > seen || movers.changed(b) > seen
    }

    /// Notes a visit to two bodies, and whether it changed them; gives its number. What changed them looks
    /// at them again in the next sweep.
    #[inline]
    pub fn note(
        &mut self,
        a: usize,
        b: usize,
        has_changed: bool,
        movers: &mut impl Changes,
    ) -> u32 {
        let seen = self.now;
        if has_changed {
            self.now += 1;
            movers.set_changed(a, self.now);
            movers.set_changed(b, self.now);
        }
        seen
    }
    // ANCHOR_END: visits
}

// ANCHOR: list
/// Lists the touches, in the order of their contacts.
pub fn list(contacts: &Contacts, touches: &mut Touches) {
    touches.clear();
    let mut first = 0;
    while first < contacts.rows() {
        let (a, b, end) = run_from(contacts, first);
        touches.push(Touch {
            first: first as u32,
            end: end as u32,
            a,
            b,
            seen: 0,
        });
        first = end;
    }
}
// ANCHOR_END: list

/// The bodies of a contact, and where the run of contacts between the same two ends.
fn run_from(contacts: &Contacts, first: usize) -> (u32, u32, usize) {
    let (a, b) = (contacts.a[first], contacts.b[first]);
    let rows = contacts.rows();
    let other = |&c: &usize| contacts.a[c] != a || contacts.b[c] != b;
    (a, b, (first + 1..rows).find(other).unwrap_or(rows))
}
