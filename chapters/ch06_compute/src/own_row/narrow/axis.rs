//! Directions in which two bodies are likely to be far apart: across their faces, across an edge of each,
//! from centre to centre, and straight out from a cylinder's axis. Among the first two kinds is always the shortest way out of
//! each other for two boxes. [Gottschalk, Lin and Manocha 1996]

use glam::Vec3;

use super::core::{BOX, CYLINDER, Core, HUGE, TINY, reach, separation, slack};

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

// ANCHOR: best_axis
/// The direction along which the two are the furthest apart. Faces come first, those of the larger body
/// before the other's; something else has to be clearly better, or a tremor would change the normal.
#[must_use]
pub fn best_axis(a: &Core, b: &Core) -> Way {
    let slack = slack(a, b);
    let mut best = Way {
        normal: Vec3::Y,
        apart: -HUGE,
    };
    let a_is_larger = reach(a) > reach(b);
    best = best_face(best, a, b, a_is_larger, -HUGE);
    best = best_face(best, a, b, !a_is_larger, best.apart + slack);
    best = best_crossing(best, a, b, best.apart + slack);
    let between = b.centre - a.centre;
    let least = best.apart + slack;
    best = better(best, a, b, between / between.length().max(TINY), least);
    if a.kind == CYLINDER {
        best = better(best, a, b, off_axis(a, between), least);
    }
    if b.kind == CYLINDER {
        best = better(best, a, b, off_axis(b, between), least);
    }
    best
}

/// The better of a way and the one along `axis`, which must have bodies further apart than `least`, m.
fn better(best: Way, a: &Core, b: &Core, axis: Vec3, least: f32) -> Way {
    let squared = axis.length_squared();
    if squared < PARALLEL2 {
        return best;
    }
    let mut normal = axis / squared.sqrt();
    if normal.dot(b.centre - a.centre) < 0.0 {
        normal = -normal;
    }
    let apart = separation(a, b, normal);
    if apart > best.apart && apart > least {
        return Way { normal, apart };
    }
    best
}
// ANCHOR_END: best_axis

/// The better of a way and the best one across the faces of a or of b.
fn best_face(best: Way, a: &Core, b: &Core, of_a: bool, least: f32) -> Way {
    let mut found = best;
    if of_a && has_faces(a) {
        for i in 0..axis_count(a) {
            found = better(found, a, b, axis_of(a, i), least);
        }
    }
    if !of_a && has_faces(b) {
        for i in 0..axis_count(b) {
            found = better(found, a, b, axis_of(b, i), least);
        }
    }
    found
}

/// The better of a way and the best one across an edge of each.
fn best_crossing(best: Way, a: &Core, b: &Core, least: f32) -> Way {
    let mut found = best;
    for i in 0..axis_count(a) {
        for j in 0..axis_count(b) {
            found = better(found, a, b, axis_of(a, i).cross(axis_of(b, j)), least);
        }
    }
    found
}

fn has_faces(core: &Core) -> bool {
    core.kind == BOX || core.kind == CYLINDER
}

/// Along how many axes a core has edges: 3 for a box, else its y alone.
fn axis_count(core: &Core) -> u32 {
    if core.kind == BOX { 3 } else { 1 }
}

fn axis_of(core: &Core, i: u32) -> Vec3 {
    if core.kind != BOX || i == 1 {
        return core.axes.y_axis;
    }
    if i == 0 {
        core.axes.x_axis
    } else {
        core.axes.z_axis
    }
}

/// The part of a direction, as a unit vector or none, at a right angle to a core's y.
fn off_axis(core: &Core, direction: Vec3) -> Vec3 {
    let off = direction - direction.dot(core.axes.y_axis) * core.axes.y_axis;
    let length = off.length();
    if length > 1e-6 * reach(core) {
        off / length
    } else {
        Vec3::ZERO
    }
}
