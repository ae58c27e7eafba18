// ANCHOR: spinning
//! `Spinner`: stays in its place and turns.

// ANCHOR: glow
use super::spin::Glowing;
// ANCHOR_END: glow
use super::spin::Spin;
use crate::{Component, GameObject, NodeId, SceneGraph};

/// Has a spin.
pub struct Spinner {
    pub node: NodeId,
    pub spin: Spin,
}

impl GameObject for Spinner {
    fn node(&self) -> NodeId {
        self.node
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        self.spin.update(graph.local_mut(self.node), dt);
    }
}

// ANCHOR: glow
impl Glowing for Spinner {
    fn glow(&self) -> f32 {
        self.spin.glow
    }
}
// ANCHOR_END: glow
// ANCHOR_END: spinning
