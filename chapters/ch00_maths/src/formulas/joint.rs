//! What joints need beside the pin: how two bodies answer to an impulse that turns them, and the
//! distance constraint. Report 9.2 to 9.4.

use super::impulse::{Mass, response};
use super::real::{Mat3, Real, Vec3};

// ANCHOR: pin_matrix
/// K = (m₁⁻¹ + m₂⁻¹) 1 − [t₁] I₁⁻¹ [t₁] − [t₂] I₂⁻¹ [t₂]: how the gap between two pinned points changes
/// by an impulse, 1/kg, with [t] the matrix of t × .
///
/// The report divides by the one number d̂·K d̂. That closes the gap along d̂ and opens it across,
/// since K d̂ seldom points along d̂; K⁻¹ d closes all of it.
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
fn crossing(t: Vec3) -> Mat3 {
    Mat3::from_cols(
        Vec3::new(0.0, t.z, -t.y),
        Vec3::new(-t.z, 0.0, t.x),
        Vec3::new(t.y, -t.x, 0.0),
    )
}
// ANCHOR_END: pin_matrix

// ANCHOR: turn_response
/// g·(M₁ + M₂) g: how much g·(ω₂ − ω₁) changes by a unit turning impulse g, 1/(kg m²).
#[must_use]
pub fn turn_response(mass_1: &Mass, mass_2: &Mass, g: Vec3) -> Real {
    g.dot(mass_1.moment(g) + mass_2.moment(g))
}
// ANCHOR_END: turn_response

// ANCHOR: distance
/// The distance constraint 0 = |d| − l: the positional impulse on body 1, kg m, that brings the
/// points t₁ and t₂, which are d apart, back to the distance l. Report 9.2.
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
