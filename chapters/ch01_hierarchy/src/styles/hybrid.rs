//! The scene as the hybrid of both: a class a kind, made of typed components, in a [`Level`]
//! whose scene graph knows where everything is. The report's engine is of this style, and so
//! are chapters 1 to 4.

mod circle;
mod living;
mod orbiter;
// ANCHOR: spinning
mod spin;
mod spinner;
mod spinning_orbiter;
// ANCHOR_END: spinning

use std::cell::RefCell;

use super::items::{Item, Kind};
use super::{Bytes, Style, formulas};
use crate::{GameObject, Level, NodeId, SceneGraph, Shared, Transform};
use circle::Circle;
use orbiter::Orbiter;
// ANCHOR: glow
use spin::Glowing;
// ANCHOR_END: glow
// ANCHOR: spinning
use spin::Spin;
use spinner::Spinner;
use spinning_orbiter::SpinningOrbiter;
// ANCHOR_END: spinning

// ANCHOR: world
/// The scene: a level, and its nodes in the order of the items.
pub struct World {
    level: Level,
    nodes: Vec<NodeId>,
    // ANCHOR: glow
    glowing: Vec<(usize, Shared<dyn Glowing>)>,
    // ANCHOR_END: glow
}
// ANCHOR_END: world

impl World {
    // ANCHOR: make
    fn make(&mut self, item: &Item, parent: Option<NodeId>) -> NodeId {
        let place = Transform::from_translation(formulas::circle(item.radius, item.phase));
        let node = self.level.graph.add("", parent, place);
        let circle = Circle::new(item);
        // ANCHOR: spinning
        let spin = Spin::new(item);
        // ANCHOR_END: spinning
        match item.kind {
            // ANCHOR: spinning
            Kind::Spinner => {
                // ANCHOR: glow
                let spinner = self.level.add(Spinner { node, spin });
                self.glowing.push((self.nodes.len(), spinner));
                // ANCHOR_END: glow
            }
            Kind::SpinningOrbiter => {
                // ANCHOR: glow
                let both = self.level.add(SpinningOrbiter { node, circle, spin });
                self.glowing.push((self.nodes.len(), both));
                // ANCHOR_END: glow
            }
            // ANCHOR_END: spinning
            Kind::Orbiter => drop(self.level.add(Orbiter { node, circle })),
        }
        self.nodes.push(node);
        node
    }
    // ANCHOR_END: make

    fn gather<T>(&self, column: &mut Vec<T>, get: impl Fn(Transform) -> T) {
        column.clear();
        let worlds = self.nodes.iter().map(|node| self.level.graph.world(*node));
        column.extend(worlds.map(get));
    }
}

impl Style for World {
    const NAME: &'static str = "hybrid";

    fn build(items: &[Item]) -> Self {
        let mut world = Self {
            level: Level::new(),
            nodes: Vec::new(),
            // ANCHOR: glow
            glowing: Vec::new(),
            // ANCHOR_END: glow
        };
        for item in items {
            let parent = item.parent.map(|parent| world.nodes[parent]);
            world.make(item, parent);
        }
        world
    }

    fn update(&mut self, dt: f32) {
        self.level.update(dt);
    }

    fn gather_positions(&self, column: &mut Vec<[f32; 3]>) {
        self.gather(column, |world| world.translation.into());
    }

    fn gather_poses(&self, column: &mut Vec<Transform>) {
        self.gather(column, |world| world);
    }

    // ANCHOR: glow
    fn gather_glow(&self, column: &mut Vec<f32>) {
        column.clear();
        column.resize(self.nodes.len(), 0.0);
        for (id, object) in &self.glowing {
            column[*id] = object.borrow().glow();
        }
    }
    // ANCHOR_END: glow

    fn bytes(items: &[Item]) -> Bytes {
        let gather = size_of::<NodeId>() + SceneGraph::BYTES_A_NODE;
        Bytes::sum(items, |item| {
            let object = match item.kind {
                Kind::Orbiter => size_of::<RefCell<Orbiter>>(),
                Kind::Spinner => size_of::<RefCell<Spinner>>(),
                Kind::SpinningOrbiter => size_of::<RefCell<SpinningOrbiter>>(),
            };
            let list = size_of::<Shared<dyn GameObject>>() + SceneGraph::BYTES_IN_ORDER;
            let counts = 2 * size_of::<usize>();
            Bytes {
                update: list + counts + object + SceneGraph::BYTES_A_NODE,
                gather,
            }
        })
    }
}
