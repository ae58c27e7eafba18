//! Newton's cradle, scenario 17: five equal balls with gaps of 0.1 mm, e = 1, each hung by
//! two threads that keep it in a plane. Balls that are drawn aside come in at 1 m/s.
//!
//! As many balls should leave as came in, at 1 m/s, while the others rest. Impacts that are
//! solved all at once give one ball in 2/N − 1 = −0.6 m/s and all others 2/N = 0.4 m/s, with
//! the same momentum and the same energy.

use glam::DVec3;

use super::parts::{floor, of_one_stuff, static_box};
use crate::{Body, Joint, Scene, Shape};

const BALLS: u32 = 5;
const RADIUS: f64 = 0.05;
const GAP: f64 = 1e-4;
/// Height of the rails that the threads hang from, and of the balls below them, m.
const RAIL_HEIGHT: f64 = 1.0;
const DROP: f64 = 0.5;
/// z of the rails, m: a thread is √(0.5² + 0.2²) m long.
const RAIL_Z: [f64; 2] = [-0.2, 0.2];
/// Of the balls that come in, at the bottom, m/s.
const SPEED: f64 = 1.0;

/// The scene: bodies 0 and 1 are the rails, 2 to 6 the balls from left to right, the first
/// `aside` of them drawn aside; the floor under them is last.
pub(super) fn build(aside: u64) -> Scene {
    let mut scene = Scene::new("cradle");
    scene.restitution_threshold = Some(0.0);
    let half_extents = DVec3::new(0.4, 0.01, 0.01);
    let rail = |z| static_box(half_extents, DVec3::new(0.0, RAIL_HEIGHT, z));
    scene.bodies.extend(RAIL_Z.map(rail));
    // A ball that swings down from the angle θ has v² = 2 g DROP (1 − cos θ).
    let cosine = 1.0 - SPEED * SPEED / (2.0 * scene.gravity.length() * DROP);
    let sine = (1.0 - cosine * cosine).sqrt();
    for k in 0..BALLS {
        let x = (f64::from(k) - f64::from(BALLS - 1) / 2.0) * (2.0 * RADIUS + GAP);
        let thread = if u64::from(k) < aside {
            DVec3::new(-sine, -cosine, 0.0)
        } else {
            DVec3::NEG_Y
        };
        let pivot = DVec3::new(x, RAIL_HEIGHT, 0.0);
        scene.joints.extend(threads(x, scene.bodies.len()));
        let shape = Shape::Sphere { radius: RADIUS };
        let ball = Body::new(shape, 1.0, pivot + DROP * thread);
        scene.bodies.push(ball);
    }
    scene.bodies.push(floor(0.8, 0.5));
    of_one_stuff(&mut scene.bodies, 1.0, 0.0);
    scene
}

/// The two threads from the rails at this x to the centre of a ball.
fn threads(x: f64, ball: usize) -> [Joint; 2] {
    [0, 1].map(|rail| Joint::Distance {
        a: rail,
        b: ball,
        anchor_a: DVec3::X * x,
        anchor_b: DVec3::ZERO,
        length: DROP.hypot(RAIL_Z[rail]),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Conserved, Penetration, joint_separation};

    #[test]
    fn all_threads_have_their_length_and_no_balls_touch() {
        for aside in 1..=4 {
            let scene = build(aside);
            let state = State::start_of(&scene);
            assert!(joint_separation(&scene, &state).unwrap() < 1e-15);
            assert_eq!(Penetration::of(&scene, &state).pairs_touching, 0);
        }
    }

    #[test]
    fn a_ball_drawn_aside_has_the_energy_of_one_metre_a_second() {
        let energy = |aside| {
            let scene = build(aside);
            Conserved::of(&scene, &State::start_of(&scene)).energy()
        };
        // All hanging straight down: 5 · 9.81 · 0.5 J.
        let down = 24.525;
        assert!((energy(1) - down - 0.5).abs() < 1e-14, "{}", energy(1));
        assert!((energy(2) - down - 1.0).abs() < 1e-14, "{}", energy(2));
    }

    #[test]
    fn the_balls_that_hang_straight_are_a_tenth_of_a_millimetre_apart() {
        let scene = build(1);
        for pair in scene.bodies[3..7].windows(2) {
            let gap = pair[1].position.distance(pair[0].position) - 2.0 * RADIUS;
            assert!((gap - 1e-4).abs() < 1e-15, "{gap}");
        }
    }
}
