//! The narrow phase against an independent judge: parry3d in f64, on 20,000 random pairs for each kind of
//! pair, from any overlap to apart by a size. "Size" is the bounding radius of the smaller body: to it
//! all tolerances refer.
//!
//! Whose answer is right, if two differ, needs no judge. Along any unit vector n two bodies are apart by
//! s(n) = −h(−n), with h the support function of their Minkowski difference, which takes a line of f64 for
//! each shape. Their distance, or minus their depth, is the largest s. So s(n) for a normal n is a proof
//! that they are at least so far apart, and the larger of s(ours) and s(parry's) is the truth as far as
//! anyone knows.

use ch00_scenes::random::SplitMix64;
use ch06_compute::own_row::narrow::{Posed, manifold, pair_kind};

use crate::bodies::{
    BALL, BOX, CAPSULE, CYLINDER, apart_along, at_points, normal_of, off_surfaces, parrys_normal,
    random_pair, size, thin,
};

const PAIRS: usize = 20_000;

/// Error of a distance or a depth, as a share of size: twice the slack within which the narrow phase
/// prefers faces.
const TOLERANCE: f64 = 1e-3;

/// What was wrong. Bodies overlap moderately by more than a tenth of the thinner one's half thickness, and
/// deeply by more than half of it.
#[derive(Default, Debug)]
struct Tally {
    /// How many are apart or overlap by less.
    shallow: usize,
    /// Of these, how many are wrong by more than the tolerance.
    wrong: usize,
    /// The largest error of these, as a share of size.
    worst: f64,
    /// How far the nearest point is from lying on both surfaces, at worst, as a share of size.
    off: f64,
    /// How many overlap moderately.
    moderate: usize,
    /// How many of these leave by a way that is too long by more than the tolerance.
    moderate_detours: usize,
    /// How many overlap deeply.
    deep: usize,
    /// How many of these take a detour.
    deep_detours: usize,
}

impl Tally {
    fn judge(&mut self, a: &Posed, b: &Posed) {
        let m = manifold(a, b, 1e6);
        assert!((1..=4).contains(&m.points), "{m:?} {a:?} {b:?}");
        assert_eq!(m.kind, pair_kind(a.kind, b.kind));
        let size = size(a).min(size(b));
        let normal = normal_of(&m, a, b);
        assert!((normal.length() - 1.0).abs() < 1e-5, "{m:?} {a:?} {b:?}");
        let ours = apart_along(a, b, normal.normalize());
        let truth = ours.max(apart_along(a, b, parrys_normal(a, b)));
        let nearest = at_points(&m, a, b)
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let is_wrong = (truth - nearest).abs() > TOLERANCE * size;
        let share = -truth / thin(a).min(thin(b));
        if share > 0.5 {
            self.deep += 1;
            self.deep_detours += usize::from(is_wrong);
        } else if share > 0.1 {
            self.moderate += 1;
            self.moderate_detours += usize::from(is_wrong);
        } else {
            self.shallow += 1;
            self.wrong += usize::from(is_wrong);
            self.worst = self.worst.max((nearest - truth).abs() / size);
            if nearest.abs() < 0.05 * size {
                let off = off_surfaces(&m, a, b) / size;
                self.off = self.off.max(off);
            }
        }
    }
}

fn judge_all(a: u32, b: u32) -> Tally {
    let mut random = SplitMix64::new(u64::from(10 * a + b));
    let mut tally = Tally::default();
    for i in 0..PAIRS {
        let (a, b) = random_pair([a, b], i, &mut random);
        tally.judge(&a, &b);
    }
    println!("{a} {b}: {tally:?}");
    tally
}

/// Balls, boxes and capsules leave by the shortest way always.
fn is_exact(a: u32, b: u32) {
    let tally = judge_all(a, b);
    let wrong = tally.wrong + tally.moderate_detours + tally.deep_detours;
    assert!(wrong == 0 && tally.off < TOLERANCE, "{tally:?}");
}

/// A cylinder's rim is round, so the way out is climbed to: from deep inside not always to the highest
/// peak.
fn is_exact_unless_deep(a: u32, b: u32) {
    let tally = judge_all(a, b);
    assert!(tally.wrong <= tally.shallow / 5000, "{tally:?}");
    assert!(tally.off < 0.02, "{tally:?}");
    assert!(tally.moderate_detours <= tally.moderate / 50, "{tally:?}");
    assert!(tally.deep_detours <= tally.deep / 20, "{tally:?}");
}

#[test]
fn ball_against_ball() {
    is_exact(BALL, BALL);
}

#[test]
fn ball_against_box() {
    is_exact(BALL, BOX);
}

#[test]
fn ball_against_capsule() {
    is_exact(BALL, CAPSULE);
}

#[test]
fn ball_against_cylinder() {
    is_exact(BALL, CYLINDER);
}

#[test]
fn box_against_box() {
    is_exact(BOX, BOX);
}

#[test]
fn box_against_capsule() {
    is_exact(BOX, CAPSULE);
}

#[test]
fn capsule_against_capsule() {
    is_exact(CAPSULE, CAPSULE);
}

#[test]
fn box_against_cylinder() {
    is_exact_unless_deep(BOX, CYLINDER);
}

#[test]
fn capsule_against_cylinder() {
    is_exact_unless_deep(CAPSULE, CYLINDER);
}

#[test]
fn cylinder_against_cylinder() {
    is_exact_unless_deep(CYLINDER, CYLINDER);
}
