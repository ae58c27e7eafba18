//! A chain with a heavy ball at its end, scenario 22: links of 0.25 m from pin to pin and
//! 1 kg, and a ball of 672 kg, released from the horizontal or hanging at rest.
//!
//! It should not stretch: 40 links keep the last pin at 10 m from the first. At rest pin k
//! carries g times the mass below it, 6984.72 N at the top and 6592.32 N at the ball. A
//! swing from the horizontal triples that. A sweep along the chain leaves 0.999 963 5 of the
//! error, so 1 % would take 126 253 sweeps.
//!
//! The ball is of steel: with 7842 kg/m³ its radius is 0.2735 m. It hangs by its surface. A
//! link is a capsule that ends at its pins.

use std::f64::consts::FRAC_PI_2;

use glam::{DQuat, DVec3};

use super::parts::{floor, static_box};
use crate::{Body, Joint, Scene, Shape};

/// From pin to pin, m.
const LINK: f64 = 0.25;
const LINK_RADIUS: f64 = 0.03;
const BALL_MASS: f64 = 672.0;
const BALL_RADIUS: f64 = 0.2735;
/// From the floor to the ball at its lowest, m.
const CLEARANCE: f64 = 2.0;

/// How the chain starts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Start {
    /// Stretched out along x.
    Horizontal,
    /// Straight down.
    Hanging,
}

/// The scene: body 0 is the hook, bodies 1 to `links` the chain from there, then the ball;
/// the floor far below is last. Pin k joins bodies k and k + 1.
pub(super) fn build(name: &str, links: u64, start: Start) -> Scene {
    let mut scene = Scene::new(name);
    let length = LINK * links as f64;
    let hook = DVec3::Y * (CLEARANCE + 2.0 * BALL_RADIUS + length);
    scene.bodies.push(static_box(DVec3::splat(0.05), hook));
    // A link's y axis points up the chain.
    let orientation = match start {
        Start::Horizontal => DQuat::from_rotation_z(FRAC_PI_2),
        Start::Hanging => DQuat::IDENTITY,
    };
    let place = |below: f64| hook - orientation * DVec3::Y * below;
    let link = Shape::Capsule {
        radius: LINK_RADIUS,
        half_height: LINK / 2.0 - LINK_RADIUS,
    };
    let ball = Shape::Sphere {
        radius: BALL_RADIUS,
    };
    let links = (0..links).map(|k| (link, 1.0, LINK * (k as f64 + 0.5)));
    for (shape, mass, below) in links.chain([(ball, BALL_MASS, length + BALL_RADIUS)]) {
        scene.joints.push(pin(scene.bodies.len(), shape));
        scene.bodies.push(Body {
            orientation,
            ..Body::new(shape, mass, place(below))
        });
    }
    scene.bodies.push(floor(length + 1.0, 2.0));
    scene
}

/// The pin at the upper end of body `b`, which is the lower end of the one before.
fn pin(b: usize, shape: Shape) -> Joint {
    let to_lower_end = if b == 1 { 0.0 } else { -LINK / 2.0 };
    let anchor_b = DVec3::Y * shape.bounding_radius();
    Joint::pin(b - 1, b, DVec3::Y * to_lower_end, anchor_b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Penetration, joint_separation};

    const BOTH: [Start; 2] = [Start::Horizontal, Start::Hanging];

    #[test]
    fn the_pins_meet_and_nothing_touches() {
        for start in BOTH {
            let scene = build("chain", 40, start);
            let state = State::start_of(&scene);
            let apart = joint_separation(&scene, &state).unwrap();
            assert!(apart < 1e-14, "{apart}");
            assert_eq!(Penetration::of(&scene, &state).pairs_touching, 0);
        }
    }

    #[test]
    fn forty_links_and_a_ball_have_the_masses_and_the_length_of_the_reference() {
        for start in BOTH {
            let scene = build("chain", 40, start);
            assert_eq!((scene.bodies.len(), scene.joints.len()), (43, 41));
            let mass: f64 = scene.bodies.iter().map(|body| body.mass).sum();
            assert!((9.81 * mass - 6984.72).abs() < 1e-9, "{mass}");
            let ball = &scene.bodies[41];
            let far = ball.position.distance(scene.bodies[0].position);
            assert!((far - 10.0 - BALL_RADIUS).abs() < 1e-14, "{far}");
        }
    }

    #[test]
    fn the_released_chain_lies_along_x_at_the_height_of_its_hook() {
        let scene = build("chain", 40, Start::Horizontal);
        let across = scene.bodies[41].position - scene.bodies[0].position;
        assert!(across.distance(DVec3::X * 10.2735) < 1e-14, "{across}");
    }

    #[test]
    fn the_ball_is_of_steel() {
        let scene = build("chain", 1, Start::Hanging);
        let density = scene.bodies[2].mass / scene.bodies[2].shape.volume();
        assert!((density - 7842.0).abs() < 1.0, "{density}");
    }
}
