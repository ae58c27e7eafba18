//! Whether it pays to leave out nodes that were not set: `update_world`, which asks each
//! node, against `recompute_world`, which doesn't.

use ch01_hierarchy::styles::items::scene;
use ch01_hierarchy::{NodeId, SceneGraph, Transform};
use glam::{Quat, Vec3};

use crate::measure::{Nanoseconds, RUNS, seconds, spread};

/// Every so-many-th node is set before an update; `None`: no node is.
const SET_EVERY: [Option<usize>; 4] = [None, Some(100), Some(10), Some(1)];

/// One share of nodes that are set.
pub struct Row {
    pub count: usize,
    /// Nodes set before each update, and nodes that moved because of it, %.
    pub set: f64,
    pub moved: f64,
    /// Setting included.
    pub skipping: Nanoseconds,
    pub recomputing: Nanoseconds,
}

/// All shares, on the tree of the styles' scene.
pub fn measure(count: usize) -> Vec<Row> {
    SET_EVERY.iter().map(|&every| row(count, every)).collect()
}

fn row(count: usize, every: Option<usize>) -> Row {
    let (mut graph, nodes) = tree(count);
    let set: Vec<NodeId> = every.map_or(Vec::new(), |every| {
        // From the end: a node near the root would take nearly all others along.
        nodes.iter().rev().step_by(every).copied().collect()
    });
    let mut skipping = [0.0; RUNS];
    let mut recomputing = [0.0; RUNS];
    for run in 0..RUNS {
        skipping[run] = seconds(|| {
            touch(&mut graph, &set);
            graph.update_world();
        });
        recomputing[run] = seconds(|| {
            touch(&mut graph, &set);
            graph.recompute_world();
        });
    }
    Row {
        count,
        set: 100.0 * set.len() as f64 / count as f64,
        moved: 100.0 * moved(graph, &nodes, &set) as f64 / count as f64,
        skipping: spread(skipping, count),
        recomputing: spread(recomputing, count),
    }
}

fn tree(count: usize) -> (SceneGraph, Vec<NodeId>) {
    let mut graph = SceneGraph::new();
    let mut nodes: Vec<NodeId> = Vec::with_capacity(count);
    for item in scene(count) {
        let local = Transform::new(Vec3::X * item.radius, Quat::from_rotation_y(item.phase));
        let parent = item.parent.map(|parent| nodes[parent]);
        nodes.push(graph.add("", parent, local));
    }
    (graph, nodes)
}

fn touch(graph: &mut SceneGraph, set: &[NodeId]) {
    for &node in set {
        graph.local_mut(node).translation.y = 1.0;
    }
}

/// How many world transforms another place for the set nodes changes.
fn moved(mut graph: SceneGraph, nodes: &[NodeId], set: &[NodeId]) -> usize {
    let before: Vec<Transform> = nodes.iter().map(|&node| graph.world(node)).collect();
    for &node in set {
        graph.local_mut(node).translation.y = 1e3;
    }
    graph.update_world();
    let pairs = nodes.iter().zip(before);
    pairs
        .filter(|(node, before)| graph.world(**node) != *before)
        .count()
}
