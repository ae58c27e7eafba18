//! A body that turns about a point fixed in the world: its place follows from its attitude.
//!
//! With the moments of inertia about that point, I + m(|s|² − s sᵀ), Euler's equations hold
//! as they do about the centre, and gravity becomes the torque (q ∗ s) × m g. (Scenario 8.)

use ch00_maths::f32::inertia::about_point;
use glam::Vec3;

/// The fixed point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedPoint {
    /// Where it is in the world, m.
    pub point: Vec3,
    /// From it to the body's centre, in the body's axes, m.
    pub arm: Vec3,
}

impl FixedPoint {
    // ANCHOR: moments
    /// Principal moments about the fixed point, kg m²; `None` where the arm makes them mix,
    /// that is unless it lies along one of the body's axes.
    #[must_use]
    pub fn moments(&self, inertia: Vec3, mass: f32) -> Option<Vec3> {
        about_point(inertia, mass, self.arm)
    }
    // ANCHOR_END: moments
}
