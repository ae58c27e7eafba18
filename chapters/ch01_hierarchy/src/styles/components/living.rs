//! IDs for a list of entities, each after its parent: a place in the list, and which of the
//! entities that lived there. A place that is left is empty until another entity moves in.

use glam::Vec3;

use super::entity::{Component, Entity};
use super::glow::Glow;
use super::placement::Placement;
use super::{World, make};
use crate::Transform;
use crate::styles::Style;
use crate::styles::items::{Item, Kind};
use crate::styles::living::{Living, ObjectId};

/// A place in the list.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    generation: u32,
    taken: bool,
}

impl Place {
    pub const FIRST: Self = Self {
        generation: 0,
        taken: true,
    };
}

impl World {
    #[inline]
    fn find(&self, id: ObjectId) -> Option<&Entity> {
        let place = self.places.get(id.slot as usize)?;
        let lives = place.taken && place.generation == id.generation;
        lives.then(|| &self.entities[id.slot as usize])
    }

    // ANCHOR: remove
    fn remove_one(&mut self, id: ObjectId) {
        if self.find(id).is_none() {
            return;
        }
        // Nothing that could be updated, nowhere to be seen.
        self.entities[id.slot as usize] = Entity::new(Placement::NOWHERE);
        let place = &mut self.places[id.slot as usize];
        place.taken = false;
        place.generation = place.generation.wrapping_add(1);
        self.free.push(id.slot);
    }
    // ANCHOR_END: remove
}

impl Living for World {
    type Id = ObjectId;

    fn populate(items: &[Item]) -> (Self, Vec<ObjectId>) {
        let ids = (0..items.len()).map(ObjectId::first).collect();
        (Self::build(items), ids)
    }

    #[inline]
    fn frames(&self, id: ObjectId) -> Option<(Transform, Transform)> {
        let placement = &self.find(id)?.placement;
        Some((placement.local, placement.world))
    }

    #[inline]
    fn position(&self, id: ObjectId) -> Option<Vec3> {
        Some(self.find(id)?.placement.world.translation)
    }

    fn count_brighter(&self, threshold: f32) -> usize {
        let glows = self.entities.iter().filter_map(Entity::get::<Glow>);
        glows.filter(|glow| glow.value > threshold).count()
    }

    fn insert(&mut self, item: &Item, parent: ObjectId) -> ObjectId {
        assert!(self.find(parent).is_some(), "the parent was removed");
        let mut entity = make(item);
        entity.placement.parent = Some(parent.slot as usize);
        // Only a place after its parent's will do.
        let Some(slot) = self.free.pop_if(|slot| *slot > parent.slot) else {
            let id = ObjectId::first(self.entities.len());
            self.entities.push(entity);
            self.places.push(Place::FIRST);
            return id;
        };
        self.entities[slot as usize] = entity;
        let place = &mut self.places[slot as usize];
        place.taken = true;
        let generation = place.generation;
        ObjectId { slot, generation }
    }

    fn remove(&mut self, ids: &[ObjectId]) {
        for &id in ids {
            self.remove_one(id);
        }
    }

    fn bytes_to_count(items: &[Item]) -> usize {
        let pointer = size_of::<Box<dyn Component>>();
        let sum = items.iter().map(|item| match item.kind {
            Kind::Orbiter => size_of::<Entity>() + pointer,
            Kind::Spinner => size_of::<Entity>() + 2 * pointer + size_of::<Glow>(),
            Kind::SpinningOrbiter => size_of::<Entity>() + 3 * pointer + size_of::<Glow>(),
        });
        sum.sum()
    }
}
