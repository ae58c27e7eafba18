//! Balls, boxes, capsules and cylinders of random size, density and attitude hang in the
//! places of `balls` (`crowd.rs`) and fall into the same box, with e = 0 and μ = 0.5: every pair
//! of shapes meets.

use glam::DVec3;

use super::crowd::{LARGEST_RADIUS, open_box_for};
use super::parts::of_one_stuff;
use crate::random::SplitMix64;
use crate::{Body, Scene, Shape};

/// The scene: body 5 + i is a ball, a box, a capsule or a cylinder as i is 0, 1, 2 or 3
/// modulo 4.
pub(super) fn build(count: u64, seed: u64) -> Scene {
    let (mut scene, centres) = open_box_for("mixed", count, seed);
    let mut random = SplitMix64::new(seed);
    let bodies = centres
        .into_iter()
        .enumerate()
        .map(|(i, centre)| body(i, centre, &mut random));
    scene.bodies.extend(bodies);
    of_one_stuff(&mut scene.bodies, 0.0, 0.5);
    scene
}

/// A body of random size, density (500 … 1500 kg/m³), attitude, velocity (±1 m/s a component)
/// and spin (±3 rad/s a component), drawn in this order.
fn body(i: usize, centre: DVec3, random: &mut SplitMix64) -> Body {
    let shape = shape(i % 4, random);
    let mass = random.between(500.0, 1500.0) * shape.volume();
    Body {
        orientation: random.rotation(),
        linear_velocity: random.vector(1.0),
        angular_velocity: random.vector(3.0),
        ..Body::new(shape, mass, centre)
    }
}

/// A solid that fits a ball of 0.3 m.
fn shape(kind: usize, random: &mut SplitMix64) -> Shape {
    match kind {
        0 => Shape::Sphere {
            radius: random.between(0.1, LARGEST_RADIUS),
        },
        1 => Shape::Box {
            half_extents: DVec3::from([(); 3].map(|()| random.between(0.06, 0.17))),
        },
        2 => Shape::Capsule {
            radius: random.between(0.05, 0.12),
            half_height: random.between(0.05, 0.18),
        },
        _ => Shape::Cylinder {
            radius: random.between(0.08, 0.21),
            half_height: random.between(0.05, 0.21),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_body_fits_the_ball_that_its_place_has_room_for() {
        for body in &build(1000, 1).bodies[5..] {
            let reach = body.shape.bounding_radius();
            assert!((0.08..=LARGEST_RADIUS).contains(&reach), "{reach}");
        }
    }

    #[test]
    fn a_quarter_of_the_bodies_is_of_each_shape() {
        let scene = build(100, 1);
        let is = |pattern: fn(&Shape) -> bool| {
            let bodies = scene.bodies[5..].iter();
            bodies.filter(|body| pattern(&body.shape)).count()
        };
        assert_eq!(is(|shape| matches!(shape, Shape::Sphere { .. })), 25);
        assert_eq!(is(|shape| matches!(shape, Shape::Box { .. })), 25);
        assert_eq!(is(|shape| matches!(shape, Shape::Capsule { .. })), 25);
        assert_eq!(is(|shape| matches!(shape, Shape::Cylinder { .. })), 25);
    }

    #[test]
    fn masses_lie_between_the_lightest_and_the_heaviest_stuff() {
        for body in &build(1000, 2).bodies[5..] {
            let density = body.mass / body.shape.volume();
            assert!((500.0..1500.0001).contains(&density), "{density}");
        }
    }

    #[test]
    fn nothing_bounces() {
        assert!(
            build(4, 1)
                .bodies
                .iter()
                .all(|body| body.restitution == 0.0)
        );
    }

    #[test]
    fn the_same_seed_gives_the_same_bodies_and_another_seed_others() {
        assert_eq!(build(20, 5), build(20, 5));
        assert_ne!(build(20, 5).bodies, build(20, 6).bodies);
    }
}
