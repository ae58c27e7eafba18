//! The ball that a key throws: as large as the scene's largest body, as dense as its first,
//! from before the scene into its middle.

use ch00_scenes::{Body, Scene, Shape};
use glam::DVec3;

use crate::camera::Ray;
use crate::render::Surroundings;

/// Fastest throw, m/s.
const MOST_SPEED: f64 = 12.0;

/// The ball with this number, thrown along a line of sight.
#[must_use]
pub fn thrown_ball(scene: &Scene, around: &Surroundings, sight: Ray, number: u32) -> Body {
    let size = f64::from(around.radius());
    let radius = radius(scene, 0.1 * size);
    let shape = Shape::Sphere { radius };
    let to_middle = (around.centre() - sight.origin).length();
    let start = sight.at(to_middle - 1.2 * around.radius());
    Body {
        linear_velocity: sight.direction.as_dvec3() * (4.0 * size).min(MOST_SPEED),
        angular_velocity: DVec3::new(3.0, 5.0, f64::from(number % 7) - 3.0),
        restitution: 0.8,
        ..Body::new(shape, density(scene) * shape.volume(), start.as_dvec3())
    }
}

/// Of the largest moving body, but at most so much, m.
fn radius(scene: &Scene, most: f64) -> f64 {
    moving(scene)
        .map(|body| body.shape.bounding_radius())
        .fold(0.5 * most, f64::max)
        .min(most)
}

/// Of the first moving body, or of water, kg/m³.
fn density(scene: &Scene) -> f64 {
    moving(scene)
        .next()
        .map_or(1000.0, |body| body.mass / body.shape.volume())
}

fn moving(scene: &Scene) -> impl Iterator<Item = &Body> {
    scene.bodies.iter().filter(|body| !body.is_static())
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn a_thrown_ball_flies_at_the_scene_and_is_as_dense_as_it() {
        let mut scene = Scene::new("one");
        let shape = Shape::Sphere { radius: 0.5 };
        scene
            .bodies
            .push(Body::new(shape, 700.0 * shape.volume(), DVec3::ZERO));
        let around = Surroundings::of(&scene);
        let sight = Ray {
            origin: Vec3::new(0.0, 0.0, 10.0),
            direction: Vec3::NEG_Z,
        };
        let ball = thrown_ball(&scene, &around, sight, 0);
        assert!(ball.position.z > 0.5 && ball.position.z < 10.0);
        assert!(ball.linear_velocity.z < 0.0);
        assert!((ball.mass / ball.shape.volume() - 700.0).abs() < 1e-9);
    }
}
