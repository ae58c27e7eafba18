//! What the narrow phase costs for each pair of shapes, in ns: resting face on face, touching by a
//! millimetre in any pose, a few centimetres apart, and deep in each other.
//!
//! `cargo run --release -p ch03_collision --no-default-features --example narrow_cost`

use std::hint::black_box;
use std::time::Instant;

use ch00_maths::f32::shape::Shape;
use ch00_scenes::random::SplitMix64;
use ch03_collision::narrow::support_point::{Core, separation};
use ch03_collision::narrow::{Placed, touch};
use glam::{Quat, Vec3};

const PAIRS: usize = 2000;
const MARGIN: f32 = 0.01;

const KINDS: [&str; 4] = ["ball", "box", "capsule", "cylinder"];

/// Two solids with their poses.
type Pair = [(Shape, Vec3, Quat); 2];

fn main() {
    println!(
        "{:20}{:>9}{:>9}{:>9}{:>9}",
        "pair", "resting", "touching", "apart", "deep"
    );
    for (a, name_a) in KINDS.iter().enumerate() {
        for (b, name_b) in KINDS.iter().enumerate().skip(a) {
            let mut random = SplitMix64::new(1);
            let mut cost = |gap| {
                let pairs: Vec<_> = (0..PAIRS).map(|_| pair([a, b], gap, &mut random)).collect();
                time(&pairs)
            };
            println!(
                "{:20}{:9.0}{:9.0}{:9.0}{:9.0}",
                format!("{name_a}, {name_b}"),
                cost(None),
                cost(Some(-0.001)),
                cost(Some(0.03)),
                cost(Some(-0.1)),
            );
        }
    }
}

/// Nanoseconds a pair: the best of some rounds.
fn time(pairs: &[Pair]) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..7 {
        let start = Instant::now();
        for [a, b] in pairs {
            black_box(touch(&placed(a), &placed(b), MARGIN));
        }
        best = best.min(start.elapsed().as_nanos() as f64 / pairs.len() as f64);
    }
    best
}

fn placed((shape, p, q): &(Shape, Vec3, Quat)) -> Placed<'_> {
    Placed {
        shape,
        p: *p,
        q: *q,
        p_before: *p,
    }
}

/// Two solids in any pose with this gap along some direction, m; or one upright on the other, both
/// turned about y, half a millimetre deep.
fn pair(kinds: [usize; 2], gap: Option<f32>, random: &mut SplitMix64) -> Pair {
    let mut solid = |kind| {
        let q = match gap {
            Some(_) => rotation(random),
            None => Quat::from_rotation_y(random.between(0.0, 6.0) as f32),
        };
        (shape(kind, random), Vec3::ZERO, q)
    };
    let mut pair = kinds.map(&mut solid);
    let direction = match gap {
        Some(_) => rotation(random) * Vec3::Y,
        None => Vec3::Y,
    };
    let (a, b) = Core::pair(&placed(&pair[0]), &placed(&pair[1]));
    pair[0].1 = direction * (gap.unwrap_or(-0.0005) - separation(&a, &b, direction));
    pair
}

/// A solid of 10 to 60 cm.
fn shape(kind: usize, random: &mut SplitMix64) -> Shape {
    let mut length = || random.between(0.05, 0.3) as f32;
    match kind {
        0 => Shape::Sphere { radius: length() },
        1 => Shape::Box {
            half_extents: Vec3::new(length(), length(), length()),
        },
        2 => Shape::Capsule {
            radius: length(),
            half_height: length(),
        },
        _ => Shape::Cylinder {
            radius: length(),
            half_height: length(),
        },
    }
}

/// Any orientation.
fn rotation(random: &mut SplitMix64) -> Quat {
    let axis = random.vector(1.0).as_vec3().normalize_or(Vec3::Y);
    Quat::from_axis_angle(axis, random.between(0.0, 6.0) as f32)
}
