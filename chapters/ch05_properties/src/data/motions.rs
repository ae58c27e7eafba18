//! What bodies go through while contacts and joints are resolved. A row a body, in the bodies' order:
//! notes of a step, which nobody needs after it, but for the inertia that joints put back with.

use glam::{Mat3, Vec3};

crate::table! {
    /// How each body moves while contacts and joints are resolved.
    pub struct Motions of
    /// A body's motion.
    Motion in "motions" {
        /// Its velocity, as far as it is resolved.
        velocity: Vec3, "v", "m/s";
        /// Its angular velocity, as far as it is resolved.
        spin: Vec3, "ω", "rad/s";
        /// How far it has been nudged.
        shift: Vec3, "δp", "m";
        /// By what it has been turned.
        turn: Vec3, "δq", "rad";
        /// I⁻¹ in world axes.
        inverse_inertia: Mat3, "M", "1/(kg m²)";
        /// I⁻¹ of a ball.
        inverse_moment: f32, "1/I", "1/(kg m²)";
        /// The visit that last changed it.
        changed: u32, "changed", "";
        /// What torques change its angular velocity by in half a step.
        spin_kick: Vec3, "½Δω", "rad/s";
    }
}
