//! 4: a box that tumbles freely, against the elliptic functions that it follows.

use ch00_scenes::{Body, Scene, Shape};
use glam::{DQuat, DVec3};

use super::angle_between;
use crate::laboratory::scenario::{AtTimes, MANY_RATES, Scenario, Watch, timed};

/// Times, s, and attitudes (w, x, y, z) of the reference.
const EXACT: [(f64, [f64; 4]); 4] = [
    (
        1.0,
        [
            0.215_151_736_6,
            0.004_631_939_503,
            -0.188_678_254_0,
            -0.958_169_500_6,
        ],
    ),
    (
        2.0,
        [
            0.834_237_559_8,
            -0.367_509_426_4,
            -0.001_110_612_090,
            0.411_075_761_7,
        ],
    ),
    (
        5.0,
        [
            0.742_614_196_2,
            -0.427_968_306_2,
            -0.030_283_079_08,
            -0.514_247_235_9,
        ],
    ),
    (
        10.0,
        [
            0.389_395_278_3,
            -0.106_057_607_8,
            -0.035_904_831_18,
            -0.914_239_544_2,
        ],
    ),
];

// ANCHOR: scenario
pub const SCENARIO: Scenario = Scenario {
    number: 4,
    name: "free_top",
    title: "A box that tumbles in free space",
    watch: "Without the gyroscopic torque no step is small enough; added explicitly it makes the body gain energy, implicitly lose it.",
    error: "angle from the exact attitude, the worst at 1, 2, 5 and 10 s",
    unit: "rad",
    one_percent: 0.01,
    scale: "of a radian",
    pass: 1e-3,
    fails: "",
    rates: MANY_RATES,
    scenes: |rate, _| Ok(vec![timed(top(DVec3::new(1.0, 2.0, 3.0)), rate, 10.0)]),
    watcher: |_| attitudes(&EXACT),
    steps: None,
    page: "ch02_rigid_bodies",
};
// ANCHOR_END: scenario

/// The box of scenarios 4 and 5, with so much spin, rad/s.
pub fn top(angular_velocity: DVec3) -> Scene {
    let half_extents = DVec3::new(0.3, 0.2, 0.1);
    let body = Body::new(Shape::Box { half_extents }, 1.0, DVec3::ZERO);
    let mut scene = Scene::new("free_top");
    scene.gravity = DVec3::ZERO;
    scene.bodies.push(Body {
        angular_velocity,
        ..body
    });
    scene
}

/// Compares attitudes at their times.
pub fn attitudes(exact: &'static [(f64, [f64; 4])]) -> Box<dyn Watch> {
    let times: Vec<f64> = exact.iter().map(|known| known.0).collect();
    Box::new(AtTimes::new(times, move |now, time| {
        let known = exact.iter().find(|known| known.0 == time);
        let [w, x, y, z] = known.map_or([f64::NAN; 4], |known| known.1);
        angle_between(now.state.orientation[0], DQuat::from_xyzw(x, y, z, w))
    }))
}
