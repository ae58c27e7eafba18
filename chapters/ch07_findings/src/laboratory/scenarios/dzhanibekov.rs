//! 5: the same box, set spinning about its middle axis: it flips over every 5.1 s.

use glam::DVec3;

use super::free_top::{SCENARIO as FREE_TOP, attitudes, top};
use crate::laboratory::scenario::{Scenario, timed};

/// Times, s, and attitudes (w, x, y, z) of the reference.
const EXACT: [(f64, [f64; 4]); 4] = [
    (
        1.0,
        [
            0.8012408686,
            -0.0005417896889,
            -0.5981995711,
            -0.01304032582,
        ],
    ),
    (
        2.0,
        [0.2826937874, 0.01331471101, -0.9545781041, -0.09320721085],
    ),
    (
        5.0,
        [0.0131913587, -0.8711319472, 0.004364470594, -0.4908523913],
    ),
    (
        10.0,
        [0.5181213969, -0.00803929059, -0.8551659085, -0.01329875287],
    ),
];

pub const SCENARIO: Scenario = Scenario {
    number: 5,
    name: "dzhanibekov",
    title: "A box that flips over",
    watch: "Any error grows as exp(2.4 t) near the middle axis; a constant spin never flips at all.",
    scenes: |rate, _| Ok(vec![timed(top(DVec3::new(0.05, 5.0, 0.05)), rate, 10.0)]),
    watcher: |_| attitudes(&EXACT),
    // Its errors grow by exp(2.4 t) and more than once: a hundred times those of scenario 4.
    pass: 0.1,
    ..FREE_TOP
};
