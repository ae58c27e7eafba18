//! What a step works on, and the two halves of it that all methods of impulses share.

use ch00_scenes::{Force, Scene};

use super::bodies::Bodies;
use super::contacts::Contacts;
use super::joints::{Joint, joints_of};
use super::real::{Quat, Real, Vec3, real, rotation, vector};

/// A body that turns about a point.
#[derive(Clone, Copy, Debug)]
pub struct Pivot {
    /// Row of the body.
    pub body: usize,
    /// The point in the world, m.
    pub point: Vec3,
    /// From the point to the body's centre, in the body's axes, m.
    pub arm: Vec3,
}

/// What a method is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Knobs {
    /// Parts of a step.
    pub substeps: u32,
    /// Sweeps over all rows, of each part.
    pub sweeps: u32,
}

/// A step of a method: `dt` in s.
pub type Step = fn(&mut World, Real, Knobs);

/// Everything that a step changes.
#[derive(Clone, Debug)]
pub struct World {
    /// m/s².
    pub gravity: Vec3,
    /// Constant forces: rows of bodies, and what the force gives them, m/s².
    pub pushes: Vec<(usize, Vec3)>,
    /// Rate at which velocities decay, 1/s.
    pub drag: Real,
    /// Impacts slower than this don't bounce, m/s.
    pub restitution_threshold: Real,
    /// The bodies.
    pub bodies: Bodies,
    /// What joins them.
    pub joints: Vec<Joint>,
    /// Bodies on fixed points.
    pub pivots: Vec<Pivot>,
    /// Where they touch.
    pub contacts: Contacts,
}

/// Impacts slower than this don't bounce where the scene doesn't say, m/s.
const SLOW: f64 = 0.05;

impl World {
    /// A scene at its start.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let bodies = Bodies::of(scene);
        let pivot = |force: &Force| match *force {
            Force::FixedPoint { body, arm } => Some(Pivot {
                body,
                point: bodies.position[body] - bodies.attitude[body] * vector(arm),
                arm: vector(arm),
            }),
            Force::Magnets { .. } | Force::Constant { .. } => None,
        };
        let pivots: Vec<_> = scene.forces.iter().filter_map(pivot).collect();
        let push = |force: &Force| match *force {
            Force::Constant { body, force } => {
                Some((body, vector(force) * bodies.inverse_mass[body]))
            }
            Force::Magnets { .. } | Force::FixedPoint { .. } => None,
        };
        Self {
            gravity: vector(scene.gravity),
            pushes: scene.forces.iter().filter_map(push).collect(),
            drag: real(scene.drag),
            restitution_threshold: real(scene.restitution_threshold.unwrap_or(SLOW)),
            joints: joints_of(scene, &bodies, &pivots),
            contacts: Contacts::of(scene, &pivots),
            pivots,
            bodies,
        }
    }

    // ANCHOR: accelerate
    /// Gravity, constant forces and drag for h seconds, and what a turning body does to its own spin.
    pub fn accelerate(&mut self, h: Real, gyro: fn(Quat, Vec3, Vec3, Real) -> Vec3) {
        let kept = 1.0 / (1.0 + self.drag * h);
        let bodies = &mut self.bodies;
        for &(row, acceleration) in &self.pushes {
            bodies.velocity[row] += acceleration * h;
        }
        for row in 0..bodies.count() {
            if bodies.moves(row) {
                let (q, inertia) = (bodies.attitude[row], bodies.inertia[row]);
                let omega = bodies.angular_velocity[row];
                bodies.velocity[row] = (bodies.velocity[row] + self.gravity * h) * kept;
                bodies.angular_velocity[row] = gyro(q, inertia, omega, h) * kept;
            }
        }
    }
    // ANCHOR_END: accelerate

    // ANCHOR: advance
    /// Moves everything for h seconds with the velocities that it has now.
    pub fn advance(&mut self, h: Real) {
        let bodies = &mut self.bodies;
        for row in 0..bodies.count() {
            if bodies.moves(row) {
                bodies.position[row] += bodies.velocity[row] * h;
                let turn = bodies.angular_velocity[row] * h;
                bodies.attitude[row] = rotation::turned(bodies.attitude[row], turn);
            }
        }
    }
    // ANCHOR_END: advance
}
