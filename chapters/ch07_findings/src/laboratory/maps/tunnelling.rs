//! 23: which balls get through a wall. Those are first that are never seen in it (P₁), or not before the middle
//! (P₂).

use super::{Map, Who, thinned};
use crate::chart::{Axis, Class};
use crate::laboratory::contenders::WITH_CCD;
use crate::laboratory::scenario::timed;
use crate::laboratory::scenarios::tunnelling::{HALF_WALL, RADIUS, behind, scene};
use crate::tunnelling::margin;

/// Balls of a cell, each at its own part of a step.
const PHASES: u32 = 50;

pub const MAP: Map = Map {
    number: "23",
    name: "tunnelling",
    title: "Which balls get through a wall of 0.1 m",
    value: "share of the balls that are behind the wall after 0.5 s",
    axes: || [Axis::log("speed (m/s)"), Axis::log("steps a second (1/s)")],
    grid: |quick| {
        let speeds = (0..=18).map(|k| 2.0 * 2f64.powf(0.5 * f64::from(k)));
        let rates = (0..=12).map(|k| (15.0 * 2f64.powf(0.5 * f64::from(k))).round());
        [speeds.collect(), rates.collect()].map(|all| thinned(all, quick))
    },
    bounds: [0.0, 0.5],
    classes: ["none gets through", "up to half of them do", "more do"],
    better_upwards: true,
    theory: "from below: (2r + w)/Δt with corrected's margin, (2r + w)/Δt (P₁), (r + w/2)/Δt (P₂)",
    who: || {
        let mut all: Vec<Who> = Who::all(["printed"])
            .map(|who| who.law(Class::Held, unseen).line(crosses))
            .collect();
        let afar = |who: Who| who.law(Class::Held, unseen_from_afar);
        let corrected = Who::all(["corrected"]).map(afar);
        all.extend(corrected.map(|who| who.line(unseen).line(crosses)));
        let found_too_late = |who: Who| who.law(Class::Held, crosses).line(unseen);
        all.extend(Who::all(["rapier"]).map(found_too_late));
        // Those look along the way of a step.
        let names = [
            WITH_CCD,
            "own-row",
            "coloured",
            "sequential-impulses",
            "soft-step",
            "xpbd",
        ];
        all.extend(Who::all(names).map(|who| who.line(unseen).line(crosses)));
        all
    },
    scene: |speed, rate, _| Ok(timed(scene(speed, rate as u32, PHASES), rate as u32, 0.5)),
    watcher: |scene, _, _| Box::new(behind(scene)),
};

/// Steps a second below which some ball isn't seen in the wall.
fn unseen(speed: f64) -> f64 {
    speed / (2.0 * (RADIUS + HALF_WALL))
}

/// The same where a wall is seen from a margin.
fn unseen_from_afar(speed: f64) -> f64 {
    speed / (2.0 * (RADIUS + HALF_WALL + margin()))
}

/// Below which some ball isn't seen before the middle.
fn crosses(speed: f64) -> f64 {
    speed / (RADIUS + HALF_WALL)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_safe_speeds_are_those_of_the_reference() {
        assert!((unseen(18.0) - 60.0).abs() < 1e-9);
        assert!((crosses(9.0) - 60.0).abs() < 1e-9);
    }
}
