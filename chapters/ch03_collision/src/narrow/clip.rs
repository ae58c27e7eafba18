//! Clipping: what of one solid's feature lies over a face of the other, by cutting it with the
//! plane on each of the face's sides. [Sutherland and Hodgman 1974]
//!
//! A point that is left is named by the corner of the feature that is nearest to it along the edge
//! that was cut. So equal boxes in a stack keep four names while they tremble to this side and that
//! of being aligned.

use glam::Vec3;

use super::features::{Feature, MOST_CORNERS};
use super::list::List;

/// Points after clipping: each side of the face can add one.
pub const MOST_POINTS: usize = 2 * MOST_CORNERS;

/// A point of what is left.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Where it is, m.
    pub at: Vec3,
    /// The feature's corner that it is or was.
    pub corner: u32,
}

/// What is left of a feature.
#[derive(Clone, Copy, Debug)]
pub struct Clipped {
    points: List<Point, MOST_POINTS>,
    /// A polygon, not a segment.
    closed: bool,
}

// ANCHOR: clip
/// The part of `feature` that lies over the polygon `face` with the unit normal `normal`, or beyond
/// its sides by at most `slack`, m.
#[must_use]
pub fn clip(feature: &Feature, face: &Feature, normal: Vec3, slack: f32) -> Clipped {
    let mut left = Clipped::whole(feature);
    let corners = face.corners();
    for (i, &from) in corners.iter().enumerate() {
        let to = corners[(i + 1) % corners.len()];
        let inward = normal.cross(to - from).normalize_or_zero();
        left.cut(from - slack * inward, inward);
    }
    left
}
// ANCHOR_END: clip

impl Clipped {
    /// A whole feature.
    fn whole(feature: &Feature) -> Self {
        let mut points = List::default();
        for (corner, &at) in (0..).zip(feature.corners()) {
            points.push(Point { at, corner });
        }
        Self {
            points,
            closed: feature.corners().len() > 2,
        }
    }

    /// Its corners, or ends.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    // ANCHOR: cut
    /// Takes away what lies behind the plane through `foot` with the normal `inward`.
    fn cut(&mut self, foot: Vec3, inward: Vec3) {
        let height = |point: &Point| inward.dot(point.at - foot);
        if self.points.iter().all(|point| height(point) >= 0.0) {
            return;
        }
        let mut left = List::default();
        let mut last = self.points[self.points.len() - 1];
        let mut before = height(&last);
        for (i, &point) in self.points.iter().enumerate() {
            let here = height(&point);
            if (before < 0.0) != (here < 0.0) && (i > 0 || self.closed) {
                let t = before / (before - here);
                let at = last.at + (point.at - last.at) * t;
                let corner = if t < 0.5 { last.corner } else { point.corner };
                left.push_if_room(Point { at, corner });
            }
            if here >= 0.0 {
                left.push_if_room(point);
            }
            (last, before) = (point, here);
        }
        self.points = left;
    }
    // ANCHOR_END: cut
}
