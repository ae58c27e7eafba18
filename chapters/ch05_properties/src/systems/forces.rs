//! Forces beside gravity: chapter 2's callbacks as tables. Sums run in the order in which the scene
//! names its forces, as the callbacks' sums do.

use ch00_maths::f32::force;
use ch00_maths::f32::impulse::Velocity;
use glam::{Quat, Vec3};

use crate::data::{FixedPoints, Poles, Pushes, Springs};

/// ΣF/m and gravity, and ΣT, of every body where it is now: two columns that this fills.
pub struct Sums<'a> {
    /// m/s².
    pub acceleration: &'a mut [Vec3],
    /// N m.
    pub torque: &'a mut [Vec3],
}

/// What acts beside gravity and the mouse: the tables of the scene's forces.
#[derive(Clone, Copy)]
pub struct Acting<'a> {
    /// Ends of magnets.
    pub poles: &'a Poles,
    /// Bodies that hang on a point.
    pub fixed_points: &'a FixedPoints,
    /// Forces that stay the same.
    pub pushes: &'a Pushes,
}

// ANCHOR: gather
/// Sums what poles, fixed points and constant forces do to bodies.
pub fn gather(
    acting: Acting<'_>,
    position: &[Vec3],
    orientation: &[Quat],
    inverse_mass: &[f32],
    gravity: Vec3,
    sums: &mut Sums<'_>,
) {
    sums.acceleration.fill(Vec3::ZERO);
    sums.torque.fill(Vec3::ZERO);
    let Acting {
        poles,
        fixed_points,
        pushes,
    } = acting;
    let last = [&poles.force, &fixed_points.force, &pushes.force].map(|of| of.last());
    let last = last.into_iter().flatten().max();
    for force in 0..=last.copied().unwrap_or(0) {
        magnets(poles, force, position, orientation, sums);
        weights(fixed_points, force, orientation, sums);
        push(pushes, force, sums);
    }
    for (row, acceleration) in sums.acceleration.iter_mut().enumerate() {
        if inverse_mass[row] == 0.0 {
            *acceleration = Vec3::ZERO;
            sums.torque[row] = Vec3::ZERO;
        } else {
            *acceleration = gravity + *acceleration * inverse_mass[row];
        }
    }
}
// ANCHOR_END: gather

// ANCHOR: magnets
/// Every pole of a force feels every other of its poles that sits in another body. Until the masses are
/// known, `acceleration` holds forces, N.
fn magnets(
    Poles {
        body,
        force: of_force,
        place,
        strength,
        softening,
        ..
    }: &Poles,
    force: u32,
    position: &[Vec3],
    orientation: &[Quat],
    sums: &mut Sums<'_>,
) {
    let first = of_force.partition_point(|&of| of < force);
    let end = of_force.partition_point(|&of| of <= force);
    for own in first..end {
        for other in (first..end).filter(|&other| body[other] != body[own]) {
            let (i, j) = (body[own] as usize, body[other] as usize);
            let between = position[i] + orientation[i] * place[own]
                - (position[j] + orientation[j] * place[other]);
            let pull = force::pole(between, strength[own] * strength[other], softening[own]);
            sums.acceleration[i] += pull;
            sums.torque[i] += (orientation[i] * place[own]).cross(pull);
        }
    }
}
// ANCHOR_END: magnets

/// Gravity turns a body about its fixed point.
fn weights(
    FixedPoints {
        body,
        force: of_force,
        arm,
        weight,
        ..
    }: &FixedPoints,
    force: u32,
    orientation: &[Quat],
    sums: &mut Sums<'_>,
) {
    let first = of_force.partition_point(|&of| of < force);
    let end = of_force.partition_point(|&of| of <= force);
    for k in first..end {
        let i = body[k] as usize;
        sums.torque[i] += (orientation[i] * arm[k]).cross(weight[k]);
    }
}

/// A constant force, at the centre of mass.
fn push(pushes: &Pushes, force: u32, sums: &mut Sums<'_>) {
    let first = pushes.force.partition_point(|&of| of < force);
    let end = pushes.force.partition_point(|&of| of <= force);
    for k in first..end {
        sums.acceleration[pushes.body[k] as usize] += pushes.push[k];
    }
}

/// Adds the mouse's pull on a body that moves with `velocity`.
pub fn drag(
    springs: &Springs,
    k: usize,
    position: &[Vec3],
    orientation: &[Quat],
    inverse_mass: &[f32],
    velocity: Velocity,
    sums: &mut Sums<'_>,
) {
    let i = springs.body[k] as usize;
    let arm = orientation[i] * springs.anchor[k];
    let stretch = springs.target[k] - (position[i] + arm);
    let (force, torque) = force::spring(springs.mass[k], arm, stretch, velocity);
    sums.acceleration[i] += force * inverse_mass[i];
    sums.torque[i] += torque;
}
