//! The shortest way apart of any two solids, or the gap between them: GJK first, EPA where it must be.
//!
//! GJK is quick and exact for cores that are apart, and says nothing about how deep they overlap.
//! A capsule's core is apart from the floor long after its surface went in. Boxes get the same grace:
//! they are shrunk under a skin, and the distance of the shrunk ones less the skin is the answer,
//! unless edges or corners meet, which the skin has rounded.
//!
//! Which it is, two bounds tell. The rounded solids lie within the sharp ones, so the sharp ones
//! are at most as far apart; and they are at least as far apart as along any one normal.
//! Where both bounds agree, nothing is left to find out. Else GJK looks at the sharp solids, and
//! EPA if they overlap.

use glam::Vec3;

use super::epa::{Penetration, epa};
use super::gjk::{Apart, Gjk, gjk};
use super::simplex::Simplex;
use super::support_point::{Core, ROUNDING, extent, separation};

/// The skin, as a share of a solid's smallest half extent.
const SKIN: f32 = 0.1;

/// Two bounds agree if they differ by this share of the smaller solid's size.
const AGREE: f32 = 5e-5;

/// Nearer than this share of the coordinates GJK's normal is mostly rounding.
const VAGUE: f32 = 1e-4;

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
    let radii = a.radius + b.radius;
    let way = match gjk(a, b, radii + margin) {
        Gjk::Far => return None,
        Gjk::Apart(apart) if apart.distance > VAGUE * extent(a, b) => {
            confirmed(a, b, (a, b), &apart).unwrap_or_else(|| believed(a, b, &apart))
        }
        Gjk::Apart(Apart { simplex, .. }) | Gjk::Overlapping(simplex) => {
            under_the_skin(a, b).unwrap_or_else(|| deep(a, b, &simplex))
        }
    };
    (way.separation <= margin).then_some(way)
}
// ANCHOR_END: shortest_way

// ANCHOR: under_the_skin
/// What GJK finds between the shrunk solids, if it holds for the sharp ones.
fn under_the_skin(a: &Core, b: &Core) -> Option<ShortestWay> {
    let (in_a, in_b) = (a.shrunk(SKIN), b.shrunk(SKIN));
    match gjk(&in_a, &in_b, f32::INFINITY) {
        Gjk::Apart(apart) => confirmed(a, b, (&in_a, &in_b), &apart),
        _ => None,
    }
}
// ANCHOR_END: under_the_skin

// ANCHOR: confirmed
/// What GJK found between two cores, if along its normal a and b are as far apart as it says: no normal
/// can do better then.
fn confirmed(a: &Core, b: &Core, cores: (&Core, &Core), apart: &Apart) -> Option<ShortestWay> {
    let radii = cores.0.radius + cores.1.radius;
    let at_most = apart.distance - radii;
    let way = settled(a, b, apart.normal, middle(cores, apart));
    let agree = AGREE * size(a, b) + ROUNDING * extent(a, b);
    (way.separation >= at_most - agree).then_some(way)
}
// ANCHOR_END: confirmed

/// What GJK found, if the solids are so long that the normal's rounding spoils the other bound.
fn believed(a: &Core, b: &Core, apart: &Apart) -> ShortestWay {
    ShortestWay {
        normal: apart.normal,
        separation: apart.distance - a.radius - b.radius,
        point: middle((a, b), apart),
        face: None,
        converged: apart.converged,
    }
}

/// What EPA finds.
fn deep(a: &Core, b: &Core, simplex: &Simplex) -> ShortestWay {
    let Penetration {
        normal,
        on_a,
        on_b,
        converged,
        ..
    } = epa(a, b, simplex);
    let point = 0.5 * (on_a + on_b + (b.radius - a.radius) * normal);
    ShortestWay {
        converged,
        ..settled(a, b, normal, point)
    }
}

// ANCHOR: settled
/// The way along `normal`, or along the normal of a face that is as good. A box that stands on
/// another has two such faces, which rounding would take in turns: the larger solid's
/// comes first, b's if they are equally large.
fn settled(a: &Core, b: &Core, normal: Vec3, point: Vec3) -> ShortestWay {
    let best = separation(a, b, normal);
    let enough = best - AS_GOOD * size(a, b) - ROUNDING * extent(a, b);
    let of_a = (Side::A, a.face_normal(-normal).map(|normal| -normal));
    let of_b = (Side::B, b.face_normal(normal));
    let faces = if a.reach() > b.reach() {
        [of_a, of_b]
    } else {
        [of_b, of_a]
    };
    for (side, face) in faces {
        let Some(face) = face else { continue };
        if face.cross(normal).length_squared() <= AS_STEEP * AS_STEEP {
            let separation = separation(a, b, face);
            if separation >= enough {
                return ShortestWay {
                    normal: face,
                    separation,
                    point,
                    face: Some(side),
                    converged: true,
                };
            }
        }
    }
    ShortestWay {
        normal,
        separation: best,
        point,
        face: None,
        converged: true,
    }
}
// ANCHOR_END: settled

/// Midway between the surfaces, where the cores are nearest to each other.
fn middle((a, b): (&Core, &Core), apart: &Apart) -> Vec3 {
    0.5 * (apart.on_a + apart.on_b + (b.radius - a.radius) * apart.normal)
}

/// How large the smaller of two solids is, m.
#[must_use]
pub fn size(a: &Core, b: &Core) -> f32 {
    (a.reach() + a.radius).min(b.reach() + b.radius)
}
