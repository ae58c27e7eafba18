//! Features: the corner, edge or face with which a solid meets another one. GJK and EPA find one
//! point where two solids touch, but a box stands on a face.
//!
//! A feature has a number that stays with it while the body moves, so that a contact is known
//! again in the next step.

use glam::Vec3;

use super::list::List;
use super::support_point::{Core, Hull};

/// Corners of the largest feature.
pub const MOST_CORNERS: usize = 8;

/// A cylinder's cap is held by its corners at these angles, which turn with the body. Eight:
/// four of them are enough to stand on, and any four that are spread evenly form a square; and the
/// polygon covers 90 % of the disc, where four would cover 64 %.
const CAP: [(f32, f32); MOST_CORNERS] = {
    const H: f32 = std::f32::consts::FRAC_1_SQRT_2;
    [
        (1.0, 0.0),
        (H, H),
        (0.0, 1.0),
        (-H, H),
        (-1.0, 0.0),
        (-H, -H),
        (0.0, -1.0),
        (H, -H),
    ]
};

/// A cylinder meets with its cap what comes from within 45° of its axis, else with its side.
const CAP_COSINE: f32 = std::f32::consts::FRAC_1_SQRT_2;

/// A point, an edge or a flat polygon of a hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feature {
    corners: List<Vec3, MOST_CORNERS>,
    /// Which feature of its hull it is, less than 16.
    pub id: u32,
}

impl Feature {
    fn new(id: usize, corners: &[Vec3]) -> Self {
        Self {
            corners: List::of(corners),
            id: id as u32,
        }
    }

    /// One corner, two ends, or a polygon's corners, anticlockwise as seen from outside.
    #[must_use]
    pub fn corners(&self) -> &[Vec3] {
        &self.corners
    }

    /// Moves it from the hull's own axes into the pair's.
    fn placed(mut self, core: &Core) -> Self {
        for corner in self.corners.iter_mut() {
            *corner = core.centre + core.axes * *corner;
        }
        self
    }
}

impl Core {
    // ANCHOR: widest_feature
    /// The widest feature that looks along the unit vector `direction`: a box's face, a cylinder's
    /// cap or the line along its side, a capsule's axis, a ball's centre.
    #[must_use]
    pub fn widest_feature(&self, direction: Vec3) -> Feature {
        let d = self.to_own(direction);
        let feature = match self.hull {
            Hull::Point => Feature::new(0, &[Vec3::ZERO]),
            Hull::Segment { half_height } => {
                let end = Vec3::Y * half_height;
                Feature::new(0, &[-end, end])
            }
            Hull::Box { half_extents } => box_face(d, half_extents),
            Hull::Cylinder {
                radius,
                half_height,
            } if d.y.abs() >= CAP_COSINE => cap(d, radius, half_height),
            Hull::Cylinder {
                radius,
                half_height,
            } => side(d, radius, half_height),
        };
        feature.placed(self)
    }
    // ANCHOR_END: widest_feature

    // ANCHOR: edge
    /// The edge that meets what comes from `direction` (a unit vector) at a right angle or nearly
    /// so, if there is one: of a box the edge whose axis is the most sideways, of a cylinder the
    /// line along its side, of a capsule its axis.
    #[must_use]
    pub fn edge(&self, direction: Vec3) -> Option<Feature> {
        let d = self.to_own(direction);
        let (along, feature) = match self.hull {
            Hull::Point => return None,
            Hull::Segment { .. } => (1, self.widest_feature(direction)),
            Hull::Box { half_extents } => {
                let along = d.abs().min_position();
                (along, box_edge(d, along, half_extents).placed(self))
            }
            Hull::Cylinder {
                radius,
                half_height,
            } => (1, side(d, radius, half_height).placed(self)),
        };
        (d[along].abs() <= SIDEWAYS).then_some(feature)
    }
    // ANCHOR_END: edge
}

/// An edge's direction may be off a right angle to the normal by this, rad.
const SIDEWAYS: f32 = 0.02;

/// The face of a box that looks along d. Its number is 2 × axis, and 1 more on the negative side.
fn box_face(d: Vec3, h: Vec3) -> Feature {
    let axis = d.abs().max_position();
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let negative = d[axis] < 0.0;
    let mut corners = [Vec3::ZERO; 4];
    for (corner, (s, t)) in
        corners
            .iter_mut()
            .zip([(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)])
    {
        corner[axis] = if negative { -h[axis] } else { h[axis] };
        corner[u] = if negative { -s } else { s } * h[u];
        corner[v] = t * h[v];
    }
    Feature::new(2 * axis + usize::from(negative), &corners)
}

/// The edge of a box along an axis that reaches furthest along d. Its number is 4 × axis and the
/// sides of the two other axes.
fn box_edge(d: Vec3, axis: usize, h: Vec3) -> Feature {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut corner = Vec3::ZERO;
    corner[u] = if d[u] < 0.0 { -h[u] } else { h[u] };
    corner[v] = if d[v] < 0.0 { -h[v] } else { h[v] };
    let end = Vec3::AXES[axis] * h[axis];
    let id = 4 * axis + 2 * usize::from(d[u] < 0.0) + usize::from(d[v] < 0.0);
    Feature::new(id, &[corner - end, corner + end])
}

/// The cap of a cylinder on the side of d: feature 0 above, 1 below.
fn cap(d: Vec3, radius: f32, half_height: f32) -> Feature {
    let below = d.y < 0.0;
    let y = if below { -half_height } else { half_height };
    // Anticlockwise as seen from above is from z to x.
    let corners = CAP.map(|(c, s)| {
        let z = if below { -c } else { c };
        Vec3::new(radius * s, y, radius * z)
    });
    Feature::new(usize::from(below), &corners)
}

/// The line along a cylinder's side that reaches furthest along d: feature 2.
fn side(d: Vec3, radius: f32, half_height: f32) -> Feature {
    let out = Vec3::new(d.x, 0.0, d.z).normalize_or(Vec3::X) * radius;
    let end = Vec3::Y * half_height;
    Feature::new(2, &[out - end, out + end])
}
