//! A level owns the scene graph and the game objects, and says in which order a frame's
//! work is done.

use std::cell::RefCell;
use std::rc::Rc;

use crate::{GameObject, NodeId, SceneGraph, Shared};

/// The scene graph and all game objects.
#[derive(Default)]
pub struct Level {
    /// Where everything is.
    pub graph: SceneGraph,
    objects: Vec<Shared<dyn GameObject>>,
}

impl Level {
    /// A level with nothing in it.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    // ANCHOR: add
    /// Takes an object in and gives back a handle to it that still knows its type.
    pub fn add<T: GameObject + 'static>(&mut self, object: T) -> Shared<T> {
        let object = Rc::new(RefCell::new(object));
        self.objects.push(object.clone());
        object
    }
    // ANCHOR_END: add

    /// Takes an object out, and its node out of the graph: what hung below it stays where it
    /// is. Says whether the object was here. Whoever holds a handle keeps the object alive.
    pub fn remove<T: GameObject + 'static>(&mut self, object: &Shared<T>) -> bool {
        let address = Rc::as_ptr(object).cast::<()>();
        let is_it = |held: &Shared<dyn GameObject>| Rc::as_ptr(held).cast::<()>() == address;
        let Some(place) = self.objects.iter().position(is_it) else {
            return false;
        };
        self.objects.remove(place);
        // The node may be gone already, with an object that shared it: that is no error here.
        let _ = self.graph.remove(object.borrow().node());
        true
    }

    /// Takes out, in one pass, all objects whose node is among these, and the nodes out of the
    /// graph. Nodes that were removed before are passed over.
    pub fn remove_all(&mut self, nodes: &[NodeId]) {
        for &node in nodes {
            // It may be gone already: that is no error here.
            let _ = self.graph.remove(node);
        }
        let graph = &self.graph;
        self.objects
            .retain(|object| graph.get(object.borrow().node()).is_some());
        self.graph.order_parents_first();
    }

    /// The objects in the order in which they were added.
    #[must_use]
    pub fn objects(&self) -> &[Shared<dyn GameObject>] {
        &self.objects
    }

    // ANCHOR: update
    /// One frame of `dt` seconds.
    pub fn update(&mut self, dt: f32) {
        self.gather_objects();
        self.update_objects(dt);
        self.graph.update_world();
    }

    /// Every object looks at the others, which nothing has changed yet.
    pub fn gather_objects(&mut self) {
        for object in &self.objects {
            object.borrow_mut().gather();
        }
    }

    /// Every object advances by `dt` seconds and places its node.
    pub fn update_objects(&mut self, dt: f32) {
        for object in &self.objects {
            object.borrow_mut().update(&mut self.graph, dt);
        }
    }
    // ANCHOR_END: update
}
