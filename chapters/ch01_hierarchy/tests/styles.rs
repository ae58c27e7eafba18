//! The three styles: the same bits, and the marks that their costs are counted by.

use ch01_hierarchy::Transform;
use ch01_hierarchy::styles::items::{Kind, scene};
use ch01_hierarchy::styles::{Style, components, cost, hierarchy, hybrid};

const STEPS: usize = 500;
const DT: f32 = 1.0 / 60.0;

struct Run {
    poses: Vec<Transform>,
    positions: Vec<[f32; 3]>,
    glow: Vec<f32>,
}

fn run<S: Style>(count: usize) -> Run {
    let mut world = S::build(&scene(count));
    for _ in 0..STEPS {
        world.update(DT);
    }
    let (mut poses, mut positions, mut glow) = (Vec::new(), Vec::new(), Vec::new());
    world.gather_poses(&mut poses);
    world.gather_positions(&mut positions);
    world.gather_glow(&mut glow);
    Run {
        poses,
        positions,
        glow,
    }
}

fn bits(run: &Run) -> Vec<u32> {
    let poses = run.poses.iter().flat_map(|pose| {
        let rotation = pose.rotation.to_array();
        pose.translation.to_array().into_iter().chain(rotation)
    });
    poses
        .chain(run.glow.iter().copied())
        .map(f32::to_bits)
        .collect()
}

#[test]
fn the_three_styles_compute_the_same_bits() {
    for count in [1, 2, 10, 777] {
        let first = run::<hierarchy::World>(count);
        let second = run::<components::World>(count);
        let third = run::<hybrid::World>(count);
        assert_eq!(bits(&first), bits(&second), "{count} items");
        assert_eq!(bits(&first), bits(&third), "{count} items");
    }
}

#[test]
fn the_position_column_is_that_of_the_poses() {
    let run = run::<components::World>(100);
    for (pose, position) in run.poses.iter().zip(&run.positions) {
        assert_eq!(pose.translation.to_array(), *position);
    }
}

#[test]
fn everything_moves_and_stays_finite() {
    let run = run::<hybrid::World>(1000);
    let mut start = Vec::new();
    hybrid::World::build(&scene(1000)).gather_poses(&mut start);
    for (before, after) in start.iter().zip(&run.poses) {
        assert!(after.translation.is_finite());
        assert!(before != after);
    }
}

#[test]
fn what_spins_glows_as_fast_as_it_spins() {
    let items = scene(300);
    let run = run::<hierarchy::World>(300);
    for (item, glow) in items.iter().zip(&run.glow) {
        // After 500 steps, 17 of its half seconds, it is there to within e⁻¹⁷.
        let expected = if item.kind == Kind::Orbiter {
            0.0
        } else {
            item.spin.abs()
        };
        assert!((glow - expected).abs() < 1e-5, "{glow} is not {expected}");
    }
}

#[test]
fn every_style_paid_for_the_new_property() {
    for (style, _) in cost::SOURCES {
        let cost = cost::of(style);
        assert!(
            cost.changed > 1 && cost.lines > cost.places,
            "{style}: {cost:?}"
        );
    }
}
