//! A capsule and another one, or a box: the nearest points in closed form, then as for all others.

use glam::Vec3;

use super::axis::{Way, best_axis};
use super::ball::SAME;
use super::convex::meet;
use super::core::{Core, HUGE, TINY, extent, separation, slack, to_own, with_sign};
use super::edges::{Meeting, along, edges_meet, nearest_points};
use super::features::edge_towards;
use super::spots::{finished, no_spots};
use crate::norm::Norm;
use crate::rows::{Manifold, ROUND};

/// Nearer than this share of the coordinates the direction between two points is mostly rounding.
const VAGUE: f32 = 1e-4;

// ANCHOR: capsule_capsule
/// Two capsules: two balls where their segments are the nearest. If they lie side by side, one ball would
/// let them rock, so there are two, at the ends of the stretch that they share.
#[must_use]
pub fn capsule_capsule(a: &Core, b: &Core, margin: f32) -> Manifold {
    let of_a = edge_towards(a, Vec3::Y);
    let of_b = edge_towards(b, Vec3::Y);
    let near = nearest_points(&of_a, &of_b, Vec3::ZERO);
    let between = along(&of_b, near.y) - along(&of_a, near.x);
    let distance = between.norm();
    let rounds = a.round + b.round;
    if distance > rounds + margin {
        return Manifold::default();
    }
    let mut normal = between / distance.max(TINY);
    let across = way_out(a, b);
    if distance < SAME * extent(a, b) || separation(a, b, across) > separation(a, b, normal) {
        normal = across;
    }
    let mut spots = no_spots(normal, ROUND, rounds + margin);
    let meeting = Meeting {
        gap: separation(a, b, normal) + rounds,
        push: 0.0,
        round_a: a.round,
        round_b: b.round,
        slack: slack(a, b),
    };
    edges_meet(&mut spots, &of_a, &of_b, &meeting);
    finished(a, b, &spots, meeting.slack)
}

/// The way out where two segments cross or nearly do: at a right angle to both; if they are parallel,
/// sideways.
fn way_out(a: &Core, b: &Core) -> Vec3 {
    let across = a.axes.y_axis.cross(b.axes.y_axis);
    let sine = across.norm();
    let mut normal = a.axes.x_axis;
    if sine > 1e-3 {
        normal = across / sine;
    }
    if normal.dot(b.centre - a.centre) < 0.0 {
        -normal
    } else {
        normal
    }
}
// ANCHOR_END: capsule_capsule

// ANCHOR: box_capsule
/// A box and a capsule. Where the segment goes through the box, the best direction across faces and edges
/// is the way out.
#[must_use]
pub fn box_capsule(a: &Core, b: &Core, margin: f32) -> Manifold {
    let centre = to_own(a, b.centre);
    let along = to_own(a, b.axes.y_axis);
    let p = centre + nearest_to_box(centre, along, b.half.y, a.half) * along;
    let between = p - p.clamp(-a.half, a.half);
    let distance = between.norm();
    if distance > b.round + margin {
        return Manifold::default();
    }
    let way = if distance > VAGUE * extent(a, b) {
        Way {
            normal: a.axes * (between / distance),
            apart: distance - b.round,
        }
    } else {
        best_axis(a, b)
    };
    meet(a, b, way, true, margin)
}
// ANCHOR_END: box_capsule

// ANCHOR: nearest_to_box
/// Where on the segment `centre` + t `along`, with |t| ≤ `reach`, the point nearest to a box is, m.
///
/// The squared distance is convex in t, and half its slope is Σ eᵢ uᵢ, with e what p reaches beyond
/// the box: straight pieces between the six planes of the faces. So it is 0 between the last place where
/// it is negative and the first where it is positive; and on a stretch within the box.
#[must_use]
pub fn nearest_to_box(centre: Vec3, along: Vec3, reach: f32, half: Vec3) -> f32 {
    let mut low = -reach;
    let mut high = reach;
    let mut flat_low = HUGE;
    let mut flat_high = -HUGE;
    for i in 0..8 {
        let t = bend(i, centre, along, half).clamp(-reach, reach);
        let slope = slope(centre + t * along, along, half);
        if slope < 0.0 {
            low = low.max(t);
        } else if slope > 0.0 {
            high = high.min(t);
        } else {
            flat_low = flat_low.min(t);
            flat_high = flat_high.max(t);
        }
    }
    if flat_low <= flat_high {
        return 0.5 * (flat_low + flat_high);
    }
    let at_low = slope(centre + low * along, along, half);
    let at_high = slope(centre + high * along, along, half);
    if at_low >= 0.0 {
        return low;
    }
    if at_high <= 0.0 {
        return high;
    }
    low - at_low * (high - low) / (at_high - at_low)
}

/// Where the line goes through plane i of the box's six; beyond its ends for the last two.
fn bend(i: u32, centre: Vec3, along: Vec3, half: Vec3) -> f32 {
    let side = if i & 1 == 0 { -1.0 } else { 1.0 };
    if i < 2 {
        return through(side * half.x - centre.x, along.x);
    }
    if i < 4 {
        return through(side * half.y - centre.y, along.y);
    }
    if i < 6 {
        return through(side * half.z - centre.z, along.z);
    }
    side * HUGE
}

/// way / speed, or far away.
fn through(way: f32, speed: f32) -> f32 {
    if speed.abs() < 1e-9 {
        with_sign(1e9, way)
    } else {
        way / speed
    }
}

/// Half the slope of the squared distance from a box along a line through p.
fn slope(p: Vec3, along: Vec3, half: Vec3) -> f32 {
    (p - p.clamp(-half, half)).dot(along)
}
// ANCHOR_END: nearest_to_box
