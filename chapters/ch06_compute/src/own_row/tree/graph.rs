//! Which bodies hang on each other, and in which order a tree's walks visit them.

use std::collections::BTreeMap;

use ch00_scenes::Scene;

use super::merge::{Bond, merged};

/// A body in a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Index of the body.
    pub body: usize,
    /// The place of its parent in the tree; the root has none.
    pub parent: Option<usize>,
    /// What holds it, with it as b; a free root has none.
    pub bond: Option<Bond>,
    /// Places above it.
    pub depth: usize,
}

// ANCHOR: forest
/// All joints of a scene, as trees and what is left.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Forest {
    /// Each tree's bodies, level by level; in a level the children of one parent lie together, in order
    /// of ID.
    pub trees: Vec<Vec<Place>>,
    /// Joints that close loops, in order.
    pub loops: Vec<usize>,
}
// ANCHOR_END: forest

/// A body that a walk found: the place of the one before it and the bond between them, and how many are
/// before it.
type Found = (usize, Option<(usize, usize)>, usize);

/// Who is joined to whom.
struct Graph {
    bonds: Vec<Bond>,
    /// The bodies that a body is joined to, in order, and by which bond.
    neighbours: Vec<Vec<(usize, usize)>>,
    /// The bond by which a body hangs on a static one.
    held: Vec<Option<usize>>,
}

impl Forest {
    /// Of a scene. All static bodies together are one: it holds trees up, and doesn't connect them.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let (graph, mut loops) = Graph::of(scene);
        let mut seen = vec![false; scene.bodies.len()];
        let mut used = vec![false; graph.bonds.len()];
        let mut trees = Vec::new();
        for start in 0..scene.bodies.len() {
            let is_joined = graph.held[start].is_some() || !graph.neighbours[start].is_empty();
            if seen[start] || !is_joined {
                continue;
            }
            let found = graph.walk(start);
            for &(body, ..) in &found {
                seen[body] = true;
            }
            let held = found.iter().map(|&(body, ..)| body);
            let held = held.filter(|&body| graph.held[body].is_some()).min();
            let root = held.unwrap_or_else(|| graph.middle(start));
            trees.push(graph.grow(root, &mut used));
        }
        let unused = graph.bonds.iter().zip(&used).filter(|(_, used)| !**used);
        loops.extend(unused.flat_map(|(bond, _)| &bond.joints));
        loops.sort_unstable();
        Self { trees, loops }
    }
}

impl Graph {
    /// The bonds of a scene, and the joints that found no room in one.
    fn of(scene: &Scene) -> (Self, Vec<usize>) {
        let mut groups: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
        for (j, joint) in scene.joints.iter().enumerate() {
            if let Some(key) = ends(scene, joint.bodies()) {
                groups.entry(key).or_default().push(j);
            }
        }
        let count = scene.bodies.len();
        let mut graph = Self {
            bonds: Vec::new(),
            neighbours: vec![Vec::new(); count],
            held: vec![None; count],
        };
        let mut left = Vec::new();
        for ((one, other), joints) in groups {
            let (bond, without_room) = merged(scene, &joints);
            left.extend(without_room);
            let index = graph.bonds.len();
            if other == WORLD {
                graph.held[one] = Some(index);
            } else {
                graph.neighbours[one].push((other, index));
                graph.neighbours[other].push((one, index));
            }
            graph.bonds.push(bond);
        }
        for neighbours in &mut graph.neighbours {
            neighbours.sort_unstable();
        }
        (graph, left)
    }

    /// All bodies that are joined to `start` somehow, level by level.
    fn walk(&self, start: usize) -> Vec<Found> {
        let mut seen = std::collections::BTreeSet::from([start]);
        let mut found = vec![(start, None, 0)];
        let mut next = 0;
        while next < found.len() {
            let (body, _, depth) = found[next];
            for &(other, bond) in &self.neighbours[body] {
                if seen.insert(other) {
                    found.push((other, Some((next, bond)), depth + 1));
                }
            }
            next += 1;
        }
        found
    }

    // ANCHOR: middle
    /// The body in the middle of the longest way through a free tree: with it as the root the tree has the
    /// fewest levels. Any body may be the root.
    fn middle(&self, start: usize) -> usize {
        let from_start = self.walk(start);
        let found = self.walk(from_start[deepest(&from_start)].0);
        let mut place = deepest(&found);
        for _ in 0..found[place].2 / 2 {
            place = found[place].1.map_or(place, |(before, _)| before);
        }
        found[place].0
    }
    // ANCHOR_END: middle

    /// The tree below a root.
    fn grow(&self, root: usize, used: &mut [bool]) -> Vec<Place> {
        let mut bond_for = |bond: usize, child: usize| {
            used[bond] = true;
            let bond = self.bonds[bond].clone();
            if bond.b == child {
                bond
            } else {
                bond.flipped()
            }
        };
        let places = self.walk(root).into_iter();
        places
            .map(|(body, before, depth)| Place {
                body,
                parent: before.map(|(place, _)| place),
                bond: before
                    .map(|(_, bond)| bond)
                    .or(self.held[body].filter(|_| depth == 0))
                    .map(|bond| bond_for(bond, body)),
                depth,
            })
            .collect()
    }
}

/// The place of the first of those that are furthest.
fn deepest(found: &[Found]) -> usize {
    let most = found.iter().map(|found| found.2).max();
    let furthest = found.iter().position(|found| Some(found.2) == most);
    furthest.unwrap_or(0)
}

/// What stands for all static bodies.
const WORLD: usize = usize::MAX;

/// The two bodies of a joint, the smaller index first, static ones last; none if both are static.
fn ends(scene: &Scene, (a, b): (usize, usize)) -> Option<(usize, usize)> {
    let is_static = |body: usize| scene.bodies[body].is_static();
    match (is_static(a), is_static(b)) {
        (true, true) => None,
        (true, false) => Some((b, WORLD)),
        (false, true) => Some((a, WORLD)),
        (false, false) => Some((a.min(b), a.max(b))),
    }
}
