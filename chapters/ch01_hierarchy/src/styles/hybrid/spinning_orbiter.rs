// ANCHOR: spinning
//! `SpinningOrbiter`: circles and spins. Nothing is inherited, so nothing is in the way: it
//! has both parts.

use super::circle::Circle;
// ANCHOR: glow
use super::spin::Glowing;
// ANCHOR_END: glow
use super::spin::Spin;
use crate::{Component, GameObject, NodeId, SceneGraph};

// ANCHOR: both
/// Has a circle and a spin.
pub struct SpinningOrbiter {
    pub node: NodeId,
    pub circle: Circle,
    pub spin: Spin,
}

impl GameObject for SpinningOrbiter {
    fn node(&self) -> NodeId {
        self.node
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        let local = graph.local_mut(self.node);
        self.circle.update(local, dt);
        self.spin.update(local, dt);
    }
}
// ANCHOR_END: both

// ANCHOR: glow
impl Glowing for SpinningOrbiter {
    fn glow(&self) -> f32 {
        self.spin.glow
    }
}
// ANCHOR_END: glow
// ANCHOR_END: spinning
