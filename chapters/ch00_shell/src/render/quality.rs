//! How much work a picture may be. A software device draws the same picture with a coarser
//! shadow, and takes one sample a pixel where that shows least, so that it still moves.

use super::surroundings::Surroundings;

/// What costs time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality {
    /// Samples a pixel: 4, or 1 where only lines and balls have edges to speak of. Those
    /// smooth their edges themselves.
    pub samples: u32,
    /// Width and height of the shadow map, texels.
    pub shadow_size: u32,
    /// The shadow's edge is the mean of (2 reach + 1)² samples.
    pub shadow_reach: i32,
}

impl Quality {
    /// For a graphics card.
    pub const CARD: Self = Self {
        samples: 4,
        shadow_size: 2048,
        shadow_reach: 1,
    };

    /// For a processor that imitates one.
    const SOFTWARE: Self = Self {
        samples: 4,
        shadow_size: 1024,
        shadow_reach: 0,
    };

    /// What suits the device and the scene.
    #[must_use]
    pub fn of(is_software: bool, surroundings: &Surroundings) -> Self {
        match (is_software, surroundings.has_edges) {
            (false, _) => Self::CARD,
            (true, true) => Self::SOFTWARE,
            (true, false) => Self {
                samples: 1,
                ..Self::SOFTWARE
            },
        }
    }
}
