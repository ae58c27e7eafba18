//! The classic Runge–Kutta method of fourth order, in attitude and angular momentum. Nothing is kept exactly,
//! and yet at short steps nothing is nearer. The attitude is made a unit at the end of a step.

use super::alone::{Alone, each_alone};
use super::real::{Quat, Real, Vec3, rotation};
use super::world::{Knobs, World};

/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    each_alone(world, dt, knobs, moved);
}

/// What changes: q and L.
#[derive(Clone, Copy)]
struct Turning {
    q: Quat,
    momentum: Vec3,
}

impl Turning {
    fn plus(self, rate: Self, h: Real) -> Self {
        Self {
            q: self.q + rate.q * h,
            momentum: self.momentum + rate.momentum * h,
        }
    }
}

// ANCHOR: runge_kutta
fn moved(body: Alone, h: Real) -> Alone {
    let rate = |at: Turning| {
        let unit = at.q.normalize();
        let omega = rotation::moment(unit, body.inertia.recip(), at.momentum);
        Turning {
            q: rotation::pure(omega * 0.5) * at.q,
            momentum: body.torque(unit),
        }
    };
    let now = Turning {
        q: body.attitude,
        momentum: rotation::moment(body.attitude, body.inertia, body.angular_velocity),
    };
    let one = rate(now);
    let two = rate(now.plus(one, 0.5 * h));
    let three = rate(now.plus(two, 0.5 * h));
    let four = rate(now.plus(three, h));
    let then = [(one, 1.0), (two, 2.0), (three, 2.0), (four, 1.0)]
        .into_iter()
        .fold(now, |sum, (rate, part)| sum.plus(rate, part * h / 6.0));
    let attitude = then.q.normalize();
    Alone {
        position: body.position + body.velocity * h + body.gravity * (0.5 * h * h),
        velocity: body.velocity + body.gravity * h,
        attitude,
        angular_velocity: rotation::moment(attitude, body.inertia.recip(), then.momentum),
        ..body
    }
}
// ANCHOR_END: runge_kutta
