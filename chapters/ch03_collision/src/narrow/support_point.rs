//! Support points: the furthest point of a solid in a direction. It is all that GJK and EPA ever
//! ask about a solid, so one algorithm serves all pairs.
//!
//! A solid is taken as a *core* rounded by a radius: a ball is a point and its radius, a capsule
//! a segment and its radius, a box and a cylinder are their own cores with radius 0. Two solids
//! overlap by d where their cores are r₁ + r₂ − d apart. [van den Bergen 2003, 4.3]

use ch00_maths::f32::shape::Shape;
use glam::{Mat3, Vec3};

use super::Placed;

// ANCHOR: core
/// What is left of a solid if its radius is taken off, centred on the origin of its own axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hull {
    /// The centre: what is left of a ball.
    Point,
    /// From −h to h along y: what is left of a capsule.
    Segment {
        /// h, m.
        half_height: f32,
    },
    /// A box.
    Box {
        /// Half of its edges, m.
        half_extents: Vec3,
    },
    /// A cylinder about y.
    Cylinder {
        /// Radius of the round side, m. It isn't taken off: the rims are sharp.
        radius: f32,
        /// Half of its height, m.
        half_height: f32,
    },
}

/// A solid as GJK sees it: a hull somewhere, and the radius by which it is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Core {
    /// The hull in its own axes.
    pub hull: Hull,
    /// How far the solid reaches beyond the hull on all sides, m.
    pub radius: f32,
    /// Where the hull's centre is, m.
    pub centre: Vec3,
    /// The hull's own axes.
    pub axes: Mat3,
}
// ANCHOR_END: core

impl Core {
    /// The cores of two solids. The axes are the world's, but the origin is b's centre: far from
    /// the world's origin an f32 has few digits left for a distance, and here it has them all.
    #[must_use]
    pub fn pair(a: &Placed, b: &Placed) -> (Self, Self) {
        (Self::at(a, a.p - b.p), Self::at(b, Vec3::ZERO))
    }

    fn at(placed: &Placed, centre: Vec3) -> Self {
        let (hull, radius) = match *placed.shape {
            Shape::Sphere { radius } => (Hull::Point, radius),
            Shape::Capsule {
                radius,
                half_height,
            } => {
                let is_ball = half_height == 0.0;
                let axis = Hull::Segment { half_height };
                (if is_ball { Hull::Point } else { axis }, radius)
            }
            Shape::Box { half_extents } => (Hull::Box { half_extents }, 0.0),
            Shape::Cylinder {
                radius,
                half_height,
            } => {
                let sharp = Hull::Cylinder {
                    radius,
                    half_height,
                };
                (sharp, 0.0)
            }
        };
        Self {
            hull,
            radius,
            centre,
            axes: Mat3::from_quat(placed.q),
        }
    }

    // ANCHOR: support
    /// The point of the hull that is furthest along `direction`, which needn't be a unit vector.
    #[must_use]
    pub fn support(&self, direction: Vec3) -> Vec3 {
        let d = self.to_own(direction);
        let own = match self.hull {
            Hull::Point => Vec3::ZERO,
            Hull::Segment { half_height } => Vec3::new(0.0, towards(d.y, half_height), 0.0),
            Hull::Box { half_extents: h } => {
                Vec3::new(towards(d.x, h.x), towards(d.y, h.y), towards(d.z, h.z))
            }
            Hull::Cylinder {
                radius,
                half_height,
            } => {
                let across = (d.x * d.x + d.z * d.z).sqrt();
                let out = if across > 0.0 { radius / across } else { 0.0 };
                Vec3::new(d.x * out, towards(d.y, half_height), d.z * out)
            }
        };
        self.centre + self.axes * own
    }
    // ANCHOR_END: support

    /// A vector in the hull's own axes.
    #[must_use]
    pub fn to_own(&self, v: Vec3) -> Vec3 {
        Vec3::new(
            self.axes.x_axis.dot(v),
            self.axes.y_axis.dot(v),
            self.axes.z_axis.dot(v),
        )
    }

    /// The directions of the hull's straight edges and lines.
    pub fn edge_axes(&self) -> impl Iterator<Item = Vec3> + use<> {
        let axes = match self.hull {
            Hull::Point => 0..0,
            Hull::Segment { .. } | Hull::Cylinder { .. } => 1..2,
            Hull::Box { .. } => 0..3,
        };
        let all = self.axes;
        axes.map(move |i| all.col(i))
    }

    /// The normals of the hull's flat faces, one for a face and its opposite.
    pub fn face_axes(&self) -> impl Iterator<Item = Vec3> + use<> {
        let flat = !matches!(self.hull, Hull::Segment { .. });
        self.edge_axes().filter(move |_| flat)
    }

    /// How far the hull reaches from its centre along a unit vector, m: as far on one side as on
    /// the other.
    #[must_use]
    pub fn half_width(&self, n: Vec3) -> f32 {
        let d = self.to_own(n).abs();
        match self.hull {
            Hull::Point => 0.0,
            Hull::Segment { half_height } => d.y * half_height,
            Hull::Box { half_extents } => d.dot(half_extents),
            Hull::Cylinder {
                radius,
                half_height,
            } => (d.x * d.x + d.z * d.z).sqrt() * radius + d.y * half_height,
        }
    }

    /// Radius of the ball about the centre that holds the hull, m.
    #[must_use]
    pub fn reach(&self) -> f32 {
        match self.hull {
            Hull::Point => 0.0,
            Hull::Segment { half_height } => half_height,
            Hull::Box { half_extents } => half_extents.length(),
            Hull::Cylinder {
                radius,
                half_height,
            } => (radius * radius + half_height * half_height).sqrt(),
        }
    }

    // ANCHOR: shrunk
    /// A smaller hull under a skin: the same solid but for its edges and corners, which are
    /// rounded now. The rounded one lies within the sharp one.
    #[must_use]
    pub fn shrunk(&self, share: f32) -> Self {
        let (hull, skin) = match self.hull {
            Hull::Point | Hull::Segment { .. } => (self.hull, 0.0),
            Hull::Box { half_extents } => {
                let skin = share * half_extents.min_element();
                let half_extents = half_extents - skin;
                (Hull::Box { half_extents }, skin)
            }
            Hull::Cylinder {
                radius,
                half_height,
            } => {
                let skin = share * radius.min(half_height);
                let hull = Hull::Cylinder {
                    radius: radius - skin,
                    half_height: half_height - skin,
                };
                (hull, skin)
            }
        };
        Self {
            hull,
            radius: self.radius + skin,
            ..*self
        }
    }
    // ANCHOR_END: shrunk
}

// ANCHOR: vertex
/// A point of the Minkowski difference a − b, which holds the difference of each point of a and
/// each point of b. It holds the origin exactly if the two share a point, and its point nearest to
/// the origin is as far from there as a is from b.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// `on_a` − `on_b`, m.
    pub point: Vec3,
    /// The point of a.
    pub on_a: Vec3,
    /// The point of b.
    pub on_b: Vec3,
}

impl Vertex {
    /// The support point of a − b: a goes as far as it can along `direction`, b against it.
    #[must_use]
    pub fn support(a: &Core, b: &Core, direction: Vec3) -> Self {
        let (on_a, on_b) = (a.support(direction), b.support(-direction));
        Self {
            point: on_a - on_b,
            on_a,
            on_b,
        }
    }
}
// ANCHOR_END: vertex

// ANCHOR: separation
/// How far apart two solids are along the unit vector `normal` from b to a, m; negative by the way
/// that a has to go along it until they touch. Over all normals, the distance is the largest.
#[must_use]
pub fn separation(a: &Core, b: &Core, normal: Vec3) -> f32 {
    let between = (a.centre - b.centre).dot(normal);
    between - a.half_width(normal) - b.half_width(normal) - a.radius - b.radius
}
// ANCHOR_END: separation

/// Rounding of a support point, as a share of [`extent`].
pub const ROUNDING: f32 = 4.0 * f32::EPSILON;

/// How large the coordinates of support points may be, m.
#[must_use]
pub fn extent(a: &Core, b: &Core) -> f32 {
    (a.centre - b.centre).length() + a.reach() + b.reach()
}

/// `size` with the sign of `d`; positive for both zeros.
fn towards(d: f32, size: f32) -> f32 {
    if d < 0.0 { -size } else { size }
}
