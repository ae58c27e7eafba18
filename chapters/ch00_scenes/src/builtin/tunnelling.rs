//! Balls that fly at a thin wall, scenario 23: r = 0.1 m, a wall of w = 0.1 m, 60 Hz, no
//! gravity, seven speeds from 9 to 300 m/s.
//!
//! A row is a speed, the slowest below; along it the balls differ in phase: where in a step
//! they are when they come to the wall. What is looked at only once a step, of length
//! s = v Δt, is not seen in the wall by a share P₁ = max(0, 1 − (2r + w)/s) of the phases, and
//! is beyond its middle when first seen, so that it is pushed out on the far side, by a
//! share P₂ = max(0, 1 − (r + w/2)/s). As e = 0, who is held stays at the wall, and who came
//! through is gone: after a few steps the rows at the wall are a bar chart of 1 − P₂.
//!
//! | v (m/s) | 9 | 12 | 18 | 30 | 60 | 100 | 300 |
//! |---|---|---|---|---|---|---|---|
//! | P₁ | 0 | 0 | 0 | 0.4 | 0.7 | 0.82 | 0.94 |
//! | P₂ | 0 | 0.25 | 0.5 | 0.7 | 0.85 | 0.91 | 0.97 |

use glam::DVec3;

use super::parts::{of_one_stuff, static_box};
use crate::{Body, Scene, Shape};

const RADIUS: f64 = 0.1;
/// Thickness of the wall, m; its middle is at x = 0.
const WALL: f64 = 0.1;
/// Speeds of the rows, m/s.
const SPEEDS: [f64; 7] = [9.0, 12.0, 18.0, 30.0, 60.0, 100.0, 300.0];
/// Between neighbours in a row and between rows, m.
const SPACING: f64 = 0.3;
/// Steps in which no ball gets to the wall.
const STEPS_BEFORE: f64 = 3.0;

/// The scene: body 0 is the wall; row j of the seven is bodies 1 + j n to n + j n, where
/// n is `balls`. Ball k of a row comes 3 + (k + ½)/n steps after the start to where it
/// touches the wall.
pub(super) fn build(balls: u64) -> Scene {
    let mut scene = Scene::new("tunnelling");
    scene.gravity = DVec3::ZERO;
    scene.steps = 60;
    scene.restitution_threshold = Some(0.0);
    let width = SPACING * balls as f64;
    let height = SPACING * SPEEDS.len() as f64;
    let half_extents = DVec3::new(WALL, height + 2.0 * RADIUS, width + 2.0 * RADIUS) / 2.0;
    let wall = static_box(half_extents, DVec3::Y * height / 2.0);
    scene.bodies.push(wall);
    for (row, speed) in SPEEDS.into_iter().enumerate() {
        for k in 0..balls {
            let step = speed * scene.dt;
            let phase = (k as f64 + 0.5) / balls as f64;
            let place = DVec3::new(
                -(RADIUS + WALL / 2.0) - (STEPS_BEFORE + phase) * step,
                SPACING * (row as f64 + 0.5),
                SPACING * (k as f64 + 0.5) - width / 2.0,
            );
            let shape = Shape::Sphere { radius: RADIUS };
            scene.bodies.push(Body {
                linear_velocity: DVec3::X * speed,
                ..Body::new(shape, 1.0, place)
            });
        }
    }
    of_one_stuff(&mut scene.bodies, 0.0, 0.0);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shares of each row, of 1000 balls, that are never in the wall after a whole number of
    /// steps, and that are not before its middle when they first are or have been through.
    fn shares() -> Vec<[f64; 2]> {
        let scene = build(1000);
        let reach = RADIUS + WALL / 2.0;
        let places = |body: &Body| {
            let (x, step) = (body.position.x, body.linear_velocity.x * scene.dt);
            let mut later = (0..).map(move |n| x + f64::from(n) * step);
            later.find(|x| *x > -reach).unwrap()
        };
        scene.bodies[1..]
            .chunks_exact(1000)
            .map(|row| {
                let unseen = row.iter().filter(|body| places(body) >= reach).count();
                let through = row.iter().filter(|body| places(body) > 0.0).count();
                [unseen as f64 / 1000.0, through as f64 / 1000.0]
            })
            .collect()
    }

    #[test]
    fn the_shares_that_pass_are_those_of_the_theory() {
        let expected = [
            [0.0, 0.0],
            [0.0, 0.25],
            [0.0, 0.5],
            [0.4, 0.7],
            [0.7, 0.85],
            [0.82, 0.91],
            [0.94, 0.97],
        ];
        assert_eq!(shares(), expected);
    }

    #[test]
    fn no_ball_is_at_the_wall_in_the_first_three_steps() {
        for body in &build(20).bodies[1..] {
            let x = body.position.x + 3.0 * body.linear_velocity.x / 60.0;
            assert!(x < -0.15, "{x}");
        }
    }
}
