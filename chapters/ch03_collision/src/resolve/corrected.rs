//! Resolution with the errata mended: every contact looks at what its neighbours did, sweep
//! after sweep. Report 8.4; friction is the section it left open.
//!
//! Three things happen: overlapping bodies are pushed apart, fast ones bounce as if they had met at
//! the surface, and what then still approaches is stopped and rubs. Only the first could add
//! energy, by lifting bodies out of obstacles, and their speed pays for that.

use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;

use super::constraint::Constraint;
use super::{LONGEST_SHIFT, Links, Rules, Span};
use crate::Contact;

/// A nudge that isn't worth another sweep, m.
pub const SMALL_NUDGE: f32 = 1e-6;

/// A nudge that is worth more sweeps than usual, m.
pub const FAR_NUDGE: f32 = 0.005;

// ANCHOR: resolve
/// Resolves all contacts, and the links, together. Returns how many impacts were left when the sweeps
/// ended; the resting contact then stops those bodies without a bounce.
pub fn resolve_corrected(
    bodies: &[Shared<RigidBody>],
    contacts: &mut [Contact],
    links: &mut impl Links,
    rules: Rules,
    span: Span,
) -> usize {
    let involved = involved(bodies.len(), contacts, links);
    for &i in &involved {
        bodies[i].borrow_mut().begin_resolving();
    }
    let mut constraints = prepare(bodies, contacts, rules, span);
    links.prepare(span);
    push_apart(bodies, &involved, &mut constraints, links, rules);
    for pair in constraints.chunk_by(Constraint::is_of_same_pair) {
        Constraint::pay_for_lift(pair, bodies);
    }
    let left = bounce(bodies, &mut constraints, rules);
    for &i in &involved {
        bodies[i].borrow_mut().begin_resting();
    }
    rest(bodies, &mut constraints, links, rules);
    for &i in &involved {
        bodies[i].borrow_mut().end_resolving();
    }
    links.finish();
    report(contacts, &constraints);
    left
}
// ANCHOR_END: resolve

/// The bodies that appear in a contact or a link, each once, in order.
fn involved(count: usize, contacts: &[Contact], links: &impl Links) -> Vec<usize> {
    let mut involved = vec![false; count];
    for contact in contacts {
        involved[contact.a] = true;
        involved[contact.b] = true;
    }
    links.each_body(|i| involved[i] = true);
    (0..count).filter(|&i| involved[i]).collect()
}

/// Works out what stays the same during all sweeps.
fn prepare(
    bodies: &[Shared<RigidBody>],
    contacts: &[Contact],
    rules: Rules,
    span: Span,
) -> Vec<Constraint> {
    contacts
        .iter()
        .map(|contact| {
            let (one, two) = (bodies[contact.a].borrow(), bodies[contact.b].borrow());
            Constraint::new(&one, &two, contact, rules, span)
        })
        .collect()
}

// ANCHOR: push_apart
/// Nudges the bodies until none overlap: each contact moves its two by what is left of its depth,
/// the one that yields more further, until all have had their turns. Velocities stay.
///
/// Where a sweep still nudges bodies far, as when limbs crash into each other, it goes on for longer.
fn push_apart(
    bodies: &[Shared<RigidBody>],
    involved: &[usize],
    constraints: &mut [Constraint],
    links: &mut impl Links,
    rules: Rules,
) {
    for sweep in 1..=3 * rules.sweeps {
        let mut furthest = links.part();
        for c in &mut *constraints {
            furthest = furthest.max(c.part(bodies));
        }
        if furthest < SMALL_NUDGE || (sweep >= rules.sweeps && furthest < FAR_NUDGE) {
            break;
        }
    }
    shorten_shifts(bodies, involved, constraints);
    for c in constraints.iter_mut().filter(|c| c.is_against_static()) {
        c.part(bodies);
    }
}
// ANCHOR_END: push_apart

/// Cuts the shifts of bodies that know of no obstacle near them, so that none is pushed through
/// one. Who is near an obstacle is pushed out of it afterwards, and must not pay for that twice.
fn shorten_shifts(bodies: &[Shared<RigidBody>], involved: &[usize], constraints: &[Constraint]) {
    let mut near_obstacle = vec![false; bodies.len()];
    for c in constraints.iter().filter(|c| c.is_against_static()) {
        near_obstacle[c.a] = true;
        near_obstacle[c.b] = true;
    }
    for &i in involved {
        if !near_obstacle[i] {
            bodies[i].borrow_mut().shorten_shift(LONGEST_SHIFT);
        }
    }
}

// ANCHOR: bounce
/// Impacts, one after the other, until nobody approaches fast: each is a collision of two bodies
/// that leaves them parting with e times the speed they had at the surface.
fn bounce(bodies: &[Shared<RigidBody>], constraints: &mut [Constraint], rules: Rules) -> usize {
    for _ in 0..rules.sweeps {
        let mut impacts = 0;
        for pair in constraints.chunk_by_mut(Constraint::is_of_same_pair) {
            impacts += usize::from(Constraint::impact(pair, bodies, rules));
        }
        if impacts == 0 {
            return 0;
        }
    }
    constraints
        .iter()
        .filter(|c| c.impact_speed(c.relative_velocity(bodies)).is_some())
        .count()
}
// ANCHOR_END: bounce

// ANCHOR: rest
/// Resting contact: supports stop what still approaches, friction stops what slides, links hold what
/// belongs together. All are kept as sums, so that a later sweep can take back what an earlier one
/// gave too much.
fn rest(
    bodies: &[Shared<RigidBody>],
    constraints: &mut [Constraint],
    links: &mut impl Links,
    rules: Rules,
) {
    links.resume();
    for c in &*constraints {
        c.apply(bodies, c.support * c.normal + c.rub);
    }
    for sweep in 0..rules.sweeps {
        let mut changed = links.hold(rules.still);
        for pair in constraints.chunk_by_mut(Constraint::is_of_same_pair) {
            changed |= hold_in_turn(pair, sweep % 2 == 1, bodies, rules);
        }
        if !changed {
            break;
        }
    }
    for c in constraints.iter_mut().filter(|c| c.is_against_static()) {
        c.hold(bodies, rules);
    }
}
// ANCHOR_END: rest

/// Mends the points of a touch. They take turns in going first, or a tower would lean to one side.
fn hold_in_turn(
    pair: &mut [Constraint],
    backwards: bool,
    bodies: &[Shared<RigidBody>],
    rules: Rules,
) -> bool {
    let either = |changed: bool, c: &mut Constraint| changed | c.hold(bodies, rules);
    if backwards {
        pair.iter_mut().rev().fold(false, either)
    } else {
        pair.iter_mut().fold(false, either)
    }
}

/// Writes the impulses into the contacts.
fn report(contacts: &mut [Contact], constraints: &[Constraint]) {
    for (contact, c) in contacts.iter_mut().zip(constraints) {
        contact.impulse = c.impact + c.support * c.normal + c.rub;
        contact.support = c.support;
        contact.rub = c.rub;
    }
}
