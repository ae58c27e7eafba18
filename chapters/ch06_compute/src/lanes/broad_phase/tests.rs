use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Scene, Settings};
use glam::Vec3;

use super::*;
use crate::lanes::Lanes;
use crate::rules::Rules;

const DT: f32 = 1.0 / 60.0;

const WAYS: [Way; 2] = [Way::Grids, Way::Tree];

fn by(way: Way) -> BroadPhase {
    let mut broad = BroadPhase::default();
    broad.force(way);
    broad
}

/// All pairs by asking each body about each.
fn by_force(bodies: &Bodies, dt: f32, broad: &BroadPhase) -> Vec<(usize, usize)> {
    let is_aside = |row: usize| broad.aside.contains(&(row as u32));
    let bounds: Vec<Bound> = (0..bodies.rows())
        .map(|row| {
            if is_aside(row) {
                Bound::EMPTY
            } else {
                bound::about(bodies, row, dt)
            }
        })
        .collect();
    let mut pairs = Vec::new();
    for a in 0..bounds.len() {
        for b in a + 1..bounds.len() {
            let idle = bodies.is_static(a) && bodies.is_static(b);
            if !idle && bounds[a].overlaps(&bounds[b]) && !broad.ignored.contains(&(a, b)) {
                pairs.push((a, b));
            }
        }
    }
    pairs
}

fn start(name: &str, count: usize) -> Lanes {
    let scene = Scene::open(name, Some(count as u64), None).unwrap();
    let rules = Rules::of(&scene, &Settings::defaults()).unwrap();
    Lanes::of(&scene, rules).unwrap()
}

/// Balls of radii 0.02 m to 0.02 `spread` m in a cube, some fast, each third one fixed.
fn crowd(count: usize, spread: f32, seed: u64) -> Bodies {
    let mut bodies = start("balls", count).bodies;
    let mut random = SplitMix64::new(seed);
    let mut number = || random.unit() as f32;
    for row in 0..bodies.rows() {
        let radius = 0.02 * spread.powf(number());
        bodies.solid[row].kind = 0;
        bodies.solid[row].size = Vec3::new(radius, 0.0, 0.0);
        bodies.place[row].reach = radius;
        bodies.place[row].position = 4.0 * Vec3::new(number(), number(), number()) - 2.0;
        let speed = if row % 50 == 0 { 200.0 } else { 1.0 };
        bodies.motion[row].velocity = speed * (Vec3::new(number(), number(), number()) - 0.5);
        if row % 3 == 0 {
            bodies.spin[row].inverse_mass = 0.0;
            bodies.solid[row].inverse_inertia = Vec3::ZERO;
        }
    }
    bodies
}

#[track_caller]
fn finds_all(bodies: &Bodies, broad: &mut BroadPhase) -> usize {
    find_pairs(bodies, DT, broad);
    assert_eq!(broad.pairs, by_force(bodies, DT, broad));
    broad.pairs.len()
}

fn within<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(work)
}

#[test]
fn grids_and_tree_find_what_brute_force_finds_for_equal_and_for_unequal_sizes() {
    for (count, spread, seed) in [(1, 1.0, 1), (10, 2.0, 2), (500, 4.0, 3), (2500, 100.0, 4)] {
        let bodies = crowd(count, spread, seed);
        for way in WAYS {
            let pairs = finds_all(&bodies, &mut by(way));
            assert!(pairs > 20 || count < 500);
        }
    }
}

#[test]
fn far_from_the_origin_and_across_it_nothing_is_lost() {
    for far in [1e3, -1e5, 1e7, 1e12] {
        let mut bodies = crowd(300, 10.0, 5);
        for place in bodies.place.iter_mut().skip(150) {
            place.position += far;
        }
        for way in WAYS {
            finds_all(&bodies, &mut by(way));
        }
    }
}

#[test]
fn in_each_step_of_a_scene_the_pairs_are_those_of_brute_force() {
    for (name, count, steps, way) in [
        ("balls", 200, 300, Way::Grids),
        ("pile", 150, 300, Way::Grids),
        ("ragdolls", 12, 200, Way::Grids),
        ("pile", 150, 300, Way::Tree),
        ("ragdolls", 12, 200, Way::Tree),
    ] {
        let mut lanes = start(name, count);
        lanes.broad.force(way);
        for step in 0..steps {
            lanes.step(DT, |_| {});
            if step % 2 == 0 {
                finds_all(&lanes.bodies, &mut lanes.broad);
            }
        }
        let anew = lanes.broad.rebuilds;
        println!("{name}: {anew} times of {steps} all was looked for anew");
        assert!(anew < steps);
    }
}

#[test]
fn pairs_found_before_are_those_that_a_rebuild_finds() {
    let mut lanes = start("balls", 3000);
    let mut tree = by(Way::Tree);
    for _ in 0..240 {
        lanes.step(DT, |_| {});
        let mut anew = BroadPhase::default();
        find_pairs(&lanes.bodies, DT, &mut anew);
        find_pairs(&lanes.bodies, DT, &mut tree);
        find_pairs(&lanes.bodies, DT, &mut lanes.broad);
        assert_eq!(anew.pairs, lanes.broad.pairs);
        assert_eq!(anew.pairs, tree.pairs);
    }
    assert!(lanes.broad.reuses > 0 && tree.reuses > 0);
    let (sorted, refitted) = tree.sorted_and_refitted();
    assert!(sorted > 0 && refitted > 0, "{sorted} and {refitted}");
}

#[test]
fn a_few_bodies_put_elsewhere_are_found_there_and_no_longer_where_they_were() {
    for way in WAYS {
        put_elsewhere(by(way));
    }
}

fn put_elsewhere(mut broad: BroadPhase) {
    let mut bodies = crowd(800, 4.0, 6);
    finds_all(&bodies, &mut broad);
    let mut random = SplitMix64::new(7);
    for turn in 0..30 {
        for _ in 0..3 {
            let row = (random.unit() * 800.0) as usize;
            let to = (random.unit() * 800.0) as usize;
            bodies.place[row].position = bodies.place[to].position + 0.01;
        }
        if turn == 20 {
            bodies.place[5].position.x = f32::NAN;
        }
        finds_all(&bodies, &mut broad);
    }
    assert!(broad.reuses > 10, "{} rebuilds", broad.rebuilds);
}

#[test]
fn one_two_and_four_threads_find_the_same_pairs_in_the_same_order() {
    let bodies = crowd(6000, 30.0, 8);
    let pairs = |threads: usize, way: Way| {
        within(threads, || {
            let mut broad = by(way);
            find_pairs(&bodies, DT, &mut broad);
            find_pairs(&bodies, DT, &mut broad);
            broad.pairs
        })
    };
    let one = pairs(1, Way::Grids);
    assert!(one.len() > 1000);
    for way in WAYS {
        for threads in [1, 2, 4] {
            assert!(pairs(threads, way) == one, "{way:?} on {threads}");
        }
    }
}

#[test]
fn bodies_that_are_all_in_one_place_are_all_pairs() {
    let mut bodies = crowd(120, 1.0, 9);
    for row in 0..bodies.rows() {
        bodies.place[row].position = Vec3::ONE;
        bodies.motion[row].velocity = Vec3::ZERO;
    }
    for way in WAYS {
        assert!(finds_all(&bodies, &mut by(way)) > 5000);
    }
}

#[test]
fn who_is_nowhere_has_no_pair() {
    let mut bodies = crowd(400, 3.0, 10);
    bodies.place[100].position.x = f32::NAN;
    bodies.place[101].position = Vec3::INFINITY;
    bodies.motion[103].velocity.y = f32::NEG_INFINITY;
    bodies.motion[104].velocity.z = f32::NAN;
    for way in WAYS {
        let mut broad = by(way);
        for _ in 0..2 {
            finds_all(&bodies, &mut broad);
            let nowhere = |row: usize| [100, 101, 103, 104].contains(&row);
            assert!(!broad.pairs.iter().any(|&(a, b)| nowhere(a) || nowhere(b)));
        }
        // And back again.
        let mut bodies = bodies.clone();
        bodies.place[100].position.x = 0.0;
        bodies.motion[103].velocity.y = 0.0;
        for row in 200..300 {
            bodies.place[row].position += 1.0;
        }
        finds_all(&bodies, &mut broad);
    }
}

#[test]
fn a_huge_body_meets_all_and_is_on_the_list_of_large_ones() {
    let mut bodies = crowd(400, 1.0, 11);
    bodies.solid[7].size.x = 1e4;
    bodies.place[7].reach = 1e4;
    for way in WAYS {
        let mut broad = by(way);
        assert!(finds_all(&bodies, &mut broad) >= bodies.rows() - 1);
        assert!(broad.large().contains(&7));
    }
}

#[test]
fn bodies_of_about_one_size_are_looked_for_in_grids_and_others_in_a_tree() {
    for (spread, way) in [
        (1.0, Way::Grids),
        (4.0, Way::Grids),
        (30.0, Way::Tree),
        (100.0, Way::Tree),
    ] {
        let mut broad = BroadPhase::default();
        let mut bodies = crowd(3000, spread, 12);
        for motion in &mut bodies.motion {
            motion.velocity = Vec3::ZERO;
        }
        finds_all(&bodies, &mut broad);
        assert_eq!(broad.way().0, way, "{:?}", broad.way());
    }
    for name in ["balls", "pile", "mixed", "ragdolls"] {
        let mut lanes = start(name, 100);
        lanes.step(DT, |_| {});
        assert_eq!(
            lanes.broad.way().0,
            Way::Grids,
            "{name} {:?}",
            lanes.broad.way()
        );
    }
}

#[test]
fn no_bodies_are_no_pairs() {
    for way in WAYS {
        assert_eq!(finds_all(&Bodies::default(), &mut by(way)), 0);
    }
}
