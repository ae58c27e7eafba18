//! What chapter 5 asks of a style besides: objects that are known by an ID, that come and go, and
//! one property of all of them.

use glam::Vec3;

use super::Style;
use super::items::Item;
use crate::Transform;

// ANCHOR: living
/// A scene whose objects come and go.
///
/// An ID names an object for as long as it lives; afterwards it names nothing. Once objects were
/// removed, the rows of the columns are in whatever order, or have whatever holes, the style leaves.
pub trait Living: Style + Sized {
    /// Names an object.
    type Id: Copy;

    /// As [`Style::build`], and the IDs in the order of the items.
    fn populate(items: &[Item]) -> (Self, Vec<Self::Id>);

    /// Where it is in its parent and where it was in the world at the last update.
    fn frames(&self, id: Self::Id) -> Option<(Transform, Transform)>;

    /// Where it was in the world at the last update, m.
    fn position(&self, id: Self::Id) -> Option<Vec3>;

    /// How many glow brighter than `threshold`: a question to one property of all.
    fn count_brighter(&self, threshold: f32) -> usize;

    /// A new object below `parent`, where its item says; the item's own `parent` is not read. Its
    /// place in the world follows with the next update.
    ///
    /// # Panics
    /// If `parent` was removed.
    fn insert(&mut self, item: &Item, parent: Self::Id) -> Self::Id;

    /// Removes objects below which nothing hangs, all in one go: what has to be put in order
    /// afterwards is put in order once. IDs of objects that are gone are passed over.
    fn remove(&mut self, ids: &[Self::Id]);

    /// Bytes of all records that [`Living::count_brighter`] visits, as in [`super::Bytes`].
    fn bytes_to_count(items: &[Item]) -> usize;
}
// ANCHOR_END: living

/// Names a slot in a style's list, and which of the objects that lived there one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectId {
    pub(super) slot: u32,
    pub(super) generation: u32,
}

impl ObjectId {
    /// Of the object that a list of slots was built with.
    pub(super) fn first(slot: usize) -> Self {
        let slot = u32::try_from(slot).expect("fewer than 2³² objects fit into memory");
        Self {
            slot,
            generation: 0,
        }
    }
}
