//! Joints and angle limits in a step: rows beside the pairs, and the trees after them.

use ch00_scenes::Scene;

use super::sums::Sums;
use crate::bodies::Bodies;
use crate::own_row::body::Gathered;
use crate::own_row::limits::Limits;
use crate::own_row::loops::solve_loop;
use crate::own_row::side::Side;
use crate::own_row::tree::{Batches, Solved, Trees};
use crate::rows::{FREE, Held, Node, Press};
use crate::simd::{Real, Widest};

/// A body without a tree.
const ALONE: u32 = u32::MAX;

/// All joints of a run, and what they do in a substep.
#[derive(Clone, Debug, Default)]
pub struct Joints<R = Widest> {
    /// Trees, what closes loops, and limits, as they were at the start.
    pub trees: Trees,
    /// The trees, a tree a lane.
    batches: Batches<R>,
    /// The limits, a limit a lane.
    limits: Limits<R>,
    /// By body: what its tree holds it with.
    joined: Vec<Held>,
    /// By body: its tree.
    tree_of: Vec<u32>,
    /// By joint that closes a loop.
    pressed: Vec<Press>,
    /// By tree: whether nothing holds it up.
    floating: Vec<bool>,
}

impl<R: Real> Joints<R> {
    /// The joints of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let trees = Trees::of(scene);
        Self {
            batches: Batches::of(&trees, &Bodies::of(scene)),
            limits: Limits::of(&trees.limits),
            joined: vec![Held::default(); scene.bodies.len()],
            tree_of: trees_of(&trees, scene.bodies.len()),
            pressed: vec![Press::default(); trees.loops.len()],
            floating: Vec::new(),
            trees,
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.trees.is_empty() && self.trees.loops.is_empty()
    }

    /// Forgets what held in the last substep.
    pub fn forget(&mut self) {
        self.trees.forget();
        self.joined.fill(Held::default());
        self.batches.forget();
        self.limits.forget();
        self.pressed.fill(Press::default());
    }

    // ANCHOR: solve_rows
    /// Every limit and every joint that closes a loop writes its own impulses.
    pub fn solve_rows(&mut self, bodies: &Bodies, h: f32) {
        self.limits.solve(bodies, h);
        for (node, pressed) in self.trees.loops.iter_mut().zip(&mut self.pressed) {
            let ends = [node.parent_body, node.body];
            if ends.iter().any(|&row| bodies.is_asleep(row as usize)) {
                continue;
            }
            let sides = ends.map(|row| Side::of(bodies, &[row]));
            *pressed = solve_loop(node, pressed, sides, h);
        }
    }
    // ANCHOR_END: solve_rows

    /// Adds what limits and loops did to a body to what its pairs did.
    #[inline]
    pub fn gather(&self, row: usize, sum: &mut Gathered) {
        if self.trees.is_empty() && self.trees.loops.is_empty() {
            return;
        }
        for (limit, is_b) in self.trees.limit_ends.at(row) {
            sum.add_turned(&self.limits.turned[limit], is_b);
        }
        for (joint, is_b) in self.trees.loop_ends.at(row) {
            let mut press = self.pressed[joint];
            (press.counts, press.stays) = (1.0, 1.0);
            sum.add(&press, is_b);
        }
    }

    /// What holds a body: its contacts, and the joints of its tree.
    #[must_use]
    pub fn with(&self, row: usize, held: Held) -> Held {
        let joined = self.joined[row];
        Held {
            linear: held.linear + joined.linear,
            angular: held.angular + joined.angular,
            ..held
        }
    }

    // ANCHOR: solve_trees
    /// Every tree mends the velocities of its bodies.
    pub fn solve_trees(&mut self, bodies: &mut Bodies, h: f32) {
        self.batches.solve(bodies, &self.joined, h);
        self.batches.apply(bodies, &mut self.joined);
    }
    // ANCHOR_END: solve_trees

    /// What the last solve made of a body; none if it is in no tree.
    #[inline]
    #[must_use]
    pub fn solved(&self, row: usize) -> Option<&Solved> {
        self.batches.at(row)
    }

    // ANCHOR: floats
    /// Notes which trees nothing holds up: nothing touches any of their bodies, and none hangs on the world.
    pub fn note_floating(&mut self, sums: &Sums<'_>) {
        let free = |row: usize| sums.row(row).touches == 0.0;
        self.floating.clear();
        for tree in &self.trees.trees {
            let nodes = &self.trees.nodes[tree.clone()];
            let floats = nodes[0].kind == FREE && nodes.iter().filter_map(Node::row).all(free);
            self.floating.push(floats);
        }
    }

    /// Whether nothing holds a body up: nothing touches it, nor any that hangs together with it, and none of
    /// them hangs on the world.
    #[must_use]
    pub fn floats(&self, row: usize, sums: &Sums<'_>) -> bool {
        match self.tree_of.get(row) {
            Some(&tree) if tree != ALONE => self.floating[tree as usize],
            _ => sums.row(row).touches == 0.0,
        }
    }
    // ANCHOR_END: floats

    /// From now on the joints alone are solved whose bodies are awake; the others keep what they hold with.
    pub fn group(&mut self, bodies: &Bodies) {
        if self.is_empty() {
            return;
        }
        let awake = |row: usize| !bodies.is_asleep(row);
        self.batches.write_back(&mut self.trees.nodes);
        self.batches = Batches::of_those(&self.trees, bodies, |nodes| {
            nodes.iter().filter_map(Node::row).any(awake)
        });
        self.limits.write_back(&mut self.trees.limits);
        self.limits.group(&self.trees.limits, |limit| {
            awake(limit.a as usize) && awake(limit.b as usize)
        });
    }

    /// A body without joints came.
    pub fn add_body(&mut self) {
        self.joined.push(Held::default());
        self.tree_of.push(ALONE);
        self.batches.add_body();
        self.trees.limit_ends.add_body();
        self.trees.loop_ends.add_body();
    }

    /// A body without joints is gone, and those after it have moved up.
    pub fn remove_body(&mut self, row: usize) {
        self.trees.remove_body(row);
        self.batches.remove_body(row);
        self.limits.remove_body(row);
        self.joined.remove(row);
        self.tree_of.remove(row);
    }
}

/// The tree of each body.
fn trees_of(trees: &Trees, bodies: usize) -> Vec<u32> {
    let mut of = vec![ALONE; bodies];
    for (tree, nodes) in trees.trees.iter().enumerate() {
        for row in trees.nodes[nodes.clone()].iter().filter_map(Node::row) {
            of[row] = tree as u32;
        }
    }
    of
}
