//! Orientations as unit quaternions: rotation vectors, exponential and logarithm, and the
//! report's functions ω(q, q*) and M(q, I, a). Report 8.2 and 8.3.
//!
//! A rotation vector points along the axis and is as long as the angle, rad. World-frame
//! rotations stand on the left: q⁺ = exp(θ) q. Errata 4, 5 and 10 are about this file.

use super::real::{Quat, Real, Vec3, atan2, cos, sin};

// ANCHOR: exp
/// exp: the unit quaternion that turns by the rotation vector θ, rad.
///
/// exp(θ) = quat[cos ½|θ|, sin(½|θ|) θ/|θ|]; below ½|θ| = 0.01 the series of sin x/x.
#[must_use]
pub fn exp(theta: Vec3) -> Quat {
    let half2 = 0.25 * theta.length_squared();
    let half = half2.sqrt();
    let half_sinc = if half < 0.01 {
        0.5 - half2 / 12.0 + half2 * half2 / 240.0
    } else {
        0.5 * sin(half) / half
    };
    let v = theta * half_sinc;
    Quat::from_xyzw(v.x, v.y, v.z, cos(half))
}
// ANCHOR_END: exp

// ANCHOR: log
/// log: the rotation vector of a unit quaternion, rad, the shorter way round: |θ| ≤ π.
///
/// The report's 2 vec(ln q), with q and −q read alike. The arc tangent keeps full accuracy
/// where an arc cosine of w would lose half of the digits; below 0.01 rad its series, 2(t − ⅓t³ + …).
#[must_use]
pub fn log(q: Quat) -> Vec3 {
    let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
    let v = sign * Vec3::new(q.x, q.y, q.z);
    let w = sign * q.w;
    let sine2 = v.length_squared();
    let sine = sine2.sqrt();
    let angle_over_sine = if sine < 0.01 * w {
        let t2 = sine2 / (w * w);
        (2.0 - t2 * (2.0 / 3.0 - t2 * (0.4 - t2 * 2.0 / 7.0))) / w
    } else {
        2.0 * atan2(sine, w) / sine
    };
    v * angle_over_sine
}
// ANCHOR_END: log

// ANCHOR: angular_velocity
/// ω(q, q*) = 2 vec(ln(norm(q q̄*)))/Δt, rad/s, world frame. Report 8.2.
///
/// Reads at most π/Δt: a body that turns further in a step is taken to have turned the
/// other way. Erratum 10.
#[must_use]
pub fn angular_velocity(q: Quat, q_last: Quat, dt: Real) -> Vec3 {
    log((q * q_last.conjugate()).normalize()) / dt
}
// ANCHOR_END: angular_velocity

// ANCHOR: reach
/// How far any point of a body within `radius`, m, of its centre has moved from p*, q* to p, q, at
/// most, m: its centre's way and the chord of its turn.
#[must_use]
pub fn reach(p: Vec3, p_last: Vec3, q: Quat, q_last: Quat, radius: Real) -> Real {
    let turn = q * q_last.conjugate();
    let chord = 2.0 * Vec3::new(turn.x, turn.y, turn.z).length();
    (p - p_last).length() + chord * radius
}
// ANCHOR_END: reach

// ANCHOR: turned
/// q turned by the world-frame rotation vector θ, rad: exp(θ) q.
#[must_use]
pub fn turned(q: Quat, theta: Vec3) -> Quat {
    (exp(theta) * q).normalize()
}
// ANCHOR_END: turned

// ANCHOR: moment
/// M(q, I, a) = q ∗ ((q̄ ∗ a) I⁻¹): what the world vector `a`, an angular momentum or a
/// torque, is as angular velocity or acceleration. Report 8.2.
///
/// `inverse_inertia` holds the inverse principal moments, 1/(kg m²).
#[must_use]
pub fn moment(q: Quat, inverse_inertia: Vec3, a: Vec3) -> Vec3 {
    q * ((q.conjugate() * a) * inverse_inertia)
}
// ANCHOR_END: moment

// ANCHOR: pure
/// quat[0, v]: the quaternion whose vector part is v.
#[must_use]
pub fn pure(v: Vec3) -> Quat {
    Quat::from_xyzw(v.x, v.y, v.z, 0.0)
}
// ANCHOR_END: pure

// ANCHOR: first_order
/// norm(q + ½ quat[0, θ] q): erratum 4 mended, but still the first-order update, which
/// turns by 2 atan(½|θ|) instead of |θ|. Erratum 5.
#[must_use]
pub fn turned_first_order(q: Quat, theta: Vec3) -> Quat {
    (q + pure(0.5 * theta) * q).normalize()
}
// ANCHOR_END: first_order

/// The formulas as the report prints them.
pub mod printed {
    use super::{Quat, Vec3, pure};

    // ANCHOR: printed
    /// norm(q + q quat[0, ½ Δq]): Δq is a world vector, but stands where a body vector
    /// belongs. Erratum 4.
    #[must_use]
    pub fn turned(q: Quat, delta: Vec3) -> Quat {
        (q + q * pure(0.5 * delta)).normalize()
    }
    // ANCHOR_END: printed
}
