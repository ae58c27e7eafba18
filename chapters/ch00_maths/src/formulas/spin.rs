//! How a rigid body turns without a stored velocity: from its angular momentum to its attitude, and
//! back from two attitudes to the momentum. Report 8.2 and 8.3, with errata 3, 5 and 10 mended.
//!
//! A body whose three moments are equal needs no axes: its momentum is I ω with one number I.

use super::real::{Quat, Real, Vec3};
use super::{free_rotation, rotation};

/// Whether the three moments are equal, as a ball's are.
#[inline]
#[must_use]
pub fn is_round(inertia: Vec3) -> bool {
    inertia.x == inertia.y && inertia.y == inertia.z
}

// ANCHOR: momentum
/// L = I ω in world axes, kg m²/s, of a body that turns with ω, rad/s.
#[inline]
#[must_use]
pub fn angular_momentum(q: Quat, inertia: Vec3, omega: Vec3) -> Vec3 {
    if is_round(inertia) {
        return omega * inertia.x;
    }
    q * ((q.conjugate() * omega) * inertia)
}

/// ω = M(q, I, L), rad/s, world axes.
#[inline]
#[must_use]
pub fn angular_velocity(q: Quat, inertia: Vec3, inverse_inertia: Vec3, momentum: Vec3) -> Vec3 {
    if is_round(inertia) {
        return momentum * inverse_inertia.x;
    }
    rotation::moment(q, inverse_inertia, momentum)
}
// ANCHOR_END: momentum

// ANCHOR: turned_by
/// The attitude `dt` seconds after q with this angular momentum, kg m²/s, world axes.
#[inline]
#[must_use]
pub fn turned_by(q: Quat, inertia: Vec3, inverse_inertia: Vec3, momentum: Vec3, dt: Real) -> Quat {
    if is_round(inertia) {
        rotation::turned(q, momentum * (inverse_inertia.x * dt))
    } else {
        free_rotation::attitude_after(q, inertia, momentum, dt)
    }
}

/// The angular momentum with which it turned from q* to q; `None` where the turn is too near half a
/// revolution to be read (erratum 10).
#[inline]
#[must_use]
pub fn momentum_of_turn(q: Quat, q_last: Quat, inertia: Vec3, dt_last: Real) -> Option<Vec3> {
    if is_round(inertia) {
        return Some(momentum_if_steady(q, q_last, inertia, dt_last));
    }
    free_rotation::momentum_of_turn(q_last, q, inertia, dt_last)
}

/// The same as if ω had been constant during the turn: exact for a ball.
#[inline]
#[must_use]
pub fn momentum_if_steady(q: Quat, q_last: Quat, inertia: Vec3, dt_last: Real) -> Vec3 {
    angular_momentum(q, inertia, rotation::angular_velocity(q, q_last, dt_last))
}
// ANCHOR_END: turned_by

// ANCHOR: momentum_after
/// The angular momentum with which it goes on for `dt` seconds: what drag leaves, and the kick of the
/// torque T, N m, between the middles of the two steps.
#[inline]
#[must_use]
pub fn momentum_after(momentum: Vec3, torque: Vec3, kept: Real, dt: Real, dt_last: Real) -> Vec3 {
    let kick = torque * (0.5 * (dt + dt_last));
    momentum * kept + kick
}
// ANCHOR_END: momentum_after

// ANCHOR: last_orientation
/// The q* of a body at q that has the angular velocity ω now: half a step of torque later it would
/// have the momentum that its last turn shows.
#[inline]
#[must_use]
pub fn last_orientation(
    q: Quat,
    inertia: Vec3,
    inverse_inertia: Vec3,
    omega: Vec3,
    torque: Vec3,
    dt: Real,
) -> Quat {
    let momentum = angular_momentum(q, inertia, omega) - torque * (0.5 * dt);
    turned_by(q, inertia, inverse_inertia, momentum, -dt)
}
// ANCHOR_END: last_orientation

// ANCHOR: kick
/// What the torque and the body's own gyroscopic moment add to its angular momentum in half a step,
/// kg m²/s: ½ Δt (T − ω × L).
#[inline]
#[must_use]
pub fn half_kick(q: Quat, inertia: Vec3, omega: Vec3, torque: Vec3, dt: Real) -> Vec3 {
    let half = 0.5 * dt;
    let gyroscopic = omega.cross(angular_momentum(q, inertia, omega));
    half * (torque - gyroscopic)
}
// ANCHOR_END: kick

/// The formulas as the report prints them.
pub mod printed {
    use super::{Quat, Real, Vec3, rotation};

    // ANCHOR: printed
    /// Δq: the last turn again, less drag, and the torque's; a world vector.
    #[inline]
    #[must_use]
    pub fn turn(
        q: Quat,
        q_last: Quat,
        inverse_inertia: Vec3,
        torque: Vec3,
        kept: Real,
        dt: Real,
    ) -> Vec3 {
        rotation::log((q * q_last.conjugate()).normalize()) * kept
            + rotation::moment(q, inverse_inertia, torque) * (dt * dt)
    }
    // ANCHOR_END: printed
}
