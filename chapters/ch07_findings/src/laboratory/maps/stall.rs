//! 3: who stops falling, and how far up. Two positions in single precision stall where g h² is less than half of
//! what the last bit of a height is worth; a velocity goes on growing, and moves the body where it reaches that
//! much a substep.

use super::{Map, Who, thinned};
use crate::chart::{Axis, Class};
use crate::laboratory::scenario::timed;
use crate::laboratory::scenarios::{G, stall};

/// A fall is looked at after this time, s.
const SECONDS: f64 = 1.0;

pub const MAP: Map = Map {
    number: "3",
    name: "stall",
    title: "Who never begins to fall",
    value: "error of the fall in the first second, as a share of it",
    axes: || [Axis::log("steps a second (1/s)"), Axis::log("height (m)")],
    grid: |quick| {
        let rates = (0..9).map(|k| 30.0 * 2f64.powi(k));
        // The law has its steps at powers of two.
        let heights = (3..20).map(|k| 1.5 * 2f64.powi(k));
        [rates.collect(), heights.collect()].map(|all| thinned(all, quick))
    },
    bounds: [0.01, 0.999_999],
    classes: [
        "falls, within 1 %",
        "falls by too much or too little",
        "never falls",
    ],
    better_upwards: false,
    theory: "from here on an increment is less than half a unit of the last bit",
    who: || {
        let mut all: Vec<Who> = Who::all(["printed", "corrected"])
            .map(|who| who.law(Class::Worse, |rate| limit(increment(rate.recip()))))
            .collect();
        let xpbd = Who::in_single("xpbd in single precision", "xpbd");
        all.push(xpbd.law(Class::Worse, |rate| limit(increment((20.0 * rate).recip()))));
        let soft = Who::in_single("soft-step in single precision", "soft-step");
        all.push(by_velocity(soft, 4.0));
        all.extend(Who::all(["own-row"]).map(|who| by_velocity(who, 8.0)));
        all.extend(Who::all(["coloured"]).map(|who| by_velocity(who, 3.0)));
        all.extend(Who::all(["rapier"]).map(|who| by_velocity(who, 4.0)));
        all.extend(Who::all(["xpbd"]));
        all.extend(Who::all(["soft-step"]));
        all
    },
    scene: |rate, height, _| Ok(timed(stall::scene(height), rate as u32, SECONDS)),
    watcher: |scene, _, _| Box::new(stall::fall(scene)),
};

/// What a method of positions adds in its first step of h s, m.
fn increment(h: f64) -> f64 {
    G * h * h
}

/// A method that stores a velocity has the largest increment in the last step.
fn by_velocity(who: Who, substeps: f64) -> Who {
    who.law(Class::Worse, move |rate| {
        limit(G * SECONDS / (substeps * rate))
    })
}

/// The height from which on single precision has no room for an increment, m.
#[must_use]
pub fn limit(increment: f64) -> f64 {
    2f64.powf(increment.log2().floor() + 25.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limits_are_those_of_the_reference() {
        for (substeps, wanted) in [(1.0, 65536.0), (4.0, 4096.0), (20.0, 128.0), (40.0, 32.0)] {
            let h = 1.0 / (60.0 * substeps);
            assert_eq!(limit(increment(h)), wanted, "{substeps}");
        }
    }
}
