//! A node and its name: a frame in the tree, and the handle by which others know it.

use crate::Transform;

// ANCHOR: node
/// Names a node for as long as it lives. A slot that is used again has a new generation,
/// so that a handle which outlived its node is found out and never names a stranger.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId {
    pub(super) index: u32,
    pub(super) generation: u32,
}

/// A frame in the tree.
#[derive(Clone, Debug)]
pub struct SceneNode {
    pub(super) local: Transform,
    pub(super) world: Transform,
    pub(super) parent: Option<NodeId>,
    /// Whether `local` or `parent` was set since the last `update_world`.
    pub(super) dirty: bool,
    /// Whether the last `update_world` gave it a new world transform.
    pub(super) moved: bool,
    pub(super) children: Vec<NodeId>,
    pub(super) name: String,
}
// ANCHOR_END: node

impl SceneNode {
    /// The name it was given; need not be unique.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The node in whose frame it is placed; `None` for a root.
    #[must_use]
    pub fn parent(&self) -> Option<NodeId> {
        self.parent
    }

    /// The nodes that are placed in its frame.
    #[must_use]
    pub fn children(&self) -> &[NodeId] {
        &self.children
    }

    /// Where it is in its parent.
    #[must_use]
    #[inline]
    pub fn local(&self) -> Transform {
        self.local
    }

    /// Where it was in the world at the last [`update_world`](super::SceneGraph::update_world).
    #[must_use]
    #[inline]
    pub fn world(&self) -> Transform {
        self.world
    }
}
