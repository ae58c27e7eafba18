//! The formulas that all styles call: they compute the same bits because they compute with
//! the same functions.

use std::f32::consts::TAU;

use glam::{Quat, Vec2, Vec3};

// ANCHOR: formulas
/// An angle (rad) after `dt` seconds at `rate` (rad/s), kept within one turn of zero.
#[must_use]
#[inline]
pub fn advance(angle: f32, rate: f32, dt: f32) -> f32 {
    let next = angle + rate * dt;
    if next.abs() < TAU { next } else { next % TAU }
}

/// The point at `angle` (rad) on a circle of `radius` (m) about y.
#[must_use]
#[inline]
pub fn circle(radius: f32, angle: f32) -> Vec3 {
    let direction = Vec2::from_angle(angle);
    Vec3::new(radius * direction.x, 0.0, -radius * direction.y)
}

/// A turn by `angle` (rad) about y.
#[must_use]
#[inline]
pub fn turn(angle: f32) -> Quat {
    Quat::from_rotation_y(angle)
}

/// Brightness after `dt` seconds: creeps towards the rate of spin (rad/s), to within 1/e of
/// it in half a second.
#[must_use]
#[inline]
pub fn follow(glow: f32, spin: f32, dt: f32) -> f32 {
    glow + (spin.abs() - glow) * (2.0 * dt).min(1.0)
}
// ANCHOR_END: formulas
