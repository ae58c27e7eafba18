//! The pin constraint: two points, one on each body, that stay together. Report 9.3.
//!
//! The correction D acts on positions; velocities follow, since p* and q* stay. Erratum 6 is
//! about this file; chapter 4 uses it.

use super::impulse::{Mass, response};
use super::real::{Quat, Real, Vec3};
use super::rotation::turned;

/// A body's pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Position, m.
    pub p: Vec3,
    /// Body to world.
    pub q: Quat,
}

// ANCHOR: correction
/// D = −d / response: the positional impulse, kg m, that closes the gap
/// d = (p₁ + t₁) − (p₂ + t₂) to first order.
#[inline]
#[must_use]
pub fn correction(mass_1: &Mass, t1: Vec3, mass_2: &Mass, t2: Vec3, gap: Vec3) -> Vec3 {
    let length: Real = gap.length();
    if length == 0.0 {
        return Vec3::ZERO;
    }
    -gap / response(mass_1, t1, mass_2, t2, gap / length)
}

/// The pose after the positional impulse D at t. For body 2 hand over −D.
#[inline]
#[must_use]
pub fn applied(pose: Pose, mass: &Mass, t: Vec3, d: Vec3) -> Pose {
    Pose {
        p: pose.p + d * mass.inverse_mass,
        q: turned(pose.q, mass.moment(t.cross(d))),
    }
}
// ANCHOR_END: correction

/// The formulas as the report prints them.
pub mod printed {
    use super::{Mass, Pose, Vec3};

    // ANCHOR: printed
    /// Body 2's pose with M(q₂, I₂, t₂) × −D where M(q₂, I₂, t₂ × −D) belongs: the cross product is
    /// taken after the inertia, so the turn is off in size and direction. Erratum 6.
    #[inline]
    #[must_use]
    pub fn applied_to_second(pose: Pose, mass: &Mass, t: Vec3, d: Vec3) -> Pose {
        Pose {
            p: pose.p - d * mass.inverse_mass,
            q: super::super::rotation::printed::turned(pose.q, mass.moment(t).cross(-d)),
        }
    }
    // ANCHOR_END: printed
}
