//! Objects that come and go in the three styles: whom an ID names, and what is left of those who went.

use ch01_hierarchy::styles::items::{Item, Kind, scene};
use ch01_hierarchy::styles::living::Living;
use ch01_hierarchy::styles::{components, hierarchy, hybrid};

const DT: f32 = 1.0 / 60.0;

/// Item 0 has eight children, and the first three of them have eight, eight and three.
const COUNT: usize = 28;
/// Leaves: two siblings below item 1, the last child of item 3, and a child of the root.
const LEAVES: [usize; 4] = [9, 12, 27, 6];

fn world<S: Living>() -> (S, Vec<S::Id>) {
    let (mut world, ids) = S::populate(&scene(COUNT));
    world.update(DT);
    (world, ids)
}

fn newcomer() -> Item {
    Item {
        kind: Kind::SpinningOrbiter,
        parent: None,
        radius: 2.0,
        phase: 0.5,
        rate: 1.0,
        spin: 3.0,
    }
}

fn the_others_are_still_found_under_their_ids<S: Living>() {
    let (mut world, ids) = world::<S>();
    let before: Vec<_> = ids.iter().map(|id| world.frames(*id)).collect();
    world.remove(&LEAVES.map(|leaf| ids[leaf]));
    for (item, id) in ids.iter().enumerate() {
        let expected = before[item].filter(|_| !LEAVES.contains(&item));
        assert_eq!(world.frames(*id), expected, "{}, item {item}", S::NAME);
        let position = expected.map(|(_, world)| world.translation);
        assert_eq!(world.position(*id), position);
    }
}

#[test]
fn when_some_go_the_others_are_still_found_under_their_ids() {
    the_others_are_still_found_under_their_ids::<hierarchy::World>();
    the_others_are_still_found_under_their_ids::<components::World>();
    the_others_are_still_found_under_their_ids::<hybrid::World>();
}

fn an_old_id_does_not_name_who_comes_later<S: Living>() {
    let (mut world, ids) = world::<S>();
    world.remove(&[ids[9]]);
    let new = world.insert(&newcomer(), ids[1]);
    world.update(DT);
    assert!(world.frames(ids[9]).is_none(), "{}", S::NAME);
    let (local, _) = world.frames(new).expect("it has come");
    assert!((local.translation.length() - 2.0).abs() < 1e-6);
    // Removing twice is no error, and doesn't reach the newcomer.
    world.remove(&[ids[9]]);
    assert!(world.position(new).is_some());
    world.remove(&[new]);
    assert!(world.position(new).is_none());
}

#[test]
fn an_id_of_one_who_went_names_nobody_who_comes_later() {
    an_old_id_does_not_name_who_comes_later::<hierarchy::World>();
    an_old_id_does_not_name_who_comes_later::<components::World>();
    an_old_id_does_not_name_who_comes_later::<hybrid::World>();
}

fn who_went_shines_no_more<S: Living>() {
    let (mut world, ids) = world::<S>();
    for _ in 0..200 {
        world.update(DT);
    }
    let new = world.insert(&newcomer(), ids[0]);
    world.remove(&LEAVES.map(|leaf| ids[leaf]));
    for _ in 0..200 {
        world.update(DT);
    }
    let bright = |item: &Item| item.kind.spins() && item.spin.abs() > 1.0;
    let items = scene(COUNT);
    let stay = (0..COUNT).filter(|item| !LEAVES.contains(item));
    let expected = stay.filter(|item| bright(&items[*item])).count();
    assert_eq!(world.count_brighter(1.0), expected + 1, "{}", S::NAME);
    let mut glow = Vec::new();
    world.gather_glow(&mut glow);
    let in_column = glow.iter().filter(|glow| **glow > 1.0).count();
    assert_eq!(in_column, expected + 1, "{}", S::NAME);
    assert!(world.position(new).is_some());
}

#[test]
fn who_went_shines_no_more_and_who_came_does() {
    who_went_shines_no_more::<hierarchy::World>();
    who_went_shines_no_more::<components::World>();
    who_went_shines_no_more::<hybrid::World>();
}

fn nothing_is_left_where_the_removed_were<S: Living>() {
    let (mut world, ids) = world::<S>();
    let gone = ids[27];
    let was = world.position(gone).expect("it lives").to_array();
    world.remove(&[gone]);
    world.update(0.0);
    let mut positions = Vec::new();
    world.gather_positions(&mut positions);
    assert!(!positions.contains(&was), "{}", S::NAME);
}

#[test]
fn nothing_is_drawn_where_the_removed_were() {
    nothing_is_left_where_the_removed_were::<hierarchy::World>();
    nothing_is_left_where_the_removed_were::<components::World>();
    nothing_is_left_where_the_removed_were::<hybrid::World>();
}
