//! Resolution with the errata mended: every contact looks at what its neighbours did, sweep
//! after sweep. Report 8.4; friction is the section it left open.
//!
//! Three things happen: overlapping bodies are pushed apart, fast ones bounce as if they had met at
//! the surface, and what then still approaches is stopped and rubs. Only the first could add
//! energy, by lifting bodies out of obstacles, and their speed pays for that.

use ch00_maths::f32::impulse::coulomb;
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use super::constraint::Constraint;
use super::{LONGEST_SHIFT, Rules};
use crate::Contact;

// ANCHOR: resolve
/// Resolves all contacts together. Returns how many impacts were left when the sweeps ended; the
/// resting contact then stops those bodies without a bounce.
pub fn resolve_corrected(
    bodies: &[Shared<RigidBody>],
    contacts: &mut [Contact],
    rules: Rules,
    dt: f32,
) -> usize {
    begin(bodies, contacts);
    let mut constraints = prepare(bodies, contacts, rules, dt);
    let shifts = push_apart(bodies.len(), &mut constraints, rules);
    for c in &constraints {
        c.pay_for_lift(bodies);
    }
    let left = bounce(bodies, &mut constraints, rules);
    rest(bodies, &mut constraints, rules);
    end(bodies, contacts, &constraints, &shifts);
    left
}
// ANCHOR_END: resolve

/// Reads the velocities of all bodies that touch something.
fn begin(bodies: &[Shared<RigidBody>], contacts: &[Contact]) {
    for i in touching(bodies.len(), contacts) {
        bodies[i].borrow_mut().begin_resolving();
    }
}

/// The bodies that appear in a contact, each once, in order.
fn touching(count: usize, contacts: &[Contact]) -> impl Iterator<Item = usize> {
    let mut touches = vec![false; count];
    for contact in contacts {
        touches[contact.a] = true;
        touches[contact.b] = true;
    }
    (0..count).filter(move |&i| touches[i])
}

/// Works out what stays the same during all sweeps.
fn prepare(
    bodies: &[Shared<RigidBody>],
    contacts: &[Contact],
    rules: Rules,
    dt: f32,
) -> Vec<Constraint> {
    contacts
        .iter()
        .map(|contact| {
            let (one, two) = (bodies[contact.a].borrow(), bodies[contact.b].borrow());
            Constraint::new(&one, &two, contact, rules, dt)
        })
        .collect()
}

// ANCHOR: push_apart
/// Finds shifts, m, that part the bodies: each contact moves its two by what is left of its
/// depth, the lighter more, until all have had their turns. Velocities stay.
fn push_apart(count: usize, constraints: &mut [Constraint], rules: Rules) -> Vec<Vec3> {
    let mut shifts = vec![Vec3::ZERO; count];
    for _ in 0..rules.sweeps {
        let mut moved = false;
        for c in &mut *constraints {
            moved |= c.part(&mut shifts);
        }
        if !moved {
            break;
        }
    }
    shorten_shifts(&mut shifts, constraints);
    for c in constraints.iter_mut().filter(|c| c.is_against_static()) {
        c.part(&mut shifts);
    }
    shifts
}
// ANCHOR_END: push_apart

/// Cuts the shifts of bodies that know of no obstacle near them, so that none is pushed through
/// one. Who is near an obstacle is pushed out of it afterwards, and must not pay for that twice.
fn shorten_shifts(shifts: &mut [Vec3], constraints: &[Constraint]) {
    let mut near_obstacle = vec![false; shifts.len()];
    for c in constraints.iter().filter(|c| c.is_against_static()) {
        near_obstacle[c.a] = true;
        near_obstacle[c.b] = true;
    }
    for (shift, _) in shifts
        .iter_mut()
        .zip(&near_obstacle)
        .filter(|(_, near)| !**near)
    {
        *shift = shift.clamp_length_max(LONGEST_SHIFT);
    }
}

// ANCHOR: bounce
/// Impacts, one after the other, until nobody approaches fast: each is a collision of two bodies
/// that leaves them parting with e times the speed they had at the surface.
fn bounce(bodies: &[Shared<RigidBody>], constraints: &mut [Constraint], rules: Rules) -> usize {
    for _ in 0..rules.sweeps {
        let mut impacts = 0;
        for c in &mut *constraints {
            let v_r = c.relative_velocity(bodies);
            let Some(speed) = c.impact_speed(v_r, rules) else {
                continue;
            };
            let approach = v_r.dot(c.normal);
            let normal = (c.restitution * speed - approach) / c.response;
            let wanted = -(v_r - approach * c.normal) / c.response_across;
            let friction = coulomb(wanted, normal, c.static_friction, c.friction);
            c.apply(bodies, normal * c.normal + friction);
            c.impact += normal * c.normal + friction;
            impacts += 1;
        }
        if impacts == 0 {
            return 0;
        }
    }
    constraints
        .iter()
        .filter(|c| c.impact_speed(c.relative_velocity(bodies), rules).is_some())
        .count()
}
// ANCHOR_END: bounce

// ANCHOR: rest
/// Resting contact: supports stop what still approaches, friction stops what slides. Both are
/// kept as sums, so that a later sweep can take back what an earlier one gave too much.
fn rest(bodies: &[Shared<RigidBody>], constraints: &mut [Constraint], rules: Rules) {
    for c in &*constraints {
        c.apply(bodies, c.support * c.normal + c.rub);
    }
    for _ in 0..rules.sweeps {
        for c in &mut *constraints {
            c.hold(bodies, rules);
        }
    }
    for c in constraints.iter_mut().filter(|c| c.is_against_static()) {
        c.hold(bodies, rules);
    }
}
// ANCHOR_END: rest

/// Writes shifts and velocities into the bodies, and impulses into the contacts.
fn end(
    bodies: &[Shared<RigidBody>],
    contacts: &mut [Contact],
    constraints: &[Constraint],
    shifts: &[Vec3],
) {
    for i in touching(bodies.len(), contacts) {
        bodies[i].borrow_mut().end_resolving(shifts[i]);
    }
    for (contact, c) in contacts.iter_mut().zip(constraints) {
        contact.impulse = c.impact + c.support * c.normal + c.rub;
        contact.support = c.support;
        contact.rub = c.rub;
    }
}
