//! Two capsules: two balls at the nearest points of their axes. If they lie side by side, nearly
//! parallel, one ball would let them rock, so there are two, at the ends of the stretch that
//! they share.

use glam::Vec3;

use super::manifold::SLACK;
use super::patch::Patch;
use super::segment::Segment;
use super::sphere_capsule::{ON_AXIS, sideways};
use super::{Placed, Spot, Touch};

/// Two capsules lie side by side if the sine of the angle between them is less. Where they are too
/// far from each other at one end, that end is no contact anyway.
const PARALLEL: f32 = 0.2;

// ANCHOR: capsule_capsule
/// Two capsules with radius and half of the axis, m; found if the gap between them is at most
/// `margin`.
#[must_use]
pub fn capsule_capsule(
    a: &Placed,
    (r1, half_1): (f32, f32),
    b: &Placed,
    (r2, half_2): (f32, f32),
    margin: f32,
) -> Option<Touch> {
    // Seen from b's centre, where differences keep their digits.
    let axis_1 = Segment {
        centre: a.p - b.p,
        half: a.q * Vec3::Y * half_1,
    };
    let axis_2 = Segment {
        centre: Vec3::ZERO,
        half: b.q * Vec3::Y * half_2,
    };
    let (s, t) = axis_1.nearest_points(&axis_2);
    let between = axis_1.at(s) - axis_2.at(t);
    let distance = between.length();
    if distance > r1 + r2 + margin {
        return None;
    }
    let normal = if distance > ON_AXIS * (half_1 + half_2) {
        between / distance
    } else {
        way_out(&axis_1, &axis_2, a.q * Vec3::Y)
    };
    // ANCHOR: spots
    let spot = |s, feature| {
        let on_1 = axis_1.at(s);
        let on_2 = axis_2.at(axis_2.nearest_to(on_1));
        let depth = r1 + r2 - on_1.distance(on_2);
        let way = (on_1 - on_2).normalize_or(normal);
        Spot {
            point: b.p + on_2 + way * (r2 - 0.5 * depth),
            depth,
            feature,
        }
    };
    let mut patch = Patch::new(spot(s, 0));
    let ends = axis_1.beside(&axis_2, PARALLEL).into_iter().flatten();
    for (feature, s) in (1..).zip(ends) {
        patch.push(spot(s, feature));
    }
    Some(patch.touch(normal, margin, SLACK * (r1 + r2)))
    // ANCHOR_END: spots
}
// ANCHOR_END: capsule_capsule

// ANCHOR: crossing
/// The way out where two axes cross: at a right angle to both, to the side of the first one's
/// centre; if they are parallel, sideways.
fn way_out(axis_1: &Segment, axis_2: &Segment, up: Vec3) -> Vec3 {
    let n = axis_1.half.cross(axis_2.half);
    let normal = n.try_normalize().unwrap_or_else(|| sideways(up));
    let side = (axis_1.centre - axis_2.centre).dot(normal);
    if side < 0.0 { -normal } else { normal }
}
// ANCHOR_END: crossing
