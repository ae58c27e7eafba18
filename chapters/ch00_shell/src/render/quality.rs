//! How much work a picture may be. A software device draws the same picture with a coarser
//! shadow and fewer triangles, so that it still moves.

/// What costs time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality {
    /// Samples a pixel along edges.
    pub samples: u32,
    /// Width and height of the shadow map, texels.
    pub shadow_size: u32,
    /// The shadow's edge is the mean of (2 reach + 1)² samples.
    pub shadow_reach: i32,
    /// How often a ball's icosahedron is divided where few balls are drawn.
    pub most_subdivisions: u32,
}

impl Quality {
    /// For a graphics card.
    pub const CARD: Self = Self {
        samples: 4,
        shadow_size: 2048,
        shadow_reach: 1,
        most_subdivisions: 4,
    };

    /// For a processor that imitates one.
    pub const SOFTWARE: Self = Self {
        samples: 4,
        shadow_size: 1024,
        shadow_reach: 0,
        most_subdivisions: 3,
    };

    /// What suits the device.
    #[must_use]
    pub fn of(is_software: bool) -> Self {
        if is_software {
            let e = |n: &str, d: u32| {
                std::env::var(n)
                    .ok()
                    .and_then(|v| v.parse().ok())
                    .unwrap_or(d)
            };
            Self {
                samples: e("SAMPLES", 4),
                shadow_size: e("SHADOW", 1024),
                most_subdivisions: e("SUB", 3),
                ..Self::SOFTWARE
            }
        } else {
            Self::CARD
        }
    }

    /// How often to divide a ball's icosahedron when so many balls are drawn.
    #[must_use]
    pub fn subdivisions(&self, balls: usize) -> u32 {
        let fewer = match balls {
            0..200 => 0,
            200..5_000 => 1,
            _ => 2,
        };
        self.most_subdivisions - fewer
    }
}
