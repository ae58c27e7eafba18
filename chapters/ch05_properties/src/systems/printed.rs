//! The report's `resolveCollisions` as printed, over columns: one visit a contact, no friction. 8.4.

use ch00_maths::f32::impulse::{self, Velocity, mixed_restitution};

use super::or_zero;
use super::resolving::inertia_in_world;
use super::velocities::{moved, write_printed};
use crate::columns::AnyTable;
use crate::data::{Bodies, Contacts};

// ANCHOR: printed
/// Resolves every contact once, in order.
pub fn resolve(bodies: &mut Bodies, contacts: &mut Contacts, dt_last: f32) {
    let rows = contacts.rows();
    contacts.impact.fill_rows(rows, glam::Vec3::ZERO);
    for c in 0..rows {
        let pair = [contacts.a[c] as usize, contacts.b[c] as usize];
        let [mut one, mut two] = pair.map(|row| velocity(bodies, row, dt_last));
        let [mass_1, mass_2] = pair.map(|row| inertia_in_world(bodies, row));
        let [r1, r2] = pair.map(|row| contacts.point[c] - bodies.position[row]);
        let n = contacts.normal[c];
        let approach = impulse::printed::relative_velocity(one, r1, two).dot(n);
        let (s1, s2) = impulse::printed::shares(&mass_1, &mass_2);
        if approach < 0.0 {
            let response = impulse::response(&mass_1, r1, &mass_2, r2, n);
            let [e1, e2] = pair.map(|row| or_zero(&bodies.restitution, row));
            let j = impulse::magnitude(approach, mixed_restitution(e1, e2), response);
            one = impulse::applied(one, &mass_1, r1, s1 * j * n);
            two = impulse::applied(two, &mass_2, r2, -s2 * j * n);
            if let Some(impact) = contacts.impact.get_mut(c) {
                *impact = s1 * j * n;
            }
        }
        for (row, share, velocity) in [(pair[0], s1, one), (pair[1], -s2, two)] {
            bodies.position[row] += share * contacts.depth[c] * n;
            write_printed(bodies, row, velocity, dt_last);
        }
    }
}
// ANCHOR_END: printed

/// What can't move has none.
fn velocity(bodies: &Bodies, row: usize, dt_last: f32) -> Velocity {
    if bodies.inverse_mass[row] == 0.0 {
        Velocity::default()
    } else {
        moved(bodies, row, dt_last)
    }
}
