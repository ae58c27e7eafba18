//! 20: fifteen cubes on each other, which should stand for ever.

use ch00_scenes::{Scene, builtin};

use crate::lab::{Moment, worst};
use crate::laboratory::scenario::{Always, FEW_RATES, Scenario, timed};

pub const SCENARIO: Scenario = Scenario {
    number: 20,
    name: "stack",
    title: "Fifteen cubes on each other",
    watch: "Pressure goes from neighbour to neighbour: a sweep leaves 99 % of what is missing, and the tower sinks, leans and falls.",
    error: "farthest that any cube ever is from its place",
    unit: "m",
    one_percent: 0.01,
    scale: "of an edge",
    pass: 1e-3,
    fails: "fell: a cube is more than 0.5 m from its place",
    rates: FEW_RATES,
    scenes: |rate, quick| {
        let scene = builtin::build("stack", Some(15), None)?;
        Ok(vec![timed(scene, rate, if quick { 10.0 } else { 60.0 })])
    },
    watcher: |scene| Box::new(places_kept(scene, 0.5)),
    steps: None,
    page: "ch03_limits",
};

/// How far bodies get from where they start, m; farther than `fallen` is fallen.
pub fn places_kept(scene: &Scene, fallen: f64) -> Always<impl Fn(&Moment) -> f64 + use<>> {
    let at: Vec<_> = scene.bodies.iter().map(|body| body.position).collect();
    Always::new(
        move |now: &Moment| {
            let pairs = at.iter().zip(&now.state.position);
            worst(pairs.map(|(one, other)| one.distance(*other)))
        },
        (fallen, "fell"),
    )
}
