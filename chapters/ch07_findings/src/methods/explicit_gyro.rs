//! Semi-implicit Euler with the gyroscopic torque of the present: ω ← ω + h I⁻¹ (τ − ω × Iω). It gains energy
//! at every step.

use super::alone::each_alone;
use super::constant_spin::euler;
use super::real::{Quat, Real, Vec3};
use super::world::{Knobs, World};

/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    each_alone(world, dt, knobs, |body, h| euler(body, h, spun));
}

// ANCHOR: explicit_gyro
/// What a body does to its own spin in h seconds.
#[must_use]
pub fn spun(q: Quat, inertia: Vec3, omega: Vec3, h: Real) -> Vec3 {
    if inertia.x == inertia.y && inertia.y == inertia.z {
        return omega;
    }
    let own = q.conjugate() * omega;
    q * (own - (own.cross(inertia * own) / inertia) * h)
}
// ANCHOR_END: explicit_gyro
