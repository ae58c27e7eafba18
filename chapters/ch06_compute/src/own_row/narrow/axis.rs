//! Directions in which two bodies are likely to be far apart: across their faces, across an edge of each,
//! from centre to centre, and straight out from a cylinder's axis. Among the first two kinds is always the shortest way out of
//! each other for two boxes. [Gottschalk, Lin and Manocha 1996]

use glam::Vec3;

use super::core::{BOX, CAPSULE, CYLINDER, Core, HUGE, TINY, reach, separation, slack};
use crate::norm::Norm;

/// The sine of an angle between edges below which they have no direction across them, squared.
const PARALLEL2: f32 = 1e-6;

/// A direction in which two bodies could part.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// Unit vector from a to b.
    pub normal: Vec3,
    /// How far apart they are along it, m; negative if they overlap.
    pub apart: f32,
}

/// How many directions [`candidate`] has.
const CANDIDATES: u32 = 18;

// ANCHOR: best_axis
/// The direction along which the two are the furthest apart. Faces come first, those of the larger body
/// before the other's; something else has to be clearly better, or a tremor would change the normal.
#[must_use]
pub fn best_axis(a: &Core, b: &Core) -> Way {
    let slack = slack(a, b);
    let between = b.centre - a.centre;
    let a_is_larger = reach(a) > reach(b);
    let mut best = Way {
        normal: Vec3::Y,
        apart: -HUGE,
    };
    let mut least = -HUGE;
    for i in 0..CANDIDATES {
        if i == 3 || i == 6 || i == 15 {
            least = best.apart + slack;
        }
        let axis = candidate(a, b, a_is_larger, i);
        let squared = axis.length_squared();
        if squared < PARALLEL2 {
            continue;
        }
        let mut normal = axis / squared.sqrt();
        if normal.dot(between) < 0.0 {
            normal = -normal;
        }
        let apart = separation(a, b, normal);
        if apart > best.apart && apart > least {
            best = Way { normal, apart };
        }
    }
    best
}
// ANCHOR_END: best_axis

// ANCHOR: candidate
/// The direction with number i, or none: 0 to 2 across the larger body's faces, 3 to 5 across the other's,
/// 6 to 14 across an edge of each, 15 from centre to centre, 16 and 17 straight out from the axis of a
/// cylinder.
fn candidate(a: &Core, b: &Core, a_is_larger: bool, i: u32) -> Vec3 {
    if i < 6 {
        let of_a = (i < 3) == a_is_larger;
        return if of_a {
            face_axis(a, i % 3)
        } else {
            face_axis(b, i % 3)
        };
    }
    if i < 15 {
        return edge_axis(a, i / 3 - 2).cross(edge_axis(b, i % 3));
    }
    let between = b.centre - a.centre;
    if i == 16 {
        return off_axis(a, between);
    }
    if i == 17 {
        return off_axis(b, between);
    }
    between / between.norm().max(TINY)
}

/// The normal of face i of three, or none.
fn face_axis(core: &Core, i: u32) -> Vec3 {
    if core.kind == CAPSULE {
        return Vec3::ZERO;
    }
    edge_axis(core, i)
}

/// The direction of edge i of three, or none: a cylinder and a capsule have the second one.
fn edge_axis(core: &Core, i: u32) -> Vec3 {
    if i == 1 {
        return core.axes.y_axis;
    }
    if core.kind != BOX {
        return Vec3::ZERO;
    }
    if i == 0 {
        core.axes.x_axis
    } else {
        core.axes.z_axis
    }
}

/// The unit vector along the part of a direction that is at a right angle to a cylinder's axis; any, if
/// there is none.
fn off_axis(core: &Core, direction: Vec3) -> Vec3 {
    if core.kind != CYLINDER {
        return Vec3::ZERO;
    }
    let off = direction - direction.dot(core.axes.y_axis) * core.axes.y_axis;
    let length = off.norm();
    if length > 1e-6 * reach(core) {
        off / length
    } else {
        core.axes.x_axis
    }
}
// ANCHOR_END: candidate
