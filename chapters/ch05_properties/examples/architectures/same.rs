//! All architectures compute the same bits, from the first frame on and after objects came and went.

use ch01_hierarchy::Transform;
use ch01_hierarchy::styles::living::Living;
use ch01_hierarchy::styles::{components, hierarchy, hybrid};

use crate::people::People;
use crate::{DT, ecs, properties};

/// Steps before objects come and go, and again after it.
pub const STEPS: usize = 250;

/// Whether five worlds of `count` objects go through the same states; the name of the first that
/// differs from the hierarchy.
pub fn check(count: usize) -> Result<(), &'static str> {
    let first = history::<hierarchy::World>(count);
    let others = [
        ("components", history::<components::World>(count)),
        ("hybrid", history::<hybrid::World>(count)),
        ("properties", history::<properties::World>(count)),
        ("ECS", history::<ecs::World>(count)),
    ];
    let different = others.iter().find(|(_, other)| *other != first);
    different.map_or(Ok(()), |(name, _)| Err(name))
}

/// The bits of all frames by ID and of all columns, before and after objects came and went.
fn history<S: Living>(count: usize) -> Vec<u32> {
    let (mut world, mut people) = People::<S::Id>::settle::<S>(count);
    for _ in 0..STEPS {
        world.update(DT);
    }
    let mut bits = state(&world, &people.ids);
    for share in [2, 3, 1] {
        let places = people.choose(count.div_ceil(share));
        let gone = people.at(&places);
        world.remove(&gone);
        bits.extend(
            gone.iter()
                .map(|id| u32::from(world.position(*id).is_some())),
        );
        let newcomers = people.newcomers(&places);
        let came = newcomers
            .iter()
            .map(|(item, parent)| world.insert(item, *parent));
        let came: Vec<S::Id> = came.collect();
        people.take_in(&places, &came);
        for _ in 0..STEPS {
            world.update(DT);
        }
        bits.extend(state(&world, &people.ids));
        bits.extend(gone.iter().map(|id| u32::from(world.frames(*id).is_some())));
    }
    bits
}

fn state<S: Living>(world: &S, ids: &[S::Id]) -> Vec<u32> {
    let mut bits = Vec::new();
    for &id in ids {
        let (local, global) = world.frames(id).expect("it lives");
        assert_eq!(world.position(id), Some(global.translation));
        bits.extend(transform(local).into_iter().chain(transform(global)));
    }
    bits.extend(rows(world).into_iter().flatten());
    bits.push(world.count_brighter(1.0) as u32);
    bits
}

/// The gathered columns, row by row, in an order that doesn't depend on who comes first.
fn rows<S: Living>(world: &S) -> Vec<[u32; 11]> {
    let (mut poses, mut positions, mut glow) = (Vec::new(), Vec::new(), Vec::new());
    world.gather_poses(&mut poses);
    world.gather_positions(&mut positions);
    world.gather_glow(&mut glow);
    assert_eq!((poses.len(), positions.len()), (glow.len(), glow.len()));
    let rows = poses.iter().zip(&positions).zip(&glow);
    let mut rows: Vec<[u32; 11]> = rows
        .map(|((pose, position), glow)| {
            let mut row = [0; 11];
            row[..7].copy_from_slice(&transform(*pose));
            row[7..10].copy_from_slice(&position.map(f32::to_bits));
            row[10] = glow.to_bits();
            row
        })
        .collect();
    rows.sort_unstable();
    rows
}

fn transform(transform: Transform) -> [u32; 7] {
    let [x, y, z] = transform.translation.to_array();
    let [i, j, k, w] = transform.rotation.to_array();
    [x, y, z, i, j, k, w].map(f32::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_five_architectures_compute_the_same_bits() {
        for count in [2, 10, 777] {
            assert_eq!(check(count), Ok(()), "{count} objects");
        }
    }
}
