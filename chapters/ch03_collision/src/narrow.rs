//! The narrow phase: where exactly two shapes touch. Pure functions over shapes and poses, a
//! file a pair of shapes. Report 7, narrow step.

mod sphere_box;
mod sphere_sphere;

pub use sphere_box::sphere_box;
pub use sphere_sphere::sphere_sphere;

use ch00_maths::f32::shape::Shape;
use glam::{Quat, Vec3};

/// Points that a touch has at most: four corners hold a face on a face.
pub const MOST_SPOTS: usize = 4;

// ANCHOR: touch
/// Where two shapes touch: the report's collision artefact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Unit vector from the second shape to the first: the shortest way apart.
    pub normal: Vec3,
    spots: [Spot; MOST_SPOTS],
    count: usize,
}

/// One point of a touch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// Midway between the two surfaces, world, m.
    pub point: Vec3,
    /// How far the shapes must part here along the normal, m; negative for a gap.
    pub depth: f32,
    /// Which features of the two shapes meet here: the same number in the next step means the same
    /// corner or edge, so that what it carried can be handed on.
    pub feature: u32,
}
// ANCHOR_END: touch

impl Touch {
    /// Without a point yet.
    #[must_use]
    pub fn empty(normal: Vec3) -> Self {
        Self {
            normal,
            spots: [Spot::default(); MOST_SPOTS],
            count: 0,
        }
    }

    /// In one point, which round shapes have: feature 0.
    #[must_use]
    pub fn single(normal: Vec3, depth: f32, point: Vec3) -> Self {
        let mut touch = Self::empty(normal);
        touch.push(Spot {
            point,
            depth,
            feature: 0,
        });
        touch
    }

    /// Adds a point.
    ///
    /// # Panics
    /// If it has [`MOST_SPOTS`] already.
    pub fn push(&mut self, spot: Spot) {
        self.spots[self.count] = spot;
        self.count += 1;
    }

    /// Its points, at least one where shapes touch.
    #[must_use]
    pub fn spots(&self) -> &[Spot] {
        &self.spots[..self.count]
    }

    /// The depth of its deepest point, m.
    #[must_use]
    pub fn depth(&self) -> f32 {
        let depths = self.spots().iter().map(|spot| spot.depth);
        depths.fold(f32::NEG_INFINITY, f32::max)
    }

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
