//! GJK: the direction in which two cores that are apart are the nearest to each other.
//!
//! The distance between a and b is the distance of the origin from the Minkowski difference b − a. GJK
//! walks there: it holds a simplex within b − a, takes the simplex's point v that is nearest to the
//! origin, and asks for the support point w of b − a along −v, the furthest beyond v towards the
//! origin. No point of b − a is nearer to the origin than v·w/|v|; where that is |v|, v is the answer.
//! [Gilbert, Johnson and Keerthi 1988; van den Bergen 2003, 4.3]

use glam::Vec3;

use super::core::{Core, rounding, support};
use super::simplex::{simplex_of, take_in};
use crate::norm::Norm;

/// Iterations before GJK gives its best so far. Boxes take a handful, cylinders up to 20.
const MOST_ITERATIONS: u32 = 24;

/// The distance is known where its bounds differ by this share of it.
const TOLERANCE: f32 = 1e-6;

// ANCHOR: gjk
/// The unit vector from a to b, where b is moved by `shift`, along which their cores are the furthest
/// apart; `start` is a guess.
#[must_use]
pub fn gjk(a: &Core, b: &Core, shift: Vec3, start: Vec3) -> Vec3 {
    let rounding = rounding(a, b);
    let mut simplex = simplex_of(difference(a, b, shift, -start));
    let mut highest = 0.0;
    let mut normal = start;
    for _ in 0..MOST_ITERATIONS {
        let v = simplex.nearest;
        let distance = v.norm();
        if distance <= rounding {
            break;
        }
        let w = difference(a, b, shift, -v);
        let at_least = v.dot(w) / distance;
        let is_higher = at_least > highest;
        if is_higher {
            highest = at_least;
            normal = v / distance;
        }
        if distance - at_least <= TOLERANCE * distance + rounding {
            break;
        }
        take_in(&mut simplex, w);
        if simplex.nearest.norm() >= distance && !is_higher {
            break;
        }
    }
    normal
}

/// The support point of b − a: b goes as far as it can along `direction`, a against it.
fn difference(a: &Core, b: &Core, shift: Vec3, direction: Vec3) -> Vec3 {
    support(b, direction) + shift - support(a, -direction)
}
// ANCHOR_END: gjk
