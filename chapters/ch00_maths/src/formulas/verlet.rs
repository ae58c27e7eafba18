//! Velocity-less Verlet for positions: the state is p, the position, and p*, the position
//! one step earlier. Report 8.2 and 8.3 after [Baltman and Radeztsky 2004].
//!
//! p⁺ = p + (p − p*) Δt/Δt* + ½ a Δt (Δt + Δt*). Errata 2, 8 and 9 are about this file.

use super::real::{Real, Vec3};

// ANCHOR: velocity
/// v(p, p*) = (p − p*)/Δt, m/s: the mean velocity over the last step, which is the
/// velocity half a step ago. Report 8.2.
#[inline]
#[must_use]
pub fn velocity(p: Vec3, p_last: Vec3, dt: Real) -> Vec3 {
    (p - p_last) / dt
}

/// The velocity now: v(p, p*) and half a step of acceleration. Erratum 9.
#[inline]
#[must_use]
pub fn velocity_now(p: Vec3, p_last: Vec3, a: Vec3, dt: Real) -> Vec3 {
    (p - p_last) / dt + 0.5 * dt * a
}
// ANCHOR_END: velocity

// ANCHOR: last_position
/// The p* of a body at p that has velocity v now: p* = p − v Δt + ½ a Δt².
///
/// The inverse of [`velocity_now`]. Used at the start and wherever an impulse sets a velocity.
#[inline]
#[must_use]
pub fn last_position(p: Vec3, v: Vec3, a: Vec3, dt: Real) -> Vec3 {
    p - (v - 0.5 * dt * a) * dt
}
// ANCHOR_END: last_position

// ANCHOR: step
/// One step: the displacement p⁺ − p, m, over `dt` seconds after a step of `dt_last`.
///
/// `kept` is the drag's factor. Exact for constant acceleration, however uneven the steps.
#[inline]
#[must_use]
pub fn displacement(p: Vec3, p_last: Vec3, a: Vec3, kept: Real, dt: Real, dt_last: Real) -> Vec3 {
    (p - p_last) * (kept * dt / dt_last) + a * (0.5 * dt * (dt + dt_last))
}
// ANCHOR_END: step

/// The formulas as the report prints them.
pub mod printed {
    use super::{Real, Vec3};

    // ANCHOR: printed
    /// p* = p − v Δt: half a step of acceleration short. Erratum 9.
    #[inline]
    #[must_use]
    pub fn last_position(p: Vec3, v: Vec3, dt: Real) -> Vec3 {
        p - v * dt
    }

    /// Δp = (p − p*) f + a Δt²: takes every step to be as long as the last. Erratum 8.
    #[inline]
    #[must_use]
    pub fn displacement(p: Vec3, p_last: Vec3, a: Vec3, kept: Real, dt: Real) -> Vec3 {
        (p - p_last) * kept + a * (dt * dt)
    }
    // ANCHOR_END: printed
}
