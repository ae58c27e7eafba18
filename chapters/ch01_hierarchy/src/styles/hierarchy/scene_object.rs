//! The base class: what every object in the tree has and does.

use crate::Transform;

// ANCHOR: base
/// The base class's fields, embedded by every class.
pub struct Base {
    pub id: usize,
    pub local: Transform,
    pub world: Transform,
    pub children: Vec<Box<dyn SceneObject>>,
}

/// The base class's virtual functions.
pub trait SceneObject {
    fn base(&self) -> &Base;
    fn base_mut(&mut self) -> &mut Base;

    /// What a class does in a frame: moves `local`.
    fn advance(&mut self, dt: f32);

    /// Inherited by all: advances, follows the parent, and passes it on.
    fn update(&mut self, parent: Option<&Transform>, dt: f32) {
        self.advance(dt);
        let base = self.base_mut();
        base.world = parent.map_or(base.local, |parent| *parent * base.local);
        for child in &mut base.children {
            child.update(Some(&base.world), dt);
        }
    }

    // ANCHOR: glow
    fn glow(&self) -> f32 {
        0.0
    }
    // ANCHOR_END: glow
}
// ANCHOR_END: base

impl Base {
    pub fn new(id: usize, local: Transform) -> Self {
        Self {
            id,
            local,
            world: local,
            children: Vec::new(),
        }
    }
}

/// Visits an object and all below it.
pub fn walk(object: &dyn SceneObject, visit: &mut impl FnMut(&dyn SceneObject)) {
    visit(object);
    for child in &object.base().children {
        walk(child.as_ref(), visit);
    }
}
