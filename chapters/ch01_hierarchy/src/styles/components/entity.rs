//! An entity and its components, and how they find each other: by type, in a list.

use std::any::Any;

use super::placement::Placement;

// ANCHOR: entity
/// Where it is, and a list of parts. There is no class that says which.
pub struct Entity {
    pub placement: Placement,
    components: Vec<Box<dyn Component>>,
}

/// A part of an entity.
pub trait Component: Any {
    /// Advances by `dt` seconds.
    fn update(&mut self, owner: &mut Owner<'_>, dt: f32);
}

/// An entity as seen by the one of its parts that is being updated.
pub struct Owner<'a> {
    pub placement: &'a mut Placement,
    before: &'a [Box<dyn Component>],
    after: &'a [Box<dyn Component>],
}
// ANCHOR_END: entity

impl Entity {
    pub fn new(placement: Placement) -> Self {
        let components = Vec::new();
        Self {
            placement,
            components,
        }
    }

    pub fn add(&mut self, component: impl Component) {
        self.components.push(Box::new(component));
    }

    pub fn update(&mut self, dt: f32) {
        for index in 0..self.components.len() {
            let (before, rest) = self.components.split_at_mut(index);
            let (component, after) = rest.split_at_mut(1);
            let mut owner = Owner {
                placement: &mut self.placement,
                before,
                after,
            };
            component[0].update(&mut owner, dt);
        }
    }

    pub fn get<T: Component>(&self) -> Option<&T> {
        find(&self.components)
    }
}

// ANCHOR: look_up
impl Owner<'_> {
    /// The first other part of this type.
    pub fn sibling<T: Component>(&self) -> Option<&T> {
        find(self.before).or_else(|| find(self.after))
    }
}

fn find<T: Component>(components: &[Box<dyn Component>]) -> Option<&T> {
    components.iter().find_map(|component| {
        let any: &dyn Any = component.as_ref();
        any.downcast_ref()
    })
}
// ANCHOR_END: look_up
