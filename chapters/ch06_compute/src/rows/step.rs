//! What all rows of a step share: a uniform.

use glam::{Quat, Vec3};

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
        /// A contact that changes the speed by more is an impact: it is over with the substep.
        impact_speed: f32, "", "m/s";
        /// The share where a pair has several points.
        push_share_of_many: f32, "β", "";
        /// Unused.
        spare_2: f32, "", "";
        /// Unused.
        spare_3: f32, "", "";
    }

    /// Where a body is drawn: the layout is that of the window's `Drawn`.
    pub struct Drawn {
        /// World position after the last step.
        position: Vec3, "p", "m";
        /// Unused.
        spare: f32, "", "";
        /// Body to world after the last step.
        orientation: Quat, "q", "";
        /// World position before it.
        position_last: Vec3, "p*", "m";
        /// Unused.
        spare_last: f32, "", "";
        /// Body to world before it.
        orientation_last: Quat, "q*", "";
    }

    /// How a body moves, for whoever looks.
    pub struct Seen {
        /// World velocity.
        velocity: Vec3, "v", "m/s";
        /// Unused.
        spare: f32, "", "";
        /// World angular velocity.
        angular_velocity: Vec3, "ω", "rad/s";
        /// Unused.
        spare_2: f32, "", "";
    }
}
