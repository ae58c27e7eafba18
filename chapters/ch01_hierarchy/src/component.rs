//! What a game object is made of: parts that several kinds of object have in common.

use crate::Transform;

// ANCHOR: component
/// A part of a game object. It owns the properties that it needs, and its owner knows it by
/// its type: `spinner.spin.rate`, no search.
pub trait Component {
    /// Advances by `dt` seconds and writes its share of its owner's place: a circling part
    /// writes the translation, a spinning part the rotation.
    fn update(&mut self, local: &mut Transform, dt: f32);
}
// ANCHOR_END: component
