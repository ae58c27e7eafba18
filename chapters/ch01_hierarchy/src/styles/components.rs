//! The scene as components: an object is an entity, which is nothing but a list of parts.
//! What an object is follows from what it has.

mod circle;
mod entity;
// ANCHOR: glow
mod glow;
// ANCHOR_END: glow
mod living;
mod placement;
// ANCHOR: spinning
mod spin;
// ANCHOR_END: spinning

use super::items::{Item, Kind};
use super::{Bytes, Style};
use crate::Transform;
use circle::Circle;
use entity::{Component, Entity};
// ANCHOR: glow
use glow::Glow;
// ANCHOR_END: glow
use living::Place;
use placement::Placement;
// ANCHOR: spinning
use spin::Spin;
// ANCHOR_END: spinning

/// The scene: a list of entities, each after its parent.
pub struct World {
    entities: Vec<Entity>,
    /// Whether an entity is there, and how many were before.
    places: Vec<Place>,
    /// Places without an entity, the one to be used next at the end.
    free: Vec<u32>,
}

// ANCHOR: make
fn make(item: &Item) -> Entity {
    let mut entity = Entity::new(Placement::new(item));
    if item.kind != Kind::Spinner {
        entity.add(Circle::new(item));
    }
    // ANCHOR: spinning
    if item.kind != Kind::Orbiter {
        entity.add(Spin::new(item));
        // ANCHOR: glow
        entity.add(Glow::default());
        // ANCHOR_END: glow
    }
    // ANCHOR_END: spinning
    entity
}
// ANCHOR_END: make

impl World {
    // ANCHOR: follow_parent
    /// The entity's world transform from its parent's, which comes before it in the list.
    fn follow_parent(&mut self, index: usize) {
        let (before, rest) = self.entities.split_at_mut(index);
        let placement = &mut rest[0].placement;
        placement.world = match placement.parent {
            Some(parent) => before[parent].placement.world * placement.local,
            None => placement.local,
        };
    }
    // ANCHOR_END: follow_parent

    fn gather<T>(&self, column: &mut Vec<T>, get: impl Fn(&Entity) -> T) {
        column.clear();
        column.extend(self.entities.iter().map(get));
    }
}

impl Style for World {
    const NAME: &'static str = "components";

    fn build(items: &[Item]) -> Self {
        Self {
            entities: items.iter().map(make).collect(),
            places: vec![Place::FIRST; items.len()],
            free: Vec::new(),
        }
    }

    fn update(&mut self, dt: f32) {
        for index in 0..self.entities.len() {
            self.entities[index].update(dt);
            self.follow_parent(index);
        }
    }

    fn gather_positions(&self, column: &mut Vec<[f32; 3]>) {
        self.gather(column, |entity| entity.placement.world.translation.into());
    }

    fn gather_poses(&self, column: &mut Vec<Transform>) {
        self.gather(column, |entity| entity.placement.world);
    }

    // ANCHOR: glow
    fn gather_glow(&self, column: &mut Vec<f32>) {
        self.gather(column, |entity| {
            entity.get::<Glow>().map_or(0.0, |glow| glow.value)
        });
    }
    // ANCHOR_END: glow

    fn bytes(items: &[Item]) -> Bytes {
        let pointer = size_of::<Box<dyn Component>>();
        let gather = size_of::<Entity>();
        Bytes::sum(items, |item| {
            let mut update = gather;
            if item.kind != Kind::Spinner {
                update += pointer + size_of::<Circle>();
            }
            if item.kind != Kind::Orbiter {
                update += 2 * pointer + size_of::<Spin>() + size_of::<Glow>();
            }
            Bytes { update, gather }
        })
    }
}
