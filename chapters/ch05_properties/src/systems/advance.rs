//! Every body advances by a step: chapter 2's update, a system for places and one for turns.

use ch00_maths::f32::{rotation, spin, verlet};
use glam::{Quat, Vec3};

use super::{Pull, or_zero};

/// How long the step is, and what drag leaves in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Δt, s.
    pub dt: f32,
    /// Δt*, the step before it, s.
    pub dt_last: f32,
    /// f: the share of a velocity that drag leaves.
    pub kept: f32,
}

// ANCHOR: positions
/// p⁺ by Verlet for uneven steps; p becomes p*.
pub fn positions(
    position: &mut [Vec3],
    last_position: &mut [Vec3],
    inverse_mass: &[f32],
    pull: Pull<'_>,
    step: Step,
) {
    let Step { dt, dt_last, kept } = step;
    let rows = position.iter_mut().zip(last_position).zip(inverse_mass);
    for (row, ((p, p_last), &inverse_mass)) in rows.enumerate() {
        if inverse_mass == 0.0 {
            continue;
        }
        let a = pull.on(row, inverse_mass);
        let moved = verlet::displacement(*p, *p_last, a, kept, dt, dt_last);
        *p_last = *p;
        *p += moved;
    }
}
// ANCHOR_END: positions

// ANCHOR: orientations
/// q⁺ by the free turn of the angular momentum; q becomes q*. Gives how many turns were too fast to be
/// read.
pub fn orientations(
    orientation: &mut [Quat],
    last_orientation: &mut [Quat],
    inertia: &[Vec3],
    inverse_inertia: &[Vec3],
    torque: &[Vec3],
    inverse_mass: &[f32],
    step: Step,
) -> usize {
    let Step { dt, dt_last, kept } = step;
    let mut unread = 0;
    for (row, (q, q_last)) in orientation.iter_mut().zip(last_orientation).enumerate() {
        if inverse_mass[row] == 0.0 {
            continue;
        }
        let (i, i_inverse) = (inertia[row], inverse_inertia[row]);
        let momentum = spin::momentum_of_turn(*q, *q_last, i, dt_last).unwrap_or_else(|| {
            unread += 1;
            spin::momentum_if_steady(*q, *q_last, i, dt_last)
        });
        let momentum = spin::momentum_after(momentum, or_zero(torque, row), kept, dt, dt_last);
        *q_last = *q;
        *q = spin::turned_by(*q, i, i_inverse, momentum, dt);
    }
    unread
}
// ANCHOR_END: orientations

/// p⁺ as the report prints it.
pub fn positions_printed(
    position: &mut [Vec3],
    last_position: &mut [Vec3],
    inverse_mass: &[f32],
    pull: Pull<'_>,
    step: Step,
) {
    let Step { dt, kept, .. } = step;
    let rows = position.iter_mut().zip(last_position).zip(inverse_mass);
    for (row, ((p, p_last), &inverse_mass)) in rows.enumerate() {
        if inverse_mass == 0.0 {
            continue;
        }
        let a = pull.on(row, inverse_mass);
        let moved = verlet::printed::displacement(*p, *p_last, a, kept, dt);
        *p_last = *p;
        *p += moved;
    }
}

/// q⁺ as the report prints it.
pub fn orientations_printed(
    orientation: &mut [Quat],
    last_orientation: &mut [Quat],
    inverse_inertia: &[Vec3],
    torque: &[Vec3],
    inverse_mass: &[f32],
    step: Step,
) {
    let Step { dt, kept, .. } = step;
    for (row, (q, q_last)) in orientation.iter_mut().zip(last_orientation).enumerate() {
        if inverse_mass[row] == 0.0 {
            continue;
        }
        let torque = or_zero(torque, row);
        let turn = spin::printed::turn(*q, *q_last, inverse_inertia[row], torque, kept, dt);
        *q_last = *q;
        *q = rotation::printed::turned(*q, turn);
    }
}

// ANCHOR: fixed_points
/// A body on a fixed point is where its turn leads it.
pub fn fixed_points(
    body: &[u32],
    point: &[Vec3],
    arm: &[Vec3],
    position: &mut [Vec3],
    last_position: &mut [Vec3],
    orientation: &[Quat],
    last_orientation: &[Quat],
) {
    for ((&body, &point), &arm) in body.iter().zip(point).zip(arm) {
        let row = body as usize;
        position[row] = point + orientation[row] * arm;
        last_position[row] = point + last_orientation[row] * arm;
    }
}
// ANCHOR_END: fixed_points
