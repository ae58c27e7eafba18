//! Any two bodies that aren't balls, from a first direction to the row of points.

use glam::Vec3;

use super::axis::{Way, best_axis};
use super::contacts::contacts;
use super::core::{BOX, Core, reach, slack, support, thin};
use super::features::{EDGE, face_towards, stands_on_face};
use super::spots::{Spots, add_spot, finished, no_spots};
use super::way::push_apart;
use crate::rows::{FIXED, Manifold};

/// The name of a point where bodies are the deepest in each other, if no feature has it.
const DEEPEST: u32 = 4 << 16;

/// A body is pierced where it overlaps by more than this share of its smallest half extent.
const SHALLOW: f32 = 0.5;

/// A normal is taken to stand on a face if it leans by less, rad.
const LEANING: f32 = 0.03;

// ANCHOR: convex_convex
/// Where a and b meet, by the likely directions first. The best of these is the answer for boxes that
/// overlap.
#[must_use]
pub fn convex_convex(a: &Core, b: &Core, margin: f32) -> Manifold {
    let way = best_axis(a, b);
    let is_known = a.kind == BOX && b.kind == BOX && way.apart < 0.0;
    meet(a, b, way, is_known, margin)
}
// ANCHOR_END: convex_convex

// ANCHOR: meet
/// Where a and b meet along `first`. If it isn't known to be the best way, then only if points lie opposite
/// each other along it that are as near as the bodies are: no direction near it can do better then. A
/// body that is pierced may be left by a quite different one.
#[must_use]
pub fn meet(a: &Core, b: &Core, first: Way, is_known: bool, margin: f32) -> Manifold {
    let slack = slack(a, b);
    let mut way = first;
    let mut spots = no_spots(way.normal, FIXED, 0.0);
    for i in 0..3 {
        if way.apart > margin {
            return Manifold::default();
        }
        let is_last = i == 2 || (is_known && i == 1);
        let tried = if is_last { way } else { settled(a, b, way) };
        spots = contacts(a, b, tried, margin);
        let is_there = spots.least <= way.apart + a.round + b.round + slack;
        let is_shallow = way.apart > -SHALLOW * thin(a).min(thin(b));
        if is_last || (is_there && (is_shallow || is_known || i == 1)) {
            break;
        }
        if !is_known && i == 0 {
            way = push_apart(a, b, way);
        }
    }
    add_deepest(&mut spots, a, b, way, slack);
    finished(a, b, &spots, slack)
}
// ANCHOR_END: meet

// ANCHOR: settled
/// The same way, with a normal that stands on a face if it nearly does: the larger body's before the
/// other's.
///
/// Faces that are tilted to each other touch where an edge of one crosses an edge of the other, and the
/// normal there is a little off both. One point can't hold a face; along the face's normal there are up
/// to four, and the gaps there are wrong only by the square of the tilt.
fn settled(a: &Core, b: &Core, way: Way) -> Way {
    let of_a = face_towards(a, way.normal);
    let of_b = face_towards(b, -way.normal);
    let is_on_a = of_a.shape != EDGE && is_near(of_a.normal, way.normal);
    let is_on_b = of_b.shape != EDGE && is_near(of_b.normal, -way.normal);
    let mut normal = way.normal;
    if is_on_a && (reach(a) > reach(b) || !is_on_b) {
        normal = of_a.normal;
    } else if is_on_b {
        normal = -of_b.normal;
    }
    Way {
        normal,
        apart: way.apart,
    }
}

fn is_near(one: Vec3, other: Vec3) -> bool {
    one.cross(other).length_squared() < LEANING * LEANING
}
// ANCHOR_END: settled

/// Adds the point where the two are the nearest or deepest, if no other is as near but for `slack`, m.
fn add_deepest(spots: &mut Spots, a: &Core, b: &Core, way: Way, slack: f32) {
    let gap = way.apart + a.round + b.round;
    let mut nearest = spots.limit;
    for k in 0..spots.count as usize {
        nearest = nearest.min(spots.at[k].w);
    }
    if spots.count > 0 && nearest <= gap + slack {
        return;
    }
    let mut on_a = support(a, way.normal);
    if stands_on_face(a, way.normal) {
        on_a = support(b, -way.normal) - gap * way.normal;
    }
    add_spot(spots, on_a, gap, DEEPEST);
}
