//! A contact while it is resolved: which approach is an impact, what holds bodies apart at rest, and
//! who pays for being lifted. Chapter 3 derives them; report 8.4 has none of these.
//!
//! n̂ points from body 2 to body 1; u is the velocity of body 1 relative to body 2 along n̂, m/s,
//! negative where they approach.

use super::impulse::surface_speed;
use super::real::{Real, Vec3};

/// A lift that nobody pays for, m: what rounding makes of a body that rests and owes nothing.
const LIFT_FOR_FREE: Real = 1e-5;

// ANCHOR: arm
/// From a body's centre to where a contact's impulse acts on it, m. A ball without friction is pushed
/// through its centre: no rounding of the contact's place may turn it.
#[inline]
#[must_use]
pub fn arm(point: Vec3, centre: Vec3, is_ball: bool, friction: Real) -> Vec3 {
    if is_ball && friction == 0.0 {
        Vec3::ZERO
    } else {
        point - centre
    }
}
// ANCHOR_END: arm

// ANCHOR: slowest_impact
/// The slowest approach that is an impact, m/s: no slower than what a pull of `closing`, m/s², makes
/// of rest in a step.
#[inline]
#[must_use]
pub fn slowest_impact(threshold: Real, closing: Real, dt: Real) -> Real {
    threshold.max(1.5 * closing * dt)
}
// ANCHOR_END: slowest_impact

/// The speed at which a gap would just close in a step, m/s; 0 where there is none.
#[inline]
#[must_use]
pub fn gap_speed(depth: Real, dt: Real) -> Real {
    (-depth).max(0.0) / dt
}

// ANCHOR: slop
/// The depth, m, that is left alone: who bounces starts from the surface, who rests may stay a little
/// inside.
#[inline]
#[must_use]
pub fn slop(u: Real, closing: Real, depth: Real, e: Real, slowest: Real, allowed: Real) -> Real {
    let speed = surface_speed((-u).max(0.0), closing, depth.max(0.0));
    if e > 0.0 && speed > slowest {
        0.0
    } else {
        allowed
    }
}
// ANCHOR_END: slop

// ANCHOR: impact_speed
/// The speed of approach at the surface, m/s, if that is an impact; `pushed` is how far the two have
/// been pushed apart, m. What doesn't bounce needs none: resting contact stops it.
#[inline]
#[must_use]
pub fn impact_speed(
    u: Real,
    gap_speed: Real,
    e: Real,
    closing: Real,
    pushed: Real,
    slowest: Real,
) -> Option<Real> {
    if u >= 0.0 || gap_speed > 0.0 || e == 0.0 {
        return None;
    }
    let speed = surface_speed(-u, closing, pushed);
    (speed > slowest).then_some(speed)
}
// ANCHOR_END: impact_speed

// ANCHOR: let_come
/// Whether two that are still apart come so fast that they will bounce: then resting contact must let
/// them come.
#[inline]
#[must_use]
pub fn is_let_come(u: Real, gap_speed: Real, e: Real, slowest: Real) -> bool {
    let approach = u + gap_speed;
    e > 0.0 && gap_speed > 0.0 && approach < gap_speed - slowest
}
// ANCHOR_END: let_come

// ANCHOR: accumulated
/// A sum of pushes, which may be taken back but never pulls.
#[inline]
#[must_use]
pub fn accumulated(sum: Real, change: Real) -> Real {
    (sum + change).max(0.0)
}
// ANCHOR_END: accumulated

/// The part of a relative velocity that lies in the contact's plane, m/s.
#[inline]
#[must_use]
pub fn sliding(v_r: Vec3, n: Vec3) -> Vec3 {
    v_r - v_r.dot(n) * n
}

// ANCHOR: lift
/// What a body pays for being lifted by `lift`, m, along `out` against the acceleration `closing`: an
/// impulse, N s, that takes from the rest of its speed what its fall doesn't pay. ½ v² must drop by the
/// acceleration times the lift. `None` where nothing is owed.
#[inline]
#[must_use]
pub fn pay_for_lift(
    v: Vec3,
    out: Vec3,
    closing: Real,
    lift: Real,
    inverse_mass: Real,
) -> Option<Vec3> {
    let fall = (-v.dot(out)).max(0.0);
    let unpaid = lift - fall * fall / (2.0 * closing);
    let rest = v + fall * out;
    let speed = rest.length();
    (unpaid > LIFT_FOR_FREE && speed > 0.0).then(|| {
        let left = surface_speed(speed, closing, unpaid);
        rest * ((left / speed - 1.0) / inverse_mass)
    })
}
// ANCHOR_END: lift
