//! The spring between a body and the mouse that drags it: damped, so that the body follows
//! without swinging, and as stiff for a light body as for a heavy one.

use ch00_maths::f32::impulse::Velocity;
use glam::Vec3;

use crate::Feel;

/// A spring from a point of a body to a point of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// In the body's axes, m.
    pub anchor: Vec3,
    /// In the world, m.
    pub target: Vec3,
}

impl Spring {
    /// Natural frequency, rad/s: a body is at the mouse after about a quarter of a second.
    const FREQUENCY: f32 = 12.0;

    /// Force, N, and torque about the body's centre, N m: critically damped.
    #[must_use]
    pub fn pull_on(&self, body: &Feel, velocity: Velocity) -> (Vec3, Vec3) {
        let arm = body.q * self.anchor;
        let stretch = self.target - (body.p + arm);
        let speed = velocity.v + velocity.omega.cross(arm);
        let force = body.mass * Self::FREQUENCY * (Self::FREQUENCY * stretch - 2.0 * speed);
        // The arm is kept short for the torque, so that a long thin body isn't whirled round.
        (force, 0.4 * arm.cross(force))
    }
}
