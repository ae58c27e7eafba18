//! Resolution: what happens to bodies that touch. Report 8.4, as printed and corrected.

mod constraint;
mod corrected;
mod links;
mod printed;

pub use corrected::{FAR_NUDGE, SMALL_NUDGE, resolve_corrected};
pub use links::{Links, NoLinks};
pub use printed::resolve_printed;

use ch00_scenes::{Body, Scene, Shape};

use crate::Margins;

/// How long the step is that is resolved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// s.
    pub dt: f32,
    /// How many times as long as the last one. What carries a body for longer is a larger impulse.
    pub longer: f32,
}

/// What the corrected resolution may choose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Sweeps over the contacts at most, for pushing, for impacts and for resting contact each.
    pub sweeps: u32,
    /// Impacts slower than this don't bounce, m/s.
    pub restitution_threshold: f32,
    /// Depth that is left alone, m: bodies at rest stay in touch.
    pub slop: f32,
    /// Sweeps end when none changes a relative velocity by more than this, m/s.
    pub still: f32,
}

/// Sweeps at most, unless `--sweeps` says otherwise.
pub const DEFAULT_SWEEPS: u32 = 16;

/// The same where all that moves are balls and nothing joins them: no tower leans, no limb folds.
pub const DEFAULT_SWEEPS_OF_BALLS: u32 = 8;

/// Sweeps at most in this scene, unless the user says otherwise.
#[must_use]
pub fn default_sweeps(scene: &Scene) -> u32 {
    let is_ball = |body: &Body| matches!(body.shape, Shape::Sphere { .. });
    let moving_are_balls = |body: &Body| body.is_static() || is_ball(body);
    if scene.joints.is_empty() && scene.bodies.iter().all(moving_are_balls) {
        DEFAULT_SWEEPS_OF_BALLS
    } else {
        DEFAULT_SWEEPS
    }
}

/// The furthest that bodies that move may push each other in a step, m.
pub const LONGEST_SHIFT: f32 = 0.1;

impl Rules {
    // ANCHOR: margins
    /// What must be known to resolve a step of `dt` seconds: pairs that could meet in the next step
    /// without bouncing, and obstacles into which a push could shift a body.
    ///
    /// Looking ahead has its limit: what moves further than this in a step can still pass through.
    #[must_use]
    pub fn margins(&self, dt: f32) -> Margins {
        let moving = self.restitution_threshold * dt + self.slop;
        Margins {
            moving,
            obstacle: moving.max(LONGEST_SHIFT),
            ahead: LONGEST_SHIFT,
        }
    }
    // ANCHOR_END: margins
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            sweeps: DEFAULT_SWEEPS,
            restitution_threshold: 0.5,
            slop: 0.001,
            still: 1e-4,
        }
    }
}
