//! 20: how many sweeps a tower takes. A sweep from a cold start leaves cos²(π/2n) of the error in n cubes.

use std::f64::consts::FRAC_PI_2;

use ch00_scenes::{Scene, builtin};

use super::mass_ratio::who;
use super::{Map, Who, thinned};
use crate::chart::{Axis, Class};
use crate::lab::worst;
use crate::laboratory::scenario::{Always, Watch, timed};
use crate::laboratory::scenarios::G;
use crate::laboratory::scenarios::stack::places_kept;

/// A cube that is farther from its place isn't held, m.
const HELD: f64 = 0.01;

pub const MAP: Map = Map {
    number: "20",
    name: "stack",
    title: "Which towers stand for 5 s",
    value: "farthest that any cube ever is from its place (m)",
    axes: || {
        [
            Axis::linear("cubes"),
            Axis::log("sweeps or substeps a step"),
        ]
    },
    grid: |quick| {
        let cubes = [1, 2, 3, 4, 5, 6, 8, 10, 12, 15].map(f64::from);
        let knobs = (0..9).map(|k| 2f64.powi(k));
        [cubes.to_vec(), knobs.collect()].map(|all| thinned(all, quick))
    },
    bounds: [HELD, 0.5],
    classes: [
        "within 1 %",
        "further from their places",
        "falls; first step: half of the error is left",
    ],
    better_upwards: true,
    theory: "1 % of the error is left from a cold start: ln 0.01 / ln cos²(π/2n) sweeps",
    who: || {
        let law = |who: Who| who.law(Class::Held, predicted);
        who().into_iter().map(law).collect()
    },
    scene: |cubes, _, quick| {
        let scene = builtin::build("stack", Some(cubes as u64), None)?;
        Ok(timed(scene, 60, if quick { 1.0 } else { 5.0 }))
    },
    watcher: |scene, _, _| Box::new(places_kept(scene, 0.5)),
};

/// Sweeps from a cold start that leave 1 % of the error in so many cubes; one cube takes one sweep.
#[must_use]
pub fn predicted(cubes: f64) -> f64 {
    let left = (FRAC_PI_2 / cubes).cos().powi(2);
    (0.01f64.ln() / left.ln()).max(1.0)
}

/// What is left of the error after a step from rest, in which nothing was pressed before: the speed that the
/// fastest cube has, over the speed g Δt that all would have.
pub fn falls_in_the_first_step(scene: &Scene) -> Box<dyn Watch> {
    let free = G * scene.dt;
    Box::new(Always::new(
        move |now| {
            let speeds = now.state.linear_velocity[1..].iter();
            worst(speeds.map(|v| v.y.abs())) / free
        },
        (f64::INFINITY, "NaN"),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fifteen_cubes_take_419_sweeps() {
        assert!(
            (predicted(15.0) - 419.2).abs() < 0.05,
            "{}",
            predicted(15.0)
        );
        assert_eq!(predicted(1.0), 1.0);
    }
}
