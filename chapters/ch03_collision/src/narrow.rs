//! The narrow phase: where exactly two shapes touch. Pure functions over shapes and poses, a
//! file a pair of shapes. Report 7, narrow step.

mod sphere_box;
mod sphere_sphere;

pub use sphere_box::sphere_box;
pub use sphere_sphere::sphere_sphere;

use ch00_maths::f32::shape::Shape;
use glam::{Quat, Vec3};

// ANCHOR: touch
/// Where two shapes touch: the report's collision artefact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Unit vector from the second shape to the first: the shortest way apart.
    pub normal: Vec3,
    /// How far they must part along it, m; negative for a gap.
    pub depth: f32,
    /// Midway between the two surfaces, world, m.
    pub point: Vec3,
}
// ANCHOR_END: touch

impl Touch {
    /// The same seen from the second shape.
    #[must_use]
    pub fn flipped(self) -> Self {
        Self {
            normal: -self.normal,
            ..self
        }
    }
}

/// A shape in the world, and where its centre was a step ago.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// The solid.
    pub shape: &'a Shape,
    /// Its centre, m.
    pub p: Vec3,
    /// Body to world.
    pub q: Quat,
    /// Where it came from, m: which side of a thin or deep obstacle it belongs to.
    pub p_before: Vec3,
}

/// Whether [`touch`] knows this pair of shapes, in either order.
#[must_use]
pub fn is_known(a: &Shape, b: &Shape) -> bool {
    matches!(
        (a, b),
        (
            Shape::Sphere { .. },
            Shape::Sphere { .. } | Shape::Box { .. }
        ) | (Shape::Box { .. }, Shape::Sphere { .. })
    )
}

// ANCHOR: dispatch
/// Where `a` and `b` touch or are at most `margin`, m, from touching; the normal points from b to a.
#[must_use]
pub fn touch(a: &Placed, b: &Placed, margin: f32) -> Option<Touch> {
    match (a.shape, b.shape) {
        (Shape::Sphere { radius: r1 }, Shape::Sphere { radius: r2 }) => {
            sphere_sphere(a.p, *r1, b.p, *r2, margin)
        }
        (Shape::Sphere { radius }, Shape::Box { half_extents }) => {
            sphere_box(a, *radius, b, *half_extents, margin)
        }
        (Shape::Box { half_extents }, Shape::Sphere { radius }) => {
            sphere_box(b, *radius, a, *half_extents, margin).map(Touch::flipped)
        }
        _ => None,
    }
}
// ANCHOR_END: dispatch
