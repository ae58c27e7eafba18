//! The points where two cores meet along a known normal. If it stands on a face, the other core's widest
//! feature lies on that; if not, two edges meet.

use glam::Vec3;

use super::axis::Way;
use super::core::{BOX, CAPSULE, CYLINDER, Core, outward, slack, smaller_size, to_own};
use super::edges::{Meeting, edges_meet};
use super::faces::faces_meet;
use super::features::{CAP_COSINE, EDGE, edge_towards, face_towards, stands_on_face};
use super::spots::{Spots, no_spots};
use super::way::GAP;
use crate::rows::{FIXED, WITH_A, WITH_B};

// ANCHOR: contacts
/// The points of two bodies that part soonest along `way`, those with a gap of at most `margin`, m.
#[must_use]
pub fn contacts(a: &Core, b: &Core, way: Way, margin: f32) -> Spots {
    let n = way.normal;
    let rounds = a.round + b.round;
    let mut spots = no_spots(n, FIXED, margin + rounds);
    let on_a = stands_on_face(a, n);
    let on_b = stands_on_face(b, n);
    if on_a || on_b {
        let of_a = face_towards(a, n);
        let of_b = face_towards(b, -n);
        faces_meet(&mut spots, a, b, &of_a, &of_b, slack(a, b));
        spots.lift_a = lift(a, of_a.shape, n);
        spots.lift_b = lift(b, of_b.shape, n);
        spots.turns = turns(on_a && of_b.shape == EDGE, on_b && of_a.shape == EDGE);
    } else {
        let of_a = edge_towards(a, n);
        let of_b = edge_towards(b, -n);
        spots.lift_a = lift(a, EDGE, n);
        spots.lift_b = lift(b, EDGE, n);
        let gap = way.apart + rounds;
        let meeting = Meeting {
            gap,
            push: (GAP * smaller_size(a, b) - gap).max(0.0),
            round_a: a.round + spots.lift_a,
            round_b: b.round + spots.lift_b,
            slack: slack(a, b),
        };
        edges_meet(&mut spots, &of_a, &of_b, &meeting);
        spots.turns = turns(a.kind == BOX && b.kind == CAPSULE, false);
    }
    spots
}
// ANCHOR_END: contacts

/// How the normal turns: with the body on whose face something round lies, else not at all.
fn turns(with_a: bool, with_b: bool) -> u32 {
    if with_a {
        return WITH_A;
    }
    if with_b { WITH_B } else { FIXED }
}

// ANCHOR: lift
/// How far from the surface, along the normal, a cylinder's axis is where it lies on its side or rolls on
/// its rim, m. A core point there stays where it is while the cylinder spins.
fn lift(core: &Core, shape: u32, n: Vec3) -> f32 {
    let d = to_own(core, n);
    let across = d.dot(outward(d));
    if core.kind != CYLINDER || shape != EDGE || across < CAP_COSINE {
        return 0.0;
    }
    core.half.x / across
}
// ANCHOR_END: lift
