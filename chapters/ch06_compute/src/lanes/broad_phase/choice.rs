//! Which way to look for candidates: by measurement.

use super::{Bound, bound};

/// From this spread of sizes on a tree is quicker than grids: `--example broad_phases`, crowds `unequal`. Radii that
/// are spread evenly by logarithm from 1 to 13 have it.
pub const UNEQUAL: f32 = 8.0;

// ANCHOR: choice
/// How boxes that may overlap are found. What is found is the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    /// Grids by size.
    #[default]
    Grids,
    /// A bounding volume hierarchy.
    Tree,
}

/// The quicker way for boxes of such a spread.
#[must_use]
pub fn of(spread: f32) -> Way {
    if spread < UNEQUAL {
        Way::Grids
    } else {
        Way::Tree
    }
}

/// How many times as wide as a small box a large one is: nine of ten are smaller than the one, one of ten is smaller
/// than the other.
#[must_use]
pub fn spread(bounds: &[Bound]) -> f32 {
    let mut extents = bound::some_extents(bounds);
    extents.sort_unstable_by(f32::total_cmp);
    let at = |tenths: usize| extents.get(tenths * extents.len() / 10);
    match (at(1), at(9)) {
        (Some(small), Some(large)) => large / small,
        _ => 1.0,
    }
}
// ANCHOR_END: choice
