//! 5: the same box, set spinning about its middle axis: it flips over every 5.1 s.

use glam::DVec3;

use super::free_top::{SCENARIO as FREE_TOP, attitudes, top};
use crate::laboratory::scenario::{Scenario, timed};

/// Times, s, and attitudes (w, x, y, z) of the reference.
const EXACT: [(f64, [f64; 4]); 4] = [
    (
        1.0,
        [
            0.801_240_868_6,
            -0.000_541_789_688_9,
            -0.598_199_571_1,
            -0.013_040_325_82,
        ],
    ),
    (
        2.0,
        [
            0.282_693_787_4,
            0.013_314_711_01,
            -0.954_578_104_1,
            -0.093_207_210_85,
        ],
    ),
    (
        5.0,
        [
            0.013_191_358_7,
            -0.871_131_947_2,
            0.004_364_470_594,
            -0.490_852_391_3,
        ],
    ),
    (
        10.0,
        [
            0.518_121_396_9,
            -0.008_039_290_59,
            -0.855_165_908_5,
            -0.013_298_752_87,
        ],
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
