//! The rod: a point of the parent and a point of the child that keep their distance. Report 9.2.

use ch00_maths::f32::impulse::{Velocity, relative_velocity, response};
use ch00_maths::f32::joint::distance_correction;
use ch03_collision::Span;
use ch04_ragdolls::{Arms, LONGEST_GAP, SMALL_GAP, WIDE};
use glam::Vec3;

use super::{Assembly, Ends, Jointed, Parted, Poses};
use crate::systems::movers::Turning;

/// Brings the points back to their distance. Says whether they were off.
pub(super) fn correct(tables: &mut Assembly<'_>, at: Ends, poses: &mut Poses<'_>) -> bool {
    let now = tables.arms_at(at.joint, poses.pose(at.parent), poses.pose(at.child));
    let length = tables.rods.length[at.part];
    let off = now.d.length() - length - tables.rods.left[at.part];
    if off.abs() < SMALL_GAP {
        return false;
    }
    if off.abs() > WIDE * length {
        poses.weigh(at.parent);
        poses.weigh(at.child);
        tables.set_arms(at.joint, now);
        let masses = [at.parent, at.child].map(|row| poses.mass(row));
        let along = now.d.normalize_or(Vec3::Y);
        tables.rods.along[at.part] = along;
        tables.rods.response[at.part] = response(&masses[0], now.t1, &masses[1], now.t2, along);
    }
    let (t1, t2) = tables.arms(at.joint);
    let nudge = tables.rods.along[at.part] * (-off / tables.rods.response[at.part]);
    poses.displace(at.parent, t1, nudge, Vec3::ZERO);
    poses.displace(at.child, t2, -nudge, Vec3::ZERO);
    true
}

/// The report's distribution of the difference by mass, for points of rigid bodies.
pub(super) fn correct_printed(tables: &Assembly<'_>, at: Ends, poses: &mut Poses<'_>) {
    let Arms { t1, t2, d } = tables.arms_at(at.joint, poses.pose(at.parent), poses.pose(at.child));
    let (mass_1, mass_2) = (poses.mass(at.parent), poses.mass(at.child));
    let length = tables.rods.length[at.part];
    let nudge = distance_correction(&mass_1, t1, &mass_2, t2, d, length);
    poses.displace(at.parent, t1, nudge, Vec3::ZERO);
    poses.displace(at.child, t2, -nudge, Vec3::ZERO);
}

/// Works out what stays the same while contacts are resolved.
pub(super) fn prepare(
    tables: &mut Assembly<'_>,
    at: Ends,
    arms: Arms,
    movers: &Turning<'_>,
    moved: [Velocity; 2],
    span: Span,
) {
    let Arms { t1, t2, d } = arms;
    let along = d.normalize_or(Vec3::Y);
    let masses = [at.parent, at.child].map(|row| movers.mass(row));
    tables.rods.along[at.part] = along;
    tables.rods.response[at.part] = response(&masses[0], t1, &masses[1], t2, along);
    tables.rods.impulse[at.part] *= span.longer;
    tables.rods.parted[at.part] = relative_velocity(moved[0], t1, moved[1], t2).dot(along);
}

/// Nudges the points to their distance, from where their nudges have brought them; gives how far they
/// were off, m.
pub(super) fn part(jointed: &mut Jointed<'_>, at: Ends, movers: &mut Turning<'_>) -> Parted {
    let poses = [at.parent, at.child].map(|row| jointed.nudged_pose(movers, row));
    let Arms { t1, t2, d } = jointed.assembly.arms_at(at.joint, poses[0], poses[1]);
    let left = d.length() - jointed.assembly.rods.length[at.part];
    if left.abs() >= SMALL_GAP {
        let along = d.normalize_or(jointed.assembly.rods.along[at.part]);
        let masses = [at.parent, at.child].map(|row| movers.mass(row));
        let response = response(&masses[0], t1, &masses[1], t2, along);
        let nudge = along * (-left.clamp(-LONGEST_GAP, LONGEST_GAP) / response);
        movers.nudge(at.parent, t1, nudge);
        movers.nudge(at.child, t2, -nudge);
    }
    Parted {
        off: left.abs(),
        nudged: left.abs() >= SMALL_GAP,
    }
}

/// Begins with what held them in the last step.
pub(super) fn resume(tables: &Assembly<'_>, at: Ends, movers: &mut Turning<'_>) {
    let (t1, t2) = tables.arms(at.joint);
    let (along, impulse) = (tables.rods.along[at.part], tables.rods.impulse[at.part]);
    movers.push(at.parent, t1, impulse * along);
    movers.push(at.child, t2, -impulse * along);
}

/// Keeps the rod as long as it is. Gives how fast it was changing, m/s.
pub(super) fn hold(tables: &mut Assembly<'_>, at: Ends, movers: &mut Turning<'_>) -> f32 {
    let (t1, t2) = tables.arms(at.joint);
    let along = tables.rods.along[at.part];
    let v_r = movers.relative_velocity(at.parent, t1, at.child, t2);
    let off = v_r.dot(along) + tables.rods.parted[at.part];
    let change = -off / tables.rods.response[at.part];
    movers.push(at.parent, t1, change * along);
    movers.push(at.child, t2, -change * along);
    tables.rods.impulse[at.part] += change;
    off.abs()
}
