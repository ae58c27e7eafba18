//! 3: a body at rest far up, in single precision. Where an increment is less than half of what the last bit
//! of a height is worth, it never begins to fall.

use ch00_scenes::Scene;
use glam::DVec3;

use super::{G, ball, share};
use crate::lab::Moment;
use crate::laboratory::scenario::{AtTimes, MANY_RATES, Scenario, timed};

/// m; of the theory the third stalls at 240 Hz, the second at 960.
const HEIGHTS: [f64; 3] = [10.0, 1000.0, 10_000.0];

pub const SCENARIO: Scenario = Scenario {
    number: 3,
    name: "stall",
    title: "A body that is let go 10 km up",
    watch: "Shorter steps make it worse: a method that stores two positions in single precision stops falling at all.",
    error: "fall in the first second, the worst of 10 m, 1 km and 10 km",
    unit: "",
    one_percent: 0.01,
    scale: "of the fall",
    pass: 0.01,
    fails: "",
    rates: MANY_RATES,
    scenes: |rate, _| Ok(HEIGHTS.map(|height| timed(scene(height), rate, 1.0)).into()),
    watcher: |scene| Box::new(fall(scene)),
    steps: None,
    page: "errata",
};

/// A body at rest so far up, m.
pub fn scene(height: f64) -> Scene {
    let mut scene = Scene::new("stall");
    scene.bodies.push(ball(0.1, 1.0, DVec3::Y * height));
    scene
}

/// The error of its fall in the first second, as a share of ½ g t².
pub fn fall(scene: &Scene) -> AtTimes<impl Fn(&Moment, f64) -> f64 + use<>> {
    let from = scene.bodies[0].position.y;
    AtTimes::new([1.0], move |now, _| {
        share(from - now.state.position[0].y, 0.5 * G)
    })
}
