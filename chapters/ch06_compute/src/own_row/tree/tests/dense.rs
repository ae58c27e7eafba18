//! All joints of all trees as one dense system in f64, from the definitions: shares nothing with the
//! walks but the nodes.

use glam::{DMat3, DQuat, DVec3, Vec3};

use super::World;
use crate::rows::{EMPTY, FREE, HINGE, Node, PIN, TWO_RODS};

/// Velocity and angular velocity of each body.
type Rates = Vec<(DVec3, DVec3)>;

/// One row of J: a speed of two bodies, and what it should be.
struct Row {
    /// Body, and what of its velocity and of its spin counts.
    parts: Vec<(usize, DVec3, DVec3)>,
    wanted: f64,
}

/// The system before it is solved.
pub struct Dense {
    rows: Vec<Row>,
    /// 1/m and I⁻¹, with the stiffness of pulls in I.
    answers: Vec<(f64, DMat3)>,
    moved: Rates,
    pushed: Rates,
}

impl Dense {
    /// Of a world before its trees are solved.
    pub fn of(world: &World) -> Self {
        let bodies = &world.bodies;
        let count = bodies.rows();
        let mut dense = Self {
            rows: Vec::new(),
            answers: (0..count).map(|row| answer(world, row)).collect(),
            moved: Rates::new(),
            pushed: Rates::new(),
        };
        for row in 0..count {
            let (motion, spin, push) = (&bodies.motion[row], &bodies.spin[row], &bodies.push[row]);
            // What was given already is taken back.
            let joined = world.joined[row];
            let (inverse, inertia) = dense.answers[row];
            let velocity = motion.velocity.as_dvec3() - inverse * joined.linear.as_dvec3();
            let turned = inertia * joined.angular.as_dvec3();
            dense
                .moved
                .push((velocity, spin.angular_velocity.as_dvec3() - turned));
            dense
                .pushed
                .push((push.velocity.as_dvec3(), push.angular_velocity.as_dvec3()));
        }
        let is_joint = |node: &&Node| node.kind != EMPTY && node.kind != FREE;
        for node in world.trees.nodes.iter().filter(is_joint) {
            add_rows(world, node, &mut dense.rows);
            dense.stiffen(world, node);
        }
        dense
    }

    /// Adds what a pull makes of the inertias of both bodies.
    fn stiffen(&mut self, world: &World, node: &Node) {
        let point = joint_point(world, node);
        let pull = node.impulse.as_dvec3() * (0.5 * f64::from(world.h));
        for (row, pull) in [(node.body, pull), (node.parent_body, -pull)] {
            let row = row as usize;
            let arm = point - position(world, row);
            let along = arm.normalize();
            let outer = DMat3::from_cols(along * along.x, along * along.y, along * along.z);
            let stiffness = arm.dot(pull).max(0.0) * (DMat3::IDENTITY - outer);
            if self.answers[row].0 > 0.0 {
                self.answers[row].1 = (self.answers[row].1.inverse() + stiffness).inverse();
            }
        }
    }

    /// Velocities and pushes after an exact solve.
    pub fn after(&self) -> [Rates; 2] {
        [
            self.solved(&self.moved, true),
            self.solved(&self.pushed, false),
        ]
    }

    /// The largest speed by which a joint is off what it wants, in a world after its trees are solved.
    pub fn lacks(&self, world: &World) -> f64 {
        let bodies = &world.bodies;
        let rate = |row: usize| {
            let spin = bodies.spin[row].angular_velocity;
            (bodies.motion[row].velocity.as_dvec3(), spin.as_dvec3())
        };
        let rates: Rates = (0..bodies.rows()).map(rate).collect();
        let off = self
            .rows
            .iter()
            .map(|row| (row.wanted - speed(row, &rates)).abs());
        off.fold(0.0, f64::max)
    }

    fn solved(&self, rates: &Rates, closes: bool) -> Rates {
        let couplings = |row: &Row| {
            self.rows
                .iter()
                .map(|other| self.coupling(row, other))
                .collect()
        };
        let matrix: Vec<Vec<f64>> = self.rows.iter().map(couplings).collect();
        let lacks = self.rows.iter().map(|row| {
            let wanted = if closes { row.wanted } else { 0.0 };
            wanted - speed(row, rates)
        });
        let lambda = eliminate(matrix, lacks.collect());
        let mut rates = rates.clone();
        for (row, lambda) in self.rows.iter().zip(lambda) {
            for &(body, linear, angular) in &row.parts {
                let (inverse, inertia) = self.answers[body];
                rates[body].0 += inverse * linear * lambda;
                rates[body].1 += inertia * (angular * lambda);
            }
        }
        rates
    }

    /// An entry of J M⁻¹ Jᵀ.
    fn coupling(&self, row: &Row, other: &Row) -> f64 {
        let mut sum = 0.0;
        for &(body, linear, angular) in &row.parts {
            let same = other.parts.iter().filter(|part| part.0 == body);
            for &(_, other_linear, other_angular) in same {
                let (inverse, inertia) = self.answers[body];
                sum += inverse * linear.dot(other_linear) + angular.dot(inertia * other_angular);
            }
        }
        sum
    }
}

/// 1/m and I⁻¹ in world axes.
fn answer(world: &World, row: usize) -> (f64, DMat3) {
    let axes = DMat3::from_quat(attitude(world, row));
    let moments = world.bodies.solid[row].inverse_inertia.as_dvec3();
    let inertia = axes * DMat3::from_diagonal(moments) * axes.transpose();
    (f64::from(world.bodies.spin[row].inverse_mass), inertia)
}

fn speed(row: &Row, rates: &Rates) -> f64 {
    let of = |&(body, linear, angular): &(usize, DVec3, DVec3)| {
        linear.dot(rates[body].0) + angular.dot(rates[body].1)
    };
    row.parts.iter().map(of).sum()
}

fn attitude(world: &World, row: usize) -> DQuat {
    world.bodies.attitude[row].as_dquat().normalize()
}

fn position(world: &World, row: usize) -> DVec3 {
    world.bodies.place[row].position.as_dvec3()
}

fn world_point(world: &World, row: usize, anchor: Vec3) -> DVec3 {
    position(world, row) + attitude(world, row) * anchor.as_dvec3()
}

/// Where a joint acts: midway between its points, or at a rod's end in the body.
fn joint_point(world: &World, node: &Node) -> DVec3 {
    let end = world_point(world, node.body as usize, node.anchor);
    if node.kind == PIN || node.kind == HINGE {
        return 0.5 * (end + world_point(world, node.parent_body as usize, node.parent_anchor));
    }
    end
}

fn add_rows(world: &World, node: &Node, rows: &mut Vec<Row>) {
    if node.kind == PIN || node.kind == HINGE {
        add_pin(world, node, rows);
    } else {
        add_rod(
            world,
            node,
            node.parent_body,
            node.parent_anchor,
            node.length,
            rows,
        );
    }
    if node.kind == HINGE {
        add_hinge(world, node, rows);
    }
    if node.kind == TWO_RODS {
        add_rod(
            world,
            node,
            node.second_parent,
            node.parent_axis,
            node.second_length,
            rows,
        );
    }
}

fn add_pin(world: &World, node: &Node, rows: &mut Vec<Row>) {
    let (i, p) = (node.body as usize, node.parent_body as usize);
    let gap = world_point(world, i, node.anchor) - world_point(world, p, node.parent_anchor);
    let closing = closing(gap / f64::from(world.h), 0.2, 10.0);
    let point = joint_point(world, node);
    for unit in DVec3::AXES {
        let parts = vec![
            (i, unit, (point - position(world, i)).cross(unit)),
            (p, -unit, -(point - position(world, p)).cross(unit)),
        ];
        rows.push(Row {
            parts,
            wanted: -closing.dot(unit),
        });
    }
}

fn add_hinge(world: &World, node: &Node, rows: &mut Vec<Row>) {
    let (i, p) = (node.body as usize, node.parent_body as usize);
    let axis = attitude(world, i) * node.axis.as_dvec3();
    let parent_axis = attitude(world, p) * node.parent_axis.as_dvec3();
    let aligning = closing(parent_axis.cross(axis) / f64::from(world.h), 1.0, 20.0);
    for unit in <[DVec3; 2]>::from(axis.normalize().any_orthonormal_pair()) {
        let parts = vec![(i, DVec3::ZERO, unit), (p, DVec3::ZERO, -unit)];
        rows.push(Row {
            parts,
            wanted: -aligning.dot(unit),
        });
    }
}

fn add_rod(world: &World, node: &Node, p: u32, hook: Vec3, length: f32, rows: &mut Vec<Row>) {
    let (i, p) = (node.body as usize, p as usize);
    let (start, end) = (
        world_point(world, p, hook),
        world_point(world, i, node.anchor),
    );
    let along = (end - start).normalize();
    let gap = along * ((end - start).length() - f64::from(length));
    let closing = closing(gap / f64::from(world.h), 0.2, 10.0);
    let parts = vec![
        (i, along, (end - position(world, i)).cross(along)),
        (p, -along, -(start - position(world, p)).cross(along)),
    ];
    rows.push(Row {
        parts,
        wanted: -closing.dot(along),
    });
}

/// A fifth of the speed that closes all, and all of it up to `gentle`.
fn closing(all: DVec3, gentle: f64, fastest: f64) -> DVec3 {
    at_most(0.2 * all + at_most(all, gentle), fastest)
}

fn at_most(v: DVec3, most: f64) -> DVec3 {
    v * (most / v.length().max(most))
}

/// Solves by Gaussian elimination with pivots.
fn eliminate(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let n = right.len();
    for k in 0..n {
        let size = |row: &usize| matrix[*row][k].abs();
        let pivot = (k..n)
            .max_by(|a, b| size(a).total_cmp(&size(b)))
            .expect("a row");
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let above = matrix[k].clone();
        for row in k + 1..n {
            let factor = matrix[row][k] / above[k];
            for (entry, above) in matrix[row].iter_mut().zip(&above).skip(k) {
                *entry -= factor * above;
            }
            right[row] -= factor * right[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n)
            .map(|column| matrix[k][column] * right[column])
            .sum();
        right[k] = (right[k] - known) / matrix[k][k];
    }
    right
}
