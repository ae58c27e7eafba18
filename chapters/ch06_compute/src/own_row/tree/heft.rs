//! How hard a body is to move.

use crate::bodies::Bodies;
use crate::simd::{Real, Vec3};

// ANCHOR: heft
/// How hard a body is to move: what of it never changes, a body a lane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heft<R> {
    /// m, kg.
    pub mass: R,
    /// 1/m, 1/kg.
    pub inverse_mass: R,
    /// Principal moments of inertia, in its own axes, kg m².
    pub moments: Vec3<R>,
    /// Their inverses, 1/(kg m²).
    pub inverse_moments: Vec3<R>,
    /// The least of the moments, kg m².
    pub least: R,
    /// Its inverse, 1/(kg m²).
    pub stiffest: R,
}
// ANCHOR_END: heft

impl<R: Real> Heft<R> {
    /// Of the bodies whose rows `row` gives for each lane. None of them is static.
    pub fn of(bodies: &Bodies, row: impl Fn(usize) -> usize) -> Self {
        let inverse_mass = R::of(|lane| bodies.spin[row(lane)].inverse_mass);
        let inverse = |lane: usize| bodies.solid[row(lane)].inverse_inertia;
        let stiffest = R::of(|lane| inverse(lane).max_element());
        Self {
            mass: inverse_mass.recip(),
            inverse_mass,
            moments: Vec3::of(|lane| inverse(lane).recip()),
            inverse_moments: Vec3::of(inverse),
            least: stiffest.recip(),
            stiffest,
        }
    }
}
