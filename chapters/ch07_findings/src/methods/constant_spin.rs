//! Semi-implicit Euler with a spin that only torques change: ω stays as it is in the world. That is Euler's
//! equation of another body, so no step is small enough for it.

use super::alone::{Alone, each_alone};
use super::real::{Quat, Real, Vec3, rotation};
use super::world::{Knobs, World};

/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    each_alone(world, dt, knobs, moved);
}

// ANCHOR: constant_spin
/// v ← v + g h, ω ← ω + I⁻¹ τ h, then x and q with the new ones.
fn moved(body: Alone, h: Real) -> Alone {
    let turned = rotation::moment(
        body.attitude,
        body.inertia.recip(),
        body.torque(body.attitude),
    );
    euler(body, body.angular_velocity + turned * h, h)
}
// ANCHOR_END: constant_spin

/// Semi-implicit Euler with a new spin.
#[must_use]
pub fn euler(body: Alone, angular_velocity: Vec3, h: Real) -> Alone {
    let velocity = body.velocity + body.gravity * h;
    Alone {
        velocity,
        angular_velocity,
        position: body.position + velocity * h,
        attitude: rotation::turned(body.attitude, angular_velocity * h),
        ..body
    }
}

/// What a body does to its own spin: nothing.
#[must_use]
pub fn spun(_q: Quat, _inertia: Vec3, omega: Vec3, _h: Real) -> Vec3 {
    omega
}
