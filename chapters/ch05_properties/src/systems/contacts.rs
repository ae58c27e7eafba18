//! Contacts while they are resolved: chapter 3's formulas, contact by contact, over the contacts'
//! columns.
//!
//! The order of visits is chapter 3's, since each looks at what the one before it did.

use ch00_maths::f32::contact;
use ch00_maths::f32::impulse::{coulomb, mixed_friction, mixed_restitution};
use ch03_collision::narrow::MOST_SPOTS;
use ch03_collision::{Rules, Span};
use glam::Vec3;

use super::broad_phase::is_ball;
use super::movers::{Movers, Pair};
use super::{Pull, or_zero};
use crate::columns::AnyTable;
use crate::data::{Bodies, Contacts, Touches};

// ANCHOR: prepare
/// Works out what stays the same during all sweeps.
pub fn prepare(
    contacts: &mut Contacts,
    bodies: &Bodies,
    movers: &impl Movers,
    pull: Pull<'_>,
    rules: Rules,
    span: Span,
) {
    make_room(contacts);
    for c in 0..contacts.rows() {
        let (a, b) = (contacts.a[c] as usize, contacts.b[c] as usize);
        let n = contacts.normal[c];
        let depth = contacts.depth[c];
        let mixed =
            |column: &[f32], mix: fn(f32, f32) -> f32| mix(or_zero(column, a), or_zero(column, b));
        let static_friction = mixed(&bodies.static_friction, mixed_friction);
        let e = mixed(&bodies.restitution, mixed_restitution);
        let arm = |row: usize| {
            let point = contacts.point[c];
            contact::arm(
                point,
                bodies.position[row],
                is_ball(bodies, row),
                static_friction,
            )
        };
        let (r1, r2) = (arm(a), arm(b));
        let pair = movers.moving_pair(a, b);
        let [w1, w2] = pair.inverse_masses();
        let closing = (pull.on(b, w2) - pull.on(a, w1)).dot(n);
        let u = pair.relative_velocity(r1, r2).dot(n);
        let slowest = contact::slowest_impact(rules.restitution_threshold, closing, span.dt);
        let slop = contact::slop(u, closing, depth, e, slowest, rules.slop);
        contacts.arm_a[c] = r1;
        contacts.arm_b[c] = r2;
        contacts.excess[c] = depth - slop;
        contacts.gap_speed[c] = contact::gap_speed(depth, span.dt);
        contacts.closing[c] = closing;
        contacts.slowest_impact[c] = slowest;
        contacts.response[c] = pair.response(r1, r2, n);
        contacts.support[c] *= span.longer;
        set(&mut contacts.restitution, c, e);
        if let Some(rub) = contacts.rub.get_mut(c) {
            *rub = contact::sliding(*rub, n) * span.longer;
            let (across_1, across_2) = n.any_orthonormal_pair();
            let across = |u| pair.response(r1, r2, u);
            contacts.response_across[c] = across(across_1).max(across(across_2));
            contacts.friction[c] = mixed(&bodies.friction, mixed_friction);
            contacts.static_friction[c] = static_friction;
        }
    }
}
// ANCHOR_END: prepare

/// A value a row in every column that the step makes for itself.
fn make_room(contacts: &mut Contacts) {
    let rows = contacts.rows();
    contacts.arm_a.fill_rows(rows, Vec3::ZERO);
    contacts.arm_b.fill_rows(rows, Vec3::ZERO);
    contacts.impact.fill_rows(rows, Vec3::ZERO);
    for column in [
        &mut contacts.excess,
        &mut contacts.pushed,
        &mut contacts.gap_speed,
        &mut contacts.closing,
        &mut contacts.slowest_impact,
        &mut contacts.response,
        &mut contacts.response_across,
        &mut contacts.restitution,
        &mut contacts.friction,
        &mut contacts.static_friction,
    ] {
        column.fill_rows(rows, 0.0);
    }
}

fn set<T>(column: &mut [T], row: usize, value: T) {
    if let Some(place) = column.get_mut(row) {
        *place = value;
    }
}

/// Whether one of a contact's bodies can't move.
#[inline]
fn is_against_static(contacts: &Contacts, c: usize, movers: &impl Movers) -> bool {
    let still = |row: u32| movers.inverse_mass(row as usize) == 0.0;
    still(contacts.a[c]) || still(contacts.b[c])
}

/// The contacts against what can't move.
pub fn against_static<'a>(
    contacts: &'a Contacts,
    movers: &impl Movers,
    found: &'a mut Vec<usize>,
) -> &'a [usize] {
    found.clear();
    found.extend((0..contacts.rows()).filter(|&c| is_against_static(contacts, c, movers)));
    found
}

/// A run of contacts between two bodies.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// Row of its first contact.
    pub first: usize,
    /// Row after its last contact.
    pub end: usize,
    /// Row of body 1.
    pub a: usize,
    /// Row of body 2.
    pub b: usize,
}

/// A row of the touches.
#[inline]
#[must_use]
pub fn run(touches: &Touches, touch: usize) -> Run {
    Run {
        first: touches.first[touch] as usize,
        end: touches.end[touch] as usize,
        a: touches.a[touch] as usize,
        b: touches.b[touch] as usize,
    }
}

/// One contact alone.
#[inline]
#[must_use]
pub fn alone(contacts: &Contacts, c: usize) -> Run {
    Run {
        first: c,
        end: c + 1,
        a: contacts.a[c] as usize,
        b: contacts.b[c] as usize,
    }
}

/// The contact's arms, r₁ and r₂.
#[inline]
fn arms(contacts: &Contacts, c: usize) -> (Vec3, Vec3) {
    (contacts.arm_a[c], contacts.arm_b[c])
}

// ANCHOR: part
/// Nudges two bodies apart by what is left of their depth, or takes back what has become superfluous.
/// Gives how far, m.
#[inline]
pub fn part(contacts: &mut Contacts, c: usize, movers: &mut impl Movers) -> f32 {
    let (a, b) = (contacts.a[c] as usize, contacts.b[c] as usize);
    let (r1, r2) = arms(contacts, c);
    let normal = contacts.normal[c];
    let left = contacts.excess[c] - normal.dot(movers.nudged_apart(a, r1, b, r2));
    let pushed = contact::accumulated(contacts.pushed[c], left);
    let change = pushed - contacts.pushed[c];
    if change != 0.0 {
        contacts.pushed[c] = pushed;
        movers.nudge_apart(a, r1, b, r2, normal * (change / contacts.response[c]));
    }
    change.abs()
}
// ANCHOR_END: part

/// Takes from a body's speed what its lift out of an obstacle costs. Of a touch's contacts the one that
/// lifted furthest pays for all.
pub fn pay_for_lift(contacts: &Contacts, run: Run, pair: &mut impl Pair) {
    let further = |&c: &usize, &d: &usize| contacts.pushed[c].total_cmp(&contacts.pushed[d]);
    let Some(c) = (run.first..run.end).max_by(further) else {
        return;
    };
    let closing = contacts.closing[c];
    let e = or_zero(&contacts.restitution, c);
    let [w1, w2] = pair.inverse_masses();
    if (w1 != 0.0 && w2 != 0.0) || closing <= 0.0 || e == 0.0 {
        return;
    }
    let (moving, out, weight) = if w1 > 0.0 {
        (0, contacts.normal[c], w1)
    } else {
        (1, -contacts.normal[c], w2)
    };
    let lift = contacts.pushed[c] * weight / contacts.response[c];
    let v = pair.velocity(moving);
    if let Some(paid) = contact::pay_for_lift(v, out, closing, lift, weight) {
        pair.push_one(moving, paid);
    }
}

/// The speed of approach at the surface, m/s, if that is an impact.
#[inline]
fn impact_speed(contacts: &Contacts, c: usize, pair: &impl Pair) -> Option<f32> {
    let (r1, r2) = arms(contacts, c);
    contact::impact_speed(
        pair.relative_velocity(r1, r2).dot(contacts.normal[c]),
        contacts.gap_speed[c],
        or_zero(&contacts.restitution, c),
        contacts.closing[c],
        contacts.pushed[c],
        contacts.slowest_impact[c],
    )
}

/// How many contacts are still impacts.
pub fn impacts_left(contacts: &Contacts, movers: &impl Movers) -> usize {
    let is_one = |&c: &usize| {
        let Run { a, b, .. } = alone(contacts, c);
        impact_speed(contacts, c, &movers.moving_pair(a, b)).is_some()
    };
    (0..contacts.rows()).filter(is_one).count()
}

// ANCHOR: impact
/// An impact of two bodies at these contacts: they part with e times the speed that they had at the
/// surface. Says whether it was one.
pub fn impact(contacts: &mut Contacts, run: Run, pair: &mut impl Pair, rules: Rules) -> bool {
    let mut hits = [(0, 0.0, 0.0); MOST_SPOTS];
    let mut count = 0;
    for c in run.first..run.end {
        if let Some(speed) = impact_speed(contacts, c, pair) {
            hits[count] = (c, or_zero(&contacts.restitution, c) * speed, 0.0);
            count += 1;
        }
    }
    let hits = &mut hits[..count];
    let visits = if count > 1 { rules.sweeps } else { 1 };
    for _ in 0..visits {
        for (c, parting, sum) in &mut *hits {
            let (r1, r2) = arms(contacts, *c);
            let n = contacts.normal[*c];
            let missing = *parting - pair.relative_velocity(r1, r2).dot(n);
            let normal = contact::accumulated(*sum, missing / contacts.response[*c]);
            let impulse = (normal - *sum) * n;
            pair.push(r1, r2, impulse);
            contacts.impact[*c] += impulse;
            *sum = normal;
        }
    }
    for &(c, _, normal) in &*hits {
        if let Some(&across) = contacts.response_across.get(c) {
            let (r1, r2) = arms(contacts, c);
            let sliding = contact::sliding(pair.relative_velocity(r1, r2), contacts.normal[c]);
            let (mu_s, mu) = (contacts.static_friction[c], contacts.friction[c]);
            let friction = coulomb(-sliding / across, normal, mu_s, mu);
            pair.push(r1, r2, friction);
            contacts.impact[c] += friction;
        }
    }
    count > 0
}
// ANCHOR_END: impact

/// Begins with what the contact carried in the last step.
#[inline]
pub fn resume(contacts: &Contacts, c: usize, pair: &mut impl Pair) {
    let (r1, r2) = arms(contacts, c);
    let carried = contacts.support[c] * contacts.normal[c] + or_zero(&contacts.rub, c);
    pair.push(r1, r2, carried);
}

/// What a visit did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mended {
    /// It changed something.
    pub anything: bool,
    /// It changed something by so much that another sweep is worth while.
    pub much: bool,
}

// ANCHOR: hold
/// Mends the support and then the friction of a contact.
#[inline]
pub fn hold(contacts: &mut Contacts, c: usize, pair: &mut impl Pair, rules: Rules) -> Mended {
    let (r1, r2) = arms(contacts, c);
    let n = contacts.normal[c];
    let (gap_speed, response) = (contacts.gap_speed[c], contacts.response[c]);
    let u = pair.relative_velocity(r1, r2).dot(n);
    let e = or_zero(&contacts.restitution, c);
    if contact::is_let_come(u, gap_speed, e, contacts.slowest_impact[c]) {
        return Mended::default();
    }
    let before = contacts.support[c];
    let support = contact::accumulated(before, -(u + gap_speed) / response);
    if support == 0.0 && before == 0.0 {
        return Mended::default();
    }
    let change = support - before;
    pair.push(r1, r2, change * n);
    contacts.support[c] = support;
    let rubbed = rub(contacts, c, pair, support, rules);
    Mended {
        anything: change != 0.0 || rubbed.anything,
        much: change.abs() * response > rules.still || rubbed.much,
    }
}

// ANCHOR_END: hold

/// Mends the friction under this support.
#[inline]
fn rub(
    contacts: &mut Contacts,
    c: usize,
    pair: &mut impl Pair,
    support: f32,
    rules: Rules,
) -> Mended {
    let Some(&across) = contacts.response_across.get(c) else {
        return Mended::default();
    };
    let (r1, r2) = arms(contacts, c);
    let sliding = contact::sliding(pair.relative_velocity(r1, r2), contacts.normal[c]);
    let before = contacts.rub[c];
    let (mu_s, mu) = (contacts.static_friction[c], contacts.friction[c]);
    let rub = coulomb(before - sliding / across, support, mu_s, mu);
    let change = rub - before;
    pair.push(r1, r2, change);
    contacts.rub[c] = rub;
    Mended {
        // Not by its length: the square of a tiny change is 0.
        anything: change != Vec3::ZERO,
        much: change.length() * across > rules.still,
    }
}
