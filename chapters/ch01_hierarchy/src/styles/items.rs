//! The scene that all styles build: a tree of items of three kinds, eight below each.

// ANCHOR: items
/// What an item does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Circles its parent.
    Orbiter,
    /// Stays where it is in its parent and spins.
    Spinner,
    /// Does both: the kind that a tree of classes has no good place for.
    SpinningOrbiter,
}

/// One thing in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Item {
    /// What it does.
    pub kind: Kind,
    /// Index of the item in whose frame it is; smaller than its own. `None` for the root.
    pub parent: Option<usize>,
    /// From the parent, m.
    pub radius: f32,
    /// Along the circle at the start, rad.
    pub phase: f32,
    /// Of circling, rad/s; kinds that don't circle ignore it.
    pub rate: f32,
    /// Of spinning, rad/s; kinds that don't spin ignore it.
    pub spin: f32,
}
// ANCHOR_END: items

impl Kind {
    /// Whether it turns on its own axis.
    #[must_use]
    pub fn spins(self) -> bool {
        self != Kind::Orbiter
    }
}

/// A scene of `count` items: item 0 is the root, the parent of item i is (i − 1) / 8, and the
/// kinds take turns.
#[must_use]
pub fn scene(count: usize) -> Vec<Item> {
    (0..count)
        .map(|i| {
            // Spreads the index over 0 … 1: the golden ratio's multiples never bunch.
            let spread = ((i as f64 * 0.618_033_988_749_895) % 1.0) as f32;
            Item {
                kind: [Kind::Orbiter, Kind::Spinner, Kind::SpinningOrbiter][i % 3],
                parent: i.checked_sub(1).map(|before| before / 8),
                radius: 0.5 + spread,
                phase: 6.0 * spread,
                rate: 0.2 + spread,
                spin: 3.0 - 5.0 * spread,
            }
        })
        .collect()
}
