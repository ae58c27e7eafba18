//! The nearest points of a point and a segment, and of two segments: what capsules need.
//! [Ericson 2005, 5.1.2 and 5.1.9]

use glam::Vec3;

/// A segment: its middle, and from there to one of its ends, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Its middle.
    pub centre: Vec3,
    /// From the middle to the end.
    pub half: Vec3,
}

impl Segment {
    /// The point at t, which goes from −1 to 1.
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.centre + t * self.half
    }

    // ANCHOR: nearest_to
    /// Where on the segment, from −1 to 1, the point nearest to `p` is: p's projection, kept
    /// between the ends. A segment without length is its middle.
    #[must_use]
    pub fn nearest_to(&self, p: Vec3) -> f32 {
        let whole = self.half.length_squared();
        if whole > 0.0 {
            ((p - self.centre).dot(self.half) / whole).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    }
    // ANCHOR_END: nearest_to

    // ANCHOR: nearest_points
    /// Where on this segment and on another, from −1 to 1, the points are that are nearest to each
    /// other.
    ///
    /// On two lines that aren't parallel they follow from d·u = d·v = 0, with d between the
    /// points. If one is beyond its end, that end and the point nearest to it are the answer.
    #[must_use]
    pub fn nearest_points(&self, other: &Self) -> (f32, f32) {
        let (u, v) = (self.half, other.half);
        let between = other.centre - self.centre;
        let n = u.cross(v);
        let n2 = n.length_squared();
        let parallel = n2 <= 1e-10 * u.length_squared() * v.length_squared();
        let s = if parallel {
            self.nearest_to(other.centre)
        } else {
            (between.cross(v).dot(n) / n2).clamp(-1.0, 1.0)
        };
        let t = other.nearest_to(self.at(s));
        (self.nearest_to(other.at(t)), t)
    }
    // ANCHOR_END: nearest_points

    // ANCHOR: beside
    /// The part of this segment, from −1 to 1, that lies beside another one: none if their
    /// directions differ by an angle with a larger sine than `parallel`, or one is past the other's
    /// end.
    #[must_use]
    pub fn beside(&self, other: &Self, parallel: f32) -> Option<[f32; 2]> {
        let (u, v) = (self.half, other.half);
        let (u2, v2) = (u.length_squared(), v.length_squared());
        if u.cross(v).length_squared() >= parallel * parallel * u2 * v2 {
            return None;
        }
        let middle = (other.centre - self.centre).dot(u) / u2;
        let reach = (v.dot(u) / u2).abs();
        let from = (middle - reach).max(-1.0);
        let to = (middle + reach).min(1.0);
        (from < to).then_some([from, to])
    }
    // ANCHOR_END: beside
}
