//! The field's usual methods, a file each, to be compared with the book's own: the same tables, the same
//! contacts, and a step that reads as its algorithm.
//!
//! Every file of `methods/` is compiled twice from one source, as the formulas of chapter 0 are: in double
//! precision, where what is left of an error is the method's alone, and in single precision, where one sees
//! what rounding adds. A file says `use super::real::*` and names no width.
//!
//! Scenes go in and states come out as with every other engine, so that any scene runs with any method, or
//! the method says why it can't.

/// The methods in double precision: engine `methods`.
#[path = "methods"]
pub mod double {
    /// Numbers, vectors and the book's formulas in double precision.
    pub mod real {
        pub use ch00_maths::f64::real::{Mat3, PI, Quat, Real, Vec3, atan2, cos, sin};
        pub use ch00_maths::f64::{force, free_rotation, impulse, inertia, rotation, swing_twist};
        use glam::{DQuat, DVec3};

        /// As `--engine` says it.
        pub const ENGINE_NAME: &str = "methods";

        /// Of a scene's number.
        #[must_use]
        pub fn real(x: f64) -> Real {
            x
        }

        /// Of a scene's vector.
        #[must_use]
        pub fn vector(v: DVec3) -> Vec3 {
            v
        }

        /// Of a scene's orientation.
        #[must_use]
        pub fn quaternion(q: DQuat) -> Quat {
            q
        }

        /// For a state.
        #[must_use]
        pub fn wide(v: Vec3) -> DVec3 {
            v
        }

        /// For a state.
        #[must_use]
        pub fn wide_turn(q: Quat) -> DQuat {
            q
        }

        /// As the narrow phase takes it.
        #[must_use]
        pub fn single(v: Vec3) -> glam::Vec3 {
            v.as_vec3()
        }

        /// As the narrow phase takes it.
        #[must_use]
        pub fn single_turn(q: Quat) -> glam::Quat {
            q.as_quat()
        }

        /// Of the narrow phase.
        #[must_use]
        pub fn of_single(v: glam::Vec3) -> Vec3 {
            v.as_dvec3()
        }

        /// Of a single number.
        #[must_use]
        pub fn of_float(x: f32) -> Real {
            f64::from(x)
        }

        /// As a single number.
        #[must_use]
        pub fn float(x: Real) -> f32 {
            x as f32
        }
    }

    pub mod alone;
    pub mod bodies;
    pub mod constant_spin;
    pub mod contacts;
    pub mod direct_joints;
    pub mod engine;
    pub mod explicit_gyro;
    pub mod implicit_gyro;
    pub mod joints;
    pub mod list;
    pub mod row;
    pub mod runge_kutta;
    pub mod sequential_impulses;
    pub mod soft_step;
    pub mod splitting;
    pub mod world;
    pub mod xpbd;
}

/// The same in single precision: engine `methods-single`.
// The duplicate is the point: one source, two widths.
#[expect(clippy::duplicate_mod)]
#[path = "methods"]
pub mod single {
    /// Numbers, vectors and the book's formulas in single precision.
    pub mod real {
        pub use ch00_maths::f32::real::{Mat3, PI, Quat, Real, Vec3, atan2, cos, sin};
        pub use ch00_maths::f32::{force, free_rotation, impulse, inertia, rotation, swing_twist};
        use glam::{DQuat, DVec3};

        /// As `--engine` says it.
        pub const ENGINE_NAME: &str = "methods-single";

        /// Of a scene's number.
        #[must_use]
        pub fn real(x: f64) -> Real {
            x as f32
        }

        /// Of a scene's vector.
        #[must_use]
        pub fn vector(v: DVec3) -> Vec3 {
            v.as_vec3()
        }

        /// Of a scene's orientation.
        #[must_use]
        pub fn quaternion(q: DQuat) -> Quat {
            q.as_quat()
        }

        /// For a state.
        #[must_use]
        pub fn wide(v: Vec3) -> DVec3 {
            v.as_dvec3()
        }

        /// For a state.
        #[must_use]
        pub fn wide_turn(q: Quat) -> DQuat {
            q.as_dquat()
        }

        /// As the narrow phase takes it.
        #[must_use]
        pub fn single(v: Vec3) -> Vec3 {
            v
        }

        /// As the narrow phase takes it.
        #[must_use]
        pub fn single_turn(q: Quat) -> Quat {
            q
        }

        /// Of the narrow phase.
        #[must_use]
        pub fn of_single(v: Vec3) -> Vec3 {
            v
        }

        /// Of a single number.
        #[must_use]
        pub fn of_float(x: f32) -> Real {
            x
        }

        /// As a single number.
        #[must_use]
        pub fn float(x: Real) -> f32 {
            x
        }
    }

    pub mod alone;
    pub mod bodies;
    pub mod constant_spin;
    pub mod contacts;
    pub mod direct_joints;
    pub mod engine;
    pub mod explicit_gyro;
    pub mod implicit_gyro;
    pub mod joints;
    pub mod list;
    pub mod row;
    pub mod runge_kutta;
    pub mod sequential_impulses;
    pub mod soft_step;
    pub mod splitting;
    pub mod world;
    pub mod xpbd;
}
