//! 21: how many sweeps a heavy cube on a light one takes. A sweep from a cold start leaves k/(k + 1) of the
//! error.

use ch00_scenes::builtin;

use super::stack::falls_in_the_first_step;
use super::{Knob, Map, Who, thinned};
use crate::chart::{Axis, Class};
use crate::laboratory::scenario::timed;
use crate::laboratory::scenarios::mass_ratio::Sink;
use crate::mass_ratio::{HELD, predicted};

pub const MAP: Map = Map {
    number: "21",
    name: "mass_ratio",
    title: "Who holds a heavy cube on one of 1 kg",
    value: "sink of the upper cube, the mean of the tenth second (m)",
    axes: || {
        [
            Axis::log("mass above / mass below"),
            Axis::log("sweeps or substeps a step"),
        ]
    },
    grid: |quick| {
        let ratios = [1, 3, 10, 30, 100, 300, 1000, 3000, 10_000];
        let knobs = (0..10).map(|k| 2f64.powi(k));
        let ratios = ratios.map(f64::from).to_vec();
        [ratios, knobs.collect()].map(|all| thinned(all, quick))
    },
    bounds: [HELD, 0.5],
    classes: [
        "within 1 %",
        "sinks further",
        "falls; first step: half of the error is left",
    ],
    better_upwards: true,
    theory: "1 % of the error is left from a cold start: ln 0.01 / ln(k/(k + 1)) sweeps",
    who: || {
        let law = |who: Who| who.law(Class::Held, predicted);
        who().into_iter().map(law).collect()
    },
    scene: |ratio, _, _| {
        let scene = builtin::build("heavy_on_light", Some(ratio as u64), None)?;
        Ok(timed(scene, 60, 10.0))
    },
    watcher: |_, _, _| Box::new(Sink::default()),
};

/// The same methods for towers: each with the knob that it has.
pub fn who() -> Vec<Who> {
    let mut all: Vec<Who> = Who::all(["sequential-impulses"])
        .map(|who| who.named("sequential-impulses: first step"))
        .map(|who| who.with(Knob::Sweeps))
        .map(|who| Who {
            instead: Some((1, falls_in_the_first_step)),
            ..who
        })
        .collect();
    all.push(Who::in_parts("xpbd: sweeps of one substep", "xpbd", 1).with(Knob::Sweeps));
    let sweeps = [
        ("corrected", "corrected: sweeps"),
        ("sequential-impulses", "sequential-impulses: sweeps"),
    ];
    let substeps = [
        ("soft-step", "soft-step: substeps"),
        ("xpbd", "xpbd: substeps"),
        ("own-row", "own-row: substeps"),
        ("coloured", "coloured: substeps"),
        ("rapier", "rapier: iterations"),
    ];
    for (knob, names) in [(Knob::Sweeps, &sweeps[..]), (Knob::Substeps, &substeps[..])] {
        for &(name, shown) in names {
            let one = Who::all([name]).map(|who| who.named(shown).with(knob));
            all.extend(one);
        }
    }
    all
}
