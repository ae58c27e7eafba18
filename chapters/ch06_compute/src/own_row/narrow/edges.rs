//! Edges that meet: a box's edge, the line along a cylinder's side, a capsule's segment. Where they cross
//! they meet in a point; side by side, along a stretch, and its ends are two points.

use glam::{Vec2, Vec3};

use super::core::HUGE;
use super::features::Feature;
use super::spots::{Spots, add_spot};
use crate::norm::Norm;

/// Edges run side by side if the sine of the angle between them is less.
const PARALLEL: f32 = 0.1;

/// How far round edges that run side by side may be from lying opposite each other, as a share of their
/// radii: a gap is wrong by half the square of that share.
pub const ASIDE: f32 = 0.05;

/// A stretch that is shorter than this share of the edge is a point.
const SHORT: f32 = 0.01;

/// Two edges as they meet.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// How far apart they are along the normal, m.
    pub gap: f32,
    /// How far they are pushed apart before their nearest points are taken, m.
    pub push: f32,
    /// How round the first one's body is there: its radius, m.
    pub round_a: f32,
    /// How round the other one's body is.
    pub round_b: f32,
    /// m.
    pub slack: f32,
}

// ANCHOR: nearest_points
/// The point at s along an edge from its middle, m.
#[must_use]
pub fn along(edge: &Feature, s: f32) -> Vec3 {
    edge.centre + s * edge.u
}

/// Where along an edge, from its middle, the point nearest to p is, m.
#[must_use]
pub fn nearest_along(edge: &Feature, p: Vec3) -> f32 {
    (p - edge.centre)
        .dot(edge.u)
        .clamp(-edge.half_u, edge.half_u)
}

/// Where along two edges, from their middles, the points are that are nearest to each other, m, if the
/// second is moved by `shift`. [Ericson 2005, 5.1.9]
#[must_use]
pub fn nearest_points(one: &Feature, other: &Feature, shift: Vec3) -> Vec2 {
    let between = other.centre + shift - one.centre;
    let n = one.u.cross(other.u);
    let sine2 = n.length_squared();
    let mut s = nearest_along(one, other.centre + shift);
    if sine2 > 1e-10 {
        let crossing = between.cross(other.u).dot(n) / sine2;
        s = crossing.clamp(-one.half_u, one.half_u);
    }
    let t = nearest_along(other, along(one, s) - shift);
    Vec2::new(nearest_along(one, along(other, t) + shift), t)
}
// ANCHOR_END: nearest_points

// ANCHOR: edges_meet
/// Adds the point or the points where two edges meet.
///
/// The nearest points of edges that overlap say little. Pushed apart along the normal, they are those
/// that overlap the most.
pub fn edges_meet(spots: &mut Spots, one: &Feature, other: &Feature, meeting: &Meeting) {
    let name = 3 << 16 | one.name << 12 | other.name << 8;
    let near = nearest_points(one, other, meeting.push * spots.normal);
    let p = along(one, near.x);
    let q = along(other, near.y);
    // The rounder one yields: it is hardly thinner a little aside.
    let rounds = meeting.round_a + meeting.round_b;
    let share = (meeting.round_a + meeting.slack) / (rounds + 2.0 * meeting.slack);
    let aside = ASIDE * rounds + meeting.slack;
    let part = stretch(one, other, near.x, spots.normal, aside);
    if part.y - part.x > SHORT * one.half_u {
        opposite(spots, one, other, part.x, share, name | 1);
        opposite(spots, one, other, part.y, share, name | 2);
    } else {
        add_spot(
            spots,
            p + share * off(spots.normal, p, q),
            meeting.gap,
            name,
        );
    }
    spots.least = (q - p).dot(spots.normal);
    if off(spots.normal, p, q).norm() > meeting.slack {
        spots.least = HUGE;
    }
}

/// How q is off from lying opposite p along the normal, m.
fn off(normal: Vec3, p: Vec3, q: Vec3) -> Vec3 {
    (q - p) - (q - p).dot(normal) * normal
}

/// Adds the point at s along an edge, and the nearest one of the other; the first one is moved by a share
/// of what it is off from lying opposite.
fn opposite(spots: &mut Spots, one: &Feature, other: &Feature, s: f32, share: f32, name: u32) {
    let p = along(one, s);
    let q = along(other, nearest_along(other, p));
    let on_a = p + share * off(spots.normal, p, q);
    add_spot(spots, on_a, (q - p).dot(spots.normal), name);
}
// ANCHOR_END: edges_meet

// ANCHOR: stretch
/// The part of an edge, from its middle, m, that lies beside another one and off from it by at most
/// `aside`, m; from not less than to if there is none. They are the nearest at `s`.
fn stretch(one: &Feature, other: &Feature, s: f32, normal: Vec3, aside: f32) -> Vec2 {
    let turn = one.u.cross(other.u);
    if turn.length_squared() > PARALLEL * PARALLEL {
        return Vec2::ZERO;
    }
    let middle = (other.centre - one.centre).dot(one.u);
    let reach = other.half_u * one.u.dot(other.u).abs();
    let far = aside / turn.dot(normal).abs().max(1e-6);
    Vec2::new(
        (middle - reach).max(-one.half_u).max(s - far),
        (middle + reach).min(one.half_u).min(s + far),
    )
}
// ANCHOR_END: stretch
