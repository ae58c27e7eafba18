//! Why a scene can't be run on a graphics device.

use thiserror::Error;

use crate::own_row::tree::TreeError;
use crate::stream::StreamError;

/// What keeps a scene from the device.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ComputeError {
    /// The device can't do it.
    #[error(transparent)]
    Stream(#[from] StreamError),
    /// A tree of joints is too large.
    #[error(transparent)]
    Tree(#[from] TreeError),
    /// Something that no kernel knows.
    #[error("bodies[{body}]: {what} isn't computed on a graphics device")]
    Unsupported {
        /// What it is.
        what: String,
        /// The body that has it.
        body: usize,
    },
}
