//! What it costs to give an object one more property for a while, and to take it away again: a mark
//! that nobody reads.
//!
//! In an ECS the mark is a component. Kept in tables, it makes another set of components, and the
//! object moves to that set's table and back; kept aside, it doesn't. Among properties it is a row of
//! a table of its own.

use std::time::Instant;

use bevy_ecs::prelude::{Component, Entity};
use bevy_ecs::world::World as Registry;
use ch01_hierarchy::Transform;
use ch05_properties::columns::{AnyTable, Table};
use ch05_properties::table;

use crate::ecs::components::{Circle, Global, Glow, Local, Spin};
use crate::measure::{Nanoseconds, RUNS, spread};

#[derive(Component)]
struct InTable;

#[derive(Component)]
#[component(storage = "SparseSet")]
struct Aside;

table! {
    /// Which things are marked.
    pub struct Marks of
    /// A mark.
    Mark in "marks" {
        /// Row of the thing.
        thing: u32, "i", "";
    }
}

/// Marking and unmarking, ns a mark.
pub struct Row {
    pub way: &'static str,
    pub count: usize,
    pub mark: Nanoseconds,
    pub unmark: Nanoseconds,
}

/// All ways, for a hundredth of `count` objects.
pub fn all(count: usize) -> [Row; 3] {
    let things: Vec<usize> = (0..count).step_by(100).collect();
    let (mut registry, entities) = crowd(count);
    let mut marks = Marks::default();
    let mut times: [[Vec<f64>; 2]; 3] = Default::default();
    for _ in 0..=RUNS {
        times[0][0].push(each(&things, |thing| {
            registry.entity_mut(entities[thing]).insert(InTable);
        }));
        times[0][1].push(each(&things, |thing| {
            registry.entity_mut(entities[thing]).remove::<InTable>();
        }));
        times[1][0].push(each(&things, |thing| {
            registry.entity_mut(entities[thing]).insert(Aside);
        }));
        times[1][1].push(each(&things, |thing| {
            registry.entity_mut(entities[thing]).remove::<Aside>();
        }));
        times[2][0].push(each(&things, |thing| {
            marks.push(Mark {
                thing: thing as u32,
            });
        }));
        let keep = vec![false; marks.rows()];
        let start = Instant::now();
        marks.retain_rows(&keep);
        times[2][1].push(start.elapsed().as_secs_f64() * 1e9 / things.len() as f64);
    }
    let ways = [
        "ECS, in tables",
        "ECS, kept aside",
        "properties, a table of marks",
    ];
    let mut times = times.into_iter();
    ways.map(|way| {
        let [mark, unmark] = times.next().expect("three ways");
        Row {
            way,
            count,
            mark: spread(mark),
            unmark: spread(unmark),
        }
    })
}

/// Entities with all that a spinning orbiter has, but no parent.
fn crowd(count: usize) -> (Registry, Vec<Entity>) {
    let mut registry = Registry::new();
    let entities = (0..count).map(|_| {
        let here = Transform::IDENTITY;
        let circle = Circle {
            radius: 1.0,
            angle: 0.0,
            rate: 1.0,
        };
        let spin = Spin {
            turned: 0.0,
            rate: 1.0,
        };
        let all = (Local(here), Global(here), circle, spin, Glow(0.0));
        registry.spawn(all).id()
    });
    let entities = entities.collect();
    (registry, entities)
}

/// Mean time over all things, ns.
fn each(things: &[usize], mut work: impl FnMut(usize)) -> f64 {
    let start = Instant::now();
    for &thing in things {
        work(thing);
    }
    start.elapsed().as_secs_f64() * 1e9 / things.len() as f64
}
