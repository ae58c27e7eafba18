//! `Placement`: where the entity is. Every entity has one and nearly every part needs it, so
//! it is a field and not looked up, as in the engines that ship.

use crate::Transform;
use crate::styles::formulas;
use crate::styles::items::Item;

/// In the parent and in the world.
pub struct Placement {
    pub parent: Option<usize>,
    pub local: Transform,
    pub world: Transform,
}

impl Placement {
    /// Of an entity that was removed.
    pub const NOWHERE: Self = Self {
        parent: None,
        local: Transform::IDENTITY,
        world: Transform::IDENTITY,
    };

    pub fn new(item: &Item) -> Self {
        let local = Transform::from_translation(formulas::circle(item.radius, item.phase));
        Self {
            parent: item.parent,
            local,
            world: local,
        }
    }
}
