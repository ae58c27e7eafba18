//! The forces of the book's scenes that depend on where bodies are: magnetic poles, and the damped
//! spring between a body and the mouse.

use super::impulse::Velocity;
use super::real::{Real, Vec3};

// ANCHOR: pole
/// The force, N, of one magnetic pole on another that is `between` away, m:
/// s₁ s₂/(d² + ε²) along the line between them. `strength` is s₁ s₂; like poles push.
#[must_use]
pub fn pole(between: Vec3, strength: Real, softening: Real) -> Vec3 {
    let squared = between.length_squared();
    if squared == 0.0 {
        return Vec3::ZERO;
    }
    between * (strength / ((squared + softening * softening) * squared.sqrt()))
}
// ANCHOR_END: pole

/// Natural frequency of [`spring`], rad/s: a body is at the mouse after about a quarter of a second.
const FREQUENCY: Real = 12.0;

/// The pull of a critically damped spring on the point `arm` from a body's centre, world axes, m, that
/// is `stretch` away from where it shall be: force, N, and torque about the centre, N m.
///
/// As stiff for a light body as for a heavy one.
#[must_use]
pub fn spring(mass: Real, arm: Vec3, stretch: Vec3, velocity: Velocity) -> (Vec3, Vec3) {
    let speed = velocity.v + velocity.omega.cross(arm);
    let force = mass * FREQUENCY * (FREQUENCY * stretch - 2.0 * speed);
    // The arm is kept short for the torque, so that a long thin body isn't whirled round.
    (force, 0.4 * arm.cross(force))
}
