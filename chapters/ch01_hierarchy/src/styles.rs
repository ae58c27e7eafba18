//! One small scene in three styles: as a class hierarchy, as components, and as the hybrid
//! of both. The same items, the same formulas, the same bits; only where a property lives
//! and who may touch it differs.
//!
//! Every line that the property `glow` cost, which was added when the rest was done, stands
//! between `ANCHOR: glow` and `ANCHOR_END: glow`, where [`cost`] counts it. What spinning costs,
//! and the two kinds that do it, stands between `ANCHOR: spinning` and its end: chapter 5 counts that.

pub mod components;
pub mod cost;
pub mod formulas;
pub mod hierarchy;
pub mod hybrid;
pub mod items;
pub mod living;
pub mod report;

use crate::Transform;
use items::Item;

// ANCHOR: style
/// What a style can be asked for. Rows are in one order, the same for every column: that of the
/// items, in all styles of this chapter.
pub trait Style {
    /// Name in tables.
    const NAME: &'static str;

    /// Makes the objects, one after the other as a level file lists them.
    fn build(items: &[Item]) -> Self;

    /// One frame of `dt` seconds: all objects move, then all world transforms follow.
    fn update(&mut self, dt: f32);

    /// The column of world positions (m), as a GPU wants it.
    fn gather_positions(&self, column: &mut Vec<[f32; 3]>);

    /// World transforms.
    fn gather_poses(&self, column: &mut Vec<Transform>);

    /// Brightness; 0 for what doesn't spin.
    fn gather_glow(&self, column: &mut Vec<f32>);

    /// Bytes of all records that a pass visits for these items.
    fn bytes(items: &[Item]) -> Bytes;
}
// ANCHOR_END: style

/// Bytes of the records that a pass reads or writes: each record whole and once, with the
/// pointer or list entry that leads to it, by `size_of`. Without names on the heap, lists of
/// children on the heap, and what the allocator adds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bytes {
    /// In [`Style::update`].
    pub update: usize,
    /// In [`Style::gather_positions`].
    pub gather: usize,
}

impl Bytes {
    /// The sum over items.
    #[must_use]
    pub fn sum(items: &[Item], bytes_of: impl Fn(&Item) -> Self) -> Self {
        items
            .iter()
            .map(bytes_of)
            .fold(Self::default(), |sum, one| Self {
                update: sum.update + one.update,
                gather: sum.gather + one.gather,
            })
    }
}
