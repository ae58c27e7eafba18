//! How a child has turned away from its rest in its parent, as two angles that limits can hold: a
//! twist about its own y axis, and a swing that tilts this axis. The angle constraint of the report's
//! unfinished section 9.4.
//!
//! rel = swing · twist: first the twist by τ about y, then the swing by θ about an axis in the plane
//! of x and z. Any rotation splits so in one way as long as the axis isn't tilted by π, all the way
//! round: there, and only there, τ has no value. [Dobrowolski 2015]

use super::real::{Quat, Real, Vec3, atan2, cos, sin};
use super::rotation::{exp, log};

/// Below this sine a swing has no direction of its own.
const SMALL_SINE: Real = 1e-6;

/// A rotation as swing and twist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwingTwist {
    /// Rotation vector of the swing, rad: pitch in x, roll in z, 0 in y.
    pub swing: Vec3,
    /// τ, rad, from −π to π, about y.
    pub twist: Real,
}

// ANCHOR: decompose
/// Splits `rel`, the child's orientation seen from its rest.
///
/// The twist is what the rotation keeps of y: quat[w, 0, y, 0] made a unit. Where the axis has been
/// swung by π nothing is left of it; the twist is then 0.
#[must_use]
pub fn decompose(rel: Quat) -> SwingTwist {
    let rel = if rel.w < 0.0 { -rel } else { rel };
    let size = (rel.y * rel.y + rel.w * rel.w).sqrt();
    if size < SMALL_SINE {
        let swing = log(rel);
        return SwingTwist { swing, twist: 0.0 };
    }
    let twist = Quat::from_xyzw(0.0, rel.y / size, 0.0, rel.w / size);
    SwingTwist {
        swing: log(rel * twist.conjugate()),
        twist: 2.0 * atan2(rel.y, rel.w),
    }
}
// ANCHOR_END: decompose

/// The rotation of a swing and a twist.
#[must_use]
pub fn compose(parts: SwingTwist) -> Quat {
    let half = 0.5 * parts.twist;
    exp(parts.swing) * Quat::from_xyzw(0.0, sin(half), 0.0, cos(half))
}

// ANCHOR: twist_axis
/// (ŷ₀ + ŷ)/(1 + ŷ₀·ŷ): what the relative angular velocity is multiplied by to give the rate of the
/// twist. ŷ₀ is where the child's axis rests, ŷ where it is, world.
///
/// It grows beyond all bounds as the axes become opposite: the singular direction.
#[must_use]
pub fn twist_axis(y_rest: Vec3, y: Vec3) -> Vec3 {
    (y_rest + y) / (1.0 + y_rest.dot(y)).max(SMALL_SINE)
}
// ANCHOR_END: twist_axis

// ANCHOR: cone
/// The angle θ between the axis at rest and now, rad, and the unit axis of the swing: the rate of
/// θ is this axis times the relative angular velocity. `None` for the axis where there is none, at
/// θ = 0; at θ = π any across will do.
#[must_use]
pub fn cone(y_rest: Vec3, y: Vec3) -> (Real, Option<Vec3>) {
    let cross = y_rest.cross(y);
    let sine = cross.length();
    let cosine = y_rest.dot(y);
    let axis = if sine > SMALL_SINE {
        Some(cross / sine)
    } else if cosine < 0.0 {
        Some(y_rest.any_orthonormal_vector())
    } else {
        None
    };
    (atan2(sine, cosine), axis)
}
// ANCHOR_END: cone

// ANCHOR: swing_axes
/// What the relative angular velocity is multiplied by to give the rates of pitch and of roll, the x
/// and z of the swing's rotation vector. `rest` is the rest frame in the world, ŷ the child's axis.
///
/// With û the swing's axis at the angle α from x: θ̇ = ω·û, α̇ = −ω·(ŷ × û)/sin θ, and so
/// d(θ cos α) = (cos α û + θ/sin θ · sin α (ŷ × û))·ω, d(θ sin α) = (sin α û − θ/sin θ · cos α (ŷ × û))·ω.
#[must_use]
pub fn swing_axes(rest: Quat, swing: Vec3, y: Vec3) -> (Vec3, Vec3) {
    let theta = swing.length();
    if theta < SMALL_SINE {
        return (rest * Vec3::X, rest * Vec3::Z);
    }
    let (cosine, sine) = (swing.x / theta, swing.z / theta);
    let u = rest * (swing / theta);
    let across = y.cross(u) * (theta / sin(theta).max(SMALL_SINE));
    (cosine * u + sine * across, sine * u - cosine * across)
}
// ANCHOR_END: swing_axes
