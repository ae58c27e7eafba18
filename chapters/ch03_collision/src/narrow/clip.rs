//! Clipping: what of one solid's feature lies over a face of the other, by cutting it with the plane
//! on each of the face's sides. [Sutherland and Hodgman 1974]
//!
//! A point is named by the two edges that meet there: edges of the feature that was cut, or the
//! cuts. The names stay the same from step to step as long as the same things meet.

use glam::Vec3;

use super::features::{Feature, MOST_CORNERS};
use super::list::List;

/// Corners after clipping: each side of the face can add one.
pub const MOST_POINTS: usize = 2 * MOST_CORNERS;

/// A corner of what is left.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Where it is, m.
    pub at: Vec3,
    /// The edge that ends here: 0 to 7 the feature's own, from 8 the cut at a side of the face.
    edge_in: u32,
    /// The edge that begins here.
    edge_out: u32,
}

impl Point {
    /// Its name: less than 256.
    #[must_use]
    pub fn id(&self) -> u32 {
        self.edge_in << 4 | self.edge_out
    }
}

/// What is left of a feature.
#[derive(Clone, Copy, Debug)]
pub struct Clipped {
    points: List<Point, MOST_POINTS>,
    /// A polygon, not a segment.
    closed: bool,
}

impl Clipped {
    /// A whole feature.
    fn whole(feature: &Feature) -> Self {
        let corners = feature.corners();
        let last = corners.len() as u32 - 1;
        let mut points = List::default();
        for (i, &at) in (0..).zip(corners) {
            points.push(Point {
                at,
                edge_in: if i == 0 { last } else { i - 1 },
                edge_out: i,
            });
        }
        Self {
            points,
            closed: corners.len() > 2,
        }
    }

    /// Its corners.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    // ANCHOR: cut
    /// Takes away what lies behind the plane through `foot`, whose normal is `inward`.
    fn cut(&mut self, foot: Vec3, inward: Vec3, edge: u32) {
        let height = |point: &Point| inward.dot(point.at - foot);
        if self.points.iter().all(|point| height(point) >= 0.0) {
            return;
        }
        let mut left = List::default();
        let mut keep = |point| {
            // A polygon that is a little out of plane could be cut more often than a flat one.
            if !left.is_full() {
                left.push(point);
            }
        };
        let mut last = self.points[self.points.len() - 1];
        let mut before = height(&last);
        for (i, &point) in self.points.iter().enumerate() {
            let here = height(&point);
            let enters = before < 0.0 && here >= 0.0;
            let leaves = before >= 0.0 && here < 0.0;
            if (enters || leaves) && (i > 0 || self.closed) {
                keep(Point {
                    at: last.at + (point.at - last.at) * (before / (before - here)),
                    edge_in: if enters { edge } else { last.edge_out },
                    edge_out: if enters { point.edge_in } else { edge },
                });
            }
            if here >= 0.0 {
                keep(point);
            }
            (last, before) = (point, here);
        }
        self.points = left;
    }
    // ANCHOR_END: cut
}

// ANCHOR: clip
/// The part of `feature` that lies over the polygon `face` with the unit normal `normal`, or beyond its
/// sides by at most `slack`, m.
#[must_use]
pub fn clip(feature: &Feature, face: &Feature, normal: Vec3, slack: f32) -> Clipped {
    let mut left = Clipped::whole(feature);
    let corners = face.corners();
    for (i, &from) in corners.iter().enumerate() {
        let to = corners[(i + 1) % corners.len()];
        let inward = normal.cross(to - from).normalize_or_zero();
        left.cut(from - slack * inward, inward, (MOST_CORNERS + i) as u32);
    }
    left
}
// ANCHOR_END: clip
