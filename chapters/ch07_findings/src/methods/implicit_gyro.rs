//! Semi-implicit Euler with the gyroscopic torque of the spin that it leads to, by one step of Newton's
//! method. [Catto, GDC 2015] It is stable because it throws energy away.

use super::alone::each_alone;
use super::constant_spin::euler;
use super::real::{Mat3, Quat, Real, Vec3};
use super::world::{Knobs, World};

/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    each_alone(world, dt, knobs, |body, h| euler(body, h, spun));
}

// ANCHOR: implicit_gyro
/// What a body does to its own spin in h seconds: one Newton step for f(ω) = I(ω − ω₀) + h ω × Iω = 0 in
/// body axes, from ω₀.
#[must_use]
pub fn spun(q: Quat, inertia: Vec3, omega: Vec3, h: Real) -> Vec3 {
    if inertia.x == inertia.y && inertia.y == inertia.z {
        return omega;
    }
    let own = q.conjugate() * omega;
    let momentum = inertia * own;
    let missing = own.cross(momentum) * h;
    let slope = Mat3::from_diagonal(inertia)
        + (across(own) * Mat3::from_diagonal(inertia) - across(momentum)) * h;
    q * (own - slope.inverse() * missing)
}

/// The matrix of a × .
fn across(a: Vec3) -> Mat3 {
    Mat3::from_cols(
        Vec3::new(0.0, a.z, -a.y),
        Vec3::new(-a.z, 0.0, a.x),
        Vec3::new(a.y, -a.x, 0.0),
    )
}
// ANCHOR_END: implicit_gyro
