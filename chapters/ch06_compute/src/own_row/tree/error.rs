//! Why the joints of a scene can't be solved on a graphics device.

use thiserror::Error;

// ANCHOR: error
/// A tree that no workgroup holds.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "joints[{joint}] hangs body {body} on a tree of {bodies} bodies; a workgroup solves {most} at most: \
     run it with `--engine lanes`, or hang the rest on a static body"
)]
pub struct TreeError {
    /// Index in the scene of the first joint that is too many.
    pub joint: usize,
    /// The body that it would hang up.
    pub body: usize,
    /// How many bodies the tree has.
    pub bodies: usize,
    /// How many it may have.
    pub most: usize,
}
// ANCHOR_END: error
