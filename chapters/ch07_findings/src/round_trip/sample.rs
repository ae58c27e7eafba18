//! What the kept tables hold of some number of bodies.

use crate::FindingsError;
use crate::kept::Line;

/// What was measured of some number of bodies, ms a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// How many.
    pub bodies: f64,
    /// Up and down together.
    pub bytes: f64,
    /// Chapter 5's systems on one thread.
    pub properties: f64,
    /// Upload, kernels and download.
    pub round_trip: f64,
    /// Each of [`PARTS`](super::PARTS), waited for by itself.
    pub parts: [f64; 3],
    /// By the GPU's own clock; not a number where it has none.
    pub kernels: f64,
}

impl Sample {
    /// A line of a table.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] for what is no number, or not positive.
    pub fn of(line: Line) -> Result<Self, FindingsError> {
        Ok(Self {
            bodies: line.positive("bodies")?,
            bytes: line.positive("bytes_a_body")?,
            properties: line.positive("ch05_ms")?,
            round_trip: line.positive("round_trip_ms")?,
            parts: [
                line.positive("upload_ms")?,
                line.positive("compute_ms")?,
                line.positive("download_ms")?,
            ],
            kernels: line.number("kernels_ms")?,
        })
    }

    /// What each part takes of all three.
    #[must_use]
    pub fn shares(&self) -> [f64; 3] {
        let sum: f64 = self.parts.iter().sum();
        self.parts.map(|part| part / sum)
    }

    /// How many times as long chapter 5 takes.
    #[must_use]
    pub fn gain(&self) -> f64 {
        self.properties / self.round_trip
    }
}
