//! The CPU twin: the own-row step in plain code on one thread, by the names of the kernels. It is what
//! runs where there is no graphics device, and what the kernels are compared with.

pub mod broad_phase;
mod engine;
mod explain;
pub mod forces;
pub mod joints;
pub mod pairs;

use ch00_maths::f32::{rotation, spin};
use ch00_scenes::{Body, Scene, State};
use glam::Vec3;

use crate::bodies::Bodies;
use crate::own_row::body::{Gathered, exchange, kick, kick_momentum, push_of, turned, turned_with};
use crate::own_row::contact::{Before, Side, bounces, press_again, restore_pair, solve_pair};
use crate::rows::{Held, Push, Step};
use crate::rules::Rules;
use broad_phase::BroadPhase;
use forces::{Forces, Pivot};
use joints::Joints;
use pairs::Pairs;

pub use engine::{ENGINE, LanesEngine, METHODS, unsupported};

/// All state of a run, and what a step does with it.
#[derive(Clone, Debug)]
pub struct Lanes {
    /// The bodies' rows.
    pub bodies: Bodies,
    /// The pairs of the last step.
    pub pairs: Pairs,
    /// Those of the step before, whose memory the next one takes.
    last_pairs: Pairs,
    /// Which bodies may touch.
    pub broad: BroadPhase,
    /// What pulls beyond gravity.
    pub forces: Forces,
    /// Joints and angle limits.
    pub joints: Joints,
    /// The constants of the run.
    pub rules: Rules,
    /// By body: what its pairs did to it in this substep.
    gathered: Vec<Gathered>,
}

impl Lanes {
    /// The start of a scene.
    ///
    /// # Errors
    /// What it doesn't model, and the index of the body.
    pub fn of(scene: &Scene, rules: Rules) -> Result<Self, (String, usize)> {
        let mut bodies = Bodies::of(scene);
        let forces = Forces::of(scene, &mut bodies)?;
        let mut broad = BroadPhase::default();
        broad.ignored = ignored(scene);
        broad.aside = forces
            .pivots
            .iter()
            .map(|pivot| pivot.body as u32)
            .collect();
        Ok(Self {
            gathered: vec![Gathered::default(); bodies.rows()],
            joints: Joints::of(scene),
            bodies,
            pairs: Pairs::default(),
            last_pairs: Pairs::default(),
            broad,
            forces,
            rules,
        })
    }

    /// Takes over where bodies are and how they move; what they pressed is forgotten.
    pub fn write_state(&mut self, state: &State) {
        self.bodies.write(state);
        self.pairs = Pairs::default();
        self.joints.forget();
        self.broad.forget();
    }

    /// Adds a body at the end.
    pub fn add_body(&mut self, body: &Body) {
        self.bodies.push(body);
        self.gathered.push(Gathered::default());
        self.joints.add_body();
        self.broad.forget();
    }

    /// Removes a body that no joint and no force holds; those after it move up.
    pub fn remove_body(&mut self, row: usize) {
        self.bodies.remove(row);
        self.gathered.pop();
        self.pairs.remove_body(row);
        self.broad.remove_body(row);
        self.forces.remove_body(row);
        self.joints.remove_body(row);
    }

    // ANCHOR: step
    /// A step of `dt` seconds. `done` hears of each part when it is done.
    pub fn step(&mut self, dt: f32, mut done: impl FnMut(&'static str)) {
        let step = self.rules.step(dt, self.bodies.rows());
        broad_phase::find_pairs(&self.bodies, dt, &mut self.broad);
        done("broad phase");
        self.meet(dt);
        done("narrow phase");
        self.start(&step);
        for substep in 1..=self.rules.substeps {
            self.solve_pairs(&step);
            self.joints.solve_rows(&self.bodies, step.h);
            self.gather();
            self.exchange();
            self.joints.solve_trees(&mut self.bodies, step.h);
            self.advance(&step);
            if substep < self.rules.substeps {
                self.kick(&step);
            }
        }
        done("substeps");
        self.bounce(&step);
        done("restitution");
    }
    // ANCHOR_END: step

    /// Narrow phase over what the broad phase found.
    fn meet(&mut self, dt: f32) {
        std::mem::swap(&mut self.pairs, &mut self.last_pairs);
        let found = &self.broad.pairs;
        pairs::meet(found, &self.bodies, dt, &self.last_pairs, &mut self.pairs);
    }

    // ANCHOR: start
    /// What held the bodies in the last step, where their points are now; then the first kick.
    fn start(&mut self, step: &Step) {
        for pair in 0..self.pairs.bodies.len() {
            let [a, b] = self.sides(pair);
            let (m, impulse) = (&self.pairs.manifold[pair], &self.pairs.impulse[pair]);
            self.pairs.press[pair] = press_again(m, impulse, &a, &b, step.h);
        }
        self.gather();
        for row in 0..self.bodies.rows() {
            self.bodies.held[row] = self.gathered[row].stays;
            self.bodies.motion[row].shares = self.gathered[row].counts.max(1.0);
        }
        self.kick(step);
    }
    // ANCHOR_END: start

    /// Every body takes up what pulls and holds it.
    fn kick(&mut self, step: &Step) {
        self.forces.gather(&self.bodies);
        for row in 0..self.bodies.rows() {
            let pull = self.forces.pulls.get(row).copied().unwrap_or_default();
            let held = self.joints.with(row, self.bodies.held[row]);
            self.bodies.before[row] = Before {
                velocity: self.bodies.motion[row].velocity,
                angular_velocity: self.bodies.spin[row].angular_velocity,
            };
            kick(
                &mut self.bodies.motion[row],
                &mut self.bodies.spin[row],
                self.bodies.attitude[row],
                &self.bodies.solid[row],
                &held,
                &pull,
                step,
            );
            kick_momentum(&mut self.bodies.momentum[row], &held, &pull, step);
        }
    }

    /// Every pair writes its own impulses.
    fn solve_pairs(&mut self, step: &Step) {
        for pair in 0..self.pairs.bodies.len() {
            let sides = self.sides(pair);
            self.pairs.press[pair] = solve_pair(
                &self.pairs.manifold[pair],
                &self.pairs.material[pair],
                &mut self.pairs.impulse[pair],
                &mut self.pairs.approach[pair],
                sides,
                step,
            );
        }
    }

    /// The two bodies of a pair.
    fn sides(&self, pair: usize) -> [Side; 2] {
        let bodies = &self.bodies;
        let (a, b) = self.pairs.bodies[pair];
        [a, b].map(|row| {
            Side::of(
                &bodies.place[row],
                bodies.attitude[row],
                &bodies.motion[row],
                &bodies.spin[row],
                &bodies.solid[row],
                bodies.before[row],
            )
        })
    }

    // ANCHOR: gather
    /// Every body sums what its pairs did to it, in the order of their IDs; then its limits and loops.
    fn gather(&mut self) {
        self.gather_pairs();
        for row in 0..self.bodies.rows() {
            self.joints.gather(row, &mut self.gathered[row]);
        }
    }

    /// What its pairs did to each body.
    fn gather_pairs(&mut self) {
        for row in 0..self.bodies.rows() {
            let mut sum = Gathered::default();
            for &pair in self.pairs.of(row) {
                let is_b = self.pairs.bodies[pair as usize].1 == row;
                sum.add(&self.pairs.press[pair as usize], is_b);
            }
            self.gathered[row] = sum;
        }
    }
    // ANCHOR_END: gather

    /// Every body puts what holds it now in the place of what it started the substep with.
    fn exchange(&mut self) {
        let bodies = &mut self.bodies;
        for row in 0..bodies.rows() {
            let new = &self.gathered[row];
            let (q, solid) = (bodies.attitude[row], &bodies.solid[row]);
            let old = bodies.held[row];
            exchange(
                &mut bodies.motion[row],
                &mut bodies.spin[row],
                q,
                solid,
                &old,
                &new.held,
            );
            bodies.momentum[row] += new.held.angular - old.angular;
            bodies.held[row] = new.stays;
            bodies.push[row] = push_of(&new.pushed, &bodies.spin[row], q, solid);
        }
    }

    // ANCHOR: advance
    /// Every body moves. A body that nothing touches falls as it should: h v̄, not h v, is how far it
    /// comes, where v̄ is the mean of its speeds before and after gravity's kick.
    fn advance(&mut self, step: &Step) {
        let bodies = &mut self.bodies;
        for row in 0..bodies.rows() {
            if bodies.spin[row].inverse_mass == 0.0 {
                continue;
            }
            let Push {
                velocity,
                angular_velocity,
                ..
            } = bodies.push[row];
            let motion = &mut bodies.motion[row];
            let alone = self.joints.floats(row, &self.gathered);
            let early = if alone {
                0.5 * step.h * step.gravity
            } else {
                Vec3::ZERO
            };
            bodies.place[row].position += step.h * (motion.velocity + velocity - early);
            motion.shares = self.gathered[row].counts.max(1.0);
            turn(bodies, row, angular_velocity, step.h);
        }
        for k in 0..self.forces.pivots.len() {
            let pivot = self.forces.pivots[k];
            self.turn_about(&pivot, step);
        }
    }
    // ANCHOR_END: advance

    // ANCHOR: turn_about
    /// A body on a fixed point: half of gravity's torque, a free turn, the other half.
    fn turn_about(&mut self, pivot: &Pivot, step: &Step) {
        let Pivot {
            body,
            point,
            arm,
            mass,
        } = *pivot;
        let bodies = &mut self.bodies;
        let weight = mass * step.gravity;
        let half = 0.5 * step.h;
        let inverse_inertia = bodies.solid[body].inverse_inertia;
        let push = bodies.push[body].angular_velocity;
        bodies.momentum[body] += half * (bodies.attitude[body] * arm).cross(weight);
        turn(bodies, body, push, step.h);
        let q = bodies.attitude[body];
        bodies.momentum[body] += half * (q * arm).cross(weight);
        let w = rotation::moment(q, inverse_inertia, bodies.momentum[body]);
        bodies.spin[body].angular_velocity = w;
        bodies.place[body].position = point + q * arm;
        bodies.motion[body].velocity = w.cross(q * arm);
    }
    // ANCHOR_END: turn_about

    // ANCHOR: bounce
    /// Restitution, once at the end of a step: a body's mass is now shared among the pairs that bounce.
    fn bounce(&mut self, step: &Step) {
        let mut any = false;
        for pair in 0..self.pairs.bodies.len() {
            let (approach, material) = (self.pairs.approach[pair], &self.pairs.material[pair]);
            let hits = bounces(approach, material, step);
            self.pairs.press[pair].counts = f32::from(u8::from(hits));
            any |= hits;
        }
        if !any {
            return;
        }
        self.gather_pairs();
        for row in 0..self.bodies.rows() {
            self.bodies.motion[row].shares = self.gathered[row].counts.max(1.0);
        }
        for pair in 0..self.pairs.bodies.len() {
            let sides = self.sides(pair);
            let (m, material) = (&self.pairs.manifold[pair], &self.pairs.material[pair]);
            let approach = self.pairs.approach[pair];
            self.pairs.press[pair] = restore_pair(m, material, approach, sides, step);
        }
        self.gather_pairs();
        for row in 0..self.bodies.rows() {
            let (q, solid) = (self.bodies.attitude[row], &self.bodies.solid[row]);
            let (motion, spin) = (&mut self.bodies.motion[row], &mut self.bodies.spin[row]);
            let held = &self.gathered[row].held;
            exchange(motion, spin, q, solid, &Held::default(), held);
            self.bodies.momentum[row] += held.angular;
        }
    }
    // ANCHOR_END: bounce
}

/// A body turns for a substep, and is pushed.
fn turn(bodies: &mut Bodies, row: usize, push: Vec3, h: f32) {
    let (q, inverse_inertia) = (bodies.attitude[row], bodies.solid[row].inverse_inertia);
    let (q, w) = if spin::is_round(inverse_inertia) {
        turned(
            q,
            bodies.spin[row].angular_velocity,
            push,
            inverse_inertia,
            h,
        )
    } else {
        turned_with(q, bodies.momentum[row], push, inverse_inertia, h)
    };
    bodies.attitude[row] = q;
    bodies.spin[row].angular_velocity = w;
}

/// The pairs of bodies that joints connect, the smaller row first, in order.
fn ignored(scene: &Scene) -> Vec<(usize, usize)> {
    let mut ignored: Vec<_> = scene
        .joints
        .iter()
        .map(|joint| {
            let (a, b) = joint.bodies();
            (a.min(b), a.max(b))
        })
        .collect();
    ignored.sort_unstable();
    ignored.dedup();
    ignored
}
