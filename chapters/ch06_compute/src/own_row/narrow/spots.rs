//! The points where two bodies touch, before four of them are chosen. A face on a face can give eighteen,
//! and four hold it as well: the ones that span the widest area, and the deepest.
//!
//! Which four they are must not change with every tremor, since a point that stays hands on what it
//! carried in the last step. So the choice begins with the first point and not with the deepest, and of
//! points that are about as good the first one wins.

use glam::{Vec3, Vec4};

use super::core::{Core, HUGE, to_own, with_sign};
use crate::rows::{Manifold, WITH_A, WITH_B};

/// Points that there can be: twice eight of a rim with the lowest, and two where rims cross.
pub const MOST_SPOTS: u32 = 20;

/// A point is taken instead of an earlier one if it adds more by this factor.
const CLEARLY: f32 = 1.001;

/// A number between 1 and 2, whose lowest bits are a feature's name: the bits of a small integer would
/// be a subnormal number, which a GPU may take for 0.
pub const FEATURE: u32 = 0x3f80_0000;

// ANCHOR: spots
/// Points of two cores that lie opposite each other along a normal.
#[derive(Clone, Copy, Debug)]
pub struct Spots {
    /// Unit vector from a to b.
    pub normal: Vec3,
    /// How the normal turns, as in [`Manifold`].
    pub turns: u32,
    /// Cores further apart than this don't count, m.
    pub limit: f32,
    /// How far the cores are apart where they are the nearest, m; huge if they lie nowhere opposite each
    /// other.
    pub least: f32,
    /// By how much a's core points are moved inwards along the normal, m: onto a cylinder's axis.
    pub lift_a: f32,
    /// By how much b's are.
    pub lift_b: f32,
    /// How many points there are.
    pub count: u32,
    /// A point of a's core, and how far along the normal that of b's core is, m.
    pub at: [Vec4; MOST_SPOTS as usize],
    /// The points' features.
    pub names: [u32; MOST_SPOTS as usize],
}

/// No points yet.
#[must_use]
pub fn no_spots(normal: Vec3, turns: u32, limit: f32) -> Spots {
    Spots {
        normal,
        turns,
        limit,
        least: HUGE,
        lift_a: 0.0,
        lift_b: 0.0,
        count: 0,
        at: [Vec4::ZERO; MOST_SPOTS as usize],
        names: [0; MOST_SPOTS as usize],
    }
}

/// Adds a point of a's core with b's core `gap` further along the normal, m, unless that is too far.
pub fn add_spot(spots: &mut Spots, on_a: Vec3, gap: f32, name: u32) {
    spots.least = spots.least.min(gap);
    if gap <= spots.limit && spots.count < MOST_SPOTS {
        spots.at[spots.count as usize] = Vec4::from((on_a, gap));
        spots.names[spots.count as usize] = name;
        spots.count += 1;
    }
}
// ANCHOR_END: spots

// ANCHOR: finished
/// The row that solvers read: all points if there are four at most, else the widest four with the
/// deepest.
#[must_use]
pub fn finished(a: &Core, b: &Core, spots: &Spots, slack: f32) -> Manifold {
    let mut m = started(a, b, spots.normal, spots.turns, spots.lift_a, spots.lift_b);
    let mut chosen = [0, 1, 2, 3];
    let mut count = spots.count;
    if spots.count > 4 {
        count = widest(spots, &mut chosen);
        keep_deepest(spots, &mut chosen, count, slack);
    }
    for i in 0..count as usize {
        let k = chosen[i] as usize;
        let mut name = spots.names[k];
        for &earlier in &chosen[..i] {
            // Points of the same corner get names of their own.
            name += 16 * u32::from(spots.names[earlier as usize] == spots.names[k]);
        }
        put(
            &mut m,
            a,
            b,
            spots.normal,
            spots.at[k].truncate(),
            spots.at[k].w,
            name,
        );
    }
    m
}

/// A row without points.
#[must_use]
pub fn started(a: &Core, b: &Core, normal: Vec3, turns: u32, lift_a: f32, lift_b: f32) -> Manifold {
    let mut m = Manifold {
        normal,
        turns,
        round_a: a.round + lift_a,
        round_b: b.round + lift_b,
        ..Manifold::default()
    };
    if turns == WITH_A {
        m.normal = to_own(a, normal);
    }
    if turns == WITH_B {
        m.normal = to_own(b, normal);
    }
    m
}

/// Adds a point to a row that has room: one of a's core, and b's core `gap` further along the normal, m.
pub fn put(m: &mut Manifold, a: &Core, b: &Core, normal: Vec3, on_a: Vec3, gap: f32, name: u32) {
    let core_a = on_a - normal * (m.round_a - a.round) - a.centre;
    let core_b = on_a + normal * (gap + m.round_b - b.round) - b.centre;
    let k = m.points as usize;
    m.core_a[k] = Vec4::from((to_own(a, core_a), f32::from_bits(FEATURE | name)));
    m.core_b[k] = Vec4::from((to_own(b, core_b), 0.0));
    m.points += 1;
}
// ANCHOR_END: finished

// ANCHOR: widest
/// The first point, the one furthest from it, the one that makes the largest triangle with these, and the
/// one that adds most to the triangle: says how many they are.
fn widest(spots: &Spots, chosen: &mut [u32; 4]) -> u32 {
    let mut count = 1;
    chosen[0] = 0;
    for _ in 1..4 {
        let mut best = 0;
        let mut most = 0.0;
        for k in 1..spots.count {
            let more = gain(spots, chosen, count, k);
            if more > CLEARLY * most {
                best = k;
                most = more;
            }
        }
        if most == 0.0 {
            break;
        }
        chosen[count as usize] = best;
        count += 1;
    }
    count
}

/// What point k adds to the extent of the chosen ones: a length squared, then twice an area.
fn gain(spots: &Spots, chosen: &[u32; 4], count: u32, k: u32) -> f32 {
    let p = spots.at[k as usize].truncate();
    let first = spots.at[chosen[0] as usize].truncate();
    if count == 1 {
        return (p - first).length_squared();
    }
    let second = spots.at[chosen[1] as usize].truncate();
    let beyond_1 = area(spots.normal, first, second, p);
    if count == 2 {
        return beyond_1.abs();
    }
    let third = spots.at[chosen[2] as usize].truncate();
    let turn = with_sign(1.0, area(spots.normal, first, second, third));
    let beyond_2 = area(spots.normal, second, third, p);
    let beyond_3 = area(spots.normal, third, first, p);
    let beyond = (turn * beyond_1).min(turn * beyond_2).min(turn * beyond_3);
    (-beyond).max(0.0)
}

/// Twice the area of a triangle as seen along the normal, with a sign for its turn.
fn area(normal: Vec3, p: Vec3, q: Vec3, r: Vec3) -> f32 {
    (q - p).cross(r - p).dot(normal)
}
// ANCHOR_END: widest

/// Puts the deepest point in the place of its neighbour if none of the chosen is as deep.
fn keep_deepest(spots: &Spots, chosen: &mut [u32; 4], count: u32, slack: f32) {
    let mut deepest = 0;
    for k in 1..spots.count {
        if spots.at[k as usize].w < spots.at[deepest as usize].w {
            deepest = k;
        }
    }
    let at = spots.at[deepest as usize];
    let mut have = HUGE;
    let mut nearest = 0;
    let mut least = HUGE;
    for (i, &one) in chosen.iter().enumerate().take(count as usize) {
        let other = spots.at[one as usize];
        have = have.min(other.w);
        let away = (other.truncate() - at.truncate()).length_squared();
        if away < least {
            least = away;
            nearest = i;
        }
    }
    if have > at.w + slack {
        chosen[nearest] = deepest;
    }
}
