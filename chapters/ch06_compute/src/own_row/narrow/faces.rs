//! Faces that lie on each other: the corners of the part that they share. They are the ends of what one
//! face's edges have over the other face, and the other face's corners over the first.
//!
//! "Over" means along the contact normal, which stands on one of the two faces. Each edge is cut on its
//! own [Cyrus and Beck 1978], so no polygon has to be kept while it is cut, and a disc is as exact as
//! a rectangle.

use glam::{Vec2, Vec3};

use super::core::{Core, reach};
use super::features::{DISC, EDGE, Feature, corner, corner_count};
use super::spots::{Spots, add_spot};
use crate::norm::Norm;

/// Set in the names of b's corners.
const OF_B: u32 = 128;
/// The corner that is a tilted rim's lowest point.
const LOWEST: u32 = 8;
/// The names of the points where two rims cross.
const CROSSING: u32 = 9;

/// A cap lies flat if the sine of its tilt is less: then its rim has no lowest point.
const FLAT: f32 = 1e-3;

/// What the points of a feature are added as.
#[derive(Clone, Copy, Debug)]
struct Role {
    /// 1 for a feature of a, −1 for one of b.
    sign: f32,
    /// What all their names have.
    name: u32,
    /// How far they may be beyond the sides of the other feature, m.
    slack: f32,
}

// ANCHOR: faces_meet
/// Adds the points where a's feature and b's lie over each other, of which at most one is an edge. What
/// reaches beyond a side by less than `slack`, m, is not cut.
pub fn faces_meet(
    spots: &mut Spots,
    a: &Core,
    b: &Core,
    of_a: &Feature,
    of_b: &Feature,
    slack: f32,
) {
    let equal = of_a.shape == of_b.shape;
    let mut name = 1 << 16 | of_a.name << 12 | of_b.name << 8;
    let mut sign = 1.0;
    let mut cut = *of_a;
    let mut face = *of_b;
    if of_a.shape > of_b.shape || (equal && reach(a) >= reach(b)) {
        name |= OF_B;
        sign = -1.0;
        cut = *of_b;
        face = *of_a;
    }
    let mut role = Role { sign, name, slack };
    edges_over(spots, &cut, &face, role);
    rims_cross(spots, &cut, &face, role);
    for i in 0..2 {
        // The ends of edges are corners of what is cut.
        if i == 1 || cut.shape == DISC {
            corners_over(spots, &cut, &face, role);
        }
        std::mem::swap(&mut cut, &mut face);
        role = Role {
            sign: -role.sign,
            name: role.name ^ OF_B,
            slack: -slack,
        };
    }
}
// ANCHOR_END: faces_meet

// ANCHOR: over
/// A point over a face: where along the face's u and v, and how far along `normal` the face is from it,
/// m.
fn over(face: &Feature, p: Vec3, normal: Vec3) -> Vec3 {
    let way = (face.centre - p).dot(face.normal) / normal.dot(face.normal);
    let foot = p + way * normal - face.centre;
    Vec3::new(foot.dot(face.u), foot.dot(face.v), way)
}

/// Adds a point of a feature, and what is opposite it on a face.
fn place(spots: &mut Spots, p: Vec3, face: &Feature, sign: f32, name: u32) {
    let way = over(face, p, spots.normal).z;
    let mut on_a = p;
    if sign < 0.0 {
        on_a = p + way * spots.normal;
    }
    add_spot(spots, on_a, sign * way, name);
}
// ANCHOR_END: over

// ANCHOR: edges_over
/// What a feature's edges have over a face: their ends, and where they leave it. An end is named by the
/// corner that it is or the nearer one, so that equal boxes in a stack keep four names while they tremble
/// to this side and that of being aligned.
fn edges_over(spots: &mut Spots, cut: &Feature, face: &Feature, role: Role) {
    if cut.shape == DISC {
        return;
    }
    let corners = corner_count(cut);
    let edges = if cut.shape == EDGE { 1 } else { corners };
    for i in 0..edges {
        let j = (i + 1) % corners;
        let p = corner(cut, i);
        let q = corner(cut, j);
        let start = over(face, p, spots.normal).truncate();
        let end = over(face, q, spots.normal).truncate();
        let part = part_over(face, start, end, role.slack);
        for k in 0..2 {
            let t = if k == 0 { part.x } else { part.y };
            // A rectangle's corner is where its next edge starts.
            let is_new = k == 0 || (part.x < part.y && (t < 1.0 || edges == 1));
            if part.x <= part.y && is_new {
                let name = role.name | if t < 0.5 { i } else { j };
                place(spots, p + t * (q - p), face, role.sign, name);
            }
        }
    }
}

/// Which part of the way from p to q, from 0 to 1, is over a face; from more than to if none is.
fn part_over(face: &Feature, p: Vec2, q: Vec2, slack: f32) -> Vec2 {
    if face.shape == DISC {
        return part_in_circle(p, q, face.half_u + slack);
    }
    let along_u = part_between(p.x, q.x, face.half_u + slack);
    let along_v = part_between(p.y, q.y, face.half_v + slack);
    Vec2::new(along_u.x.max(along_v.x), along_u.y.min(along_v.y))
}

/// Which part of the way from p to q is between −h and h.
fn part_between(p: f32, q: f32, h: f32) -> Vec2 {
    let d = q - p;
    if d.abs() < 1e-6 * h {
        return if p.abs() <= h {
            Vec2::new(0.0, 1.0)
        } else {
            Vec2::new(1.0, 0.0)
        };
    }
    let one = (-h - p) / d;
    let other = (h - p) / d;
    Vec2::new(one.min(other).max(0.0), one.max(other).min(1.0))
}

/// Which part of the way from p to q is within r of the origin.
fn part_in_circle(p: Vec2, q: Vec2, r: f32) -> Vec2 {
    let d = q - p;
    let d2 = d.length_squared().max(1e-12 * r * r);
    let half = p.dot(d);
    let root = half * half - d2 * (p.length_squared() - r * r);
    if root < 0.0 {
        return Vec2::new(1.0, 0.0);
    }
    let reach = root.sqrt();
    Vec2::new(
        ((-half - reach) / d2).max(0.0),
        ((-half + reach) / d2).min(1.0),
    )
}
// ANCHOR_END: edges_over

// ANCHOR: corners_over
/// The corners of a feature that are over a face.
fn corners_over(spots: &mut Spots, feature: &Feature, face: &Feature, role: Role) {
    if face.shape == EDGE {
        return;
    }
    for i in 0..corner_count(feature) + lowest_count(feature, spots.normal) {
        let mut p = corner(feature, i);
        if i == LOWEST {
            p = lowest(feature, role.sign * spots.normal);
        }
        let at = over(face, p, spots.normal).truncate();
        if is_over(face, at, role.slack) {
            let name = corner_name(feature, face, role.name, i, at);
            place(spots, p, face, role.sign, name);
        }
    }
}

fn is_over(face: &Feature, p: Vec2, slack: f32) -> bool {
    if face.shape == DISC {
        let r = face.half_u + slack;
        return p.length_squared() <= r * r;
    }
    p.x.abs() <= face.half_u + slack && p.y.abs() <= face.half_v + slack
}

/// The name of a feature's corner i, which is at `at` over a face. Where both are rectangles, it is that of
/// the face's corner on its side: a corner that moves a little beyond two sides of a face hands its name to
/// the face's own.
fn corner_name(feature: &Feature, face: &Feature, name: u32, i: u32, at: Vec2) -> u32 {
    if feature.shape == DISC || face.shape == DISC {
        return name | i;
    }
    let side = u32::from(at.x < 0.0);
    (name ^ OF_B) | if at.y < 0.0 { 3 - side } else { side }
}
// ANCHOR_END: corners_over

// ANCHOR: rims
/// 1 for a cap that stands on its rim, else 0.
fn lowest_count(feature: &Feature, normal: Vec3) -> u32 {
    let tilt = Vec2::new(feature.u.dot(normal), feature.v.dot(normal)).norm();
    u32::from(feature.shape == DISC && tilt > FLAT)
}

/// The point of a cap's rim that is furthest along a direction.
fn lowest(disc: &Feature, direction: Vec3) -> Vec3 {
    let x = disc.u.dot(direction);
    let y = disc.v.dot(direction);
    disc.centre + disc.half_u / Vec2::new(x, y).norm() * (x * disc.u + y * disc.v)
}

/// Where the rims of two caps cross, as seen along the normal. Where one is tilted so much that its rim
/// isn't a circle but for the slack, they have other points.
fn rims_cross(spots: &mut Spots, disc: &Feature, other: &Feature, role: Role) {
    if disc.shape != DISC || other.shape != DISC {
        return;
    }
    let between = over(disc, other.centre, spots.normal).truncate();
    let d2 = between.length_squared();
    let r = disc.half_u;
    let s = other.half_u;
    if d2 < 1e-6 * r * r {
        return;
    }
    let along = 0.5 + 0.5 * (r * r - s * s) / d2;
    let across2 = r * r / d2 - along * along;
    if across2 < 0.0 {
        return;
    }
    for i in 0..2 {
        let across = if i == 0 { 1.0 } else { -1.0 } * across2.sqrt();
        let x = along * between.x - across * between.y;
        let y = along * between.y + across * between.x;
        let p = disc.centre + x * disc.u + y * disc.v;
        let at = over(other, p, spots.normal).truncate();
        if is_over(other, at, role.slack) {
            place(spots, p, other, role.sign, role.name | (CROSSING + i));
        }
    }
}
// ANCHOR_END: rims
