//! What others may ask of a rigid body. Nothing here changes it.

use ch00_maths::f32::rotation;
use ch00_maths::f32::shape::Shape;
use glam::{Quat, Vec3};

use super::{Material, RigidBody};

impl RigidBody {
    /// Whether nothing moves it.
    #[must_use]
    pub fn is_static(&self) -> bool {
        self.inverse_mass == 0.0
    }

    /// Whether it hangs on a fixed point. Such a body doesn't collide.
    #[must_use]
    pub fn is_held(&self) -> bool {
        self.fixed_point.is_some()
    }

    /// p, m.
    #[must_use]
    pub fn position(&self) -> Vec3 {
        self.p
    }

    /// p*, m.
    #[must_use]
    pub fn last_position(&self) -> Vec3 {
        self.p_last
    }

    /// q.
    #[must_use]
    pub fn orientation(&self) -> Quat {
        self.q
    }

    /// q*.
    #[must_use]
    pub fn last_orientation(&self) -> Quat {
        self.q_last
    }

    /// How far any point of it moved in the last step, at most, m.
    #[must_use]
    pub fn last_reach(&self) -> f32 {
        let radius = self.collider.bounding_radius();
        rotation::reach(self.p, self.p_last, self.q, self.q_last, radius)
    }

    /// ΣF/m and gravity, m/s², where it is now.
    #[must_use]
    pub fn acceleration(&self) -> Vec3 {
        self.acceleration
    }

    /// kg; infinite for a static body.
    #[must_use]
    pub fn mass(&self) -> f32 {
        self.mass
    }

    /// Principal moments, kg m².
    #[must_use]
    pub fn inertia(&self) -> Vec3 {
        self.inertia
    }

    /// Its solid.
    #[must_use]
    pub fn collider(&self) -> &Shape {
        &self.collider
    }

    /// Its surface.
    #[must_use]
    pub fn material(&self) -> Material {
        self.material
    }

    /// Turns that were too near half a revolution to be read, since it was made.
    #[must_use]
    pub fn unread_turns(&self) -> usize {
        self.unread_turns
    }
}
