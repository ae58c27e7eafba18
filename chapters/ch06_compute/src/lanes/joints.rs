//! Joints and angle limits in a step: rows beside the pairs, and the trees after them.

use ch00_scenes::Scene;

use crate::bodies::Bodies;
use crate::own_row::body::Gathered;
use crate::own_row::limits::solve_limit;
use crate::own_row::loops::solve_loop;
use crate::own_row::one_side::Side;
use crate::own_row::tree::Trees;
use crate::rows::{FREE, Held, Node, Press, Turned};

/// A body without a tree.
const ALONE: u32 = u32::MAX;

/// All joints of a run, and what they do in a substep.
#[derive(Clone, Debug, Default)]
pub struct Joints {
    /// Trees, what closes loops, and limits.
    pub trees: Trees,
    /// By body: what its tree holds it with.
    joined: Vec<Held>,
    /// By body: its tree.
    tree_of: Vec<u32>,
    /// By limit.
    turned: Vec<Turned>,
    /// By joint that closes a loop.
    pressed: Vec<Press>,
}

impl Joints {
    /// The joints of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let trees = Trees::of(scene);
        Self {
            joined: vec![Held::default(); scene.bodies.len()],
            tree_of: trees_of(&trees, scene.bodies.len()),
            turned: vec![Turned::default(); trees.limits.len()],
            pressed: vec![Press::default(); trees.loops.len()],
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
        self.turned.fill(Turned::default());
        self.pressed.fill(Press::default());
    }

    // ANCHOR: solve_rows
    /// Every limit and every joint that closes a loop writes its own impulses.
    pub fn solve_rows(&mut self, bodies: &Bodies, h: f32) {
        for (limit, turned) in self.trees.limits.iter_mut().zip(&mut self.turned) {
            let sides = [limit.a, limit.b].map(|row| side_of(bodies, row));
            *turned = solve_limit(limit, turned, sides, h);
        }
        for (node, pressed) in self.trees.loops.iter_mut().zip(&mut self.pressed) {
            let sides = [node.parent_body, node.body].map(|row| side_of(bodies, row));
            *pressed = solve_loop(node, pressed, sides, h);
        }
    }
    // ANCHOR_END: solve_rows

    /// Adds what limits and loops did to a body to what its pairs did.
    pub fn gather(&self, row: usize, sum: &mut Gathered) {
        if self.trees.is_empty() && self.trees.loops.is_empty() {
            return;
        }
        for (limit, is_b) in self.trees.limit_ends.at(row) {
            sum.add_turned(&self.turned[limit], is_b);
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
        self.trees.solve(bodies, &mut self.joined, h);
    }
    // ANCHOR_END: solve_trees

    // ANCHOR: floats
    /// Whether nothing holds a body up: nothing touches it, nor any that hangs together with it, and none of
    /// them hangs on the world.
    #[must_use]
    pub fn floats(&self, row: usize, gathered: &[Gathered]) -> bool {
        let free = |row: usize| gathered[row].touches == 0.0;
        match self.tree_of.get(row) {
            Some(&tree) if tree != ALONE => {
                let nodes = &self.trees.nodes[self.trees.trees[tree as usize].clone()];
                nodes[0].kind == FREE && nodes.iter().filter_map(Node::row).all(free)
            }
            _ => free(row),
        }
    }
    // ANCHOR_END: floats

    /// A body without joints came.
    pub fn add_body(&mut self) {
        self.joined.push(Held::default());
        self.tree_of.push(ALONE);
        self.trees.limit_ends.add_body();
        self.trees.loop_ends.add_body();
    }

    /// A body without joints is gone, and those after it have moved up.
    pub fn remove_body(&mut self, row: usize) {
        self.trees.remove_body(row);
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

fn side_of(bodies: &Bodies, row: u32) -> Side {
    let row = row as usize;
    Side::of(
        &bodies.place[row],
        bodies.attitude[row],
        &bodies.motion[row],
        &bodies.spin[row],
        &bodies.solid[row],
        bodies.before[row],
    )
}
