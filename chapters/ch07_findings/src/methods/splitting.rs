//! Half a kick, a drift, half a kick: gravity changes momenta, then the body moves and turns as if it were
//! alone in space, by chapter 0's splitting, which keeps angular momentum to the last bit.

use super::alone::{Alone, each_alone};
use super::real::{Real, free_rotation, rotation};
use super::world::{Knobs, World};

/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    each_alone(world, dt, knobs, moved);
}

// ANCHOR: splitting
/// Second order, and symmetric in time.
fn moved(body: Alone, h: Real) -> Alone {
    let q = body.attitude;
    let velocity = body.velocity + body.gravity * (0.5 * h);
    let momentum = rotation::moment(q, body.inertia, body.angular_velocity);
    let momentum = momentum + body.torque(q) * (0.5 * h);
    let turned = free_rotation::attitude_after(q, body.inertia, momentum, h);
    let momentum = momentum + body.torque(turned) * (0.5 * h);
    Alone {
        position: body.position + velocity * h,
        velocity: velocity + body.gravity * (0.5 * h),
        attitude: turned,
        angular_velocity: rotation::moment(turned, body.inertia.recip(), momentum),
        ..body
    }
}
// ANCHOR_END: splitting
