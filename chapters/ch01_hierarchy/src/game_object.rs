//! What a level knows about the things in it: where they hang in the scene graph, and that
//! they take part in a frame's two phases.

use std::cell::RefCell;
use std::rc::Rc;

use crate::{NodeId, SceneGraph};

// ANCHOR: shared
/// An object that several others hold on to, each of which may change it: what the report's
/// engine has pointers for. Who borrows it while another is changing it panics.
pub type Shared<T> = Rc<RefCell<T>>;
// ANCHOR_END: shared

// ANCHOR: game_object
/// A thing in a level.
///
/// A frame has two phases, so that it doesn't matter which object comes first: all gather,
/// then all update.
pub trait GameObject {
    /// The node that says where it is.
    fn node(&self) -> NodeId;

    /// Looks at other objects, which are all still in the state of the last frame, and notes
    /// what it needs of them. Changes nothing but itself, and of that nothing that others read.
    fn gather(&mut self) {}

    /// Advances itself by `dt` seconds from what it noted, and writes its place into `graph`.
    fn update(&mut self, graph: &mut SceneGraph, dt: f32);
}
// ANCHOR_END: game_object
