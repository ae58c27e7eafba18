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
use super::movers::Movers;
use super::{Pull, or_zero};
use crate::columns::AnyTable;
use crate::data::{Bodies, Contacts};

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
        let on = |row: usize| pull.on(row, movers.inverse_mass(row));
        let closing = (on(b) - on(a)).dot(n);
        let u = movers.relative_velocity(a, r1, b, r2).dot(n);
        let slowest = contact::slowest_impact(rules.restitution_threshold, closing, span.dt);
        let slop = contact::slop(u, closing, depth, e, slowest, rules.slop);
        contacts.arm_a[c] = r1;
        contacts.arm_b[c] = r2;
        contacts.excess[c] = depth - slop;
        contacts.gap_speed[c] = contact::gap_speed(depth, span.dt);
        contacts.closing[c] = closing;
        contacts.slowest_impact[c] = slowest;
        contacts.response[c] = movers.response(a, r1, b, r2, n);
        contacts.support[c] *= span.longer;
        set(&mut contacts.restitution, c, e);
        if let Some(rub) = contacts.rub.get_mut(c) {
            *rub = contact::sliding(*rub, n) * span.longer;
            let (across_1, across_2) = n.any_orthonormal_pair();
            let across = |u| movers.response(a, r1, b, r2, u);
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

/// v_r at a contact, m/s.
#[inline]
fn relative_velocity(contacts: &Contacts, c: usize, movers: &impl Movers) -> Vec3 {
    let (a, b) = (contacts.a[c] as usize, contacts.b[c] as usize);
    movers.relative_velocity(a, contacts.arm_a[c], b, contacts.arm_b[c])
}

/// The impulse on body 1, N s, and its opposite on body 2.
#[inline]
fn apply(contacts: &Contacts, c: usize, movers: &mut impl Movers, impulse: Vec3) {
    movers.push(contacts.a[c] as usize, contacts.arm_a[c], impulse);
    movers.push(contacts.b[c] as usize, contacts.arm_b[c], -impulse);
}

// ANCHOR: part
/// Nudges two bodies apart by what is left of their depth, or takes back what has become superfluous.
/// Gives how far, m.
#[inline]
pub fn part(contacts: &mut Contacts, c: usize, movers: &mut impl Movers) -> f32 {
    let (a, b) = (contacts.a[c] as usize, contacts.b[c] as usize);
    let (r1, r2) = (contacts.arm_a[c], contacts.arm_b[c]);
    let normal = contacts.normal[c];
    let parted = movers.nudged(a, r1) - movers.nudged(b, r2);
    let left = contacts.excess[c] - normal.dot(parted);
    let pushed = contact::accumulated(contacts.pushed[c], left);
    let change = pushed - contacts.pushed[c];
    if change != 0.0 {
        contacts.pushed[c] = pushed;
        let nudge = normal * (change / contacts.response[c]);
        movers.nudge(a, r1, nudge);
        movers.nudge(b, r2, -nudge);
    }
    change.abs()
}
// ANCHOR_END: part

// ANCHOR: pairs
/// Calls `visit` with the rows of each touch: contacts of the same two bodies stand together.
#[inline]
pub fn each_touch(contacts: &mut Contacts, mut visit: impl FnMut(&mut Contacts, usize, usize)) {
    let rows = contacts.rows();
    let mut first = 0;
    while first < rows {
        let pair = (contacts.a[first], contacts.b[first]);
        let mut end = first + 1;
        while end < rows && (contacts.a[end], contacts.b[end]) == pair {
            end += 1;
        }
        visit(contacts, first, end);
        first = end;
    }
}
// ANCHOR_END: pairs

/// Takes from a body's speed what its lift out of an obstacle costs. Of a touch's contacts the one that
/// lifted furthest pays for all.
pub fn pay_for_lift(contacts: &Contacts, first: usize, end: usize, movers: &mut impl Movers) {
    let further = |&c: &usize, &d: &usize| contacts.pushed[c].total_cmp(&contacts.pushed[d]);
    let Some(c) = (first..end).max_by(further) else {
        return;
    };
    let closing = contacts.closing[c];
    let e = or_zero(&contacts.restitution, c);
    if !is_against_static(contacts, c, movers) || closing <= 0.0 || e == 0.0 {
        return;
    }
    let (a, b) = (contacts.a[c] as usize, contacts.b[c] as usize);
    let (moving, out) = if movers.inverse_mass(a) > 0.0 {
        (a, contacts.normal[c])
    } else {
        (b, -contacts.normal[c])
    };
    let weight = movers.inverse_mass(moving);
    let lift = contacts.pushed[c] * weight / contacts.response[c];
    let v = movers.velocity(moving);
    if let Some(paid) = contact::pay_for_lift(v, out, closing, lift, weight) {
        movers.push(moving, Vec3::ZERO, paid);
    }
}

/// The speed of approach at the surface, m/s, if that is an impact.
#[inline]
fn impact_speed(contacts: &Contacts, c: usize, movers: &impl Movers) -> Option<f32> {
    contact::impact_speed(
        relative_velocity(contacts, c, movers).dot(contacts.normal[c]),
        contacts.gap_speed[c],
        or_zero(&contacts.restitution, c),
        contacts.closing[c],
        contacts.pushed[c],
        contacts.slowest_impact[c],
    )
}

/// How many contacts are still impacts.
pub fn impacts_left(contacts: &Contacts, movers: &impl Movers) -> usize {
    let is_one = |&c: &usize| impact_speed(contacts, c, movers).is_some();
    (0..contacts.rows()).filter(is_one).count()
}

// ANCHOR: impact
/// An impact of two bodies at these contacts: they part with e times the speed that they had at the
/// surface. Says whether it was one.
pub fn impact(
    contacts: &mut Contacts,
    first: usize,
    end: usize,
    movers: &mut impl Movers,
    rules: Rules,
) -> bool {
    let mut hits = [(0, 0.0, 0.0); MOST_SPOTS];
    let mut count = 0;
    for c in first..end {
        if let Some(speed) = impact_speed(contacts, c, movers) {
            hits[count] = (c, or_zero(&contacts.restitution, c) * speed, 0.0);
            count += 1;
        }
    }
    let hits = &mut hits[..count];
    let visits = if count > 1 { rules.sweeps } else { 1 };
    for _ in 0..visits {
        for (c, parting, sum) in &mut *hits {
            let n = contacts.normal[*c];
            let missing = *parting - relative_velocity(contacts, *c, movers).dot(n);
            let normal = contact::accumulated(*sum, missing / contacts.response[*c]);
            give(contacts, *c, movers, (normal - *sum) * n);
            *sum = normal;
        }
    }
    for &(c, _, normal) in &*hits {
        if let Some(&across) = contacts.response_across.get(c) {
            let v_r = relative_velocity(contacts, c, movers);
            let wanted = -contact::sliding(v_r, contacts.normal[c]) / across;
            let (mu_s, mu) = (contacts.static_friction[c], contacts.friction[c]);
            give(contacts, c, movers, coulomb(wanted, normal, mu_s, mu));
        }
    }
    count > 0
}
// ANCHOR_END: impact

/// An impulse that no sweep takes back, N s.
#[inline]
fn give(contacts: &mut Contacts, c: usize, movers: &mut impl Movers, impulse: Vec3) {
    apply(contacts, c, movers, impulse);
    contacts.impact[c] += impulse;
}

/// Begins with what the contact carried in the last step.
#[inline]
pub fn resume(contacts: &Contacts, c: usize, movers: &mut impl Movers) {
    let carried = contacts.support[c] * contacts.normal[c] + or_zero(&contacts.rub, c);
    apply(contacts, c, movers, carried);
}

// ANCHOR: hold
/// Mends the support and then the friction of a contact. Says whether that changed anything worth
/// another sweep.
#[inline]
pub fn hold(contacts: &mut Contacts, c: usize, movers: &mut impl Movers, rules: Rules) -> bool {
    let n = contacts.normal[c];
    let (gap_speed, response) = (contacts.gap_speed[c], contacts.response[c]);
    let u = relative_velocity(contacts, c, movers).dot(n);
    let e = or_zero(&contacts.restitution, c);
    if contact::is_let_come(u, gap_speed, e, contacts.slowest_impact[c]) {
        return false;
    }
    let before = contacts.support[c];
    let support = contact::accumulated(before, -(u + gap_speed) / response);
    if support == 0.0 && before == 0.0 {
        return false;
    }
    let change = support - before;
    apply(contacts, c, movers, change * n);
    contacts.support[c] = support;
    let rubbed = rub(contacts, c, movers, support);
    change.abs() * response > rules.still || rubbed > rules.still
}

/// The friction under this support; gives the change of velocity that it made, m/s.
#[inline]
fn rub(contacts: &mut Contacts, c: usize, movers: &mut impl Movers, support: f32) -> f32 {
    let Some(&across) = contacts.response_across.get(c) else {
        return 0.0;
    };
    let v_r = relative_velocity(contacts, c, movers);
    let wanted = contacts.rub[c] - contact::sliding(v_r, contacts.normal[c]) / across;
    let (mu_s, mu) = (contacts.static_friction[c], contacts.friction[c]);
    let rub = coulomb(wanted, support, mu_s, mu);
    let rubbed = rub - contacts.rub[c];
    apply(contacts, c, movers, rubbed);
    contacts.rub[c] = rub;
    rubbed.length() * across
}
// ANCHOR_END: hold
