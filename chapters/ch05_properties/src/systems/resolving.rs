//! The resolution of contacts and joints together: push apart, pay, bounce, rest. Chapter 3's order,
//! chapter 3's ends of the sweeps.

use ch00_maths::f32::impulse::{Inertia, Mass, Velocity};
use ch00_maths::f32::{rotation, spin};
use ch03_collision::{FAR_NUDGE, LONGEST_SHIFT, Rules, SMALL_NUDGE};
use glam::Vec3;

use super::contacts::{self, Mended, Run};
use super::joints::Held;
use super::movers::{Movers, Turning};
use super::visits::Visits;
use super::{Pull, or_zero};
use crate::columns::AnyTable;
use crate::data::{Bodies, Contacts, Joints, Motions, Touches};

// ANCHOR: involved
/// The bodies that appear in a contact or a joint, each once, in order.
pub fn involved(rows: usize, contacts: &Contacts, joints: &Joints, found: &mut Vec<u32>) {
    let mut is_in = vec![false; rows];
    let ends = [&contacts.a, &contacts.b, &joints.parent, &joints.child];
    for &row in ends.into_iter().flat_map(|column| column.iter()) {
        is_in[row as usize] = true;
    }
    found.clear();
    found.extend((0..rows as u32).filter(|&row| is_in[row as usize]));
}
// ANCHOR_END: involved

/// Before contacts are resolved: no nudges yet, and I⁻¹ turned to where the body is now.
pub fn weigh(
    involved: &[u32],
    bodies: &Bodies,
    Motions {
        shift,
        turn,
        inverse_inertia,
        inverse_moment,
        ..
    }: &mut Motions,
) {
    for row in involved.iter().map(|&row| row as usize) {
        shift[row] = Vec3::ZERO;
        if let Some(turn) = turn.get_mut(row) {
            *turn = Vec3::ZERO;
        }
        if let Some(inverse_inertia) = inverse_inertia.get_mut(row) {
            *inverse_inertia = inertia_in_world(bodies, row).inverse_inertia;
        }
        if let Some(inverse_moment) = inverse_moment.get_mut(row) {
            *inverse_moment = bodies.inverse_inertia[row].x;
        }
    }
}

/// How a body that is turned as it is answers to impulses.
#[must_use]
pub fn inertia_in_world(bodies: &Bodies, row: usize) -> Mass {
    let (w, i_inverse) = (bodies.inverse_mass[row], bodies.inverse_inertia[row]);
    Mass::new(w, i_inverse, bodies.orientation[row])
}

// ANCHOR: push_apart
/// Nudges bodies until none overlap and all joints are closed. Velocities stay.
///
/// Where a sweep still nudges bodies far, as when limbs crash into each other, it goes on for longer.
/// `every` asks for idle visits too.
pub fn push_apart<M: Movers>(
    contacts: &mut Contacts,
    touches: &mut Touches,
    movers: &mut M,
    joints: &mut impl Held<M>,
    involved: &[u32],
    rules: Rules,
    every: bool,
) {
    let mut visits = Visits::begin(every, involved, [&mut touches.seen, joints.seen()], movers);
    for sweep in 1..=3 * rules.sweeps {
        let mut furthest = joints.part(movers, &mut visits);
        for touch in 0..touches.rows() {
            furthest = furthest.max(part(contacts, touches, touch, movers, &mut visits));
        }
        if furthest < SMALL_NUDGE || (sweep >= rules.sweeps && furthest < FAR_NUDGE) {
            break;
        }
    }
    let mut against = Vec::new();
    contacts::against_static(contacts, movers, &mut against);
    shorten_shifts(contacts, &against, movers, involved);
    for &c in &against {
        contacts::part(contacts, c, movers);
    }
}

// ANCHOR_END: push_apart

// ANCHOR: due
/// Nudges the two bodies of a touch apart, if they have been nudged since its last visit; gives how far,
/// m.
#[inline]
fn part<M: Movers>(
    contacts: &mut Contacts,
    touches: &mut Touches,
    touch: usize,
    movers: &mut M,
    visits: &mut Visits,
) -> f32 {
    let Run { first, end, a, b } = contacts::run(touches, touch);
    let mut furthest = 0.0_f32;
    if visits.is_due(touches.seen[touch], a, b, movers) {
        for c in first..end {
            furthest = furthest.max(contacts::part(contacts, c, movers));
        }
        touches.seen[touch] = visits.note(a, b, furthest != 0.0, movers);
    }
    furthest
}
// ANCHOR_END: due

/// Cuts the shifts of bodies that know of no obstacle near them, so that none is pushed through one.
fn shorten_shifts(
    contacts: &Contacts,
    against: &[usize],
    movers: &mut impl Movers,
    involved: &[u32],
) {
    let last = involved.last().map_or(0, |&row| row as usize + 1);
    let mut near_obstacle = vec![false; last];
    for &c in against {
        near_obstacle[contacts.a[c] as usize] = true;
        near_obstacle[contacts.b[c] as usize] = true;
    }
    for row in involved.iter().map(|&row| row as usize) {
        if !near_obstacle[row] {
            movers.shorten_shift(row, LONGEST_SHIFT);
        }
    }
}

/// What is lifted out of an obstacle pays for it with speed.
pub fn pay_for_lifts(contacts: &Contacts, touches: &Touches, movers: &mut impl Movers) {
    for touch in 0..touches.rows() {
        let run = contacts::run(touches, touch);
        let mut pair = movers.moving_pair(run.a, run.b);
        contacts::pay_for_lift(contacts, run, &mut pair);
        movers.set_moving_pair(run.a, run.b, &pair);
    }
}

// ANCHOR: bounce
/// Impacts, one after the other, until nobody approaches fast. Gives how many were left.
pub fn bounce(
    contacts: &mut Contacts,
    touches: &mut Touches,
    movers: &mut impl Movers,
    involved: &[u32],
    rules: Rules,
    every: bool,
) -> usize {
    let mut visits = Visits::begin(every, involved, [&mut touches.seen, &mut []], movers);
    for _ in 0..rules.sweeps {
        let mut impacts = 0;
        for touch in 0..touches.rows() {
            let run = contacts::run(touches, touch);
            if !visits.is_due(touches.seen[touch], run.a, run.b, movers) {
                continue;
            }
            let mut pair = movers.moving_pair(run.a, run.b);
            let hit = contacts::impact(contacts, run, &mut pair, rules);
            if hit {
                movers.set_moving_pair(run.a, run.b, &pair);
                impacts += 1;
            }
            touches.seen[touch] = visits.note(run.a, run.b, hit, movers);
        }
        if impacts == 0 {
            return 0;
        }
    }
    contacts::impacts_left(contacts, movers)
}
// ANCHOR_END: bounce

/// From now on velocities are those in the middle of the coming step. What they were is noted in the
/// columns of what held the bodies.
pub fn begin_resting(
    involved: &[u32],
    bodies: &mut Bodies,
    Motions {
        velocity,
        spin,
        inverse_inertia,
        inverse_moment,
        spin_kick,
        ..
    }: &mut Motions,
    gravity: Option<Vec3>,
    dt_last: f32,
) {
    let half = 0.5 * dt_last;
    for row in involved.iter().map(|&row| row as usize) {
        bodies.held_velocity[row] = velocity[row];
        let pull = Pull::of(gravity, &bodies.acceleration).on(row, bodies.inverse_mass[row]);
        velocity[row] += half * pull;
        if let Some(spin) = spin.get_mut(row) {
            bodies.held_spin[row] = *spin;
            let (q, i) = (bodies.orientation[row], bodies.inertia[row]);
            let torque = or_zero(&bodies.torque, row);
            let kick = spin::half_kick(q, i, *spin, torque, dt_last);
            let kick = match inverse_moment.get(row) {
                Some(inverse_moment) => inverse_moment.moment(kick),
                None => inverse_inertia[row].moment(kick),
            };
            spin_kick[row] = kick;
            *spin += kick;
        }
    }
}

/// What held a body in the last step is over.
pub fn let_go(bodies: &mut Bodies, row: usize) {
    for column in [&mut bodies.held_velocity, &mut bodies.held_spin] {
        if let Some(held) = column.get_mut(row) {
            *held = Vec3::ZERO;
        }
    }
}

// ANCHOR: rest
/// Resting contact: supports stop what still approaches, friction stops what slides, joints hold what
/// belongs together. All are kept as sums, so that a later sweep can take back what an earlier one gave.
pub fn rest<M: Movers>(
    contacts: &mut Contacts,
    touches: &mut Touches,
    movers: &mut M,
    joints: &mut impl Held<M>,
    involved: &[u32],
    rules: Rules,
    every: bool,
) {
    joints.resume(movers);
    for touch in 0..touches.rows() {
        let run = contacts::run(touches, touch);
        let mut pair = movers.moving_pair(run.a, run.b);
        for c in run.first..run.end {
            contacts::resume(contacts, c, &mut pair);
        }
        movers.set_moving_pair(run.a, run.b, &pair);
    }
    let mut visits = Visits::begin(every, involved, [&mut touches.seen, joints.seen()], movers);
    for sweep in 0..rules.sweeps {
        let mut much = joints.hold(movers, &mut visits, rules.still);
        for touch in 0..touches.rows() {
            let run = contacts::run(touches, touch);
            if visits.is_due(touches.seen[touch], run.a, run.b, movers) {
                let mended = hold_in_turn(contacts, run, sweep % 2 == 1, movers, rules);
                touches.seen[touch] = visits.note(run.a, run.b, mended.anything, movers);
                much |= mended.much;
            }
        }
        if !much {
            break;
        }
    }
    let mut against = Vec::new();
    contacts::against_static(contacts, movers, &mut against);
    for &c in &against {
        hold_in_turn(contacts, contacts::alone(contacts, c), false, movers, rules);
    }
}
// ANCHOR_END: rest

/// Mends the points of a touch. They take turns in going first, or a tower would lean to one side.
#[inline]
fn hold_in_turn(
    contacts: &mut Contacts,
    run: Run,
    backwards: bool,
    movers: &mut impl Movers,
    rules: Rules,
) -> Mended {
    let Run { first, end, a, b } = run;
    let mut pair = movers.moving_pair(a, b);
    let mut all = Mended::default();
    for k in first..end {
        let c = if backwards { end - 1 - (k - first) } else { k };
        let mended = contacts::hold(contacts, c, &mut pair, rules);
        all.anything |= mended.anything;
        all.much |= mended.much;
    }
    if all.anything {
        movers.set_moving_pair(a, b, &pair);
    }
    all
}

// ANCHOR: displace
/// After contacts are resolved: the bodies go where they were nudged to, and what held them is noted.
/// Their velocities are then theirs to write into p* and q*.
pub fn displace(
    involved: &[u32],
    bodies: &mut Bodies,
    Motions {
        velocity,
        spin,
        shift,
        turn,
        spin_kick,
        ..
    }: &mut Motions,
    gravity: Option<Vec3>,
    dt_last: f32,
) {
    let half = 0.5 * dt_last;
    for row in involved.iter().map(|&row| row as usize) {
        let pull = Pull::of(gravity, &bodies.acceleration).on(row, bodies.inverse_mass[row]);
        velocity[row] -= half * pull;
        bodies.held_velocity[row] = velocity[row] - bodies.held_velocity[row];
        bodies.position[row] += shift[row];
        if let Some(spin) = spin.get_mut(row) {
            *spin -= spin_kick[row];
            bodies.held_spin[row] = *spin - bodies.held_spin[row];
            if turn[row] != Vec3::ZERO {
                bodies.orientation[row] = rotation::turned(bodies.orientation[row], turn[row]);
            }
        }
    }
}
// ANCHOR_END: displace

/// The columns of motions and bodies that the resolution with turns works on.
pub fn turning<'a>(bodies: &'a Bodies, motions: &'a mut Motions) -> Turning<'a> {
    Turning {
        velocity: &mut motions.velocity,
        spin: &mut motions.spin,
        shift: &mut motions.shift,
        turn: &mut motions.turn,
        changed: &mut motions.changed,
        inverse_mass: &bodies.inverse_mass,
        inverse_inertia: &motions.inverse_inertia,
    }
}

/// The same where all that moves are balls.
pub fn rolling<'a>(bodies: &'a Bodies, motions: &'a mut Motions) -> Turning<'a, f32> {
    Turning {
        velocity: &mut motions.velocity,
        spin: &mut motions.spin,
        shift: &mut motions.shift,
        turn: &mut motions.turn,
        changed: &mut motions.changed,
        inverse_mass: &bodies.inverse_mass,
        inverse_inertia: &motions.inverse_moment,
    }
}

/// Those that the resolution without turns works on.
pub fn gliding<'a>(bodies: &'a Bodies, motions: &'a mut Motions) -> super::movers::Gliding<'a> {
    super::movers::Gliding {
        velocity: &mut motions.velocity,
        shift: &mut motions.shift,
        changed: &mut motions.changed,
        inverse_mass: &bodies.inverse_mass,
    }
}

/// A body's velocities as far as they are resolved.
#[must_use]
pub fn resolved(motions: &Motions, row: usize) -> Velocity {
    Velocity {
        v: motions.velocity[row],
        omega: or_zero(&motions.spin, row),
    }
}
