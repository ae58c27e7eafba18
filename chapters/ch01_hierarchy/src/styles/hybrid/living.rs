//! IDs for the level: the handles of the scene graph's nodes.

use std::cell::RefCell;

use glam::Vec3;

use super::World;
use super::spin::Glowing;
use super::spinner::Spinner;
use super::spinning_orbiter::SpinningOrbiter;
use crate::styles::Style;
use crate::styles::items::{Item, Kind};
use crate::styles::living::Living;
use crate::{NodeId, Shared, Transform};

impl Living for World {
    type Id = NodeId;

    fn populate(items: &[Item]) -> (Self, Vec<NodeId>) {
        let world = Self::build(items);
        let ids = world.nodes.clone();
        (world, ids)
    }

    #[inline]
    fn frames(&self, id: NodeId) -> Option<(Transform, Transform)> {
        let node = self.level.graph.get(id)?;
        Some((node.local(), node.world()))
    }

    #[inline]
    fn position(&self, id: NodeId) -> Option<Vec3> {
        Some(self.level.graph.get(id)?.world().translation)
    }

    fn count_brighter(&self, threshold: f32) -> usize {
        let glows = self.glowing.iter();
        let glows = glows.map(|(_, object)| object.borrow().glow());
        glows.filter(|glow| *glow > threshold).count()
    }

    fn insert(&mut self, item: &Item, parent: NodeId) -> NodeId {
        self.make(item, Some(parent))
    }

    // ANCHOR: remove
    fn remove(&mut self, ids: &[NodeId]) {
        self.level.remove_all(ids);
        let graph = &self.level.graph;
        // ANCHOR: glow
        let mut rows = 0;
        let moved = self.nodes.iter().map(|node| {
            let row = graph.get(*node).map(|_| rows);
            rows += usize::from(row.is_some());
            row
        });
        let moved: Vec<Option<usize>> = moved.collect();
        self.glowing.retain_mut(|(row, _)| {
            let now = moved[*row];
            *row = now.unwrap_or_default();
            now.is_some()
        });
        // ANCHOR_END: glow
        self.nodes.retain(|node| graph.get(*node).is_some());
    }
    // ANCHOR_END: remove

    fn bytes_to_count(items: &[Item]) -> usize {
        let entry = size_of::<(usize, Shared<dyn Glowing>)>() + 2 * size_of::<usize>();
        let sum = items.iter().map(|item| match item.kind {
            Kind::Orbiter => 0,
            Kind::Spinner => entry + size_of::<RefCell<Spinner>>(),
            Kind::SpinningOrbiter => entry + size_of::<RefCell<SpinningOrbiter>>(),
        });
        sum.sum()
    }
}
