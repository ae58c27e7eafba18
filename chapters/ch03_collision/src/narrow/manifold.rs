//! Contact points: one point can't hold a box that stands on its face, so a touch has up to four.
//!
//! If the normal is that of a flat face, the other solid's widest feature is clipped to the face,
//! and what is left of it are the points. If two edges run side by side, they share a stretch, and
//! its ends are the points. Else the two solids meet in one point, the one that GJK and EPA found.

use glam::Vec3;

use super::clip::clip;
use super::features::Feature;
use super::patch::Patch;
use super::segment::Segment;
use super::shortest_way::{ShortestWay, Side, shortest_way, size};
use super::support_point::Core;
use super::way_back::way_back;
use super::{Placed, Spot, Touch};

/// What reaches beyond a face's side by less than this share of the smaller solid's size is not
/// cut, and points count as equally deep if they differ by less: a tremor must not change which
/// points there are.
pub(super) const SLACK: f32 = 5e-4;

/// Edges run side by side if the sine of the angle between them is less.
const PARALLEL: f32 = 0.02;

// ANCHOR: convex_convex
/// Any two solids; found if the gap between them is at most `margin`, m.
#[must_use]
pub fn convex_convex(a: &Placed, b: &Placed, margin: f32) -> Option<Touch> {
    let (core_a, core_b) = Core::pair(a, b);
    let way = shortest_way(&core_a, &core_b, margin)?;
    let way = way_back(a, b, (&core_a, &core_b), way);
    Some(manifold(&core_a, &core_b, &way, margin).moved_by(b.p))
}
// ANCHOR_END: convex_convex

// ANCHOR: manifold
/// The contact points of two solids that part soonest along `way`, those with a gap of at most
/// `margin`, m.
#[must_use]
pub fn manifold(a: &Core, b: &Core, way: &ShortestWay, margin: f32) -> Touch {
    let slack = SLACK * size(a, b);
    let mut patch = Patch::new(Spot {
        point: way.point,
        depth: -way.separation,
        feature: 0,
    });
    match way.face {
        Some(side) => over_face(a, b, way.normal, side, slack, &mut patch),
        None => along_edges(a, b, way.normal, &mut patch),
    }
    let mut touch = patch.touch(way.normal, margin, slack);
    touch.converged = way.converged;
    touch
}
// ANCHOR_END: manifold

// ANCHOR: over_face
/// Clips the other solid's widest feature to the face on whose normal the way stands.
fn over_face(a: &Core, b: &Core, normal: Vec3, side: Side, slack: f32, patch: &mut Patch) {
    let (of_a, of_b) = (a.widest_feature(-normal), b.widest_feature(normal));
    let (face, other, outward, tag) = match side {
        Side::A => (of_a, of_b, -normal, 1),
        Side::B => (of_b, of_a, normal, 2),
    };
    let name = tag << 16 | face.id << 12 | other.id << 8;
    patch.name_nearest(name | 0xff);
    for point in clip(&other, &face, outward, slack).points() {
        let foot = point.at - outward * outward.dot(point.at - face.corners()[0]);
        let (on_a, on_b) = match side {
            Side::A => (foot, point.at),
            Side::B => (point.at, foot),
        };
        patch.push(spot(a, b, normal, on_a, on_b, name | point.corner));
    }
}
// ANCHOR_END: over_face

// ANCHOR: along_edges
/// Two edges that run side by side touch along the stretch that they share, others in a point.
fn along_edges(a: &Core, b: &Core, normal: Vec3, patch: &mut Patch) {
    let (Some(of_a), Some(of_b)) = (a.edge(-normal), b.edge(normal)) else {
        return;
    };
    let name = 3 << 16 | of_a.id << 12 | of_b.id << 8;
    patch.name_nearest(name);
    let (edge_a, edge_b) = (segment(&of_a), segment(&of_b));
    let ends = edge_a.beside(&edge_b, PARALLEL).into_iter().flatten();
    for (end, s) in (1..).zip(ends) {
        let on_a = edge_a.at(s);
        let on_b = edge_b.at(edge_b.nearest_to(on_a));
        patch.push(spot(a, b, normal, on_a, on_b, name | end));
    }
}
// ANCHOR_END: along_edges

fn segment(edge: &Feature) -> Segment {
    let corners = edge.corners();
    Segment {
        centre: 0.5 * (corners[0] + corners[1]),
        half: 0.5 * (corners[1] - corners[0]),
    }
}

/// The contact point between two points of the hulls.
fn spot(a: &Core, b: &Core, normal: Vec3, on_a: Vec3, on_b: Vec3, feature: u32) -> Spot {
    let on_a = on_a - a.radius * normal;
    let on_b = on_b + b.radius * normal;
    Spot {
        point: 0.5 * (on_a + on_b),
        depth: (on_b - on_a).dot(normal),
        feature,
    }
}
