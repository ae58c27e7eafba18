//! 22: forty links of a kilogramme and a ball of 672, let go from the horizontal.

use ch00_scenes::{builtin, measures::joint_separation};

use crate::laboratory::scenario::{Always, FEW_RATES, Scenario, timed};

pub const SCENARIO: Scenario = Scenario {
    number: 22,
    name: "ball_and_chain",
    title: "A chain with a heavy ball",
    watch: "Forty joints in a row carry what hangs below them: a sweep tells a joint of its neighbour only, and the chain stretches like rubber.",
    error: "widest joint, the worst of all steps",
    unit: "m",
    one_percent: 2.5e-3,
    scale: "of a link",
    pass: 1e-4,
    fails: "torn: a joint is open by more than 2.5 m",
    rates: FEW_RATES,
    scenes: |rate, quick| {
        let mut scene = builtin::build("chain", Some(40), None)?;
        // The floor would stop a ball that sinks.
        scene.bodies.pop();
        Ok(vec![timed(scene, rate, if quick { 3.0 } else { 10.0 })])
    },
    watcher: |scene| {
        let scene = scene.clone();
        Box::new(Always::new(
            move |now| joint_separation(&scene, now.state).unwrap_or(f64::NAN),
            (2.5, "torn"),
        ))
    },
    steps: None,
    page: "ch06_ragdolls",
};
