//! What the kernels know of a body, 16 bytes a row. Its attitude q is a column of its own: a
//! quaternion is 16 bytes already.

use glam::Vec3;

use super::layout::rows;

rows! {
    // ANCHOR: place
    /// Where a body is.
    pub struct Place {
        /// World position of its origin.
        position: Vec3, "p", "m";
        /// Radius of the ball about its origin that holds it.
        reach: f32, "r", "m";
    }
    // ANCHOR_END: place

    /// How a body moves.
    pub struct Motion {
        /// World velocity of its origin.
        velocity: Vec3, "v", "m/s";
        /// Among how many active pairs its mass is shared, at least 1.
        shares: f32, "n", "";
    }

    /// How a body turns.
    pub struct Spin {
        /// World angular velocity.
        angular_velocity: Vec3, "ω", "rad/s";
        /// 0 for a static body.
        inverse_mass: f32, "1/m", "1/kg";
    }

    /// How a body is pushed out of others, for one substep: it moves it and is forgotten.
    pub struct Push {
        /// Velocity of the push.
        velocity: Vec3, "v_p", "m/s";
        /// Unused.
        spare_1: f32, "", "";
        /// Angular velocity of the push.
        angular_velocity: Vec3, "ω_p", "rad/s";
        /// Unused.
        spare_2: f32, "", "";
    }

    /// What holds a body: the sum of its impulses of the last substep, with which the next one starts.
    pub struct Held {
        /// Impulse through its origin.
        linear: Vec3, "P", "N s";
        /// Unused.
        spare_1: f32, "", "";
        /// Turning impulse about its origin.
        angular: Vec3, "T", "N m s";
        /// Unused.
        spare_2: f32, "", "";
    }

    /// What a body is made of.
    pub struct Solid {
        /// Inverse of its principal moments of inertia, in its own axes; 0 for a static body.
        inverse_inertia: Vec3, "1/I", "1/(kg m²)";
        /// 0 ball, 1 box, 2 capsule, 3 cylinder: the kinds of chapter 5.
        kind: u32, "", "";
        /// Ball: radius, 0, 0. Box: half extents. Capsule and cylinder: radius, half height, 0.
        size: Vec3, "s", "m";
        /// The body's ID, which stays when rows move.
        id: u32, "", "";
    }

    /// How a body's surface behaves.
    pub struct Material {
        /// Coefficient of restitution; a pair has the mean of the two.
        restitution: f32, "e", "";
        /// Kinetic coefficient of friction; a pair has the geometric mean of the two.
        friction: f32, "μ", "";
        /// Static coefficient of friction.
        static_friction: f32, "μ_s", "";
        /// Unused.
        spare: f32, "", "";
    }
}
