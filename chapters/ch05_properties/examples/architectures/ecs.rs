//! The scene in an entity component system, `bevy_ecs`: an object is a number, its properties are
//! components, and the library keeps a table for each set of components that occurs.
//!
//! Rows of a gathered column are in the order of those tables, not of the items. One thread, as for
//! all the others: the library's `multi_threaded` is off.

pub mod components;
pub mod systems;

use bevy_ecs::bundle::Bundle;
use bevy_ecs::entity::EntityLocation;
use bevy_ecs::prelude::{ChildOf, Children, Entity, IntoScheduleConfigs, QueryState, Schedule};
use bevy_ecs::world::World as Registry;
use ch01_hierarchy::Transform;
use ch01_hierarchy::styles::items::{Item, Kind};
use ch01_hierarchy::styles::living::Living;
use ch01_hierarchy::styles::{Bytes, Style, formulas};
use glam::Vec3;

// ANCHOR: glow
use components::Glow;
// ANCHOR_END: glow
// ANCHOR: spinning
use components::Spin;
// ANCHOR_END: spinning
use components::{Circle, Global, Local, Step};

// ANCHOR: world
/// The scene: the library's world, the systems in their order, and the questions that are asked
/// from outside.
pub struct World {
    registry: Registry,
    schedule: Schedule,
    globals: QueryState<&'static Global>,
    frames: QueryState<(&'static Local, &'static Global)>,
    // ANCHOR: glow
    glows: QueryState<&'static Glow>,
    glows_by_row: QueryState<(&'static Global, Option<&'static Glow>)>,
    // ANCHOR_END: glow
}
// ANCHOR_END: world

// ANCHOR: make
/// A thing with the components that its item asks for, all at once: each that is added later would
/// move the others to another table.
fn spawn(registry: &mut Registry, item: &Item, parent: Option<Entity>) -> Entity {
    let place = Transform::from_translation(formulas::circle(item.radius, item.phase));
    let frames = (Local(place), Global(place));
    let circle = Circle {
        radius: item.radius,
        angle: item.phase,
        rate: item.rate,
    };
    // ANCHOR: spinning
    let spin = Spin {
        turned: 0.0,
        rate: item.spin,
    };
    // ANCHOR_END: spinning
    // ANCHOR: glow
    let spin = (spin, Glow::default());
    // ANCHOR_END: glow
    match item.kind {
        Kind::Orbiter => spawn_below(registry, parent, (frames, circle)),
        // ANCHOR: spinning
        Kind::Spinner => spawn_below(registry, parent, (frames, spin)),
        Kind::SpinningOrbiter => spawn_below(registry, parent, (frames, circle, spin)),
        // ANCHOR_END: spinning
    }
}
// ANCHOR_END: make

fn spawn_below(registry: &mut Registry, parent: Option<Entity>, bundle: impl Bundle) -> Entity {
    match parent {
        Some(parent) => registry.spawn((bundle, ChildOf(parent))).id(),
        None => registry.spawn(bundle).id(),
    }
}

// ANCHOR: schedule
fn systems() -> Schedule {
    let mut schedule = Schedule::default();
    schedule.add_systems(
        (
            systems::circle,
            // ANCHOR: spinning
            systems::spin,
            // ANCHOR_END: spinning
            // ANCHOR: glow
            systems::glow,
            // ANCHOR_END: glow
            systems::follow_parents,
        )
            .chain(),
    );
    schedule
}
// ANCHOR_END: schedule

impl World {
    /// The questions learn of sets of components that occur for the first time.
    fn update_questions(&mut self) {
        self.globals.update_archetypes(&self.registry);
        self.frames.update_archetypes(&self.registry);
        // ANCHOR: glow
        self.glows.update_archetypes(&self.registry);
        self.glows_by_row.update_archetypes(&self.registry);
        // ANCHOR_END: glow
    }
}

impl Style for World {
    const NAME: &'static str = "ECS";

    fn build(items: &[Item]) -> Self {
        Self::populate(items).0
    }

    fn update(&mut self, dt: f32) {
        self.registry.insert_resource(Step(dt));
        self.schedule.run(&mut self.registry);
    }

    fn gather_positions(&self, column: &mut Vec<[f32; 3]>) {
        column.clear();
        let globals = self.globals.iter_manual(&self.registry);
        column.extend(globals.map(|global| <[f32; 3]>::from(global.0.translation)));
    }

    fn gather_poses(&self, column: &mut Vec<Transform>) {
        column.clear();
        column.extend(
            self.globals
                .iter_manual(&self.registry)
                .map(|global| global.0),
        );
    }

    // ANCHOR: glow
    fn gather_glow(&self, column: &mut Vec<f32>) {
        column.clear();
        let glows = self.glows_by_row.iter_manual(&self.registry);
        column.extend(glows.map(|(_, glow)| glow.map_or(0.0, |glow| glow.0)));
    }
    // ANCHOR_END: glow

    /// A component that is written has the tick of its last change written beside it. Children are
    /// found by the list that their parent keeps and the place that the library keeps of each entity.
    fn bytes(items: &[Item]) -> Bytes {
        let tick = size_of::<u32>();
        let way = size_of::<Entity>() + size_of::<EntityLocation>();
        let frames = size_of::<Local>() + size_of::<Global>() + 2 * tick;
        let mut sum = Bytes::sum(items, |item| {
            let mut update = frames + way;
            if item.kind != Kind::Spinner {
                update += size_of::<Circle>() + tick;
            }
            if item.kind.spins() {
                update += size_of::<Spin>() + size_of::<Glow>() + 2 * tick;
            }
            Bytes {
                update,
                gather: size_of::<Global>(),
            }
        });
        let parents = items
            .last()
            .and_then(|item| item.parent)
            .map_or(0, |parent| parent + 1);
        sum.update += parents * size_of::<Children>();
        sum
    }
}

impl Living for World {
    type Id = Entity;

    fn populate(items: &[Item]) -> (Self, Vec<Entity>) {
        let mut registry = Registry::new();
        let mut entities: Vec<Entity> = Vec::with_capacity(items.len());
        for item in items {
            let parent = item.parent.map(|parent| entities[parent]);
            entities.push(spawn(&mut registry, item, parent));
        }
        let world = Self {
            globals: registry.query(),
            frames: registry.query(),
            // ANCHOR: glow
            glows: registry.query(),
            glows_by_row: registry.query(),
            // ANCHOR_END: glow
            schedule: systems(),
            registry,
        };
        (world, entities)
    }

    #[inline]
    fn frames(&self, id: Entity) -> Option<(Transform, Transform)> {
        let (local, global) = self.frames.get_manual(&self.registry, id).ok()?;
        Some((local.0, global.0))
    }

    #[inline]
    fn position(&self, id: Entity) -> Option<Vec3> {
        let global = self.globals.get_manual(&self.registry, id).ok()?;
        Some(global.0.translation)
    }

    fn count_brighter(&self, threshold: f32) -> usize {
        let glows = self.glows.iter_manual(&self.registry);
        glows.filter(|glow| glow.0 > threshold).count()
    }

    fn insert(&mut self, item: &Item, parent: Entity) -> Entity {
        assert!(
            self.registry.get_entity(parent).is_ok(),
            "the parent was removed"
        );
        let id = spawn(&mut self.registry, item, Some(parent));
        self.update_questions();
        id
    }

    // ANCHOR: remove
    fn remove(&mut self, ids: &[Entity]) {
        for &id in ids {
            // It may be gone already: that is no error here.
            let _ = self.registry.try_despawn(id);
        }
        self.update_questions();
    }
    // ANCHOR_END: remove

    fn bytes_to_count(items: &[Item]) -> usize {
        items.iter().filter(|item| item.kind.spins()).count() * size_of::<Glow>()
    }
}
