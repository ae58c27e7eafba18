//! A step without contacts: gravity, limits, loops, trees, and on.

use ch00_scenes::{Scene, State};
use glam::{DVec3, Vec3};

use super::Trees;
use crate::bodies::Bodies;
use crate::own_row::body::Moving;
use crate::own_row::limits::Limits;
use crate::own_row::loops::solve_loop;
use crate::own_row::side::Side;
use crate::own_row::tree::Batches;
use crate::rows::{Held, Press, Push};
use crate::simd::{Eight, Real};

/// Bodies and what joins them, solved in the lanes that the engine has.
pub type World = WorldOf<Eight>;

/// Bodies and what joins them.
pub struct WorldOf<R> {
    pub bodies: Bodies,
    pub trees: Trees,
    pub batches: Batches<R>,
    /// What the joints of trees hold bodies with.
    pub joined: Vec<Held>,
    /// What limits and loops do.
    pub limits: Limits<R>,
    pub pressed: Vec<Press>,
    /// What limits and loops held bodies with in the last substep.
    rows_held: Vec<Held>,
    pub h: f32,
    substeps: u32,
    gravity: Vec3,
}

impl<R: Real> WorldOf<R> {
    /// A scene without contacts.
    pub fn of(scene: &Scene, substeps: u32) -> Self {
        let (trees, bodies) = (Trees::of(scene), Bodies::of(scene));
        Self {
            batches: Batches::of(&trees, &bodies),
            limits: Limits::of(&trees.limits),
            bodies,
            joined: vec![Held::default(); scene.bodies.len()],
            pressed: vec![Press::default(); trees.loops.len()],
            rows_held: vec![Held::default(); scene.bodies.len()],
            trees,
            h: scene.dt as f32 / substeps as f32,
            substeps,
            gravity: scene.gravity.as_vec3(),
        }
    }

    /// Takes over what nodes and limits say that held in the last substep.
    pub fn read_impulses(&mut self) {
        self.batches = Batches::of(&self.trees, &self.bodies);
        let turned = std::mem::take(&mut self.limits.turned);
        self.limits = Limits::of(&self.trees.limits);
        self.limits.turned = turned;
    }

    /// Solves the trees once.
    pub fn solve_trees(&mut self) {
        self.batches.solve(&self.bodies, &self.joined, self.h);
        self.batches.apply(&mut self.bodies, &mut self.joined);
        self.batches.write_back(&mut self.trees.nodes);
    }

    /// A step.
    pub fn step(&mut self) {
        for _ in 0..self.substeps {
            self.substep();
        }
    }

    pub fn substep(&mut self) {
        for row in 0..self.bodies.rows() {
            self.kick(row);
        }
        self.solve_rows();
        for row in 0..self.bodies.rows() {
            self.gather(row);
        }
        self.solve_trees();
        for row in 0..self.bodies.rows() {
            self.advance(row);
        }
    }

    /// Gives a body an impulse.
    fn give(&mut self, row: usize, held: Held) {
        let turning = self.bodies.turned_by(row, held.angular);
        self.bodies.motion[row].velocity += held.linear * self.bodies.spin[row].inverse_mass;
        self.bodies.spin[row].angular_velocity += turning;
        self.bodies.momentum[row] += held.angular;
    }

    /// Gravity, and what held it in the last substep.
    fn kick(&mut self, row: usize) {
        self.bodies.push[row] = Push::default();
        if self.bodies.spin[row].inverse_mass > 0.0 {
            self.bodies.motion[row].velocity += self.h * self.gravity;
        }
        self.give(row, self.joined[row]);
        self.give(row, self.rows_held[row]);
        let limits = self
            .trees
            .limit_ends
            .at(row)
            .filter(|&(limit, _)| self.limits.turned[limit].counts > 0.0);
        let shares = limits.count() + self.trees.loop_ends.at(row).count();
        self.bodies.motion[row].shares = if self.bodies.is_static(row) {
            1.0
        } else {
            (shares as f32).max(1.0)
        };
    }

    /// Solves limits and loops once.
    pub fn solve_rows(&mut self) {
        let bodies = &self.bodies;
        self.limits.solve(bodies, self.h);
        self.limits.write_back(&mut self.trees.limits);
        for (node, pressed) in self.trees.loops.iter_mut().zip(&mut self.pressed) {
            let sides = [node.parent_body, node.body].map(|row| Side::of(bodies, &[row]));
            *pressed = solve_loop(node, pressed, sides, self.h);
        }
    }

    fn gather(&mut self, row: usize) {
        let (mut held, mut push) = (Held::default(), Held::default());
        for (limit, is_b) in self.trees.limit_ends.at(row) {
            let sign = if is_b { 1.0 } else { -1.0 };
            held.angular += sign * self.limits.turned[limit].turning;
            push.angular += sign * self.limits.turned[limit].push;
        }
        for (joint, is_b) in self.trees.loop_ends.at(row) {
            let press = &self.pressed[joint];
            let sign = if is_b { 1.0 } else { -1.0 };
            held.linear += sign * press.linear;
            push.linear += sign * press.push;
            held.angular += if is_b {
                press.angular_b
            } else {
                press.angular_a
            };
            push.angular += if is_b { press.push_b } else { press.push_a };
        }
        let old = std::mem::replace(&mut self.rows_held[row], held);
        let change = Held {
            linear: held.linear - old.linear,
            angular: held.angular - old.angular,
            ..Held::default()
        };
        self.give(row, change);
        self.bodies.push[row].velocity = push.linear * self.bodies.spin[row].inverse_mass;
        self.bodies.push[row].angular_velocity = self.bodies.turned_by(row, push.angular);
    }

    fn advance(&mut self, row: usize) {
        if self.bodies.is_static(row) {
            return;
        }
        let bodies = &mut self.bodies;
        let push = bodies.push[row];
        bodies.place[row].position += self.h * (bodies.motion[row].velocity + push.velocity);
        let mut moving = Moving::<f32> {
            attitude: bodies.attitude[row].into(),
            angular_velocity: bodies.spin[row].angular_velocity.into(),
            momentum: bodies.momentum[row].into(),
            inverse_inertia: bodies.solid[row].inverse_inertia.into(),
            ..Moving::default()
        };
        moving.turn(push.angular_velocity.into(), self.h);
        bodies.attitude[row] = moving.attitude.lane(0);
        bodies.spin[row].angular_velocity = moving.angular_velocity.lane(0);
    }

    /// Where all are.
    pub fn state(&self) -> State {
        let mut state = State::default();
        self.bodies.read(&mut state);
        state
    }

    /// Momentum, kg m/s, and angular momentum about the origin, kg m²/s.
    pub fn momentum(&self) -> (DVec3, DVec3) {
        let state = self.state();
        let mut sum = (DVec3::ZERO, DVec3::ZERO);
        for row in 0..self.bodies.rows() {
            if self.bodies.is_static(row) {
                continue;
            }
            let mass = 1.0 / f64::from(self.bodies.spin[row].inverse_mass);
            let q = state.orientation[row];
            let moments = self.bodies.solid[row].inverse_inertia.as_dvec3().recip();
            let p = mass * state.linear_velocity[row];
            sum.0 += p;
            sum.1 += state.position[row].cross(p);
            sum.1 += q * (moments * (q.conjugate() * state.angular_velocity[row]));
        }
        sum
    }
}
