//! Many balls that settle into a bed of about six layers, for as many as a machine can hold: balls of
//! radius 0.1 to 0.3 m, e = 0.95, μ = 0.5, of the stuffs of `balls`.
//!
//! The floor grows with their number and the bed does not: one ball and a million press on the floor with
//! the same weight, so that what a step costs per ball can be compared. (The box of `balls` grows in all
//! three directions: 100,000 of them would lie 15 m deep, and take a minute to.)
//!
//! They start in columns that stand on a square lattice, each as wide as the widest ball. In its column a
//! ball is off the middle by as much as its radius leaves free, and rests all but on the one below: so the
//! lattice is loose sideways and dense upwards, no two balls overlap, and none falls far. All balls of one
//! level come before those of the next.
//!
//! Balls of this size fill 0.042 m³ on average, and settled they take up 0.6 of the space, as dense heaps
//! do. Thirteen of them in a column of 0.62 m lie 2.36 m deep: six times their mean diameter of 0.4 m.

use ch00_maths::f64::real::{PI, cos, sin};
use glam::DVec3;

use super::parts::{in_open_box, of_one_stuff};
use crate::random::SplitMix64;
use crate::{Body, Scene, Shape};

/// Radii of the balls, m.
const RADII: [f64; 2] = [0.1, 0.3];
/// How wide a column is, m.
const COLUMN: f64 = 0.62;
/// Balls of a column, on average.
const LEVELS: u64 = 13;
/// From a ball to the next below it, and of the lowest to the floor, m.
const GAP: f64 = 0.01;

/// The scene with `count` balls.
pub(super) fn build(count: u64, seed: u64) -> Scene {
    let columns = columns_for(count);
    let inner = columns.map(|columns| 0.5 * COLUMN * columns as f64);
    let mut random = SplitMix64::new(seed);
    let balls = balls(count, columns, &mut random);
    let top = balls.iter().map(|ball| ball.position.y).fold(0.0, f64::max);
    // A light ball that is hit by heavy ones flies higher than it started.
    let wall_height = 10.0 + 3.0 * top;

    let mut scene = in_open_box("pile", inner, wall_height, seed);
    scene.bodies.extend(balls);
    of_one_stuff(&mut scene.bodies, 0.95, 0.5);
    scene
}

/// How many columns stand along x and along z: as nearly a square as whole numbers allow.
fn columns_for(count: u64) -> [u64; 2] {
    let columns = ((count + LEVELS / 2) / LEVELS).max(1);
    let along_x = columns.isqrt();
    [along_x, columns.div_ceil(along_x)]
}

/// The balls, level upon level.
fn balls(count: u64, [along_x, along_z]: [u64; 2], random: &mut SplitMix64) -> Vec<Body> {
    let middle = |k: u64, of: u64| COLUMN * (k as f64 + 0.5 * (1.0 - of as f64));
    let columns = (0..along_z).flat_map(|z| (0..along_x).map(move |x| (x, z)));
    let feet = columns.map(|(x, z)| DVec3::new(middle(x, along_x), 0.0, middle(z, along_z)));
    let mut tops: Vec<DVec3> = feet.collect();
    let places = tops.len();
    (0..count as usize)
        .map(|i| ball_on(&mut tops[i % places], random))
        .collect()
}

/// A ball of random radius (0.1 … 0.3 m) and density (500 … 1500 kg/m³), somewhere above the `top` of its
/// column (a part of the free width and a direction), with a small velocity (±0.3 m/s a component) and
/// spin (±1 rad/s a component), drawn in this order. Raises the top.
fn ball_on(top: &mut DVec3, random: &mut SplitMix64) -> Body {
    let radius = random.between(RADII[0], RADII[1]);
    let shape = Shape::Sphere { radius };
    let mass = random.between(500.0, 1500.0) * shape.volume();
    let aside = random.unit() * (0.5 * COLUMN - radius);
    let towards = random.between(0.0, 2.0 * PI);
    let off_middle = aside * DVec3::new(cos(towards), 0.0, sin(towards));
    let place = *top + off_middle + DVec3::Y * (GAP + radius);
    top.y += GAP + 2.0 * radius;
    Body {
        linear_velocity: random.vector(0.3),
        angular_velocity: random.vector(1.0),
        ..Body::new(shape, mass, place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Penetration, escaped};

    #[test]
    fn no_balls_overlap_at_the_start_and_all_are_in_the_box() {
        for count in [1, 7, 13, 60, 1000, 30_000] {
            let scene = build(count, 3);
            assert_eq!(scene.dynamic_count() as u64, count);
            let start = State::start_of(&scene);
            let found = Penetration::of(&scene, &start);
            assert_eq!(found.pairs_touching, 0, "{count} balls: {found:?}");
            assert_eq!(escaped(&scene, &start), Some(0));
        }
    }

    #[test]
    fn the_floor_grows_with_the_number_of_balls() {
        for (count, off) in [(20, 0.5), (100, 0.15), (1000, 0.04), (100_000, 0.012)] {
            let [x, z] = build(count, 1).meta_pair("inner_half_extents").unwrap();
            let each = 4.0 * x * z / count as f64;
            let wanted = COLUMN * COLUMN / LEVELS as f64;
            assert!((each / wanted - 1.0).abs() < off, "{count} balls: {each}");
            assert!(x <= z && z < 2.1 * x, "{count} balls: {x} {z}");
        }
    }

    #[test]
    fn settled_balls_would_lie_six_mean_diameters_deep() {
        let scene = build(10_000, 1);
        let [x, z] = scene.meta_pair("inner_half_extents").unwrap();
        let balls = scene.bodies.iter().filter(|body| !body.is_static());
        let volume: f64 = balls.map(|ball| ball.shape.volume()).sum();
        let depth = volume / 0.6 / (4.0 * x * z);
        assert!((depth / 0.4 - 6.0).abs() < 0.3, "{depth} m");
    }

    #[test]
    fn no_ball_falls_far() {
        let balls = build(10_000, 1).bodies;
        let highest = balls[5..]
            .iter()
            .map(|ball| ball.position.y)
            .fold(0.0, f64::max);
        // Thirteen levels of 0.41 m on average; the highest of 783 columns is three deviations higher.
        assert!(highest < 7.5, "{highest}");
    }

    #[test]
    fn stuffs_and_sizes_are_those_of_the_balls() {
        for ball in &build(1000, 2).bodies[5..] {
            let Shape::Sphere { radius } = ball.shape else {
                panic!("a ball");
            };
            assert!((0.1..0.3).contains(&radius), "{radius}");
            let density = ball.mass / ball.shape.volume();
            assert!((500.0..1500.0001).contains(&density), "{density}");
            assert_eq!((ball.restitution, ball.friction), (0.95, 0.5));
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_balls_and_another_seed_others() {
        assert_eq!(build(20, 5), build(20, 5));
        assert_ne!(build(20, 5).bodies, build(20, 6).bodies);
    }
}
