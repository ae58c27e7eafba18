//! How deep two solids overlap, exactly: the shortest way that parts them.
//!
//! A sphere or capsule is a segment (a point) with a radius. So every pair here is a
//! distance from a segment to a segment, a point or a box, less the radii; and where a
//! segment runs through a box, the separating axes of the two decide [Ericson 2005,
//! sections 5.1.9 and 5.2.1]. Two boxes are in `boxes.rs`.

use glam::{DQuat, DVec3};

use super::boxes::box_depth;
use crate::{Scene, Shape, State};

/// A solid somewhere in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The solid.
    pub shape: Shape,
    /// World position of its origin, m.
    pub position: DVec3,
    /// Body to world.
    pub orientation: DQuat,
}

impl Placed {
    /// Body `i` of a scene, where `state` has it.
    #[must_use]
    pub fn new(scene: &Scene, state: &State, i: usize) -> Self {
        Self {
            shape: scene.bodies[i].shape,
            position: state.position[i],
            orientation: state.orientation[i],
        }
    }
}

/// Points within `radius` of a segment from `centre` − `half` to `centre` + `half`.
#[derive(Clone, Copy)]
struct Round {
    centre: DVec3,
    half: DVec3,
    radius: f64,
}

/// How deep a and b overlap, m: the length of the shortest shift that parts them. At most
/// 0 where they don't touch, and then minus their distance, of which two boxes may give
/// less. `None` for cylinders.
#[must_use]
pub fn depth(a: &Placed, b: &Placed) -> Option<f64> {
    match (round(a), round(b)) {
        (Some(a), Some(b)) => Some(a.radius + b.radius - segment_distance(&a, &b)),
        (Some(a), None) => in_box(&a, b),
        (None, Some(b)) => in_box(&b, a),
        (None, None) => box_depth(a, b),
    }
}

fn round(solid: &Placed) -> Option<Round> {
    let (radius, half_height) = match solid.shape {
        Shape::Sphere { radius } => (radius, 0.0),
        Shape::Capsule {
            radius,
            half_height,
        } => (radius, half_height),
        Shape::Box { .. } | Shape::Cylinder { .. } => return None,
    };
    Some(Round {
        centre: solid.position,
        half: solid.orientation * DVec3::new(0.0, half_height, 0.0),
        radius,
    })
}

/// Smallest |d + s u − t v| over −1 ≤ s, t ≤ 1, where d joins the centres and u, v are the
/// half-segments [Ericson 2005, section 5.1.9, there with 0 ≤ s, t ≤ 1].
fn segment_distance(a: &Round, b: &Round) -> f64 {
    let (u, v, d) = (a.half, b.half, a.centre - b.centre);
    let (uu, uv, vv) = (u.dot(u), u.dot(v), v.dot(v));
    let (ud, vd) = (u.dot(d), v.dot(d));
    let best_s = |t: f64| clamped_ratio(t * uv - ud, uu);
    let best_t = |s: f64| clamped_ratio(s * uv + vd, vv);
    // Of parallel segments any s will do, as t and then s follow.
    let determinant = uu * vv - uv * uv;
    let s = if determinant > 1e-12 * uu * vv {
        ((uv * vd - ud * vv) / determinant).clamp(-1.0, 1.0)
    } else {
        0.0
    };
    let t = best_t(s);
    let s = best_s(t);
    (d + s * u - t * v).length()
}

/// `numerator / denominator` within −1 … 1; 0 for the point-like segment of 0 / 0.
fn clamped_ratio(numerator: f64, denominator: f64) -> f64 {
    if denominator > 0.0 {
        (numerator / denominator).clamp(-1.0, 1.0)
    } else {
        0.0
    }
}

/// Depth of a round solid in a box; `None` if the other solid is none.
fn in_box(round: &Round, solid: &Placed) -> Option<f64> {
    let Shape::Box { half_extents } = solid.shape else {
        return None;
    };
    let to_box = solid.orientation.conjugate();
    let centre = to_box * (round.centre - solid.position);
    let half = to_box * round.half;
    let distance = distance_to_box(centre, half, half_extents);
    // Where the segment meets the box, rounding may leave a distance of some 1e-17 m.
    let rounding = 1e-12 * (centre.length() + half.length() + half_extents.length());
    if distance > rounding {
        return Some(round.radius - distance);
    }
    Some(round.radius + way_out_of_box(centre, half, half_extents))
}

/// Distance from the segment to a box about the origin; 0 if they meet.
///
/// The squared distance at `centre` + t `half` is convex in t, and its slope is linear
/// between the places where the segment crosses the planes of the faces: the zero of the
/// slope is found between two of those.
fn distance_to_box(centre: DVec3, half: DVec3, extents: DVec3) -> f64 {
    let outside = |t: f64| {
        let p = centre + t * half;
        p - p.clamp(-extents, extents)
    };
    let slope = |t: f64| outside(t).dot(half);
    let mut low = (-1.0, slope(-1.0));
    if low.1 >= 0.0 {
        return outside(low.0).length();
    }
    for t in face_crossings(centre, half, extents) {
        let high = (t, slope(t));
        if high.1 >= 0.0 {
            let t = low.0 + (high.0 - low.0) * -low.1 / (high.1 - low.1);
            return outside(t).length();
        }
        low = high;
    }
    outside(1.0).length()
}

/// Where within −1 < t ≤ 1 the segment crosses the planes of the box's faces, and its end,
/// in ascending order.
fn face_crossings(centre: DVec3, half: DVec3, extents: DVec3) -> [f64; 7] {
    let low = (-extents - centre) / half;
    let high = (extents - centre) / half;
    let mut crossings = [low.x, low.y, low.z, high.x, high.y, high.z, 1.0];
    for t in &mut crossings {
        // Also where the segment runs along a face and the quotient is no number.
        if !(-1.0..=1.0).contains(t) {
            *t = 1.0;
        }
    }
    crossings.sort_by(f64::total_cmp);
    crossings
}

/// The shortest shift that takes a segment which meets a box about the origin out of it.
///
/// Box and segment span a polyhedron of shifts under which they meet; its faces are
/// perpendicular to an axis of the box or to one of those and the segment.
fn way_out_of_box(centre: DVec3, half: DVec3, extents: DVec3) -> f64 {
    let along = |n: DVec3| n.abs().dot(extents) + half.dot(n).abs() - centre.dot(n).abs();
    let axes = DVec3::AXES.into_iter();
    let faces = axes.clone().map(along);
    let edges = axes
        .filter_map(|axis| axis.cross(half).try_normalize())
        .map(along);
    faces.chain(edges).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
