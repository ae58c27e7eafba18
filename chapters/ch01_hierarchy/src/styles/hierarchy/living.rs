//! IDs for a tree in which each object owns its children.
//!
//! Where C++ hands out a pointer to the object, an owned tree has a way to it: from the root down,
//! which child to take. A directory has for each object its parent and its place among the
//! children.

use glam::Vec3;

use super::scene_object::{SceneObject, walk};
use super::{World, make};
use crate::Transform;
use crate::styles::Style;
use crate::styles::items::Item;
use crate::styles::living::{Living, ObjectId};

/// Where the object of a slot hangs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Entry {
    /// Slot of its parent; its own for a root.
    parent: u32,
    /// Place among its parent's children, or among the roots.
    place: u32,
    generation: u32,
    alive: bool,
}

impl World {
    /// A directory of the tree, and no free slot.
    pub(super) fn directory_of(roots: &[Box<dyn SceneObject>], count: usize) -> Vec<Entry> {
        let mut directory = vec![Entry::default(); count];
        let mut note = |parent: usize, place: usize, child: &dyn SceneObject| {
            directory[child.base().id] = Entry {
                parent: parent as u32,
                place: place as u32,
                generation: 0,
                alive: true,
            };
        };
        for (place, root) in roots.iter().enumerate() {
            note(root.base().id, place, root.as_ref());
            walk(root.as_ref(), &mut |object| {
                for (place, child) in object.base().children.iter().enumerate() {
                    note(object.base().id, place, child.as_ref());
                }
            });
        }
        directory
    }

    #[inline]
    fn entry(&self, id: ObjectId) -> Option<&Entry> {
        let entry = self.directory.get(id.slot as usize)?;
        (entry.alive && entry.generation == id.generation).then_some(entry)
    }

    // ANCHOR: find
    /// The object in a slot: its parent's child, and the parent is found likewise.
    fn object(&self, slot: u32) -> &dyn SceneObject {
        let Entry { parent, place, .. } = self.directory[slot as usize];
        let siblings = if parent == slot {
            &self.roots
        } else {
            &self.object(parent).base().children
        };
        siblings[place as usize].as_ref()
    }
    // ANCHOR_END: find

    #[inline]
    fn find(&self, id: ObjectId) -> Option<&dyn SceneObject> {
        self.entry(id).map(|_| self.object(id.slot))
    }

    /// The list in which a child of the object in slot `parent` stands.
    fn children_of(&mut self, parent: u32) -> &mut Vec<Box<dyn SceneObject>> {
        children_below(&mut self.roots, &self.directory, parent)
    }

    fn remove_one(&mut self, id: ObjectId) {
        let Some(&Entry { parent, place, .. }) = self.entry(id) else {
            return;
        };
        let siblings = if parent == id.slot {
            &mut self.roots
        } else {
            self.children_of(parent)
        };
        drop(siblings.swap_remove(place as usize));
        // The last sibling took its place; of the roots, each is its own parent.
        if let Some(moved) = siblings.get(place as usize) {
            let slot = moved.base().id;
            self.directory[slot].place = place;
        }
        let entry = &mut self.directory[id.slot as usize];
        entry.alive = false;
        entry.generation = entry.generation.wrapping_add(1);
        self.free.push(id.slot);
    }
}

fn children_below<'a>(
    roots: &'a mut Vec<Box<dyn SceneObject>>,
    directory: &[Entry],
    slot: u32,
) -> &'a mut Vec<Box<dyn SceneObject>> {
    let Entry { parent, place, .. } = directory[slot as usize];
    let siblings = if parent == slot {
        roots
    } else {
        children_below(roots, directory, parent)
    };
    &mut siblings[place as usize].base_mut().children
}

impl Living for World {
    type Id = ObjectId;

    fn populate(items: &[Item]) -> (Self, Vec<ObjectId>) {
        let ids = (0..items.len()).map(ObjectId::first).collect();
        (Self::build(items), ids)
    }

    #[inline]
    fn frames(&self, id: ObjectId) -> Option<(Transform, Transform)> {
        let base = self.find(id)?.base();
        Some((base.local, base.world))
    }

    #[inline]
    fn position(&self, id: ObjectId) -> Option<Vec3> {
        Some(self.find(id)?.base().world.translation)
    }

    fn count_brighter(&self, threshold: f32) -> usize {
        let mut count = 0;
        for root in &self.roots {
            walk(root.as_ref(), &mut |object| {
                count += usize::from(object.glow() > threshold);
            });
        }
        count
    }

    fn insert(&mut self, item: &Item, parent: ObjectId) -> ObjectId {
        assert!(self.entry(parent).is_some(), "the parent was removed");
        let slot = self.free.pop().unwrap_or_else(|| {
            self.directory.push(Entry::default());
            ObjectId::first(self.count).slot
        });
        let siblings = self.children_of(parent.slot);
        let place = siblings.len() as u32;
        siblings.push(make(slot as usize, item));
        let entry = &mut self.directory[slot as usize];
        *entry = Entry {
            parent: parent.slot,
            place,
            generation: entry.generation,
            alive: true,
        };
        let generation = entry.generation;
        self.count = self.directory.len();
        ObjectId { slot, generation }
    }

    fn remove(&mut self, ids: &[ObjectId]) {
        for &id in ids {
            self.remove_one(id);
        }
    }

    fn bytes_to_count(items: &[Item]) -> usize {
        Self::bytes(items).update
    }
}
