//! 16: two balls that meet with friction: one pair sticks, one slips, one is head-on. They meet at the end of
//! the first step, so that who looks for contacts after moving finds them touching, with the exact normal.

use ch00_scenes::{Body, Scene};
use glam::DVec3;

use super::{ball, of_one_stuff};
use crate::lab::worst;
use crate::laboratory::scenario::{AtTimes, SOME_RATES, Scenario, timed};

/// How deep they are after a step, m: so that rounding leaves no gap.
const DEPTH: f64 = 1e-6;

/// v₁, v₂, ω₁ before; v₁, v₂, ω₁, ω₂ after; μ.
struct Case {
    friction: f64,
    before: [DVec3; 3],
    after: [DVec3; 4],
}

const CASES: [Case; 3] = [
    Case {
        friction: 0.5,
        before: [
            DVec3::new(3.0, 1.0, 0.0),
            DVec3::new(-1.0, 0.0, 0.0),
            DVec3::new(0.0, 0.0, 5.0),
        ],
        after: [
            DVec3::new(-1.8, 0.714_285_714_3, 0.0),
            DVec3::new(1.4, 0.142_857_142_9, 0.0),
            DVec3::new(0.0, 0.0, -2.142_857_143),
            DVec3::new(0.0, 0.0, -1.785_714_286),
        ],
    },
    Case {
        friction: 0.1,
        before: [
            DVec3::new(3.0, 4.0, 1.0),
            DVec3::new(-1.0, 0.0, 0.0),
            DVec3::new(0.0, 10.0, 5.0),
        ],
        after: [
            DVec3::new(-1.8, 3.52, 1.0),
            DVec3::new(1.4, 0.24, 0.0),
            DVec3::new(0.0, 10.0, -7.0),
            DVec3::new(0.0, 0.0, -3.0),
        ],
    },
    Case {
        friction: 0.0,
        before: [DVec3::new(3.0, 0.0, 0.0), DVec3::NEG_X, DVec3::ZERO],
        after: [
            DVec3::new(-1.8, 0.0, 0.0),
            DVec3::new(1.4, 0.0, 0.0),
            DVec3::ZERO,
            DVec3::ZERO,
        ],
    },
];

pub const SCENARIO: Scenario = Scenario {
    number: 16,
    name: "oblique",
    title: "Two balls that meet with friction",
    watch: "The impulse along the normal must be known before friction is cut off by it.",
    error: "speeds after the impact, of the 4 m/s before, and spins as fast; the worst of three pairs",
    unit: "",
    one_percent: 0.01,
    scale: "of 4 m/s",
    pass: 1e-3,
    fails: "",
    rates: SOME_RATES,
    scenes: |rate, _| {
        Ok(CASES
            .iter()
            .map(|case| {
                let mut scene = Scene::new("oblique");
                scene.gravity = DVec3::ZERO;
                scene.restitution_threshold = Some(0.0);
                let [v1, v2, spin] = case.before;
                let before = |x: f64, v: DVec3| DVec3::X * x - v / f64::from(rate);
                scene.bodies.push(Body {
                    linear_velocity: v1,
                    angular_velocity: spin,
                    ..ball(0.1, 1.0, before(-0.1, v1))
                });
                scene.bodies.push(Body {
                    linear_velocity: v2,
                    ..ball(0.2, 2.0, before(0.2 - DEPTH, v2))
                });
                of_one_stuff(&mut scene, 0.8, case.friction);
                timed(scene, rate, 0.2)
            })
            .collect())
    },
    watcher: |scene| {
        let friction = scene.bodies[0].friction;
        Box::new(AtTimes::new([0.2], move |now, _| {
            let case = CASES.iter().find(|case| case.friction == friction);
            let [v1, v2, w1, w2] = case.map_or([DVec3::NAN; 4], |case| case.after);
            let state = now.state;
            worst([
                state.linear_velocity[0].distance(v1) / 4.0,
                state.linear_velocity[1].distance(v2) / 4.0,
                state.angular_velocity[0].distance(w1) * 0.1 / 4.0,
                state.angular_velocity[1].distance(w2) * 0.2 / 4.0,
            ])
        }))
    },
    steps: None,
    page: "ch03_friction",
};
