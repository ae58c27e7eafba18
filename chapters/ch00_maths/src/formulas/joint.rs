//! What joints need beside the pin: how two bodies answer to an impulse that turns them, and the
//! distance constraint. Report 9.2 to 9.4.

use super::impulse::{Mass, Velocity, relative_velocity, response};
use super::real::{Mat3, Real, Vec3};

// ANCHOR: pin_matrix
/// K = (m₁⁻¹ + m₂⁻¹) 1 − [t₁] I₁⁻¹ [t₁] − [t₂] I₂⁻¹ [t₂]: how the gap between two pinned points changes
/// by an impulse, 1/kg, with [t] the matrix of t × .
///
/// The report divides by the one number d̂·K d̂. That closes the gap along d̂ and opens it across,
/// since K d̂ seldom points along d̂; K⁻¹ d closes all of it.
#[inline]
#[must_use]
pub fn pin_matrix(mass_1: &Mass, t1: Vec3, mass_2: &Mass, t2: Vec3) -> Mat3 {
    let turning = |mass: &Mass, t: Vec3| {
        let t = crossing(t);
        t * mass.inverse_inertia * t
    };
    Mat3::from_diagonal(Vec3::splat(mass_1.inverse_mass + mass_2.inverse_mass))
        - turning(mass_1, t1)
        - turning(mass_2, t2)
}

/// [t]: the matrix with [t] a = t × a.
#[inline]
fn crossing(t: Vec3) -> Mat3 {
    Mat3::from_cols(
        Vec3::new(0.0, t.z, -t.y),
        Vec3::new(-t.z, 0.0, t.x),
        Vec3::new(t.y, -t.x, 0.0),
    )
}
// ANCHOR_END: pin_matrix

// ANCHOR: turn_response
/// g·(M₁ + M₂) g: how much g·(ω₂ − ω₁) changes by a unit angular impulse g, 1/(kg m²).
#[inline]
#[must_use]
pub fn turn_response(mass_1: &Mass, mass_2: &Mass, g: Vec3) -> Real {
    g.dot(mass_1.moment(g) + mass_2.moment(g))
}
// ANCHOR_END: turn_response

// ANCHOR: lever
/// How two pinned bodies turn against each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lever {
    /// g: angular impulse on the child; the parent gets its opposite.
    pub turn: Vec3,
    /// Impulse at the pin on the parent that goes with it; the child gets its opposite.
    pub pin: Vec3,
    /// What g·(ω₂ − ω₁) changes by.
    pub response: Real,
}

/// How the two turn about the pin: a unit angular impulse g on the child, and its opposite on the
/// parent, would also part the points; the lever's impulse at the pin keeps them together. K⁻¹ is
/// the inverse of [`pin_matrix`].
#[inline]
#[must_use]
pub fn lever(parent: &Mass, t1: Vec3, child: &Mass, t2: Vec3, k_inverse: Mat3, g: Vec3) -> Lever {
    let (turn_1, turn_2) = (parent.moment(g), child.moment(g));
    let parting = -turn_1.cross(t1) - turn_2.cross(t2);
    let pin = k_inverse * -parting;
    Lever {
        turn: g,
        pin,
        response: g.dot(turn_1 + turn_2) + parting.dot(pin),
    }
}
// ANCHOR_END: lever

// ANCHOR: parted
/// Relative velocity of two pinned points in the middle of the last step, m/s, as far as it comes
/// from their circling.
///
/// On a curved path the points part along the tangent, in the middle of the last step outwards
/// and in the middle of the next inwards, equally fast: now, halfway between, they don't.
#[inline]
#[must_use]
pub fn parted(one: Velocity, t1: Vec3, two: Velocity, t2: Vec3, dt: Real) -> Vec3 {
    let circling = |omega: Vec3, t: Vec3| 0.5 * dt * omega.length_squared() * t.length();
    let most = circling(one.omega, t1) + circling(two.omega, t2);
    relative_velocity(one, t1, two, t2).clamp_length_max(most)
}
// ANCHOR_END: parted

// ANCHOR: distance
/// The distance constraint 0 = |d| − l: the positional impulse on body 1, kg m, that brings the
/// points t₁ and t₂, which are d apart, back to the distance l. Report 9.2.
#[inline]
#[must_use]
pub fn distance_correction(
    mass_1: &Mass,
    t1: Vec3,
    mass_2: &Mass,
    t2: Vec3,
    d: Vec3,
    length: Real,
) -> Vec3 {
    let distance = d.length();
    if distance == 0.0 {
        return Vec3::ZERO;
    }
    let u = d / distance;
    u * ((length - distance) / response(mass_1, t1, mass_2, t2, u))
}
// ANCHOR_END: distance
