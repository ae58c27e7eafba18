//! The scene graph: world transforms, hanging nodes elsewhere, and handles that outlive
//! their nodes.

use ch01_hierarchy::{GraphError, Keep, NodeId, SceneGraph, Transform};
use glam::{Quat, Vec3};

/// Rounding of a few operations on numbers of size 10.
const ROUNDING: f32 = 1e-5;

fn at(x: f32) -> Transform {
    Transform::from_translation(Vec3::X * x)
}

fn turned(x: f32, angle: f32) -> Transform {
    Transform::new(Vec3::X * x, Quat::from_rotation_y(angle))
}

/// A chain a → b → c, each one metre out and turned by half a radian.
fn chain() -> (SceneGraph, [NodeId; 3]) {
    let mut graph = SceneGraph::new();
    let a = graph.add("a", None, turned(1.0, 0.5));
    let b = graph.add("b", Some(a), turned(1.0, 0.5));
    let c = graph.add("c", Some(b), turned(1.0, 0.5));
    (graph, [a, b, c])
}

fn assert_close(left: Transform, right: Transform) {
    assert!(
        left.translation.abs_diff_eq(right.translation, ROUNDING)
            && left.rotation.abs_diff_eq(right.rotation, ROUNDING),
        "{left:?} is not {right:?}"
    );
}

#[test]
fn a_world_transform_is_the_product_of_the_local_ones_from_the_root() {
    let (mut graph, [a, b, c]) = chain();
    graph.update_world();
    let product = graph.local(a) * graph.local(b) * graph.local(c);
    assert_eq!(graph.world(c), product);
}

#[test]
fn a_node_has_its_world_transform_as_soon_as_it_is_added() {
    let (mut graph, [.., c]) = chain();
    let before = graph.world(c);
    graph.update_world();
    assert_eq!(before, graph.world(c));
}

#[test]
fn setting_the_root_moves_the_leaf_at_the_next_update_and_not_before() {
    let (mut graph, [a, _, c]) = chain();
    graph.update_world();
    let before = graph.world(c);
    graph.set_local(a, turned(3.0, 0.5));
    assert_eq!(graph.world(c), before);
    graph.update_world();
    assert_close(graph.world(c), at(2.0) * before);
}

#[test]
fn a_node_that_keeps_its_world_place_stays_where_it_is() {
    let (mut graph, [a, _, c]) = chain();
    graph.update_world();
    let before = graph.world(c);
    graph.attach(c, Some(a), Keep::World).unwrap();
    graph.update_world();
    assert_eq!(graph.parent(c), Some(a));
    assert_close(graph.world(c), before);
}

#[test]
fn keeping_the_world_place_counts_what_was_set_since_the_last_update() {
    let (mut graph, [a, b, c]) = chain();
    graph.set_local(b, at(7.0));
    let expected = graph.local(a) * at(7.0) * graph.local(c);
    graph.detach(c, Keep::World).unwrap();
    graph.update_world();
    assert_close(graph.world(c), expected);
}

#[test]
fn a_node_that_keeps_its_local_place_goes_along() {
    let (mut graph, [_, b, c]) = chain();
    let local = graph.local(c);
    graph.detach(b, Keep::Local).unwrap();
    graph.update_world();
    assert_eq!(graph.local(c), local);
    assert_eq!(graph.world(b), graph.local(b));
    assert_close(graph.world(c), graph.local(b) * local);
}

#[test]
fn a_tree_can_not_bite_its_tail() {
    let (mut graph, [a, _, c]) = chain();
    let cycle = |parent: &str| GraphError::Cycle {
        child: "a".to_owned(),
        parent: parent.to_owned(),
    };
    assert_eq!(graph.attach(a, Some(c), Keep::Local), Err(cycle("c")));
    assert_eq!(graph.attach(a, Some(a), Keep::World), Err(cycle("a")));
    assert_eq!(graph.parent(a), None, "a refused change changes nothing");
    assert_eq!(
        cycle("c").to_string(),
        "node `a` can't be attached to `c`, which is in its own subtree"
    );
}

#[test]
fn a_parent_that_was_added_later_is_still_updated_first() {
    let mut graph = SceneGraph::new();
    let child = graph.add("child", None, at(1.0));
    let late = graph.add("late parent", None, at(10.0));
    graph.attach(child, Some(late), Keep::Local).unwrap();
    graph.set_local(late, at(20.0));
    graph.update_world();
    assert_eq!(graph.world(child).translation, Vec3::X * 21.0);
}

#[test]
fn children_of_a_removed_node_move_up_and_stay_in_place() {
    let (mut graph, [a, b, c]) = chain();
    graph.update_world();
    let before = graph.world(c);
    graph.remove(b).unwrap();
    graph.update_world();
    assert_eq!(graph.len(), 2);
    assert_eq!(graph.parent(c), Some(a));
    assert_eq!(graph.get(a).unwrap().children(), [c]);
    assert_close(graph.world(c), before);
}

#[test]
fn a_handle_never_names_the_node_that_took_the_slot() {
    let (mut graph, [.., c]) = chain();
    graph.remove(c).unwrap();
    let newcomer = graph.add("newcomer", None, at(1.0));
    assert_ne!(newcomer, c);
    assert!(graph.get(c).is_none());
    assert_eq!(graph.remove(c), Err(GraphError::Removed(c)));
    assert_eq!(
        graph.attach(newcomer, Some(c), Keep::Local),
        Err(GraphError::Removed(c))
    );
    assert_eq!(graph.get(newcomer).unwrap().name(), "newcomer");
}

#[test]
#[should_panic(expected = "names a node that was removed")]
fn the_world_transform_of_a_removed_node_is_not_made_up() {
    let (mut graph, [.., c]) = chain();
    graph.remove(c).unwrap();
    let _ = graph.world(c);
}

#[test]
fn a_slot_that_is_used_again_is_updated_once_and_after_its_parent() {
    let (mut graph, [a, b, c]) = chain();
    graph.remove(a).unwrap();
    let again = graph.add("again", Some(c), at(1.0));
    graph.update_world();
    graph.set_local(b, at(5.0));
    graph.update_world();
    assert_eq!(graph.world(again), graph.world(c) * at(1.0));
    assert_eq!(graph.len(), 3);
}

#[test]
fn skipping_what_was_not_set_gives_the_bits_of_computing_all() {
    let mut graph = SceneGraph::new();
    let mut nodes = vec![graph.add("root", None, turned(0.3, 0.1))];
    for i in 1..200_u16 {
        let parent = nodes[usize::from(i - 1) / 3];
        nodes.push(graph.add("", Some(parent), turned(f32::from(i % 7), 0.2)));
    }
    for frame in 0..20_u16 {
        for step in 0..5 {
            let node = nodes[usize::from(frame) * 37 % 200 / (step + 1)];
            graph.set_local(node, turned(f32::from(frame), 0.01 * f32::from(frame)));
        }
        let mut all = graph.clone();
        graph.update_world();
        all.recompute_world();
        for &node in &nodes {
            assert_eq!(graph.world(node), all.world(node));
        }
    }
}
