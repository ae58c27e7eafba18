//! Drag: the fraction of a velocity that a step leaves. Report 8.3, erratum 11.
//!
//! dv/dt = −F v has the solution v(t) = v₀ exp(−F t), so a step keeps exp(−F Δt).

use super::real::{Real, exp};

// ANCHOR: kept
/// Fraction of a velocity that is left after `dt` seconds of drag at the rate F, 1/s.
#[must_use]
pub fn kept(rate: Real, dt: Real) -> Real {
    exp(-rate * dt)
}
// ANCHOR_END: kept

/// The formula as the report prints it.
pub mod printed {
    use super::Real;

    // ANCHOR: printed
    /// f = 1 − Δt F: its first-order series. What is left after a second depends on Δt.
    #[must_use]
    pub fn kept(rate: Real, dt: Real) -> Real {
        1.0 - dt * rate
    }
    // ANCHOR_END: printed
}
