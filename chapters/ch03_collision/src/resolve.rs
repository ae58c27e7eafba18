//! Resolution: what happens to bodies that touch. Report 8.4, as printed and corrected.

mod constraint;
mod corrected;
mod printed;

pub use corrected::resolve_corrected;
pub use printed::resolve_printed;

use crate::Margins;

/// What the corrected resolution may choose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Sweeps over the contacts, for pushing, for impacts and for resting contact each.
    pub sweeps: u32,
    /// Impacts slower than this don't bounce, m/s.
    pub restitution_threshold: f32,
    /// Depth that is left alone, m: bodies at rest stay in touch.
    pub slop: f32,
}

/// Sweeps unless `--sweeps` says otherwise.
pub const DEFAULT_SWEEPS: u32 = 8;

/// The furthest that bodies that move may push each other in a step, m.
pub const LONGEST_SHIFT: f32 = 0.1;

impl Rules {
    // ANCHOR: margins
    /// What must be known to resolve a step of `dt` seconds: pairs that could meet in the next step
    /// without bouncing, and obstacles into which a push could shift a body.
    #[must_use]
    pub fn margins(&self, dt: f32) -> Margins {
        let moving = self.restitution_threshold * dt + self.slop;
        Margins {
            moving,
            obstacle: moving.max(LONGEST_SHIFT),
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
        }
    }
}
