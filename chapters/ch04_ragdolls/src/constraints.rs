//! The constraints that a joint is made of, a file each. Every one knows its two bodies by the order
//! parent, child, and can do the same things with them:
//!
//! - `correct` puts them back after they have moved. p* and q* stay, so their velocities follow:
//!   that is the report's constraint update.
//! - `prepare`, `part`, `resume`, `hold` and `finish` take part in the resolution of contacts
//!   (chapter 3's `Links`), so that a joint and a contact on the same body agree.

mod anchors;
mod angle;
mod distance;
mod limits;
mod pin;

pub use anchors::{Anchors, Arms};
pub use angle::AngleConstraint;
pub use distance::DistanceConstraint;
pub use limits::{AngleLimits, Bound, MOST_ROWS, Row};
pub use pin::PinConstraint;

/// A gap, m, that is closed enough.
pub const SMALL_GAP: f32 = 1e-6;

/// A gap is wide if it is more than this share of the arms to the joint.
pub const WIDE: f32 = 0.01;

/// An angle, rad, that is near enough.
pub const SMALL_ANGLE: f32 = 1e-5;

/// The largest gap, m, that one nudge closes.
pub const LONGEST_GAP: f32 = 0.05;

/// The largest angle, rad, that one nudge turns.
pub const LARGEST_TURN: f32 = 0.2;
