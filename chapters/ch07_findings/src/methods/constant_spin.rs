//! Semi-implicit Euler with a spin that only torques change: ω stays as it is in the world. That is Euler's
//! equation of another body, so no step is small enough for it.

use super::alone::{Alone, each_alone};
use super::real::{Quat, Real, Vec3, rotation};
use super::world::{Knobs, World};

/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    each_alone(world, dt, knobs, |body, h| euler(body, h, spun));
}

// ANCHOR: euler
/// Semi-implicit Euler: v ← v + g h, ω ← what the body's own spin becomes, and I⁻¹ τ h, then x and q with the
/// new ones.
#[must_use]
pub fn euler(body: Alone, h: Real, spun: fn(Quat, Vec3, Vec3, Real) -> Vec3) -> Alone {
    let (q, inertia) = (body.attitude, body.inertia);
    let pulled = rotation::moment(q, inertia.recip(), body.torque(q));
    let angular_velocity = spun(q, inertia, body.angular_velocity, h) + pulled * h;
    let velocity = body.velocity + body.gravity * h;
    Alone {
        velocity,
        angular_velocity,
        position: body.position + velocity * h,
        attitude: rotation::turned(q, angular_velocity * h),
        ..body
    }
}
// ANCHOR_END: euler

/// What a body does to its own spin: nothing.
#[must_use]
pub fn spun(_q: Quat, _inertia: Vec3, omega: Vec3, _h: Real) -> Vec3 {
    omega
}
