//! Velocities, which nobody stores: read from p, p* and q, q*, and written into p* and q*.

use ch00_maths::f32::impulse::Velocity;
use ch00_maths::f32::{rotation, spin, verlet};
use glam::{Quat, Vec3};

use super::{Pull, or_zero};
use crate::data::Bodies;

// ANCHOR: read
/// The velocities that a body would have now if nothing had held it: the mean ones of its last step, and
/// half a step of what pulls it.
#[must_use]
pub fn now(
    Bodies {
        position,
        last_position,
        orientation,
        last_orientation,
        inverse_mass,
        inertia,
        inverse_inertia,
        torque,
        ..
    }: &Bodies,
    row: usize,
    pull: Pull<'_>,
    dt_last: f32,
) -> Velocity {
    if inverse_mass[row] == 0.0 {
        return Velocity::default();
    }
    let a = pull.on(row, inverse_mass[row]);
    let v = verlet::velocity_now(position[row], last_position[row], a, dt_last);
    let omega = if let (Some(&q), Some(&q_last)) = (orientation.get(row), last_orientation.get(row))
    {
        let (i, i_inverse) = (inertia[row], inverse_inertia[row]);
        let momentum = spin::momentum_of_turn(q, q_last, i, dt_last)
            .unwrap_or_else(|| spin::momentum_if_steady(q, q_last, i, dt_last))
            + or_zero(torque, row) * (0.5 * dt_last);
        spin::angular_velocity(q, i, i_inverse, momentum)
    } else {
        Vec3::ZERO
    };
    Velocity { v, omega }
}

/// Its velocities now: what holds it acts during the whole step, half of it before now and half after.
#[must_use]
pub fn with_held(bodies: &Bodies, row: usize, now: Velocity) -> Velocity {
    Velocity {
        v: now.v - 0.5 * or_zero(&bodies.held_velocity, row),
        omega: now.omega - 0.5 * or_zero(&bodies.held_spin, row),
    }
}
// ANCHOR_END: read

/// The mean velocities of a body over the last step: what the printed method takes for those now.
#[must_use]
pub fn moved(bodies: &Bodies, row: usize, dt_last: f32) -> Velocity {
    let (p, p_last) = (bodies.position[row], bodies.last_position[row]);
    let turns = (
        bodies.orientation.get(row),
        bodies.last_orientation.get(row),
    );
    Velocity {
        v: verlet::velocity(p, p_last, dt_last),
        omega: match turns {
            (Some(&q), Some(&q_last)) => rotation::angular_velocity(q, q_last, dt_last),
            _ => Vec3::ZERO,
        },
    }
}

/// The velocity of a body on a fixed point follows from its turn, m/s.
#[must_use]
pub fn of_held(orientation: Quat, arm: Vec3, omega: Vec3) -> Vec3 {
    omega.cross(orientation * arm)
}

// ANCHOR: write
/// Gives a body that is pulled by `a`, m/s², these velocities by writing p* and q*.
pub fn write(
    Bodies {
        position,
        last_position,
        orientation,
        last_orientation,
        inverse_mass,
        inertia,
        inverse_inertia,
        torque,
        ..
    }: &mut Bodies,
    row: usize,
    velocity: Velocity,
    a: Vec3,
    dt: f32,
) {
    let is_static = inverse_mass[row] == 0.0;
    let p = position[row];
    last_position[row] = if is_static {
        p
    } else {
        verlet::last_position(p, velocity.v, a, dt)
    };
    if let (Some(&q), Some(q_last)) = (orientation.get(row), last_orientation.get_mut(row)) {
        *q_last = if is_static {
            q
        } else {
            let (i, i_inverse) = (inertia[row], inverse_inertia[row]);
            let torque = or_zero(torque, row);
            spin::last_orientation(q, i, i_inverse, velocity.omega, torque, dt)
        };
    }
}
// ANCHOR_END: write

/// The same as printed.
pub fn write_printed(bodies: &mut Bodies, row: usize, velocity: Velocity, dt: f32) {
    let is_static = bodies.inverse_mass[row] == 0.0;
    let p = bodies.position[row];
    bodies.last_position[row] = if is_static {
        p
    } else {
        verlet::printed::last_position(p, velocity.v, dt)
    };
    if let (Some(&q), Some(q_last)) = (
        bodies.orientation.get(row),
        bodies.last_orientation.get_mut(row),
    ) {
        *q_last = if is_static {
            q
        } else {
            rotation::printed::turned(q, -velocity.omega * dt)
        };
    }
}
