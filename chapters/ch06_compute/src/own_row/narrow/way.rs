//! The shortest way apart, without a polytope. GJK knows the nearest points of bodies that are apart, so
//! bodies that overlap are pushed apart first, along the best direction known. The direction that GJK
//! finds there is a better one for the bodies where they are, and so on.
//!
//! Why it is better: along n two bodies are apart by s(n), and pushed apart by t along m, by
//! s(n) + t n·m. GJK finds the n for which that is the largest. Since n·m = 1 − ½|n − m|², it is
//! s(n) + t − ½t|n − m|², and for n = m it is s(m) + t. So s(n) ≥ s(m) + ½t|n − m|²: a step of
//! the proximal method, which can only climb. [Rockafellar 1976]

use super::axis::Way;
use super::core::{Core, separation, smaller_size};
use super::gjk::gjk;

/// How far apart cores are pushed, as a share of the smaller body's size: enough for GJK to tell a
/// direction, and no more, since a short push climbs faster.
pub const GAP: f32 = 0.02;

/// Pushes at most.
const MOST_PUSHES: u32 = 8;

/// A push that gains less than this share of the smaller body's size was the last.
const ENOUGH: f32 = 1e-5;

// ANCHOR: push_apart
/// A direction along which the two are at least as far apart as along `start`, and further than along all
/// those near it.
#[must_use]
pub fn push_apart(a: &Core, b: &Core, start: Way) -> Way {
    let size = smaller_size(a, b);
    let rounds = a.round + b.round;
    let mut best = start;
    let mut push = 0.0;
    for i in 0..MOST_PUSHES {
        let normal = gjk(a, b, push * best.normal, best.normal);
        let apart = separation(a, b, normal);
        let gain = apart - best.apart;
        if gain > 0.0 {
            best = Way { normal, apart };
        }
        push = (GAP * size - rounds - best.apart).max(0.0);
        if push == 0.0 || i > 0 && gain < ENOUGH * size {
            break;
        }
    }
    best
}
// ANCHOR_END: push_apart
