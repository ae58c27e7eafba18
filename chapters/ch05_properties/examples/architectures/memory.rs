//! Bytes that a world holds: what it has asked of the allocator and not given back, counted by the
//! allocator itself. What the allocator adds to each piece, 8 to 16 bytes as a rule, is not in it.

use std::alloc::System;

use ch01_hierarchy::styles::living::Living;
use ch01_hierarchy::styles::{components, hierarchy, hybrid};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

use crate::measure::ROUNDS;
use crate::people::People;
use crate::{DT, ecs, properties};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// What a world of some architecture holds, an object.
pub struct Held {
    pub architecture: &'static str,
    pub count: usize,
    /// As it was built.
    pub fresh: f64,
    /// Pieces of memory, as it was built.
    pub pieces: f64,
    /// When a quarter of the objects has been replaced.
    pub aged: f64,
}

/// All architectures for one N.
pub fn all(count: usize) -> [Held; 5] {
    [
        held::<hierarchy::World>(count),
        held::<components::World>(count),
        held::<hybrid::World>(count),
        held::<properties::World>(count),
        held::<ecs::World>(count),
    ]
}

fn held<S: Living>(count: usize) -> Held {
    let (fresh, pieces) = after::<S>(count, 0);
    let (aged, _) = after::<S>(count, ROUNDS);
    Held {
        architecture: S::NAME,
        count,
        fresh,
        pieces,
        aged,
    }
}

/// Bytes and pieces, an object, when a hundredth of all has been replaced `rounds` times.
fn after<S: Living>(count: usize, rounds: usize) -> (f64, f64) {
    let region = Region::new(ALLOCATOR);
    let (mut world, mut people) = People::<S::Id>::settle::<S>(count);
    for _ in 0..rounds {
        let places = people.choose((count / 100).max(1));
        world.remove(&people.at(&places));
        let newcomers = people.newcomers(&places);
        let came = newcomers
            .iter()
            .map(|(item, parent)| world.insert(item, *parent));
        let came: Vec<S::Id> = came.collect();
        people.take_in(&places, &came);
    }
    world.update(DT);
    drop(people);
    let change = region.change();
    drop(world);
    let bytes = change.bytes_allocated - change.bytes_deallocated;
    let pieces = change.allocations - change.deallocations;
    (bytes as f64 / count as f64, pieces as f64 / count as f64)
}
