//! From a scene's joints to tables: trees, what closes loops, limits.

use std::ops::Range;

use ch00_scenes::Scene;
use glam::{DVec3, Vec3};

use super::TreeError;
use super::graph::{Forest, Place};
use super::merge::Bond;
use crate::own_row::limits::limit_of;
use crate::rows::{EMPTY, FREE, Limit, NONE, Node};

/// Nodes that a workgroup solves, an invocation each. A tree lies in one workgroup.
pub const WORKGROUP: usize = 64;

// ANCHOR: trees
/// The joints of a scene.
#[derive(Clone, Debug, Default)]
pub struct Trees {
    /// The nodes of all trees. They are filled up with empty rows so that a tree of up to
    /// [`WORKGROUP`] bodies lies in one run of so many rows.
    pub nodes: Vec<Node>,
    /// Where in them each tree lies.
    pub trees: Vec<Range<usize>>,
    /// Joints that close loops, each a row by itself: b is the body, a the parent.
    pub loops: Vec<Node>,
    /// Angle limits: those of one kind lie together, in the order of the scene.
    pub limits: Vec<Limit>,
    /// The loops of each body.
    pub loop_ends: Ends,
    /// The limits of each body.
    pub limit_ends: Ends,
}
// ANCHOR_END: trees

// ANCHOR: ends
/// Which rows of a table end at a body: those of body i are `rows[starts[i]..starts[i + 1]]`, in order,
/// each as 2 r, or as 2 r + 1 where the body is b.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ends {
    /// One more than there are bodies.
    pub starts: Vec<u32>,
    /// Twice as many as there are rows.
    pub rows: Vec<u32>,
}
// ANCHOR_END: ends

impl Ends {
    /// Of rows between these bodies, a and b.
    #[must_use]
    pub fn of(bodies: usize, pairs: &[(u32, u32)]) -> Self {
        let mut ends: Vec<(u32, u32)> = Vec::new();
        for (row, &(a, b)) in pairs.iter().enumerate() {
            ends.extend([(a, 2 * row as u32), (b, 2 * row as u32 + 1)]);
        }
        ends.sort_unstable();
        let start = |body: usize| ends.partition_point(|&(end, _)| (end as usize) < body) as u32;
        Self {
            starts: (0..=bodies).map(start).collect(),
            rows: ends.iter().map(|&(_, row)| row).collect(),
        }
    }

    /// A body came at which none ends.
    pub fn add_body(&mut self) {
        self.starts.push(self.rows.len() as u32);
    }

    /// A body at which none ended is gone.
    pub fn remove_body(&mut self, body: usize) {
        self.starts.remove(body);
    }

    /// The rows that end at a body, and whether it is their b.
    pub fn at(&self, body: usize) -> impl Iterator<Item = (usize, bool)> {
        let range = self.starts[body] as usize..self.starts[body + 1] as usize;
        self.rows[range]
            .iter()
            .map(|&row| (row as usize / 2, row % 2 == 1))
    }
}

impl Trees {
    /// The joints of a scene. A body's row is its index.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let forest = Forest::of(scene);
        let mut trees = Self::default();
        for places in &forest.trees {
            trees.plant(places);
        }
        trees.fill_up();
        trees.loops = forest.loops.iter().map(|&j| closing(scene, j)).collect();
        let indices = 0..scene.joints.len();
        trees.limits = indices.filter_map(|j| limit_of(scene, j)).collect();
        let bonds = forest.trees.iter().flatten();
        for bond in bonds.filter_map(|place| place.bond.as_ref()) {
            trees.pin_limits(bond);
        }
        trees.limits.sort_by_key(|limit| limit.kind);
        let bodies = scene.bodies.len();
        let of_loops = trees.loops.iter().map(|node| (node.parent_body, node.body));
        trees.loop_ends = Ends::of(bodies, &of_loops.collect::<Vec<_>>());
        let of_limits = trees.limits.iter().map(|limit| (limit.a, limit.b));
        trees.limit_ends = Ends::of(bodies, &of_limits.collect::<Vec<_>>());
        trees
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    // ANCHOR: plant
    /// Adds a tree behind the others: in the same workgroup if it has room, else in the next.
    fn plant(&mut self, places: &[Place]) {
        let taken = self.nodes.len() % WORKGROUP;
        if taken + places.len() > WORKGROUP {
            self.fill_up();
        }
        let first = self.nodes.len();
        for place in places {
            let parent = place.parent.map(|parent| first + parent);
            let here = self.nodes.len() as u32;
            if let Some(parent) = parent {
                let parent = &mut self.nodes[parent];
                parent.first_child = parent.first_child.min(here);
                parent.children += 1;
            }
            let node = place.bond.as_ref().map_or_else(Node::free, Node::of);
            self.nodes.push(Node {
                body: place.body as u32,
                parent: parent.map_or(NONE, |parent| parent as u32),
                depth: place.depth as u32,
                first_child: NONE,
                ..node
            });
        }
        self.trees.push(first..self.nodes.len());
    }
    // ANCHOR_END: plant

    /// Fills the last workgroup up with empty rows, and tells all rows of a workgroup how deep it is.
    fn fill_up(&mut self) {
        let full = self.nodes.len().next_multiple_of(WORKGROUP);
        self.nodes.resize(full, Node::default());
        for group in self.nodes.chunks_mut(WORKGROUP) {
            let levels = group.iter().map(|node| node.depth).max().unwrap_or(0);
            for node in group {
                node.levels = levels;
            }
        }
    }

    /// A limit of one of two pins turns about the line of both.
    fn pin_limits(&mut self, bond: &Bond) {
        for &joint in &bond.joints {
            let place = self
                .limits
                .binary_search_by_key(&(joint as u32), |limit| limit.joint);
            let Ok(place) = place else {
                continue;
            };
            let limit = &mut self.limits[place];
            let [a, b] = bond.anchors.map(DVec3::as_vec3);
            let is_flipped = limit.a as usize != bond.a;
            [limit.anchor_a, limit.anchor_b] = if is_flipped { [b, a] } else { [a, b] };
        }
    }

    // ANCHOR: fits
    /// Whether a workgroup holds each tree.
    ///
    /// # Errors
    /// [`TreeError`] names the first joint that is too many.
    pub fn fits(&self) -> Result<(), TreeError> {
        match self.trees.iter().find(|tree| tree.len() > WORKGROUP) {
            None => Ok(()),
            Some(tree) => Err(TreeError {
                joint: self.nodes[tree.start + WORKGROUP].joint as usize,
                body: self.nodes[tree.start + WORKGROUP].body as usize,
                bodies: tree.len(),
                most: WORKGROUP,
            }),
        }
    }
    // ANCHOR_END: fits

    /// A body without joints is gone: those after it have moved up.
    pub fn remove_body(&mut self, body: usize) {
        let move_up = |row: &mut u32| {
            if *row != NONE && *row as usize > body {
                *row -= 1;
            }
        };
        for node in self.nodes.iter_mut().chain(&mut self.loops) {
            move_up(&mut node.body);
            move_up(&mut node.parent_body);
            move_up(&mut node.second_parent);
        }
        for limit in &mut self.limits {
            move_up(&mut limit.a);
            move_up(&mut limit.b);
        }
        self.limit_ends.remove_body(body);
        self.loop_ends.remove_body(body);
    }

    /// Forgets what held in the last substep.
    pub fn forget(&mut self) {
        for node in self.nodes.iter_mut().chain(&mut self.loops) {
            node.impulse = Vec3::ZERO;
            node.turning = Vec3::ZERO;
        }
        for limit in &mut self.limits {
            limit.impulses = Vec3::ZERO;
        }
    }
}

impl Node {
    /// Row of its body; None where the row only fills up a workgroup.
    #[must_use]
    pub fn row(&self) -> Option<usize> {
        (self.kind != EMPTY).then_some(self.body as usize)
    }

    /// Nothing holds it.
    fn free() -> Self {
        Self {
            kind: FREE,
            parent_body: NONE,
            second_parent: NONE,
            joint: NONE,
            ..Self::default()
        }
    }

    /// What this bond's b hangs by.
    fn of(bond: &Bond) -> Self {
        let second = bond.second.map_or(NONE, |second| second as u32);
        Self {
            body: bond.b as u32,
            parent_body: bond.a as u32,
            parent: NONE,
            kind: bond.kind,
            anchor: bond.anchors[1].as_vec3(),
            parent_anchor: bond.anchors[0].as_vec3(),
            axis: bond.axes[1].as_vec3(),
            parent_axis: bond.axes[0].as_vec3(),
            length: bond.lengths[0] as f32,
            second_length: bond.lengths[1] as f32,
            second_parent: second,
            joint: bond.joints[0] as u32,
            ..Self::default()
        }
    }
}

/// A joint that closes a loop.
fn closing(scene: &Scene, joint: usize) -> Node {
    Node::of(&Bond::of(scene, joint))
}
