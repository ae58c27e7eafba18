//! Contact points: one point can't hold a box that stands on its face, so a touch has up to four.
//!
//! If the normal is that of a flat face, the other solid's widest feature is clipped to the face,
//! and what is left of it are the points. If two edges run side by side, they share a stretch, and
//! its ends are the points. Else the two solids meet in one point, the one that GJK and EPA found.

use glam::Vec3;

use super::clip::{MOST_POINTS, clip};
use super::features::Feature;
use super::list::List;
use super::segment::Segment;
use super::shortest_way::{ShortestWay, Side, shortest_way, size};
use super::support_point::Core;
use super::{MOST_SPOTS, Placed, Spot, Touch};

/// What reaches beyond a face's side by less than this share of the smaller solid's size is not cut,
/// and points count as equally deep if they differ by less.
pub(super) const SLACK: f32 = 2e-4;

/// A point is taken instead of an earlier one if it is further away by this factor.
const CLEARLY: f32 = 1.001;

// ANCHOR: convex_convex
/// Any two solids; found if the gap between them is at most `margin`, m.
#[must_use]
pub fn convex_convex(a: &Placed, b: &Placed, margin: f32) -> Option<Touch> {
    let origin = b.p;
    let (a, b) = Core::pair(a, b);
    let way = shortest_way(&a, &b, margin)?;
    let mut touch = manifold(&a, &b, &way, margin);
    touch.converged = way.converged;
    touch.move_by(origin);
    Some(touch)
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
    patch.touch(way.normal, margin, slack)
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
    patch.nearest.feature = name | 0xff;
    for point in clip(&other, &face, outward, slack).points() {
        let foot = point.at - outward * outward.dot(point.at - face.corners()[0]);
        let (on_a, on_b) = match side {
            Side::A => (foot, point.at),
            Side::B => (point.at, foot),
        };
        patch.push(spot(a, b, normal, on_a, on_b, name | point.id()));
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
    patch.nearest.feature = name;
    let (edge_a, edge_b) = (segment(&of_a), segment(&of_b));
    let ends = edge_a.beside(&edge_b).into_iter().flatten();
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

/// The points where two solids touch, before four of them are chosen.
pub(super) struct Patch {
    /// Where the two are nearest to each other.
    nearest: Spot,
    spots: List<Spot, { MOST_POINTS + 1 }>,
}

impl Patch {
    /// No more than the point where the two are nearest to each other.
    pub(super) fn new(nearest: Spot) -> Self {
        Self {
            nearest,
            spots: List::default(),
        }
    }

    /// Adds a point.
    pub(super) fn push(&mut self, spot: Spot) {
        self.spots.push(spot);
    }

    // ANCHOR: patch
    /// The touch: points whose gap is at most `margin`, and the nearest point if none of them is as
    /// deep; four of them if there are more.
    pub(super) fn touch(mut self, normal: Vec3, margin: f32, slack: f32) -> Touch {
        self.spots.retain(|spot| spot.depth >= -margin);
        if self.deepest() < self.nearest.depth - slack {
            self.spots.push(self.nearest);
        }
        if self.spots.len() <= MOST_SPOTS {
            return Touch::new(normal, &self.spots);
        }
        let mut four = List::<_, MOST_SPOTS>::default();
        for i in self.four(normal, slack).into_iter().flatten() {
            four.push(self.spots[i]);
        }
        Touch::new(normal, &four)
    }
    // ANCHOR_END: patch

    fn deepest(&self) -> f32 {
        let depths = self.spots.iter().map(|spot| spot.depth);
        depths.fold(f32::NEG_INFINITY, f32::max)
    }

    // ANCHOR: four
    /// Which four points to keep: the deepest, the one furthest from it, the one that makes the
    /// largest triangle with these, and the one that adds most to the triangle. Of points
    /// that are about as good the first stays, so that rounding doesn't change the choice.
    fn four(&self, normal: Vec3, slack: f32) -> [Option<usize>; MOST_SPOTS] {
        let at = |i: usize| self.spots[i].point;
        // Twice the area of a triangle, positive if it is anticlockwise about the normal.
        let area = |i, j, k| (at(j) - at(i)).cross(at(k) - at(i)).dot(normal);
        let deepest = self.deepest();
        let first = (0..self.spots.len()).find(|&i| self.spots[i].depth >= deepest - slack);
        let first = first.unwrap_or(0);
        let second = self.best(|i| (at(i) - at(first)).length_squared());
        let Some(second) = second else {
            return [Some(first), None, None, None];
        };
        let third = self.best(|i| area(first, second, i).abs());
        let Some(third) = third else {
            return [Some(first), Some(second), None, None];
        };
        let turn = area(first, second, third).signum();
        let sides = [(first, second), (second, third), (third, first)];
        let beyond = |i, (from, to)| -turn * area(from, to, i);
        let fourth = self.best(|i| {
            sides
                .map(|side| beyond(i, side))
                .into_iter()
                .fold(0.0, f32::max)
        });
        [Some(first), Some(second), Some(third), fourth]
    }
    // ANCHOR_END: four

    /// The first point whose score none of the others clearly beats; none if no score is positive.
    fn best(&self, score: impl Fn(usize) -> f32) -> Option<usize> {
        let (mut best, mut most) = (None, 0.0);
        for i in 0..self.spots.len() {
            let score = score(i);
            if score > CLEARLY * most {
                (best, most) = (Some(i), score);
            }
        }
        best
    }
}
