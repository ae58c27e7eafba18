//! A body that circles a place and spins on its own axis: the game object of the orrery,
//! with its two components.
//!
//! It has two nodes. The *carrier* travels round the orbit and carries what circles the
//! body; the body's own node, below it, spins. Were it one node, a planet would swing its
//! moons round with its day.

use std::f64::consts::TAU;

use glam::{Quat, Vec3};

use crate::{Component, GameObject, NodeId, SceneGraph, Transform};

// ANCHOR: clock
/// An angle that grows at a steady rate: phase + rate · time.
///
/// Time is added up in f64: in f32 a clock of 1/60 s ticks is seconds off after an hour. The
/// angle is reduced to one turn before it becomes an f32, for the same reason.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SteadyAngle {
    /// At time 0, rad.
    pub phase: f64,
    /// rad/s.
    pub rate: f64,
    /// s.
    time: f64,
}

impl SteadyAngle {
    /// Lets `dt` seconds pass.
    pub fn advance(&mut self, dt: f32) {
        self.time += f64::from(dt);
    }

    /// The angle now, 0 … 2π rad.
    #[must_use]
    pub fn now(&self) -> f32 {
        (self.phase + self.rate * self.time).rem_euclid(TAU) as f32
    }
}
// ANCHOR_END: clock

impl SteadyAngle {
    /// Starts at `phase` (rad) and grows by `rate` (rad/s).
    #[must_use]
    pub fn new(phase: f64, rate: f64) -> Self {
        Self {
            phase,
            rate,
            time: 0.0,
        }
    }

    /// Is at `angle` (rad) now and goes on from there.
    pub fn restart_at(&mut self, angle: f64) {
        *self = Self::new(angle, self.rate);
    }
}

// ANCHOR: motion
/// How a frame moves, seen from the world.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Velocity of its origin, m/s.
    pub linear: Vec3,
    /// Angular velocity, rad/s.
    pub angular: Vec3,
}

impl Motion {
    /// The motion of an arm that is hinged to this frame's origin, turns by `omega` (rad/s)
    /// against it, and reaches to `tip` (m): ω = ω₁ + ω₂, v = v₁ + ω × r. World axes.
    #[must_use]
    pub fn of_arm(self, omega: Vec3, tip: Vec3) -> Self {
        let angular = self.angular + omega;
        Self {
            linear: self.linear + angular.cross(tip),
            angular,
        }
    }
}
// ANCHOR_END: motion

// ANCHOR: circle
/// Moves its owner round a circle in a plane tilted about the parent's x axis. The owner's x
/// axis always points away from the centre, as an arm's does that swings round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// m.
    pub radius: f32,
    /// Turns the parent's axes into the plane's, whose normal is y.
    pub plane: Quat,
    /// From the plane's x axis, right-handed about its normal.
    pub angle: SteadyAngle,
}

impl Component for Circle {
    fn update(&mut self, local: &mut Transform, dt: f32) {
        self.angle.advance(dt);
        local.rotation = self.plane * Quat::from_rotation_y(self.angle.now());
        local.translation = local.rotation * (Vec3::X * self.radius);
    }
}
// ANCHOR_END: circle

impl Circle {
    /// Angular velocity in the parent's frame, rad/s.
    #[must_use]
    pub fn omega(&self) -> Vec3 {
        self.plane * Vec3::Y * self.angle.rate as f32
    }
}

// ANCHOR: spin
/// Turns its owner about its own y axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    /// About y, right-handed.
    pub angle: SteadyAngle,
}

impl Spin {
    /// Angular velocity in the carrier's frame, rad/s.
    #[must_use]
    pub fn omega(&self) -> Vec3 {
        Vec3::Y * self.angle.rate as f32
    }
}

impl Component for Spin {
    fn update(&mut self, local: &mut Transform, dt: f32) {
        self.angle.advance(dt);
        local.rotation = Quat::from_rotation_y(self.angle.now());
    }
}
// ANCHOR_END: spin

// ANCHOR: orbiter
/// A body on an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbiter {
    /// The frame that travels: hangs below what is circled; what circles this hangs below it.
    pub carrier: NodeId,
    /// The body's own frame, below the carrier.
    pub body: NodeId,
    /// How it travels.
    pub circle: Circle,
    /// How it spins.
    pub spin: Spin,
}

impl GameObject for Orbiter {
    fn node(&self) -> NodeId {
        self.body
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        self.circle.update(graph.local_mut(self.carrier), dt);
        self.spin.update(graph.local_mut(self.body), dt);
    }
}
// ANCHOR_END: orbiter

impl Orbiter {
    /// Places both nodes where the angles say now.
    pub fn place(&mut self, graph: &mut SceneGraph) {
        self.update(graph, 0.0);
    }
}
