//! Which joints make trees.

use ch00_scenes::{Joint, Scene, builtin};
use glam::DVec3;

use super::*;
use crate::rows::{EMPTY, HINGE, NONE, PIN};

fn scene(name: &str, count: Option<u64>) -> Scene {
    builtin::build(name, count, None).expect("a built-in scene")
}

fn kinds(trees: &Trees) -> Vec<u32> {
    let kinds = trees.nodes.iter().map(|node| node.kind);
    kinds.filter(|&kind| kind != EMPTY).collect()
}

#[test]
fn two_pins_of_a_door_are_a_hinge_and_its_stop_is_a_limit() {
    for name in ["door", "door_pins"] {
        let trees = Trees::of(&scene(name, None));
        assert_eq!(kinds(&trees), [HINGE], "{name}");
        assert_eq!((trees.loops.len(), trees.limits.len()), (0, 1), "{name}");
    }
}

#[test]
fn two_threads_of_a_cradle_are_one_row_a_ball() {
    let trees = Trees::of(&scene("cradle", None));
    assert_eq!(kinds(&trees), [TWO_RODS; 5]);
    assert_eq!(trees.trees.len(), 5);
    assert!(trees.loops.is_empty());
}

#[test]
fn a_chain_is_one_tree_with_a_level_a_link() {
    let trees = Trees::of(&scene("chain", None));
    assert_eq!(kinds(&trees), [PIN; 41]);
    assert_eq!(trees.nodes[40].depth, 40);
    assert!(trees.nodes.iter().all(|node| node.levels == 40));
    assert_eq!(trees.fits(), Ok(()));
}

#[test]
fn a_ragdoll_hangs_on_its_waist_since_that_makes_the_fewest_levels() {
    let trees = Trees::of(&scene("ragdolls", Some(7)));
    assert_eq!(trees.trees.len(), 7);
    assert_eq!(trees.limits.len(), 77);
    for tree in &trees.trees {
        let nodes = &trees.nodes[tree.clone()];
        assert_eq!(nodes.len(), 12);
        assert_eq!(nodes[0].kind, FREE);
        assert_eq!(nodes.iter().map(|node| node.depth).max(), Some(3));
    }
    // Five fit into a workgroup, so the sixth starts the next one.
    assert_eq!(trees.trees[5].start, WORKGROUP);
    assert_eq!(trees.nodes.len(), 2 * WORKGROUP);
}

#[test]
fn parents_stand_before_children_and_siblings_side_by_side_in_order_of_id() {
    for seed in 0..20 {
        let trees = Trees::of(&random_tree(seed, 30, seed % 2 == 0));
        for tree in &trees.trees {
            for i in tree.clone() {
                let node = &trees.nodes[i];
                let mut ids = Vec::new();
                for child in children(node) {
                    assert!(child > i && tree.contains(&child));
                    assert_eq!(trees.nodes[child].parent as usize, i);
                    assert_eq!(trees.nodes[child].parent_body, node.body);
                    assert_eq!(trees.nodes[child].depth, node.depth + 1);
                    ids.push(trees.nodes[child].body);
                }
                assert!(ids.is_sorted());
            }
            let below: u32 = tree.clone().map(|i| trees.nodes[i].children).sum();
            assert_eq!(below as usize, tree.len() - 1);
        }
    }
}

/// Four bodies in a ring.
fn ring() -> Scene {
    let mut scene = scene("pair", None);
    let one = scene.bodies[0].clone();
    scene.bodies = vec![one; 4];
    scene.joints = (0..4)
        .map(|i| Joint::pin(i, (i + 1) % 4, DVec3::X, DVec3::NEG_X))
        .collect();
    scene
}

#[test]
fn one_joint_of_a_ring_closes_a_loop() {
    let trees = Trees::of(&ring());
    assert_eq!(kinds(&trees), [FREE, PIN, PIN, PIN]);
    assert_eq!(trees.loops.len(), 1);
    assert_eq!(trees.loop_ends.rows.len(), 2);
}

#[test]
fn a_body_that_hangs_on_two_static_bodies_closes_a_loop() {
    let mut scene = ring();
    scene.joints.truncate(2);
    scene.bodies[0].mass = 0.0;
    scene.bodies[2].mass = 0.0;
    let trees = Trees::of(&scene);
    assert_eq!((kinds(&trees), trees.loops.len()), (vec![PIN], 1));
}

#[test]
fn pins_that_no_hinge_could_be_are_left_to_a_loop() {
    let mut scene = ring();
    // Off by a decimetre: further apart in one body than in the other.
    scene.joints = vec![
        Joint::pin(0, 1, DVec3::ZERO, DVec3::ZERO),
        Joint::pin(0, 1, DVec3::Y, DVec3::Y * 1.1),
    ];
    let trees = Trees::of(&scene);
    assert_eq!((kinds(&trees), trees.loops.len()), (vec![FREE, PIN], 1));
}

#[test]
fn a_third_pin_on_the_line_of_two_and_a_second_hinge_there_add_nothing() {
    let mut scene = ring();
    let pin = |y: f64| Joint::pin(0, 1, DVec3::Y * y, DVec3::new(1.0, y, 0.0));
    scene.joints = vec![pin(0.0), pin(1.0), pin(3.0)];
    let trees = Trees::of(&scene);
    assert_eq!((kinds(&trees), trees.loops.len()), (vec![FREE, HINGE], 0));
    scene.joints[1] = Joint::Hinge {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: DVec3::X,
        axis_a: DVec3::Y,
        axis_b: DVec3::Y,
        range: None,
    };
    let trees = Trees::of(&scene);
    assert_eq!((kinds(&trees), trees.loops.len()), (vec![FREE, HINGE], 0));
}

#[test]
fn a_chain_of_more_bodies_than_a_workgroup_names_the_first_joint_too_many() {
    let trees = Trees::of(&thin_chain(100, 0.03, 1.0));
    let error = trees.fits().expect_err("100 links");
    assert_eq!(
        error,
        TreeError {
            joint: 64,
            body: 65,
            bodies: 100,
            most: 64
        }
    );
    assert!(
        error
            .to_string()
            .starts_with("joints[64] hangs body 65 on a tree of 100 bodies")
    );
}

#[test]
fn joints_follow_bodies_that_move_up() {
    let mut scene = ring();
    scene.joints = vec![Joint::pin(1, 3, DVec3::X, DVec3::NEG_X)];
    let mut trees = Trees::of(&scene);
    assert_eq!((trees.nodes[1].body, trees.nodes[1].parent_body), (3, 1));
    trees.remove_body(2);
    assert_eq!((trees.nodes[1].body, trees.nodes[1].parent_body), (2, 1));
    trees.remove_body(0);
    assert_eq!((trees.nodes[1].body, trees.nodes[1].parent_body), (1, 0));
    assert_eq!((trees.nodes[0].body, trees.nodes[0].parent_body), (0, NONE));
}
