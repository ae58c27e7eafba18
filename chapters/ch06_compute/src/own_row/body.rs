//! What a body does in a substep: it takes up what pulls and holds it, gathers what its pairs did to
//! it, and moves.

use ch00_maths::f32::{free_rotation, rotation, spin};
use glam::{Quat, Vec3};

use crate::rows::{Held, Motion, Press, Push, Solid, Spin, Step, Turned};

// ANCHOR: kick
/// Starts a substep: gravity, drag, other pulls, and what held the body in the last substep.
pub fn kick(
    motion: &mut Motion,
    spin: &mut Spin,
    attitude: Quat,
    solid: &Solid,
    held: &Held,
    pull: &Pull,
    step: &Step,
) {
    if spin.inverse_mass > 0.0 {
        motion.velocity += step.h * step.gravity;
    }
    motion.velocity += step.h * pull.acceleration + held.linear * spin.inverse_mass;
    motion.velocity *= step.drag;
    let turning = held.angular + step.h * pull.torque;
    spin.angular_velocity += rotation::moment(attitude, solid.inverse_inertia, turning);
    spin.angular_velocity *= step.drag;
}

/// The same for its angular momentum, kg m²/s, world.
pub fn kick_momentum(momentum: &mut Vec3, held: &Held, pull: &Pull, step: &Step) {
    *momentum += held.angular + step.h * pull.torque;
    *momentum *= step.drag;
}
// ANCHOR_END: kick

/// What pulls a body beyond gravity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pull {
    /// m/s².
    pub acceleration: Vec3,
    /// About its origin, world axes, N m.
    pub torque: Vec3,
}

// ANCHOR: gather
/// What a body's pairs did to it, summed in the order of their IDs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Gathered {
    /// The impulses of this substep.
    pub held: Held,
    /// Those of them with which the next one begins.
    pub stays: Held,
    /// The pushes of this substep.
    pub pushed: Held,
    /// How many pairs, limits and loops count.
    pub counts: f32,
    /// How many pairs count.
    pub touches: f32,
}

impl Gathered {
    /// Adds a pair in which the body is b, or a.
    pub fn add(&mut self, press: &Press, is_b: bool) {
        let sign = if is_b { 1.0 } else { -1.0 };
        let turning = if is_b {
            press.angular_b
        } else {
            press.angular_a
        };
        self.held.linear += sign * press.linear;
        self.held.angular += turning;
        self.stays.linear += sign * press.stays * press.linear;
        self.stays.angular += press.stays * turning;
        self.pushed.linear += sign * press.push;
        self.pushed.angular += if is_b { press.push_b } else { press.push_a };
        self.counts += press.counts;
        self.touches += press.counts;
    }

    /// Adds a limit in which the body is b, or a.
    pub fn add_turned(&mut self, turned: &Turned, is_b: bool) {
        let sign = if is_b { 1.0 } else { -1.0 };
        self.held.angular += sign * turned.turning;
        self.stays.angular += sign * turned.turning;
        self.pushed.angular += sign * turned.push;
        self.counts += turned.counts;
    }
}
// ANCHOR_END: gather

// ANCHOR: exchange
/// Puts what holds the body now in the place of what it started the substep with.
pub fn exchange(
    motion: &mut Motion,
    spin: &mut Spin,
    attitude: Quat,
    solid: &Solid,
    old: &Held,
    new: &Held,
) {
    motion.velocity += (new.linear - old.linear) * spin.inverse_mass;
    let turning = new.angular - old.angular;
    spin.angular_velocity += rotation::moment(attitude, solid.inverse_inertia, turning);
}
// ANCHOR_END: exchange

/// The velocities that pushes are, for this body.
#[must_use]
pub fn push_of(pushed: &Held, spin: &Spin, attitude: Quat, solid: &Solid) -> Push {
    Push {
        velocity: pushed.linear * spin.inverse_mass,
        angular_velocity: rotation::moment(attitude, solid.inverse_inertia, pushed.angular),
        ..Push::default()
    }
}

// ANCHOR: turned
/// The attitude and the angular velocity after a substep: the push turns it, and then it turns freely
/// with its angular momentum (chapter 2's splitting, so that errata 3 and 5 stay mended).
#[must_use]
pub fn turned(
    attitude: Quat,
    angular_velocity: Vec3,
    push: Vec3,
    inverse_inertia: Vec3,
    h: f32,
) -> (Quat, Vec3) {
    if spin::is_round(inverse_inertia) {
        return (
            rotation::turned(attitude, h * (angular_velocity + push)),
            angular_velocity,
        );
    }
    let momentum = rotation::moment(attitude, inverse_inertia.recip(), angular_velocity);
    turned_with(attitude, momentum, push, inverse_inertia, h)
}

/// The same for a body whose angular momentum is known, kg m²/s, world. Read from the angular velocity in
/// each substep, it would grow by a rounding each time: 2e-7 of it, which after 10 s is 1e-3.
#[must_use]
pub fn turned_with(
    attitude: Quat,
    momentum: Vec3,
    push: Vec3,
    inverse_inertia: Vec3,
    h: f32,
) -> (Quat, Vec3) {
    let inertia = inverse_inertia.recip();
    let attitude = rotation::turned(attitude, h * push);
    let attitude = free_rotation::attitude_after(attitude, inertia, momentum, h);
    (
        attitude,
        rotation::moment(attitude, inverse_inertia, momentum),
    )
}
// ANCHOR_END: turned
