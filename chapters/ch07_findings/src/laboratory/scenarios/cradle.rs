//! 17: Newton's cradle without its threads: one ball or two come in at 1 m/s, as many leave.

use ch00_scenes::Scene;
use glam::DVec3;

use super::{ball, of_one_stuff};
use crate::lab::worst;
use crate::laboratory::scenario::{AtTimes, SOME_RATES, Scenario, timed};

const RADIUS: f64 = 0.05;
const GAP: f64 = 1e-4;
const BALLS: usize = 5;

pub const SCENARIO: Scenario = Scenario {
    number: 17,
    name: "cradle",
    title: "Newton's cradle",
    watch: "Impacts that are solved all at once send one ball back and four on, with the same momentum and the same energy.",
    error: "speeds after all impacts, the worst of five balls, of 1 m/s; one and two come in",
    unit: "",
    one_percent: 0.01,
    scale: "of 1 m/s",
    pass: 0.02,
    fails: "",
    rates: SOME_RATES,
    scenes: |rate, _| {
        Ok([1, 2]
            .map(|coming: usize| {
                let mut scene = Scene::new("cradle");
                scene.gravity = DVec3::ZERO;
                scene.restitution_threshold = Some(0.0);
                for k in 0..BALLS {
                    let mut x = k as f64 * (2.0 * RADIUS + GAP);
                    let comes = k < coming;
                    if comes {
                        x -= 0.05;
                    }
                    let mut body = ball(RADIUS, 1.0, DVec3::X * x);
                    body.linear_velocity = DVec3::X * f64::from(u8::from(comes));
                    scene.bodies.push(body);
                }
                of_one_stuff(&mut scene, 1.0, 0.0);
                timed(scene, rate, 0.5)
            })
            .into())
    },
    watcher: |scene| {
        let coming = scene
            .bodies
            .iter()
            .filter(|body| body.linear_velocity.x > 0.0);
        let coming = coming.count();
        Box::new(AtTimes::new([0.5], move |now, _| {
            worst((0..BALLS).map(|k| {
                let leaves = f64::from(u8::from(k >= BALLS - coming));
                (now.state.linear_velocity[k].x - leaves).abs()
            }))
        }))
    },
    steps: None,
    page: "ch06_own_row",
};
