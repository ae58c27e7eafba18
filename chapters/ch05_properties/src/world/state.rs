//! Where everything is: reading it, and putting it elsewhere.

use ch00_maths::f32::impulse::Velocity;
use ch00_scenes::State;
use glam::Quat;

use super::{Method, World};
use crate::columns::AnyTable;
use crate::plan::Part;
use crate::systems::{Pull, advance, forces, or_zero, velocities};

impl World {
    /// Where every body is, in order of row.
    pub fn read_state(&self, state: &mut State) {
        state.clear();
        for row in 0..self.data.bodies.rows() {
            let velocity = self.velocity(row);
            let q: Quat = or_zero(&self.data.bodies.orientation, row);
            state.push(
                self.data.bodies.position[row].as_dvec3(),
                q.as_dquat(),
                velocity.v.as_dvec3(),
                velocity.omega.as_dvec3(),
            );
        }
    }

    /// The row of the fixed point that a body hangs on, if it does.
    fn fixed_point_of(&self, row: usize) -> Option<usize> {
        let held = &self.data.fixed_points.body;
        held.iter().position(|&body| body as usize == row)
    }

    // ANCHOR: velocity
    /// The velocities of a body: now (`corrected`) or over the last step (`printed`).
    #[must_use]
    pub fn velocity(&self, row: usize) -> Velocity {
        let (bodies, dt_last) = (&self.data.bodies, self.steps.dt_last);
        if bodies.inverse_mass[row] == 0.0 {
            return Velocity::default();
        }
        if self.surroundings.method == Method::Printed {
            return velocities::moved(bodies, row, dt_last);
        }
        let pull = Pull::of(self.gravity(), &bodies.acceleration);
        let mut now = velocities::now(bodies, row, pull, dt_last);
        let held = &self.data.fixed_points;
        if let Some(k) = self.fixed_point_of(row) {
            now.v = velocities::of_held(bodies.orientation[row], held.arm[k], now.omega);
        }
        velocities::with_held(bodies, row, now)
    }
    // ANCHOR_END: velocity

    /// Gives a body these velocities by writing p* and q*.
    pub(crate) fn set_velocity(&mut self, row: usize, velocity: Velocity) {
        let dt = self.steps.dt_last;
        if self.surroundings.method == Method::Printed {
            velocities::write_printed(&mut self.data.bodies, row, velocity, dt);
        } else {
            let bodies = &self.data.bodies;
            let pull =
                Pull::of(self.gravity(), &bodies.acceleration).on(row, bodies.inverse_mass[row]);
            velocities::write(&mut self.data.bodies, row, velocity, pull, dt);
        }
        let held = &self.data.fixed_points;
        if let Some(k) = self.fixed_point_of(row) {
            let bodies = &mut self.data.bodies;
            if bodies.inverse_mass[row] != 0.0 {
                bodies.last_position[row] =
                    held.point[k] + bodies.last_orientation[row] * held.arm[k];
            }
        }
    }

    /// Sums what acts on each body where it is now, if anything but gravity does.
    pub(crate) fn gather(&mut self) {
        if !self.plan.has(Part::Forces) {
            return;
        }
        let gravity = self.surroundings.gravity;
        let data = &mut self.data;
        let bodies = &mut data.bodies;
        let mut sums = forces::Sums {
            acceleration: &mut bodies.acceleration,
            torque: &mut bodies.torque,
        };
        forces::gather(
            forces::Acting {
                poles: &data.poles,
                fixed_points: &data.fixed_points,
                pushes: &data.pushes,
            },
            &bodies.position,
            &bodies.orientation,
            &bodies.inverse_mass,
            gravity,
            &mut sums,
        );
        for k in 0..self.data.springs.rows() {
            self.drag(k);
        }
    }

    /// Adds what the mouse does to the body that it drags.
    fn drag(&mut self, k: usize) {
        let row = self.data.springs.body[k] as usize;
        if self.data.bodies.inverse_mass[row] == 0.0 {
            return;
        }
        let velocity = self.velocity(row);
        let bodies = &mut self.data.bodies;
        let mut sums = forces::Sums {
            acceleration: &mut bodies.acceleration,
            torque: &mut bodies.torque,
        };
        forces::drag(
            &self.data.springs,
            k,
            &bodies.position,
            &bodies.orientation,
            &bodies.inverse_mass,
            velocity,
            &mut sums,
        );
    }

    // ANCHOR: write_state
    /// Puts every body where `state` says; `dt` is the step that comes next. What touched is forgotten.
    pub fn write_state(&mut self, state: &State, dt: f32) {
        self.steps.dt_last = dt;
        self.forget_contacts();
        let bodies = &mut self.data.bodies;
        bodies.held_velocity.fill(glam::Vec3::ZERO);
        bodies.held_spin.fill(glam::Vec3::ZERO);
        for row in 0..bodies.rows() {
            bodies.position[row] = state.position[row].as_vec3();
            if let Some(q) = bodies.orientation.get_mut(row) {
                *q = state.orientation[row].as_quat();
            }
        }
        self.gather();
        for row in 0..self.data.bodies.rows() {
            let velocity = Velocity {
                v: state.linear_velocity[row].as_vec3(),
                omega: state.angular_velocity[row].as_vec3(),
            };
            self.set_velocity(row, velocity);
        }
        if self.surroundings.method == Method::Corrected {
            self.begin_joints_anew();
        }
        self.begin(dt);
    }
    // ANCHOR_END: write_state

    /// Forgets what touched and where obstacles were.
    pub(crate) fn forget_contacts(&mut self) {
        self.data.contacts.clear();
        self.carried = crate::systems::narrow_phase::Carried::default();
        self.broad.obstacles_for = None;
        self.involved = (0..self.data.bodies.rows() as u32).collect();
    }

    /// Puts the bodies on fixed points where their turns led them.
    pub(crate) fn place_held(&mut self) {
        let (held, bodies) = (&self.data.fixed_points, &mut self.data.bodies);
        advance::fixed_points(
            &held.body,
            &held.point,
            &held.arm,
            &mut bodies.position,
            &mut bodies.last_position,
            &bodies.orientation,
            &bodies.last_orientation,
        );
    }
}
