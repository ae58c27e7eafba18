//! `Orbiter`: circles its parent.

use super::circle::Circle;
use crate::{Component, GameObject, NodeId, SceneGraph};

/// Has a circle.
pub struct Orbiter {
    pub node: NodeId,
    pub circle: Circle,
}

impl GameObject for Orbiter {
    fn node(&self) -> NodeId {
        self.node
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        self.circle.update(graph.local_mut(self.node), dt);
    }
}
