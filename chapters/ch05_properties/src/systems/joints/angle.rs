//! Angle limits: up to three turns a joint, each bounded, each about the pin. The report's open section,
//! 9.4.

use std::ops::Range;

use ch00_maths::f32::joint::{Lever, lever, turn_response};
use ch03_collision::Span;
use ch04_ragdolls::{Bound, LARGEST_TURN, MOST_ROWS, Row, SMALL_ANGLE};
use glam::{Quat, Vec3};

use super::{Assembly, Ends, Parted, Poses, pin};
use crate::data::{Bodies, Limits, bound_code, bound_of, limits_of};
use crate::systems::movers::Turning;

/// The rows of a limit's turns.
#[inline]
fn turns_of(limit: usize) -> Range<usize> {
    MOST_ROWS * limit..MOST_ROWS * (limit + 1)
}

/// What is limited at these orientations.
fn rows(limits: &Limits, limit: usize, parent: Quat, child: Quat) -> [Row; MOST_ROWS] {
    let axes = [limits.axis_parent[limit], limits.axis_child[limit]];
    limits_of(
        limits.kind[limit],
        axes,
        limits.low[limit],
        limits.high[limit],
    )
    .rows(parent, limits.rest[limit], child)
}

/// How the two turn about their pin by angular impulses along g.
#[inline]
fn lever_at(
    tables: &Assembly<'_>,
    at: Ends,
    mass: impl Fn(usize) -> ch00_maths::f32::impulse::Mass,
    g: Vec3,
) -> Lever {
    let (t1, t2) = tables.arms(at.joint);
    let k_inverse = tables.pins.yielding[at.part];
    lever(&mass(at.parent), t1, &mass(at.child), t2, k_inverse, g)
}

// ANCHOR: correct
/// Turns the two back to their limits where they have passed them since the last step. Says whether
/// they had.
pub(super) fn correct(tables: &Assembly<'_>, at: Ends, poses: &mut Poses<'_>) -> bool {
    let Some(limit) = at.limit else {
        return false;
    };
    let (q1, q2) = (poses.orientation[at.parent], poses.orientation[at.child]);
    let mut moved = false;
    for (turn, row) in turns_of(limit).zip(rows(tables.limits, limit, q1, q2)) {
        let beyond = row.missing(row.room - tables.turns.left[turn]);
        if beyond.abs() < SMALL_ANGLE {
            continue;
        }
        let lever = lever_at(tables, at, |row| poses.mass(row), row.axis);
        let size = beyond / lever.response;
        let (t1, t2) = tables.arms(at.joint);
        poses.displace(at.child, t2, -size * lever.pin, size * lever.turn);
        poses.displace(at.parent, t1, size * lever.pin, -size * lever.turn);
        moved = true;
    }
    moved
}
// ANCHOR_END: correct

/// The same with the report's first-order turn. The report has no formula for this constraint.
pub(super) fn correct_printed(tables: &Assembly<'_>, at: Ends, poses: &mut Poses<'_>) {
    let Some(limit) = at.limit else {
        return;
    };
    let (q1, q2) = (poses.orientation[at.parent], poses.orientation[at.child]);
    for row in rows(tables.limits, limit, q1, q2) {
        let beyond = row.missing(row.room);
        if beyond != 0.0 {
            let (mass_1, mass_2) = (poses.mass(at.parent), poses.mass(at.child));
            let impulse = row.axis * (beyond / turn_response(&mass_1, &mass_2, row.axis));
            poses.displace_printed(at.child, Vec3::ZERO, mass_2.moment(impulse));
            poses.displace_printed(at.parent, Vec3::ZERO, mass_1.moment(-impulse));
        }
    }
}

/// Works out what stays the same while contacts are resolved.
pub(super) fn prepare(
    tables: &mut Assembly<'_>,
    at: Ends,
    bodies: &Bodies,
    movers: &Turning<'_>,
    span: Span,
) {
    let Some(limit) = at.limit else {
        return;
    };
    let (q1, q2) = (bodies.orientation[at.parent], bodies.orientation[at.child]);
    for (turn, row) in turns_of(limit).zip(rows(tables.limits, limit, q1, q2)) {
        let same = bound_of(tables.turns.bound[turn]) == row.bound;
        tables.turns.impulse[turn] *= if same { span.longer } else { 0.0 };
        tables.turns.axis[turn] = row.axis;
        tables.turns.room[turn] = row.room;
        tables.turns.bound[turn] = bound_code(row.bound);
        tables.turns.nudged[turn] = 0.0;
        if row.bound != Bound::Free {
            let lever = lever_at(tables, at, |row| movers.mass(row), row.axis);
            tables.turns.pin[turn] = lever.pin;
            tables.turns.response[turn] = lever.response;
            tables.turns.slack[turn] = row.room.max(0.0) / span.dt;
        }
    }
}

// ANCHOR: part
/// Nudges the two back to their limits, or takes back what others have made superfluous. Gives how far,
/// as the way of a limb of a decimetre, m.
pub(super) fn part(
    tables: &mut Assembly<'_>,
    at: Ends,
    [(_, q1), (_, q2)]: [(Vec3, Quat); 2],
    movers: &mut Turning<'_>,
) -> Parted {
    let Some(limit) = at.limit else {
        return Parted {
            off: 0.0,
            nudged: false,
        };
    };
    let mut furthest = 0.0_f32;
    for (turn, row) in turns_of(limit).zip(rows(tables.limits, limit, q1, q2)) {
        if row.bound == Bound::Free || row.bound != bound_of(tables.turns.bound[turn]) {
            continue;
        }
        let lever = lever_at(tables, at, |row| movers.mass(row), row.axis);
        let beyond = -row.room.clamp(-LARGEST_TURN, LARGEST_TURN);
        let before = tables.turns.nudged[turn];
        let nudged = row.bound.accumulated(before, beyond / lever.response);
        let change = nudged - before;
        let turned = (change * lever.response).abs();
        if turned >= SMALL_ANGLE {
            tables.turns.nudged[turn] = nudged;
            let (t1, t2) = tables.arms(at.joint);
            movers.nudge_turn(at.child, change * lever.turn);
            movers.nudge_turn(at.parent, -change * lever.turn);
            movers.nudge(at.parent, t1, change * lever.pin);
            movers.nudge(at.child, t2, -change * lever.pin);
            furthest = furthest.max(0.1 * turned);
        }
    }
    Parted {
        off: furthest,
        nudged: furthest != 0.0,
    }
}
// ANCHOR_END: part

/// Begins with what held them in the last step. The pin's own impulse remembers its share.
pub(super) fn resume(tables: &Assembly<'_>, at: Ends, movers: &mut Turning<'_>) {
    for turn in at.limit.into_iter().flat_map(turns_of) {
        let (impulse, axis) = (tables.turns.impulse[turn], tables.turns.axis[turn]);
        if impulse != 0.0 {
            movers.twist(at.child, impulse * axis);
            movers.twist(at.parent, -impulse * axis);
        }
    }
}

// ANCHOR: hold
/// Keeps the two from turning past a limit within the next step. Says whether a rate was off by more
/// than ten times `still`, rad/s: on a limb of a decimetre that is `still`, m/s.
pub(super) fn hold(
    tables: &mut Assembly<'_>,
    at: Ends,
    movers: &mut Turning<'_>,
    still: f32,
) -> bool {
    let mut off = false;
    for turn in at.limit.into_iter().flat_map(turns_of) {
        let bound = bound_of(tables.turns.bound[turn]);
        if bound == Bound::Free {
            continue;
        }
        let axis = tables.turns.axis[turn];
        let (before, response) = (tables.turns.impulse[turn], tables.turns.response[turn]);
        let rate = axis.dot(movers.spin[at.child] - movers.spin[at.parent]);
        let impulse = bound.held(before, rate, tables.turns.slack[turn], response);
        let change = impulse - before;
        tables.turns.impulse[turn] = impulse;
        if change != 0.0 {
            movers.twist(at.child, change * axis);
            movers.twist(at.parent, -change * axis);
            let at_pin = change * tables.turns.pin[turn];
            pin::push(tables, at, movers, at_pin);
            tables.pins.impulse[at.part] += at_pin;
            off |= (change * response).abs() > 10.0 * still;
        }
    }
    off
}
// ANCHOR_END: hold

/// Notes how far beyond their limits the two are left.
pub(super) fn finish(tables: &mut Assembly<'_>, at: Ends, bodies: &Bodies) {
    let Some(limit) = at.limit else {
        return;
    };
    let (q1, q2) = (bodies.orientation[at.parent], bodies.orientation[at.child]);
    for (turn, row) in turns_of(limit).zip(rows(tables.limits, limit, q1, q2)) {
        tables.turns.left[turn] = -row.missing(row.room);
    }
}
