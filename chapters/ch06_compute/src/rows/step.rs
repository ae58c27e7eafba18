//! What all rows of a step share: a uniform.

use glam::Vec3;

use super::layout::rows;

rows! {
    /// The numbers of a step.
    pub struct Step {
        /// Acceleration of every free body.
        gravity: Vec3, "g", "m/s²";
        /// Length of a substep.
        h: f32, "h", "s";
        /// What is left of a velocity after a substep of drag.
        drag: f32, "f", "";
        /// Slower approaches don't bounce.
        restitution_threshold: f32, "", "m/s";
        /// Depth that is left alone.
        slop: f32, "", "m";
        /// The share of the depth beyond it that a substep pushes out.
        push_share: f32, "β", "";
        /// The fastest push.
        fastest_push: f32, "", "m/s";
        /// How many bodies there are.
        bodies: u32, "", "";
        /// How many pairs there are.
        pairs: u32, "", "";
        /// Unused.
        spare: u32, "", "";
    }
}
