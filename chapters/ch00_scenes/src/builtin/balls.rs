//! The bouncing balls of the report's Table 1: balls of random size, mass and speed hang
//! in a spiral (`crowd.rs`) and fall into an open-lidded box, e = 0.95.

use glam::DVec3;

use super::crowd::{LARGEST_RADIUS, open_box_for};
use super::parts::of_one_stuff;
use crate::random::SplitMix64;
use crate::{Body, Scene, Shape};

/// The scene with `count` balls.
pub(super) fn build(count: u64, seed: u64) -> Scene {
    let (mut scene, centres) = open_box_for("balls", count, seed);
    let mut random = SplitMix64::new(seed);
    let balls = centres.into_iter().map(|centre| ball(centre, &mut random));
    scene.bodies.extend(balls);
    of_one_stuff(&mut scene.bodies, 0.95, 0.5);
    scene
}

/// A ball of random radius (0.1 … 0.3 m), density (500 … 1500 kg/m³), velocity (±1 m/s
/// a component) and spin (±3 rad/s a component), drawn in this order.
fn ball(centre: DVec3, random: &mut SplitMix64) -> Body {
    let radius = random.between(0.1, LARGEST_RADIUS);
    let shape = Shape::Sphere { radius };
    let mass = random.between(500.0, 1500.0) * shape.volume();
    Body {
        linear_velocity: random.vector(1.0),
        angular_velocity: random.vector(3.0),
        ..Body::new(shape, mass, centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::Penetration;

    fn reference() -> Scene {
        let text = include_str!("../../../../tests/reference/scenes/balls_60.json");
        Scene::from_json(text, "balls_60.json").unwrap()
    }

    #[test]
    fn sixty_balls_hang_where_the_reference_has_them() {
        let (ours, theirs) = (build(60, 1), reference());
        assert_eq!(ours.bodies.len(), theirs.bodies.len());
        for (i, (a, b)) in ours.bodies.iter().zip(&theirs.bodies).enumerate() {
            let off = (a.position - b.position).abs().max_element();
            // The file is rounded to 1e-6.
            assert!(off < 2e-6, "body {i} is off by {off}");
        }
    }

    #[test]
    fn the_box_of_sixty_balls_is_that_of_the_reference() {
        let (ours, theirs) = (build(60, 1), reference());
        for (a, b) in ours.bodies[..5].iter().zip(&theirs.bodies) {
            let (Shape::Box { half_extents: a }, Shape::Box { half_extents: b }) =
                (a.shape, b.shape)
            else {
                panic!("the first five bodies are the box");
            };
            assert!((a - b).abs().max_element() < 1e-12, "{a} {b}");
        }
        assert_eq!(
            ours.meta_pair("inner_half_extents"),
            theirs.meta_pair("inner_half_extents")
        );
        let height = ours.meta["wall_height"].as_f64().unwrap();
        assert!((height - 30.82).abs() < 1e-12, "{height}");
    }

    #[test]
    fn restitution_and_friction_are_those_of_the_reference() {
        for (a, b) in build(60, 1).bodies.iter().zip(&reference().bodies) {
            assert!((a.restitution - b.restitution).abs() < 1e-15);
            assert!((a.friction - b.friction).abs() < 1e-15);
        }
    }

    #[test]
    fn no_balls_make_an_empty_box() {
        let scene = build(0, 1);
        assert_eq!(scene.bodies.len(), 5);
        assert_eq!(scene.dynamic_count(), 0);
    }

    #[test]
    fn eight_times_sixty_balls_get_a_box_of_twice_the_width() {
        let scene = build(480, 1);
        assert_eq!(scene.meta_pair("inner_half_extents"), Some([3.0, 3.0]));
    }

    #[test]
    fn no_balls_overlap_at_the_start() {
        for count in [10, 60, 1000, 10_000] {
            let scene = build(count, 3);
            let start = Penetration::of(&scene, &State::start_of(&scene));
            assert_eq!(start.pairs_touching, 0, "{count} balls: {start:?}");
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_balls_and_another_seed_others() {
        assert_eq!(build(20, 5), build(20, 5));
        assert_ne!(build(20, 5).bodies, build(20, 6).bodies);
    }

    #[test]
    fn masses_lie_between_the_lightest_and_the_heaviest_stuff() {
        for body in &build(1000, 2).bodies[5..] {
            let density = body.mass / body.shape.volume();
            assert!((500.0..1500.0001).contains(&density), "{density}");
        }
    }
}
