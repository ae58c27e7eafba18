//! The bouncing balls of the report's Table 1: balls of random size, mass and speed hang
//! in a spiral and fall into an open-lidded box, e = 0.95.
//!
//! A layer is a spiral r = s (1 + θ/2π) about a ball in the middle, with steps of about
//! 1.02 s along the arc, s = 0.66 m being 1.1 diameters of the largest ball. Layers lie s
//! apart, each turned against the one below by the golden angle, so that no ball hangs
//! right above another; odd layers run from the outside in.

use ch00_maths::f64::real::{PI, cos, sin};
use glam::DVec3;
use serde_json::json;

use super::MOST_BALLS;
use crate::random::SplitMix64;
use crate::{Body, Scene, SceneError, Shape};

const LARGEST_RADIUS: f64 = 0.3;
const SPACING: f64 = 2.2 * LARGEST_RADIUS;
const LOWEST_LAYER: f64 = 1.0;
/// The golden angle π (3 − √5), rad, to six places: as in the reference scene.
const TURN: f64 = 2.399_963;
const WALL_HALF_THICKNESS: f64 = 0.5;

/// The scene with `count` balls; the box grows with the cube root of their number.
pub(super) fn build(count: u64, seed: u64) -> Result<Scene, SceneError> {
    if count > MOST_BALLS {
        return Err(SceneError::Count {
            scene: "balls",
            count,
            least: 0,
            most: MOST_BALLS,
        });
    }
    let inner = inner_half_extent(count);
    let centres = spiral(count, inner);
    let top = centres.last().map_or(LOWEST_LAYER, |centre| centre.y);
    let wall_height = 10.0 + 3.0 * (top + SPACING);

    let mut scene = Scene::new("balls");
    scene.bodies = open_box(inner, wall_height);
    let mut random = SplitMix64::new(seed);
    scene
        .bodies
        .extend(centres.into_iter().map(|centre| ball(centre, &mut random)));
    scene
        .meta
        .insert("inner_half_extents".to_owned(), json!([inner, inner]));
    scene
        .meta
        .insert("wall_height".to_owned(), json!(wall_height));
    scene.meta.insert("seed".to_owned(), json!(seed));
    Ok(scene)
}

/// Half of the inner width of the box, m: 1.5 up to 60 balls.
#[expect(clippy::cast_precision_loss, reason = "count is at most 100,000")]
fn inner_half_extent(count: u64) -> f64 {
    1.5 * libm::cbrt(count as f64 / 60.0).max(1.0)
}

/// Floor and four walls, 1 m thick, inner faces at ±`inner` and y = 0.
fn open_box(inner: f64, wall_height: f64) -> Vec<Body> {
    let outer = inner + 2.0 * WALL_HALF_THICKNESS;
    let (half, middle) = (wall_height / 2.0, inner + WALL_HALF_THICKNESS);
    let wall_x = DVec3::new(WALL_HALF_THICKNESS, half, outer);
    let wall_z = DVec3::new(inner, half, WALL_HALF_THICKNESS);
    [
        (
            DVec3::new(outer, WALL_HALF_THICKNESS, outer),
            DVec3::new(0.0, -WALL_HALF_THICKNESS, 0.0),
        ),
        (wall_x, DVec3::new(middle, half, 0.0)),
        (wall_x, DVec3::new(-middle, half, 0.0)),
        (wall_z, DVec3::new(0.0, half, middle)),
        (wall_z, DVec3::new(0.0, half, -middle)),
    ]
    .into_iter()
    .map(|(half_extents, position)| elastic(Shape::Box { half_extents }, 0.0, position))
    .collect()
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
        ..elastic(shape, mass, centre)
    }
}

fn elastic(shape: Shape, mass: f64, position: DVec3) -> Body {
    Body {
        restitution: 0.95,
        friction: 0.5,
        ..Body::new(shape, mass, position)
    }
}

/// The centres of `count` balls, layer upon layer.
fn spiral(count: u64, inner: f64) -> Vec<DVec3> {
    let layer = spiral_layer(inner - 0.4);
    let inwards: Vec<_> = layer.iter().rev().copied().collect();
    let mut centres = Vec::new();
    let mut level = 0.0;
    let mut left = usize::try_from(count).unwrap_or(usize::MAX);
    for points in [&layer, &inwards].into_iter().cycle() {
        if left == 0 {
            break;
        }
        for &(radius, angle) in points.iter().take(left) {
            let turned = angle - level * TURN;
            centres.push(DVec3::new(
                radius * cos(turned),
                LOWEST_LAYER + level * SPACING,
                radius * sin(turned),
            ));
        }
        left = left.saturating_sub(points.len());
        level += 1.0;
    }
    centres
}

/// Radius and angle of the points of a layer, from the middle outwards.
fn spiral_layer(outermost: f64) -> Vec<(f64, f64)> {
    let mut points = vec![(0.0, 0.0)];
    let (mut radius, mut angle) = (SPACING, 0.0);
    while radius <= outermost {
        points.push((radius, angle));
        angle += 1.02 * SPACING / radius;
        radius = SPACING * (1.0 + angle / (2.0 * PI));
    }
    points
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
        let (ours, theirs) = (build(60, 1).unwrap(), reference());
        assert_eq!(ours.bodies.len(), theirs.bodies.len());
        for (i, (a, b)) in ours.bodies.iter().zip(&theirs.bodies).enumerate() {
            let off = (a.position - b.position).abs().max_element();
            // The file is rounded to 1e-6.
            assert!(off < 2e-6, "body {i} is off by {off}");
        }
    }

    #[test]
    fn the_box_of_sixty_balls_is_that_of_the_reference() {
        let (ours, theirs) = (build(60, 1).unwrap(), reference());
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
        for (a, b) in build(60, 1).unwrap().bodies.iter().zip(&reference().bodies) {
            assert!((a.restitution - b.restitution).abs() < 1e-15);
            assert!((a.friction - b.friction).abs() < 1e-15);
        }
    }

    #[test]
    fn no_balls_make_an_empty_box() {
        let scene = build(0, 1).unwrap();
        assert_eq!(scene.bodies.len(), 5);
        assert_eq!(scene.dynamic_count(), 0);
    }

    #[test]
    fn eight_times_sixty_balls_get_a_box_of_twice_the_width() {
        let scene = build(480, 1).unwrap();
        assert_eq!(scene.meta_pair("inner_half_extents"), Some([3.0, 3.0]));
    }

    #[test]
    fn no_balls_overlap_at_the_start() {
        for count in [10, 60, 1000, 10_000] {
            let scene = build(count, 3).unwrap();
            let start = Penetration::of(&scene, &State::start_of(&scene));
            assert_eq!(start.pairs_touching, 0, "{count} balls: {start:?}");
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_balls_and_another_seed_others() {
        assert_eq!(build(20, 5).unwrap(), build(20, 5).unwrap());
        assert_ne!(build(20, 5).unwrap().bodies, build(20, 6).unwrap().bodies);
    }

    #[test]
    fn masses_lie_between_the_lightest_and_the_heaviest_stuff() {
        for body in &build(1000, 2).unwrap().bodies[5..] {
            let density = body.mass / body.shape.volume();
            assert!((500.0..1500.0001).contains(&density), "{density}");
        }
    }

    #[test]
    fn more_than_a_hundred_thousand_balls_are_refused_with_the_range() {
        let message = build(1_000_000_000, 1).unwrap_err().to_string();
        assert!(
            message.contains("--count 1000000000: it can have 0 to 100000"),
            "{message}"
        );
    }
}
