//! One side of a limit or a loop, one at a time.

use glam::{Mat3, Quat, Vec3};

use crate::rows::{Motion, Place, Seen, Solid, Spin};

/// One of the two bodies, as the pair sees it.
#[derive(Clone, Copy, Debug)]
pub struct Side {
    /// World position, m.
    pub position: Vec3,
    /// Body to world.
    pub attitude: Quat,
    /// m/s.
    pub velocity: Vec3,
    /// rad/s.
    pub angular_velocity: Vec3,
    /// 1/m: with the whole mass.
    pub inverse_mass: f32,
    /// n/m: with the share of the mass that the pair has.
    pub shared_mass: f32,
    /// n I⁻¹ in world axes.
    pub shared_inertia: Mat3,
    /// What the two velocities were before the substep's kick.
    pub before: Seen,
}

impl Side {
    /// Gathers it from a body's rows.
    #[must_use]
    pub fn of(
        place: &Place,
        attitude: Quat,
        motion: &Motion,
        spin: &Spin,
        solid: &Solid,
        before: Seen,
    ) -> Self {
        Self {
            before,
            position: place.position,
            attitude,
            velocity: motion.velocity,
            angular_velocity: spin.angular_velocity,
            inverse_mass: spin.inverse_mass,
            shared_mass: motion.shares * spin.inverse_mass,
            shared_inertia: world_inertia(attitude, motion.shares * solid.inverse_inertia),
        }
    }
}

/// R D Rᵀ: a diagonal tensor in body axes as a matrix in world axes.
#[must_use]
pub fn world_inertia(q: Quat, diagonal: Vec3) -> Mat3 {
    let r = Mat3::from_quat(q);
    let scaled = Mat3::from_cols(
        r.x_axis * diagonal.x,
        r.y_axis * diagonal.y,
        r.z_axis * diagonal.z,
    );
    scaled * r.transpose()
}

/// Two unit vectors across a unit vector and across each other. [Duff and others 2017]
#[must_use]
pub fn across(n: Vec3) -> [Vec3; 2] {
    let sign = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let p = -1.0 / (sign + n.z);
    let q = n.x * n.y * p;
    [
        Vec3::new(1.0 + sign * n.x * n.x * p, sign * q, -sign * n.x),
        Vec3::new(q, sign + n.y * n.y * p, -n.y),
    ]
}
