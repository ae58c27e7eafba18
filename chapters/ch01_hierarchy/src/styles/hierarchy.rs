//! The scene as a class hierarchy: `SceneObject` ← `Orbiter` ← `SpinningOrbiter`, and
//! `SceneObject` ← `Spinner`. Each object owns its children.
//!
//! Rust has no inheritance; a base class becomes two things. Its fields are a struct that the
//! derived one embeds, its virtual functions are a trait whose default bodies are inherited.

mod living;
mod orbiter;
mod scene_object;
// ANCHOR: spinning
mod spinner;
mod spinning_orbiter;
// ANCHOR_END: spinning

use super::items::{Item, Kind};
use super::{Bytes, Style};
use crate::Transform;
use living::Entry;
use orbiter::Orbiter;
use scene_object::{SceneObject, walk};
// ANCHOR: spinning
use spinner::Spinner;
use spinning_orbiter::SpinningOrbiter;
// ANCHOR_END: spinning

/// The scene: its roots own everything.
pub struct World {
    roots: Vec<Box<dyn SceneObject>>,
    /// Rows of a column: a slot that nobody lives in keeps its row.
    count: usize,
    directory: Vec<Entry>,
    /// Slots without an object, the one to be used next at the end.
    free: Vec<u32>,
}

// ANCHOR: make
fn make(id: usize, item: &Item) -> Box<dyn SceneObject> {
    match item.kind {
        Kind::Orbiter => Box::new(Orbiter::new(id, item)),
        // ANCHOR: spinning
        Kind::Spinner => Box::new(Spinner::new(id, item)),
        Kind::SpinningOrbiter => Box::new(SpinningOrbiter::new(id, item)),
        // ANCHOR_END: spinning
    }
}
// ANCHOR_END: make

impl World {
    /// A column with one value an object, which the walk finds in the order of the tree.
    fn gather<T: Copy>(&self, column: &mut Vec<T>, empty: T, get: impl Fn(&dyn SceneObject) -> T) {
        column.clear();
        column.resize(self.count, empty);
        for root in &self.roots {
            walk(root.as_ref(), &mut |object| {
                column[object.base().id] = get(object);
            });
        }
    }
}

impl Style for World {
    const NAME: &'static str = "hierarchy";

    fn build(items: &[Item]) -> Self {
        let mut made: Vec<_> = (0..items.len()).map(|id| make(id, &items[id])).collect();
        let mut roots = Vec::new();
        // From the last to the first, each has its children by the time its parent takes it.
        while let Some(object) = made.pop() {
            match items[made.len()].parent {
                Some(parent) => made[parent].base_mut().children.push(object),
                None => roots.push(object),
            }
        }
        let count = items.len();
        let directory = Self::directory_of(&roots, count);
        Self {
            roots,
            count,
            directory,
            free: Vec::new(),
        }
    }

    fn update(&mut self, dt: f32) {
        for root in &mut self.roots {
            root.update(None, dt);
        }
    }

    fn gather_positions(&self, column: &mut Vec<[f32; 3]>) {
        self.gather(column, [0.0; 3], |object| {
            object.base().world.translation.into()
        });
    }

    fn gather_poses(&self, column: &mut Vec<Transform>) {
        self.gather(column, Transform::IDENTITY, |object| object.base().world);
    }

    // ANCHOR: glow
    fn gather_glow(&self, column: &mut Vec<f32>) {
        self.gather(column, 0.0, |object| object.glow());
    }
    // ANCHOR_END: glow

    fn bytes(items: &[Item]) -> Bytes {
        Bytes::sum(items, |item| {
            let object = match item.kind {
                Kind::Orbiter => size_of::<Orbiter>(),
                Kind::Spinner => size_of::<Spinner>(),
                Kind::SpinningOrbiter => size_of::<SpinningOrbiter>(),
            };
            let visited = size_of::<Box<dyn SceneObject>>() + object;
            Bytes {
                update: visited,
                gather: visited,
            }
        })
    }
}
