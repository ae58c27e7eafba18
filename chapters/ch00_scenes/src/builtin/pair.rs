//! Two balls of 2 kg and 0.7 kg that meet off-centre in free space: nothing but their one
//! impulse acts, so momentum, which is (3.1, 0.14, 0) N s, can change only by a mistake.
//! Erratum 2 of the report is one: it scales each body's share of the impulse by mass
//! once more, which keeps momentum for equal masses alone.

use glam::DVec3;

use crate::{Body, Scene, Shape};

/// The scene. The balls close at 2.9 m/s and meet after 0.43 s, their centres 0.17 m off
/// the line of a head-on impact; the lighter one spins, so that friction acts too.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("pair");
    scene.gravity = DVec3::ZERO;
    scene.steps = 120;
    scene.restitution_threshold = Some(0.0);
    let shape = Shape::Sphere { radius: 0.2 };
    let heavy = Body {
        linear_velocity: DVec3::new(1.9, 0.0, 0.0),
        ..Body::new(shape, 2.0, DVec3::new(-0.8, 0.0, 0.0))
    };
    let light = Body {
        linear_velocity: DVec3::new(-1.0, 0.2, 0.0),
        angular_velocity: DVec3::new(0.0, 0.0, 5.0),
        ..Body::new(shape, 0.7, DVec3::new(0.8, 0.05, 0.1))
    };
    scene.bodies = [heavy, light]
        .into_iter()
        .map(|body| Body {
            restitution: 0.8,
            friction: 0.3,
            ..body
        })
        .collect();
    scene
}
