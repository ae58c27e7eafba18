//! The bodies: their state, and what doesn't change. A body that can't move has an inverse mass of 0.

use ch00_maths::f32::shape::Shape;
use glam::{Quat, Vec3};

crate::table! {
    /// What moves, and what it moves against.
    pub struct Bodies of
    /// A rigid body.
    Body in "bodies" {
        /// Where its centre is.
        position: Vec3, "p", "m", editable;
        /// Where its centre was a step ago.
        last_position: Vec3, "p*", "m", editable;
        /// How it is turned: body to world.
        orientation: Quat, "q", "", editable;
        /// How it was turned a step ago.
        last_orientation: Quat, "q*", "", editable;
        /// Its solid: 0 ball, 1 box, 2 capsule, 3 cylinder.
        shape: u32, "shape", "";
        /// Radius; half-extents of a box; radius and half-height of a capsule and a cylinder.
        size: Vec3, "size", "m";
        /// 1/m; 0 for what can't move.
        inverse_mass: f32, "1/m", "1/kg";
        /// Its principal moments.
        inertia: Vec3, "I", "kg m²";
        /// The inverse moments; 0 for what can't turn.
        inverse_inertia: Vec3, "I⁻¹", "1/(kg m²)";
        /// How much of the speed is left after an impact; a pair has the mean.
        restitution: f32, "e", "", editable;
        /// Friction while it slides; a pair has the geometric mean.
        friction: f32, "μ", "", editable;
        /// Friction before it slides.
        static_friction: f32, "μ_s", "", editable;
        /// ΣF/m and gravity, where it is now.
        acceleration: Vec3, "a", "m/s²";
        /// ΣT, where it is now.
        torque: Vec3, "T", "N m";
        /// What supports, friction and joints changed its velocity by in the last step.
        held_velocity: Vec3, "v_held", "m/s";
        /// What they changed its angular velocity by.
        held_spin: Vec3, "ω_held", "rad/s";
    }
}

// ANCHOR: shape
/// A shape as two values of columns: kind and size.
#[must_use]
pub fn shape_columns(shape: &Shape) -> (u32, Vec3) {
    match *shape {
        Shape::Sphere { radius } => (0, Vec3::new(radius, 0.0, 0.0)),
        Shape::Box { half_extents } => (1, half_extents),
        Shape::Capsule {
            radius,
            half_height,
        } => (2, Vec3::new(radius, half_height, 0.0)),
        Shape::Cylinder {
            radius,
            half_height,
        } => (3, Vec3::new(radius, half_height, 0.0)),
    }
}

/// The way back.
#[must_use]
#[inline]
pub fn shape_of(kind: u32, size: Vec3) -> Shape {
    let (radius, half_height) = (size.x, size.y);
    match kind {
        0 => Shape::Sphere { radius },
        1 => Shape::Box { half_extents: size },
        2 => Shape::Capsule {
            radius,
            half_height,
        },
        _ => Shape::Cylinder {
            radius,
            half_height,
        },
    }
}
// ANCHOR_END: shape

/// The kind of a ball.
pub const BALL: u32 = 0;
