//! 23: balls of 9 to 1,000 m/s at a wall as thick as they are wide across the middle.

use ch00_scenes::Scene;
use glam::DVec3;

use super::{ball, block, of_one_stuff};
use crate::lab::Moment;
use crate::laboratory::scenario::{AtTimes, Scenario, timed};

/// m.
pub const RADIUS: f64 = 0.1;
/// Half of the wall's thickness, m.
pub const HALF_WALL: f64 = 0.05;
/// m/s.
const SPEEDS: [f64; 5] = [9.0, 30.0, 100.0, 300.0, 1000.0];
/// Of each speed: so many places in a step to start from.
const PHASES: u32 = 20;
/// From one ball to the next, m.
const ASIDE: f64 = 0.5;

pub const SCENARIO: Scenario = Scenario {
    number: 23,
    name: "tunnelling",
    title: "Fast balls at a thin wall",
    watch: "What is looked at only at the ends of a step is never seen in the wall; what is found behind its middle comes out on the far side.",
    error: "share of the balls that are behind the wall afterwards, the worst of 9 to 1,000 m/s",
    unit: "",
    one_percent: 0.01,
    scale: "of the balls",
    pass: 0.0,
    fails: "",
    rates: &[30, 60, 120, 240, 480, 960, 1920],
    scenes: |rate, _| {
        Ok(SPEEDS
            .map(|speed| timed(scene(speed, rate, PHASES), rate, 0.5))
            .into())
    },
    watcher: |scene| Box::new(behind(scene)),
    steps: None,
    page: "ch03_limits",
};

/// The share of the balls that are behind the middle of the wall after half a second.
pub fn behind(scene: &Scene) -> AtTimes<impl Fn(&Moment, f64) -> f64 + use<>> {
    let balls = 1..scene.bodies.len();
    AtTimes::new([0.5], move |now, _| {
        let behind = |k: &usize| now.state.position[*k].x > 0.0;
        balls.clone().filter(behind).count() as f64 / balls.len() as f64
    })
}

/// Balls of one speed, m/s, each at its own part of a step.
pub fn scene(speed: f64, rate: u32, phases: u32) -> Scene {
    let mut scene = Scene::new("tunnelling");
    scene.gravity = DVec3::ZERO;
    let wide = ASIDE * f64::from(phases);
    scene
        .bodies
        .push(block(DVec3::new(HALF_WALL, wide, wide), DVec3::ZERO));
    for k in 0..phases {
        // The golden ratio spreads any number of phases evenly.
        let phase = (f64::from(k) * 0.618_033_988_7).fract() / f64::from(rate);
        let x = -0.5 - RADIUS - HALF_WALL - speed * phase;
        let y = ASIDE * (f64::from(k) - f64::from(phases) / 2.0);
        let mut body = ball(RADIUS, 1.0, DVec3::new(x, y, 0.0));
        body.linear_velocity = DVec3::X * speed;
        scene.bodies.push(body);
    }
    of_one_stuff(&mut scene, 0.0, 0.0);
    scene
}
