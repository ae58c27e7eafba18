//! The four solids that a body can be. Each is centred on the body's origin; the axis of
//! a cylinder and of a capsule is the body's y.

use super::inertia;
use super::real::{PI, Real, Vec3};

/// A solid shape, lengths in metres. Report 7: OriBox, Sphere, Cylinder, Capsule.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(rename_all = "snake_case", deny_unknown_fields)
)]
pub enum Shape {
    /// A ball.
    Sphere {
        /// Distance from the centre to the surface.
        radius: Real,
    },
    /// A box whose faces follow the body's axes (the report's `OriBox`).
    Box {
        /// Half of the edge along x, y and z.
        half_extents: Vec3,
    },
    /// A cylinder with two half-balls on its ends.
    Capsule {
        /// Radius of the cylinder and of its caps.
        radius: Real,
        /// Half of the straight part along y.
        half_height: Real,
    },
    /// A cylinder with flat ends.
    Cylinder {
        /// Radius of the round side.
        radius: Real,
        /// Half of the height along y.
        half_height: Real,
    },
}

impl Shape {
    /// Volume, m³.
    #[must_use]
    pub fn volume(&self) -> Real {
        match *self {
            Shape::Sphere { radius } => 4.0 / 3.0 * PI * radius * radius * radius,
            Shape::Box { half_extents: h } => 8.0 * h.x * h.y * h.z,
            Shape::Capsule {
                radius,
                half_height,
            } => PI * radius * radius * (2.0 * half_height + 4.0 / 3.0 * radius),
            Shape::Cylinder {
                radius,
                half_height,
            } => 2.0 * PI * radius * radius * half_height,
        }
    }

    /// Radius of the smallest ball about the origin that holds the shape, m.
    #[must_use]
    pub fn bounding_radius(&self) -> Real {
        match *self {
            Shape::Sphere { radius } => radius,
            Shape::Box { half_extents } => half_extents.length(),
            Shape::Capsule {
                radius,
                half_height,
            } => radius + half_height,
            Shape::Cylinder {
                radius,
                half_height,
            } => (radius * radius + half_height * half_height).sqrt(),
        }
    }

    /// The principal moments of inertia of the solid with this mass, kg m². Report 8.1.
    #[must_use]
    pub fn inertia(&self, mass: Real) -> Vec3 {
        match *self {
            Shape::Sphere { radius } => inertia::sphere(mass, radius),
            Shape::Box { half_extents } => inertia::ori_box(mass, half_extents),
            Shape::Capsule {
                radius,
                half_height,
            } => inertia::capsule(mass, radius, half_height),
            Shape::Cylinder {
                radius,
                half_height,
            } => inertia::cylinder(mass, radius, half_height),
        }
    }
}
