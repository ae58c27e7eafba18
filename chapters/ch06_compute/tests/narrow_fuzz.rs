//! The narrow phase against an independent judge: parry3d in f64, on 20,000 random pairs for each kind of
//! pair, from any overlap to apart by a size. "Size" is the bounding radius of the smaller body: to it
//! all tolerances refer.
//!
//! Whose answer is right, if two differ, needs no judge. Along any unit vector n two bodies are apart by
//! s(n) = −h(−n), with h the support function of their Minkowski difference, which takes a line of f64 for
//! each shape. Their distance, or minus their depth, is the largest s. So s(n) for a normal n is a proof
//! that they are at least so far apart, and the larger of s(ours) and s(parry's) is the truth as far as
//! anyone knows.

mod narrow_bodies;

use ch00_scenes::random::SplitMix64;
use ch06_compute::own_row::narrow::{Posed, manifold, pair_kind};
use glam::DVec3;
use narrow_bodies::{apart_along, at_points, normal_of, parrys_normal, random_pair, size};

const PAIRS: usize = 20_000;

/// What was wrong, at worst, as shares of size.
#[derive(Default, Debug)]
struct Tally {
    /// Of the distance of the nearest point, in pairs that are apart or overlap by less than 2 %.
    shallow: f64,
    /// In pairs that overlap by less than 20 %.
    moderate: f64,
    /// In all others.
    deep: f64,
    /// How many overlap by more than 20 % and leave by a way that is longer than need be by 1 %.
    detours: usize,
    /// How many normals are off parry's by more than 1° and not as good.
    off: usize,
}

impl Tally {
    fn judge(&mut self, a: &Posed, b: &Posed) {
        let m = manifold(a, b, 1e6);
        assert!((1..=4).contains(&m.points), "{m:?} {a:?} {b:?}");
        assert_eq!(m.kind, pair_kind(a.kind, b.kind));
        let size = size(a).min(size(b));
        let normal = normal_of(&m, a, b);
        assert!((normal.length() - 1.0).abs() < 1e-5, "{m:?} {a:?} {b:?}");
        let normal = normal.normalize();
        let parrys = parrys_normal(a, b);
        let ours = apart_along(a, b, normal);
        let truth = ours.max(apart_along(a, b, parrys));
        let found = at_points(&m, a, b)
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let error = (found - truth).abs() / size;
        let depth = -truth / size;
        let worst = if depth < 0.02 {
            &mut self.shallow
        } else if depth < 0.2 {
            &mut self.moderate
        } else {
            self.detours += usize::from(error > 0.01);
            &mut self.deep
        };
        if error > *worst {
            *worst = error;
            if std::env::var("SHOW").is_ok() {
                println!(
                    "{error} found {found} ours {ours} truth {truth} n {normal} parry {parrys}\n{m:?}\n{a:?}\n{b:?}"
                );
            }
        }
        let angle = normal.angle_between(parrys).to_degrees();
        self.off += usize::from(angle > 1.0 && ours < truth - 1e-3 * size);
    }
}

fn judge_all(a: u32, b: u32) {
    let mut random = SplitMix64::new(u64::from(10 * a + b));
    let mut tally = Tally::default();
    for i in 0..PAIRS {
        let (a, b) = random_pair([a, b], i, &mut random);
        tally.judge(&a, &b);
    }
    println!("{a} {b}: {tally:?}");
}

#[test]
fn all_pairs() {
    for a in 0..4 {
        for b in a..4 {
            judge_all(a, b);
        }
    }
}
