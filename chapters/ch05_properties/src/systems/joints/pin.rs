//! The pin: a point of the parent and a point of the child that stay together. Report 9.3.

use ch00_maths::f32::impulse::Velocity;
use ch00_maths::f32::joint::{self, pin_matrix};
use ch00_maths::f32::pin;
use ch03_collision::Span;
use ch04_ragdolls::{Arms, LONGEST_GAP, SMALL_GAP, WIDE};
use glam::{Quat, Vec3};

use super::{Assembly, Ends, Parted, Poses};
use crate::systems::movers::Turning;

// ANCHOR: correct
/// Closes the gap that has opened since the last step. Says whether there was one.
pub(super) fn correct(tables: &mut Assembly<'_>, at: Ends, poses: &mut Poses<'_>) -> bool {
    let now = tables.arms_at(at.joint, poses.pose(at.parent), poses.pose(at.child));
    let opened = now.d - tables.pins.left[at.part];
    let gap = opened.length();
    if gap < SMALL_GAP {
        return false;
    }
    let (t1, t2) = tables.arms(at.joint);
    if gap > WIDE * (t1.length() + t2.length()) {
        poses.weigh(at.parent);
        poses.weigh(at.child);
        tables.set_arms(at.joint, now);
        let k = pin_matrix(
            &poses.mass(at.parent),
            now.t1,
            &poses.mass(at.child),
            now.t2,
        );
        tables.pins.yielding[at.part] = k.inverse();
    }
    let (t1, t2) = tables.arms(at.joint);
    let d = tables.pins.yielding[at.part] * -opened;
    poses.displace(at.parent, t1, d, Vec3::ZERO);
    poses.displace(at.child, t2, -d, Vec3::ZERO);
    true
}
// ANCHOR_END: correct

/// The report's correction: along the gap, by one number, and with erratum 6 on the child.
pub(super) fn correct_printed(tables: &Assembly<'_>, at: Ends, poses: &mut Poses<'_>) {
    let Arms { t1, t2, d } = tables.arms_at(at.joint, poses.pose(at.parent), poses.pose(at.child));
    let (mass_1, mass_2) = (poses.mass(at.parent), poses.mass(at.child));
    let d = pin::correction(&mass_1, t1, &mass_2, t2, d);
    poses.displace_printed(
        at.parent,
        d * mass_1.inverse_mass,
        mass_1.moment(t1.cross(d)),
    );
    poses.displace_printed(
        at.child,
        -d * mass_2.inverse_mass,
        mass_2.moment(t2).cross(-d),
    );
}

/// Works out what stays the same while contacts are resolved.
pub(super) fn prepare(
    tables: &mut Assembly<'_>,
    at: Ends,
    movers: &Turning<'_>,
    moved: [Velocity; 2],
    span: Span,
) {
    let (t1, t2) = tables.arms(at.joint);
    let k = pin_matrix(&movers.mass(at.parent), t1, &movers.mass(at.child), t2);
    tables.pins.yielding[at.part] = k.inverse();
    tables.pins.impulse[at.part] *= span.longer;
    tables.pins.parted[at.part] = joint::parted(moved[0], t1, moved[1], t2, span.dt);
}

/// Nudges the two points together, from where nudges have brought their bodies; gives how far they were
/// apart, m.
pub(super) fn part(
    tables: &Assembly<'_>,
    at: Ends,
    [parent, child]: [(Vec3, Quat); 2],
    movers: &mut Turning<'_>,
) -> Parted {
    let Arms { t1, t2, d } = tables.arms_at(at.joint, parent, child);
    let gap = d.length();
    if gap >= SMALL_GAP {
        let k = pin_matrix(&movers.mass(at.parent), t1, &movers.mass(at.child), t2);
        let nudge = k.inverse() * -d.clamp_length_max(LONGEST_GAP);
        movers.nudge(at.parent, t1, nudge);
        movers.nudge(at.child, t2, -nudge);
    }
    Parted {
        off: gap,
        nudged: gap >= SMALL_GAP,
    }
}

/// Begins with what held them in the last step.
pub(super) fn resume(tables: &Assembly<'_>, at: Ends, movers: &mut Turning<'_>) {
    push(tables, at, movers, tables.pins.impulse[at.part]);
}

/// An impulse at the pin, N s: on the parent, and its opposite on the child.
#[inline]
pub(super) fn push(tables: &Assembly<'_>, at: Ends, movers: &mut Turning<'_>, impulse: Vec3) {
    let (t1, t2) = tables.arms(at.joint);
    movers.push(at.parent, t1, impulse);
    movers.push(at.child, t2, -impulse);
}

// ANCHOR: hold
/// Lets the two points move alike. Gives by how much they didn't, m/s.
#[inline]
pub(super) fn hold(tables: &mut Assembly<'_>, at: Ends, movers: &mut Turning<'_>) -> f32 {
    let (t1, t2) = tables.arms(at.joint);
    let v_r = movers.relative_velocity(at.parent, t1, at.child, t2);
    let off = v_r + tables.pins.parted[at.part];
    let change = tables.pins.yielding[at.part] * -off;
    push(tables, at, movers, change);
    tables.pins.impulse[at.part] += change;
    off.length()
}
// ANCHOR_END: hold
