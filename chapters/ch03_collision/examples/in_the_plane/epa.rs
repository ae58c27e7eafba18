//! Exercise 2 of the page on EPA: EPA in the plane. A polygon instead of a polytope, edges instead of faces, and
//! no hole to patch: a new point goes between the two ends of the edge that it was found from.

use ch03_collision::narrow::support_point::{Core, Vertex};
use glam::Vec3;

/// What one iteration looked at.
pub struct Look {
    /// Anticlockwise.
    pub polygon: Vec<Vertex>,
    /// The place of the corner where the nearest edge begins.
    pub nearest: usize,
    /// Its outward normal.
    pub normal: Vec3,
    /// How far the origin is behind it, m: the depth is no less.
    pub distance: f32,
    /// The support point along the normal.
    pub support: Vertex,
}

impl Look {
    /// The depth is no more, m.
    pub fn at_most(&self) -> f32 {
        self.support.point.dot(self.normal)
    }
}

// ANCHOR: epa_in_the_plane
/// All iterations, from a triangle that holds the origin.
pub fn epa(a: &Core, b: &Core, triangle: &[Vertex]) -> Vec<Look> {
    let mut polygon = triangle.to_vec();
    let [p, q, r] = [0, 1, 2].map(|i| polygon[i].point);
    if (q - p).cross(r - p).z < 0.0 {
        polygon.swap(0, 1);
    }
    let mut looks = Vec::new();
    loop {
        let look = look(a, b, &polygon);
        let is_known = look.at_most() - look.distance < 1e-5;
        if !is_known {
            polygon.insert(look.nearest + 1, look.support);
        }
        looks.push(look);
        if is_known {
            return looks;
        }
    }
}

/// The edge that is nearest to the origin, and what lies beyond it.
fn look(a: &Core, b: &Core, polygon: &[Vertex]) -> Look {
    let edge = |i: usize| {
        let (from, to) = (polygon[i].point, polygon[(i + 1) % polygon.len()].point);
        let normal = (to - from).cross(Vec3::Z).normalize();
        (i, normal, normal.dot(from))
    };
    let edges = (0..polygon.len()).map(edge);
    let nearest = edges.min_by(|one, other| one.2.total_cmp(&other.2));
    let (nearest, normal, distance) = nearest.expect("a polygon has edges");
    Look {
        polygon: polygon.to_vec(),
        nearest,
        normal,
        distance,
        support: Vertex::support(a, b, normal),
    }
}
// ANCHOR_END: epa_in_the_plane
