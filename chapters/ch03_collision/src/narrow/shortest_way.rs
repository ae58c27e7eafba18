//! The shortest way apart of any two solids, or the gap between them: GJK first, EPA where it must
//! be.
//!
//! GJK is quick and exact for cores that are apart, and says nothing about how deep they overlap. A
//! capsule's core is apart from the floor long after its surface went in. A box gets the same
//! grace: it is shrunk under a skin, a radius, and rounded by that lies within the sharp one.
//!
//! So two bounds are known. The sharp solids are at most as far apart as the rounded ones, and at
//! least as far as along the normal of any face. Where both agree, that face is the answer. They do
//! where something lies on a face or stands on it with a corner, and don't where edges cross or
//! rims meet. These are left to EPA.

use glam::Vec3;

use super::epa::epa;
use super::gjk::{Apart, Gjk, gjk};
use super::simplex::Simplex;
use super::support_point::{Core, ROUNDING, extent, separation};

/// The skin, as a share of a solid's smallest half extent.
const SKIN: f32 = 0.1;

/// Nearer than this share of the coordinates GJK's normal is mostly rounding.
pub const VAGUE: f32 = 1e-4;

/// A face leads if along its normal the solids are as far apart as along the best one, but for
/// this share of the smaller one's size …
const AS_GOOD: f32 = 1e-4;

/// … and if that normal differs from it by an angle with at most this sine.
const AS_STEEP: f32 = 0.015;

/// One of two solids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The first.
    A,
    /// The second.
    B,
}

/// The shortest way apart of two solids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShortestWay {
    /// Unit vector from b to a.
    pub normal: Vec3,
    /// How far apart they are along it, m; negative if they overlap.
    pub separation: f32,
    /// Midway between the two points that are nearest to each other, or deepest in each other, m.
    pub point: Vec3,
    /// Whose flat face the normal stands on.
    pub face: Option<Side>,
    /// False if EPA ran out of room: there may be a slightly shorter way.
    pub converged: bool,
}

// ANCHOR: shortest_way
/// The shortest way apart of two solids that are at most `margin` from touching, m.
#[must_use]
pub fn shortest_way(a: &Core, b: &Core, margin: f32) -> Option<ShortestWay> {
    let face = leading_face(a, b);
    if face.separation > margin {
        return None;
    }
    let way = match gjk(a, b, a.radius + b.radius + margin) {
        Gjk::Far => return None,
        Gjk::Apart(apart) if apart.distance > VAGUE * extent(a, b) => {
            settled(face, ShortestWay::of_apart(a, b, &apart), a, b)
        }
        Gjk::Apart(Apart { simplex, .. }) | Gjk::Overlapping(simplex) => {
            let sure = under_the_skin(a, b, face);
            sure.unwrap_or_else(|| settled(face, ShortestWay::of_overlap(a, b, &simplex), a, b))
        }
    };
    (way.separation <= margin).then_some(way)
}
// ANCHOR_END: shortest_way

// ANCHOR: leading_face
/// The way along the normal of a flat face on which the solids are furthest apart. A box that
/// stands on another has two such faces, which rounding would take in turns: the larger solid's
/// comes first, b's if they are equally large.
#[must_use]
pub fn leading_face(a: &Core, b: &Core) -> ShortestWay {
    let (of_a, of_b) = ((Side::A, a), (Side::B, b));
    let a_first = a.reach() > b.reach();
    let larger_first = if a_first { [of_a, of_b] } else { [of_b, of_a] };
    let mut best = ShortestWay::unknown();
    for (side, core) in larger_first {
        let clearly = best.separation + tolerance(a, b);
        for axis in core.face_axes() {
            let towards_a = axis.dot(a.centre - b.centre) >= 0.0;
            let normal = if towards_a { axis } else { -axis };
            let separation = separation(a, b, normal);
            if separation > clearly.max(best.separation) {
                best = ShortestWay {
                    normal,
                    separation,
                    face: Some(side),
                    ..best
                };
            }
        }
    }
    best
}
// ANCHOR_END: leading_face

// ANCHOR: under_the_skin
/// The way along the face's normal, if the rounded solids are no further apart than that: then the
/// sharp ones aren't either, and no normal can do better.
#[must_use]
pub fn under_the_skin(a: &Core, b: &Core, face: ShortestWay) -> Option<ShortestWay> {
    let (in_a, in_b, limit) = skinned(a, b, face)?;
    match gjk(&in_a, &in_b, limit) {
        Gjk::Apart(apart) if apart.distance <= limit => Some(ShortestWay {
            point: ShortestWay::of_apart(&in_a, &in_b, &apart).point,
            ..face
        }),
        _ => None,
    }
}

/// The two, the one whose face leads under a skin, and how far apart their cores are at most if
/// that face is the answer, m.
#[must_use]
pub fn skinned(a: &Core, b: &Core, face: ShortestWay) -> Option<(Core, Core, f32)> {
    let (in_a, in_b) = match face.face? {
        Side::A => (a.shrunk(SKIN), *b),
        Side::B => (*a, b.shrunk(SKIN)),
    };
    let limit = face.separation + in_a.radius + in_b.radius + 0.5 * tolerance(a, b);
    Some((in_a, in_b, limit))
}
// ANCHOR_END: under_the_skin

// ANCHOR: settled
/// The way along the face's normal if that is as good as the best one, which may be off it by
/// rounding.
fn settled(face: ShortestWay, best: ShortestWay, a: &Core, b: &Core) -> ShortestWay {
    let as_good = face.separation >= best.separation - tolerance(a, b);
    let as_steep = face.normal.cross(best.normal).length_squared() <= AS_STEEP * AS_STEEP;
    if as_good && as_steep {
        let point = best.point;
        ShortestWay { point, ..face }
    } else {
        best
    }
}
// ANCHOR_END: settled

impl ShortestWay {
    /// Of what is as far apart as can be.
    fn unknown() -> Self {
        Self {
            normal: Vec3::Y,
            separation: f32::NEG_INFINITY,
            point: Vec3::ZERO,
            face: None,
            converged: true,
        }
    }

    /// What GJK found between two cores.
    fn of_apart(a: &Core, b: &Core, apart: &Apart) -> Self {
        Self {
            normal: apart.normal,
            separation: apart.distance - a.radius - b.radius,
            point: between(a, b, apart.normal, apart.on_a, apart.on_b),
            face: None,
            converged: apart.converged,
        }
    }

    /// What EPA finds.
    fn of_overlap(a: &Core, b: &Core, simplex: &Simplex) -> Self {
        let found = epa(a, b, simplex);
        Self {
            normal: found.normal,
            separation: -found.depth - a.radius - b.radius,
            point: between(a, b, found.normal, found.on_a, found.on_b),
            face: None,
            converged: found.converged,
        }
    }
}

/// Midway between the surfaces over two points of the cores.
fn between(a: &Core, b: &Core, normal: Vec3, on_a: Vec3, on_b: Vec3) -> Vec3 {
    0.5 * (on_a + on_b + (b.radius - a.radius) * normal)
}

/// Along two normals the solids are equally far apart if they differ by less than this, m.
fn tolerance(a: &Core, b: &Core) -> f32 {
    AS_GOOD * size(a, b) + ROUNDING * extent(a, b)
}

/// How large the smaller of two solids is, m.
#[must_use]
pub fn size(a: &Core, b: &Core) -> f32 {
    (a.reach() + a.radius).min(b.reach() + b.radius)
}
