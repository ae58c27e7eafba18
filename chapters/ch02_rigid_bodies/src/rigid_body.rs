//! The report's `RigidBody`: a game object that has a position and an orientation now and
//! one step ago, and nothing else that moves. Report 8.1 to 8.3.
//!
//! Every velocity that anyone asks for is read from those differences, and every velocity
//! that anyone sets is written into p* and q*.

use ch00_maths::f32::impulse::{Mass, Velocity};
use ch00_maths::f32::shape::Shape;
use ch00_maths::f32::{drag, rotation, spin, verlet};
use ch01_hierarchy::{GameObject, NodeId, SceneGraph, Transform};
use glam::{Quat, Vec3};

use crate::{Callback, Feel, FixedPoint, Method, Spring};

mod properties;
mod resolving;

// ANCHOR: material
/// What a body's surface is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// e: 0 stays, 1 bounces for ever.
    pub restitution: f32,
    /// μ_k, while it slides.
    pub friction: f32,
    /// μ_s, before it slides.
    pub static_friction: f32,
}
// ANCHOR_END: material

// ANCHOR: rigid_body
/// A rigid body.
pub struct RigidBody {
    node: NodeId,
    method: Method,
    /// Its solid: the report's collider.
    collider: Shape,
    material: Material,
    /// kg; infinite for a static body.
    mass: f32,
    inverse_mass: f32,
    /// Principal moments I, kg m², and their inverses.
    inertia: Vec3,
    inverse_inertia: Vec3,
    /// p and p*, m.
    p: Vec3,
    p_last: Vec3,
    /// q and q*.
    q: Quat,
    q_last: Quat,
    /// How long ago p* and q* were, s.
    dt_last: f32,
    /// ΣF/m and gravity, m/s², and ΣT, N m, where the bodies are now.
    acceleration: Vec3,
    torque: Vec3,
    gravity: Vec3,
    forces: Vec<Callback>,
    torques: Vec<Callback>,
    /// F of the report, 1/s.
    drag: f32,
    fixed_point: Option<FixedPoint>,
    /// The mouse, while it drags the body.
    spring: Option<Spring>,
    // ANCHOR_END: rigid_body
    /// While collisions are resolved: what it moves like, how it answers to impulses, and how far it
    /// has been shifted, m, and turned, rad.
    moving: Velocity,
    answers: Mass,
    shift: Vec3,
    turn: Vec3,
    /// What its forces change its velocities by in half a step.
    half_kick: Velocity,
    /// What supports, friction and joints changed its velocities by in the last resolution.
    held_by: Velocity,
    /// Turns too fast to read (erratum 10), so far.
    unread_turns: usize,
}

impl RigidBody {
    /// A body at rest at the origin. A mass of 0 makes it static.
    #[must_use]
    pub fn new(
        node: NodeId,
        method: Method,
        collider: Shape,
        mass: f32,
        material: Material,
    ) -> Self {
        let is_static = mass == 0.0;
        let inertia = collider.inertia(mass);
        Self {
            node,
            method,
            collider,
            material,
            mass: if is_static { f32::INFINITY } else { mass },
            inverse_mass: if is_static { 0.0 } else { 1.0 / mass },
            inertia,
            inverse_inertia: if is_static {
                Vec3::ZERO
            } else {
                inertia.recip()
            },
            p: Vec3::ZERO,
            p_last: Vec3::ZERO,
            q: Quat::IDENTITY,
            q_last: Quat::IDENTITY,
            dt_last: 1.0,
            acceleration: Vec3::ZERO,
            torque: Vec3::ZERO,
            gravity: Vec3::ZERO,
            forces: Vec::new(),
            torques: Vec::new(),
            drag: 0.0,
            fixed_point: None,
            spring: None,
            moving: Velocity::default(),
            answers: Mass::new(0.0, Vec3::ZERO, Quat::IDENTITY),
            shift: Vec3::ZERO,
            turn: Vec3::ZERO,
            half_kick: Velocity::default(),
            held_by: Velocity::default(),
            unread_turns: 0,
        }
    }

    /// Sets the constant acceleration, m/s², and the rate of drag, 1/s, that it moves under.
    pub fn set_surroundings(&mut self, gravity: Vec3, drag: f32) {
        self.gravity = gravity;
        self.drag = drag;
    }

    // ANCHOR: hold
    /// Holds it by a point; its moments become those about the point.
    ///
    /// Says whether the arm allows that: it must lie along one of the body's axes.
    pub fn hold(&mut self, fixed_point: FixedPoint) -> bool {
        let Some(moments) = fixed_point.moments(self.inertia, self.mass) else {
            return false;
        };
        self.inertia = moments;
        self.inverse_inertia = moments.recip();
        self.fixed_point = Some(fixed_point);
        let (arm, weight) = (fixed_point.arm, self.mass * self.gravity);
        self.add_torque(Box::new(move |feel| (feel.q * arm).cross(weight)));
        true
    }
    // ANCHOR_END: hold

    /// Adds a force, N.
    pub fn add_force(&mut self, force: Callback) {
        self.forces.push(force);
    }

    /// Adds a torque, N m.
    pub fn add_torque(&mut self, torque: Callback) {
        self.torques.push(torque);
    }

    // ANCHOR: place
    /// Puts it at p, q with these velocities; `dt` is the step that comes next.
    pub fn place(&mut self, p: Vec3, q: Quat, velocity: Velocity, dt: f32) {
        self.p = p;
        self.q = q;
        self.dt_last = dt;
        self.held_by = Velocity::default();
        self.sum_callbacks();
        self.set_velocity(velocity);
    }
    // ANCHOR_END: place

    /// Ties it to a spring from now on, or lets go.
    pub fn set_spring(&mut self, spring: Option<Spring>) {
        self.spring = spring;
    }

    // ANCHOR: gather
    /// Asks every callback what it does to the body here.
    fn sum_callbacks(&mut self) {
        if self.is_static() {
            return;
        }
        let feel = Feel {
            p: self.p,
            q: self.q,
            mass: self.mass,
        };
        let sum = |callbacks: &[Callback]| callbacks.iter().map(|ask| ask(&feel)).sum::<Vec3>();
        self.acceleration = self.gravity + sum(&self.forces) * self.inverse_mass;
        self.torque = sum(&self.torques);
        if let Some(spring) = self.spring {
            let (force, torque) = spring.pull_on(&feel, self.velocity());
            self.acceleration += force * self.inverse_mass;
            self.torque += torque;
        }
    }
    // ANCHOR_END: gather

    // ANCHOR: update
    /// Advances it by `dt`, as its method says.
    fn advance(&mut self, dt: f32) {
        let (p, q) = match self.method {
            Method::Printed => self.next_pose_printed(dt),
            Method::Corrected => self.next_pose(dt),
        };
        self.p_last = self.p;
        self.q_last = self.q;
        self.p = p;
        self.q = q;
        self.dt_last = dt;
        self.held_by = Velocity::default();
        if let Some(held) = self.fixed_point {
            self.p = held.point + self.q * held.arm;
            self.p_last = held.point + self.q_last * held.arm;
        }
    }
    // ANCHOR_END: update

    // ANCHOR: corrected
    /// p⁺ by Verlet for uneven steps, q⁺ by the free turn of the angular momentum.
    fn next_pose(&mut self, dt: f32) -> (Vec3, Quat) {
        let kept = drag::kept(self.drag, dt);
        let moved = verlet::displacement(
            self.p,
            self.p_last,
            self.acceleration,
            kept,
            dt,
            self.dt_last,
        );
        let momentum = self.angular_momentum_of_last_turn();
        let momentum = spin::momentum_after(momentum, self.torque, kept, dt, self.dt_last);
        (self.p + moved, self.turned_by(momentum, dt))
    }
    // ANCHOR_END: corrected

    // ANCHOR: turned_by
    /// The attitude `dt` later with this angular momentum, kg m²/s, world axes.
    fn turned_by(&self, momentum: Vec3, dt: f32) -> Quat {
        spin::turned_by(self.q, self.inertia, self.inverse_inertia, momentum, dt)
    }

    /// The angular momentum with which it turned from q* to q, kg m²/s, world axes.
    fn angular_momentum_of_last_turn(&mut self) -> Vec3 {
        if let Some(momentum) = self.read_angular_momentum() {
            return momentum;
        }
        self.unread_turns += 1;
        self.angular_momentum_if_steady()
    }
    // ANCHOR_END: turned_by

    /// The same, or `None` where the turn is too near half a revolution to be read.
    fn read_angular_momentum(&self) -> Option<Vec3> {
        spin::momentum_of_turn(self.q, self.q_last, self.inertia, self.dt_last)
    }

    /// I ω, as if ω had been constant during the turn: exact for a ball.
    fn angular_momentum_if_steady(&self) -> Vec3 {
        spin::momentum_if_steady(self.q, self.q_last, self.inertia, self.dt_last)
    }

    // ANCHOR: printed
    /// p⁺ and q⁺ as the report prints them.
    fn next_pose_printed(&mut self, dt: f32) -> (Vec3, Quat) {
        let f = drag::printed::kept(self.drag, dt);
        let moved = verlet::printed::displacement(self.p, self.p_last, self.acceleration, f, dt);
        let (q, q_last) = (self.q, self.q_last);
        let turned = spin::printed::turn(q, q_last, self.inverse_inertia, self.torque, f, dt);
        (self.p + moved, rotation::printed::turned(self.q, turned))
    }
    // ANCHOR_END: printed

    // ANCHOR: velocity
    /// Its velocities now (`corrected`) or over the last step (`printed`).
    ///
    /// What holds a body acts during the whole step, half of it before now and half after: a body at
    /// rest reads as one.
    #[must_use]
    pub fn velocity(&self) -> Velocity {
        if self.is_static() {
            return Velocity::default();
        }
        match self.method {
            Method::Printed => self.moved(),
            Method::Corrected => {
                let now = self.velocity_now();
                Velocity {
                    v: now.v - 0.5 * self.held_by.v,
                    omega: now.omega - 0.5 * self.held_by.omega,
                }
            }
        }
    }

    fn velocity_now(&self) -> Velocity {
        let momentum = self
            .read_angular_momentum()
            .unwrap_or_else(|| self.angular_momentum_if_steady())
            + self.torque * (0.5 * self.dt_last);
        let omega = spin::angular_velocity(self.q, self.inertia, self.inverse_inertia, momentum);
        let v = match self.fixed_point {
            Some(held) => omega.cross(self.q * held.arm),
            None => verlet::velocity_now(self.p, self.p_last, self.acceleration, self.dt_last),
        };
        Velocity { v, omega }
    }
    // ANCHOR_END: velocity

    /// Its mean velocities over the last step.
    #[must_use]
    pub fn moved(&self) -> Velocity {
        Velocity {
            v: verlet::velocity(self.p, self.p_last, self.dt_last),
            omega: rotation::angular_velocity(self.q, self.q_last, self.dt_last),
        }
    }

    // ANCHOR: set_velocity
    /// Gives it these velocities by writing p* and q*.
    pub fn set_velocity(&mut self, velocity: Velocity) {
        if self.is_static() {
            self.p_last = self.p;
            self.q_last = self.q;
            return;
        }
        let dt = self.dt_last;
        match self.method {
            Method::Printed => {
                self.p_last = verlet::printed::last_position(self.p, velocity.v, dt);
                self.q_last = rotation::printed::turned(self.q, -velocity.omega * dt);
            }
            Method::Corrected => {
                self.p_last = verlet::last_position(self.p, velocity.v, self.acceleration, dt);
                self.q_last = spin::last_orientation(
                    self.q,
                    self.inertia,
                    self.inverse_inertia,
                    velocity.omega,
                    self.torque,
                    dt,
                );
            }
        }
        if let Some(held) = self.fixed_point {
            self.p_last = held.point + self.q_last * held.arm;
        }
    }
    // ANCHOR_END: set_velocity

    /// Writes its place into the graph.
    pub fn place_node(&self, graph: &mut SceneGraph) {
        graph.set_local(self.node, Transform::new(self.p, self.q));
    }
}

// ANCHOR: game_object
impl GameObject for RigidBody {
    fn node(&self) -> NodeId {
        self.node
    }

    fn gather(&mut self) {
        self.sum_callbacks();
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        if !self.is_static() {
            self.advance(dt);
        }
        self.place_node(graph);
    }
}
// ANCHOR_END: game_object
