//! One ball on a floor, whose bounces are known exactly: scenarios 11 (e = 1) and 12
//! (e = ½). The ball of 0.1 m falls from a centre height of 5 m; bounce n is at
//! t₁ (1 + e − 2eⁿ)/(1 − e) with t₁ = √(2·4.9/g) = 0.99949 s, the apex after it at
//! 0.1 + 4.9 e²ⁿ m. For e = 1 it is at (2n − 1) t₁ and every apex at 5 m.

use glam::DVec3;

use crate::{Body, Scene, Shape};

/// The scene in which ball and floor both have this coefficient, so that their mean is it.
pub(super) fn build(name: &str, restitution: f64) -> Scene {
    let floor = Shape::Box {
        half_extents: DVec3::new(2.0, 0.5, 2.0),
    };
    let ball = Shape::Sphere { radius: 0.1 };
    let mut scene = Scene::new(name);
    scene.restitution_threshold = Some(0.0);
    scene.bodies = [
        Body::new(floor, 0.0, DVec3::new(0.0, -0.5, 0.0)),
        Body::new(ball, 1.0, DVec3::new(0.0, 5.0, 0.0)),
    ]
    .into_iter()
    .map(|body| Body {
        restitution,
        friction: 0.0,
        ..body
    })
    .collect();
    scene
}
