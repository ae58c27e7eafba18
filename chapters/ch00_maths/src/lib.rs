//! The formulas of the book, one pure function each, named as in the book.
//!
//! Every file of `formulas/` is compiled twice from one source: [`mod@f32`] is what the engines run,
//! [`mod@f64`] is what the laboratory compares them with. A file says `use super::real::*`
//! and never names a width, so a formula is written once and read once.
//!
//! Trigonometry comes from `libm`, not from the platform, so that every machine computes
//! the same bits. Units are SI and radians throughout.

/// The formulas in single precision: what every engine runs.
#[path = "formulas"]
pub mod f32 {
    /// The names that the formulas use for numbers, vectors and functions of one number.
    pub mod real {
        pub use glam::{Mat3, Quat, Vec3};
        pub use libm::{atan2f as atan2, cosf as cos, expf as exp, sinf as sin};
        /// The width of a number in this module.
        pub type Real = f32;
        /// π.
        pub const PI: Real = std::f32::consts::PI;
    }

    pub mod contact;
    pub mod drag;
    pub mod force;
    pub mod free_rotation;
    pub mod impulse;
    pub mod inertia;
    pub mod joint;
    pub mod pin;
    pub mod rotation;
    pub mod shape;
    pub mod spin;
    pub mod swing_twist;
    pub mod verlet;
}

/// The formulas in double precision: what the laboratory measures against.
// The duplicate is the point: one source, two widths.
#[expect(clippy::duplicate_mod)]
#[path = "formulas"]
pub mod f64 {
    /// The names that the formulas use for numbers, vectors and functions of one number.
    pub mod real {
        pub use glam::{DMat3 as Mat3, DQuat as Quat, DVec3 as Vec3};
        pub use libm::{atan2, cos, exp, sin};
        /// The width of a number in this module.
        pub type Real = f64;
        /// π.
        pub const PI: Real = std::f64::consts::PI;
    }

    pub mod contact;
    pub mod drag;
    pub mod force;
    pub mod free_rotation;
    pub mod impulse;
    pub mod inertia;
    pub mod joint;
    pub mod pin;
    pub mod rotation;
    pub mod shape;
    pub mod spin;
    pub mod swing_twist;
    pub mod verlet;
}

impl f64::shape::Shape {
    /// The same in single precision.
    #[must_use]
    pub fn single(&self) -> f32::shape::Shape {
        use f32::shape::Shape as Single;
        match *self {
            Self::Sphere { radius } => Single::Sphere {
                radius: radius as f32,
            },
            Self::Box { half_extents } => Single::Box {
                half_extents: half_extents.as_vec3(),
            },
            Self::Capsule {
                radius,
                half_height,
            } => Single::Capsule {
                radius: radius as f32,
                half_height: half_height as f32,
            },
            Self::Cylinder {
                radius,
                half_height,
            } => Single::Cylinder {
                radius: radius as f32,
                half_height: half_height as f32,
            },
        }
    }
}
