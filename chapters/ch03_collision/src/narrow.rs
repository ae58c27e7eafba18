//! The narrow phase: where exactly two shapes touch. Pure functions over shapes and poses, which
//! ask for no memory. Report 7, narrow step.
//!
//! Balls, and capsules among themselves, take the short way: a file a pair. All others go through
//! [`shortest_way`] (GJK and EPA), and then to the contact points, where features are clipped.

mod capsule_capsule;
pub mod clip;
pub mod epa;
pub mod features;
pub mod gjk;
pub mod list;
mod manifold;
mod patch;
pub mod segment;
pub mod shortest_way;
pub mod simplex;
mod sphere_box;
mod sphere_capsule;
mod sphere_cylinder;
mod sphere_sphere;
pub mod support_point;
mod way_back;

pub use capsule_capsule::capsule_capsule;
pub use manifold::{convex_convex, manifold};
pub use sphere_box::sphere_box;
pub use sphere_capsule::sphere_capsule;
pub use sphere_cylinder::sphere_cylinder;
pub use sphere_sphere::sphere_sphere;

use ch00_maths::f32::shape::Shape::{self, Box, Capsule, Cylinder, Sphere};
use glam::{Quat, Vec3};
use list::List;

/// Points that a touch has at most: four corners hold a face on a face.
pub const MOST_SPOTS: usize = 4;

// ANCHOR: touch
/// Where two shapes touch: the report's collision artefact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Unit vector from the second shape to the first: the shortest way apart.
    pub normal: Vec3,
    /// False if EPA ran out of room before it was sure: a slightly shorter way may exist.
    pub converged: bool,
    spots: List<Spot, MOST_SPOTS>,
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
    /// In up to [`MOST_SPOTS`] points.
    ///
    /// # Panics
    /// If there are more.
    #[must_use]
    pub fn new(normal: Vec3, spots: &[Spot]) -> Self {
        Self {
            normal,
            converged: true,
            spots: List::of(spots),
        }
    }

    /// In one point, which round shapes have: feature 0.
    #[must_use]
    pub fn single(normal: Vec3, depth: f32, point: Vec3) -> Self {
        let spot = Spot {
            point,
            depth,
            feature: 0,
        };
        Self::new(normal, &[spot])
    }

    /// Its points, at least one where shapes touch.
    #[must_use]
    pub fn spots(&self) -> &[Spot] {
        &self.spots
    }

    /// The depth of its deepest point, m.
    #[must_use]
    pub fn depth(&self) -> f32 {
        let depths = self.spots().iter().map(|spot| spot.depth);
        depths.fold(f32::NEG_INFINITY, f32::max)
    }

    /// The same, moved.
    #[must_use]
    fn moved_by(mut self, way: Vec3) -> Self {
        for spot in self.spots.iter_mut() {
            spot.point += way;
        }
        self
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

// ANCHOR: dispatch
/// Where `a` and `b` touch or are at most `margin`, m, from touching; the normal points from b to
/// a.
#[must_use]
pub fn touch(a: &Placed, b: &Placed, margin: f32) -> Option<Touch> {
    match (*a.shape, *b.shape) {
        (Sphere { radius: r1 }, Sphere { radius: r2 }) => sphere_sphere(a.p, r1, b.p, r2, margin),
        (Sphere { radius }, Box { half_extents }) => sphere_box(a, radius, b, half_extents, margin),
        (
            Sphere { radius: r1 },
            Capsule {
                radius,
                half_height,
            },
        ) => sphere_capsule(a.p, r1, b, radius, half_height, margin),
        (
            Sphere { radius: r1 },
            Cylinder {
                radius,
                half_height,
            },
        ) => sphere_cylinder(a.p, r1, b, radius, half_height, margin),
        (_, Sphere { .. }) => touch(b, a, margin).map(Touch::flipped),
        (
            Capsule {
                radius: r1,
                half_height: h1,
            },
            Capsule {
                radius: r2,
                half_height: h2,
            },
        ) => capsule_capsule(a, (r1, h1), b, (r2, h2), margin),
        _ => convex_convex(a, b, margin),
    }
}
// ANCHOR_END: dispatch
