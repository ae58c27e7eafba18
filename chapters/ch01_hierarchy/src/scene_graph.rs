//! The scene graph: a tree of nodes, each of which says where it is in its parent, from
//! which follows where it is in the world: world = world of parent · local.
//!
//! The nodes lie in one arena and name each other by [`NodeId`], a slot and the generation
//! of its content: Rust's answer to the pointers up and down of a tree.

mod node;

use thiserror::Error;

use crate::Transform;
pub use node::{NodeId, SceneNode};

/// What stays as it is when a node changes its parent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// The place in the world: a hand that lets go of a cup.
    World,
    /// The place in the parent: a lamp that is screwed into another socket.
    Local,
}

/// Why the tree can't be changed so.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum GraphError {
    /// The new parent is the node itself or lies below it.
    #[error("node `{child}` can't be attached to `{parent}`, which is in its own subtree")]
    Cycle {
        /// Name of the node to attach.
        child: String,
        /// Name of the wished parent.
        parent: String,
    },
    /// The node was removed.
    #[error("{0:?} names a node that was removed")]
    Removed(NodeId),
}

#[derive(Clone, Debug)]
struct Slot {
    generation: u32,
    node: Option<SceneNode>,
}

/// The tree: an arena of nodes. Several roots are allowed.
#[derive(Clone, Debug, Default)]
pub struct SceneGraph {
    slots: Vec<Slot>,
    free: Vec<u32>,
    /// Slots of all nodes, each after its parent.
    order: Vec<u32>,
    order_is_stale: bool,
}

impl SceneGraph {
    /// Bytes of a node's record, for the book's tables.
    pub const BYTES_A_NODE: usize = size_of::<Slot>();
    /// Bytes of a node's entry in the order of updates, for the book's tables.
    pub const BYTES_IN_ORDER: usize = size_of::<u32>();

    /// An empty tree.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// How many nodes there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.slots.len() - self.free.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds a node below `parent`, or a root.
    ///
    /// # Panics
    /// If `parent` was removed.
    pub fn add(
        &mut self,
        name: impl Into<String>,
        parent: Option<NodeId>,
        local: Transform,
    ) -> NodeId {
        let node = SceneNode {
            local,
            world: parent.map_or(local, |parent| self.world(parent) * local),
            parent,
            dirty: true,
            moved: false,
            children: Vec::new(),
            name: name.into(),
        };
        let id = self.store(node);
        if let Some(parent) = parent {
            self.node_mut(parent).children.push(id);
        }
        id
    }

    /// Removes a node. Its children move up to its parent and stay where they are in the world.
    ///
    /// # Errors
    /// [`GraphError::Removed`] if it was removed before.
    pub fn remove(&mut self, id: NodeId) -> Result<(), GraphError> {
        let parent = self.get(id).ok_or(GraphError::Removed(id))?.parent;
        for child in std::mem::take(&mut self.node_mut(id).children) {
            self.attach(child, parent, Keep::World)?;
        }
        self.unlink(id);
        let slot = &mut self.slots[id.index as usize];
        slot.node = None;
        slot.generation += 1;
        self.free.push(id.index);
        self.order_is_stale = true;
        Ok(())
    }

    /// The node, or `None` if it was removed.
    #[must_use]
    #[inline]
    pub fn get(&self, id: NodeId) -> Option<&SceneNode> {
        let slot = self.slots.get(id.index as usize)?;
        slot.node
            .as_ref()
            .filter(|_| slot.generation == id.generation)
    }

    /// All nodes with their handles, in the order of their slots.
    pub fn iter(&self) -> impl Iterator<Item = (NodeId, &SceneNode)> {
        (0u32..).zip(&self.slots).filter_map(|(index, slot)| {
            let id = NodeId {
                index,
                generation: slot.generation,
            };
            slot.node.as_ref().map(|node| (id, node))
        })
    }

    /// The node in whose frame it is placed; `None` for a root.
    ///
    /// # Panics
    /// If it was removed.
    #[must_use]
    #[track_caller]
    pub fn parent(&self, id: NodeId) -> Option<NodeId> {
        self.node(id).parent
    }

    /// Where the node is in its parent.
    ///
    /// # Panics
    /// If it was removed.
    #[must_use]
    #[track_caller]
    pub fn local(&self, id: NodeId) -> Transform {
        self.node(id).local
    }

    /// Where the node was in the world at the last [`update_world`](Self::update_world).
    ///
    /// # Panics
    /// If it was removed.
    #[must_use]
    #[track_caller]
    pub fn world(&self, id: NodeId) -> Transform {
        self.node(id).world
    }

    /// Places the node in its parent. Its world transform and those below it follow with the
    /// next [`update_world`](Self::update_world).
    ///
    /// # Panics
    /// If it was removed.
    #[track_caller]
    pub fn set_local(&mut self, id: NodeId, local: Transform) {
        *self.local_mut(id) = local;
    }

    /// The node's place in its parent, to be written: counts as set.
    ///
    /// # Panics
    /// If it was removed.
    #[track_caller]
    pub fn local_mut(&mut self, id: NodeId) -> &mut Transform {
        let node = self.node_mut(id);
        node.dirty = true;
        &mut node.local
    }

    // ANCHOR: attach
    /// Hangs a node below another `parent`, or makes it a root.
    ///
    /// # Errors
    /// [`GraphError::Cycle`] if `parent` is the node or below it, [`GraphError::Removed`] if
    /// either was removed. The tree is then as before.
    pub fn attach(
        &mut self,
        id: NodeId,
        parent: Option<NodeId>,
        keep: Keep,
    ) -> Result<(), GraphError> {
        self.check_attach(id, parent)?;
        let local = match keep {
            Keep::Local => self.local(id),
            Keep::World => {
                let frame = parent.map_or(Transform::IDENTITY, |parent| self.chain(parent));
                frame.inverse() * self.chain(id)
            }
        };
        self.unlink(id);
        if let Some(parent) = parent {
            self.node_mut(parent).children.push(id);
        }
        self.node_mut(id).parent = parent;
        self.set_local(id, local);
        self.order_is_stale = true;
        Ok(())
    }
    // ANCHOR_END: attach

    /// Makes a node a root: [`attach`](Self::attach) to nothing.
    ///
    /// # Errors
    /// [`GraphError::Removed`].
    pub fn detach(&mut self, id: NodeId, keep: Keep) -> Result<(), GraphError> {
        self.attach(id, None, keep)
    }

    // ANCHOR: update_world
    /// Brings all world transforms up to date, parents before children. A node is computed
    /// anew only if it or one above it was set since the last time.
    pub fn update_world(&mut self) {
        self.order_parents_first();
        for place in 0..self.order.len() {
            let index = self.order[place] as usize;
            let above = self
                .parent_slot(index)
                .map(|parent| (parent.world, parent.moved));
            let node = self.in_order(index);
            node.moved = node.dirty || above.is_some_and(|(_, moved)| moved);
            if node.moved {
                node.world = above.map_or(node.local, |(world, _)| world * node.local);
                node.dirty = false;
            }
        }
    }
    // ANCHOR_END: update_world

    /// Computes every world transform anew, whether anything was set or not. The same bits as
    /// [`update_world`](Self::update_world), which is measured against it.
    pub fn recompute_world(&mut self) {
        self.order_parents_first();
        for place in 0..self.order.len() {
            let index = self.order[place] as usize;
            let above = self.parent_slot(index).map(|parent| parent.world);
            let node = self.in_order(index);
            node.world = above.map_or(node.local, |world| world * node.local);
            node.dirty = false;
            node.moved = true;
        }
    }

    fn store(&mut self, node: SceneNode) -> NodeId {
        let index = self.free.pop().unwrap_or_else(|| {
            self.slots.push(Slot {
                generation: 0,
                node: None,
            });
            u32::try_from(self.slots.len() - 1).expect("fewer than 2³² nodes fit into memory")
        });
        let slot = &mut self.slots[index as usize];
        slot.node = Some(node);
        // Its parent is in the order already, so the end is after it.
        self.order.push(index);
        NodeId {
            index,
            generation: slot.generation,
        }
    }

    #[track_caller]
    fn node(&self, id: NodeId) -> &SceneNode {
        self.get(id)
            .unwrap_or_else(|| panic!("{}", GraphError::Removed(id)))
    }

    #[track_caller]
    fn node_mut(&mut self, id: NodeId) -> &mut SceneNode {
        match self.slots.get_mut(id.index as usize) {
            Some(Slot {
                generation,
                node: Some(node),
            }) if *generation == id.generation => node,
            _ => panic!("{}", GraphError::Removed(id)),
        }
    }

    fn in_order(&mut self, index: usize) -> &mut SceneNode {
        let node = self.slots[index].node.as_mut();
        node.expect("the order lists slots that hold a node")
    }

    fn parent_slot(&self, index: usize) -> Option<&SceneNode> {
        let parent = self.slots[index].node.as_ref()?.parent?;
        self.slots[parent.index as usize].node.as_ref()
    }

    /// The world transform as the local ones say now, updated or not.
    fn chain(&self, id: NodeId) -> Transform {
        let mut world = self.local(id);
        let mut above = self.parent(id);
        while let Some(parent) = above {
            world = self.local(parent) * world;
            above = self.parent(parent);
        }
        world
    }

    fn check_attach(&self, id: NodeId, parent: Option<NodeId>) -> Result<(), GraphError> {
        let node = self.get(id).ok_or(GraphError::Removed(id))?;
        let mut above = parent;
        while let Some(ancestor) = above {
            let next = self.get(ancestor).ok_or(GraphError::Removed(ancestor))?;
            if ancestor == id {
                return Err(GraphError::Cycle {
                    child: node.name.clone(),
                    parent: parent.map_or(String::new(), |id| self.node(id).name.clone()),
                });
            }
            above = next.parent;
        }
        Ok(())
    }

    fn unlink(&mut self, id: NodeId) {
        if let Some(parent) = self.node(id).parent {
            self.node_mut(parent).children.retain(|child| *child != id);
        }
    }

    /// Level by level from the roots: each node after its parent, siblings side by side.
    pub(crate) fn order_parents_first(&mut self) {
        if !self.order_is_stale {
            return;
        }
        let roots = self.iter().filter(|(_, node)| node.parent.is_none());
        let mut order: Vec<u32> = roots.map(|(id, _)| id.index).collect();
        let mut next = 0;
        while next < order.len() {
            let children = self.in_order(order[next] as usize).children.iter();
            order.extend(children.map(|child| child.index));
            next += 1;
        }
        self.order = order;
        self.order_is_stale = false;
    }
}
