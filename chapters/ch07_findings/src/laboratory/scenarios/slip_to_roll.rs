//! 13: a ball that slides at 4 m/s and begins to roll.

use ch00_scenes::Scene;
use glam::DVec3;

use super::{G, ball, floor, of_one_stuff, share};
use crate::laboratory::scenario::{AtTimes, SOME_RATES, Scenario, timed};

const SPEED: f64 = 4.0;
const RADIUS: f64 = 0.5;
const FRICTION: f64 = 0.3;

pub const SCENARIO: Scenario = Scenario {
    number: 13,
    name: "slip_to_roll",
    title: "A ball that slides, then rolls",
    watch: "It ends with 5/7 of its speed whatever the friction; where it is by then tells when it began to roll.",
    error: "speed, spin and place after 1 s, the worst of the three",
    unit: "",
    one_percent: 0.01,
    scale: "of what is exact",
    pass: 1e-3,
    fails: "",
    rates: SOME_RATES,
    scenes: |rate, _| {
        let mut scene = Scene::new("slip_to_roll");
        scene.bodies.push(floor(20.0));
        let mut body = ball(RADIUS, 1.0, DVec3::Y * RADIUS);
        body.linear_velocity = DVec3::X * SPEED;
        scene.bodies.push(body);
        of_one_stuff(&mut scene, 0.0, FRICTION);
        Ok(vec![timed(scene, rate, 1.0)])
    },
    watcher: |_| {
        Box::new(AtTimes::new([1.0], |now, _| {
            let (rolls, slips) = (5.0 / 7.0 * SPEED, 2.0 * SPEED / (7.0 * FRICTION * G));
            let place = rolls + slips * (SPEED - rolls) / 2.0;
            let state = now.state;
            share(state.linear_velocity[1].x, rolls)
                .max(share(-state.angular_velocity[1].z * RADIUS, rolls))
                .max(share(state.position[1].x, place))
        }))
    },
    steps: None,
    page: "ch03_friction",
};
