//! The spring between a body and the mouse that drags it: damped, so that the body follows
//! without swinging, and as stiff for a light body as for a heavy one.

use ch00_maths::f32::force;
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
    /// Force, N, and torque about the body's centre, N m: critically damped.
    #[must_use]
    pub fn pull_on(&self, body: &Feel, velocity: Velocity) -> (Vec3, Vec3) {
        let arm = body.q * self.anchor;
        let stretch = self.target - (body.p + arm);
        force::spring(body.mass, arm, stretch, velocity)
    }
}
