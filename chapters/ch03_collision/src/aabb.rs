//! Axis-aligned bounding boxes: the cheapest question about two shapes, whether they could touch.

use ch00_maths::f32::shape::Shape;
use glam::{Mat3, Quat, Vec3};

/// A box along the world's axes, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Smallest coordinates.
    pub min: Vec3,
    /// Largest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// Holds nothing; joined with a box it is that box.
    pub const EMPTY: Self = Self {
        min: Vec3::INFINITY,
        max: Vec3::NEG_INFINITY,
    };

    // ANCHOR: of_shape
    /// The smallest box about a shape at p, q.
    #[must_use]
    pub fn of_shape(shape: &Shape, p: Vec3, q: Quat) -> Self {
        let axes = Mat3::from_quat(q);
        let y = axes.y_axis;
        let reach = match *shape {
            Shape::Sphere { radius } => Vec3::splat(radius),
            Shape::Box { half_extents: h } => {
                axes.x_axis.abs() * h.x + y.abs() * h.y + axes.z_axis.abs() * h.z
            }
            Shape::Capsule {
                radius,
                half_height,
            } => y.abs() * half_height + Vec3::splat(radius),
            Shape::Cylinder {
                radius,
                half_height,
            } => {
                // A disc with the normal y reaches r √(1 − y_i²) along axis i.
                let across = (Vec3::ONE - y * y).max(Vec3::ZERO);
                let across = Vec3::new(across.x.sqrt(), across.y.sqrt(), across.z.sqrt());
                y.abs() * half_height + across * radius
            }
        };
        Self {
            min: p - reach,
            max: p + reach,
        }
    }
    // ANCHOR_END: of_shape

    // ANCHOR: overlaps
    /// Whether the two share a point; touching counts.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }
    // ANCHOR_END: overlaps

    /// The smallest box about both.
    #[must_use]
    pub fn joined(&self, other: &Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// The same, wider by `margin` on every side, m.
    #[must_use]
    pub fn grown(&self, margin: f32) -> Self {
        Self {
            min: self.min - margin,
            max: self.max + margin,
        }
    }

    /// Its centre, m.
    #[must_use]
    pub fn centre(&self) -> Vec3 {
        0.5 * (self.min + self.max)
    }

    /// Its edges, m.
    #[must_use]
    pub fn size(&self) -> Vec3 {
        self.max - self.min
    }
}
