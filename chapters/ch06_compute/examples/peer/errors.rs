//! How good a run is: from scene and state alone, the same for every engine.

use ch00_scenes::measures::{
    Penetration, escaped, joint_separations, kinetic_energy_of, limit_excesses, percentile,
};
use ch00_scenes::{Scene, State};

/// What is wrong at one moment, and how lively the scene is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    /// Overlaps, m and as parts of the smaller body's radius.
    pub penetration: Penetration,
    /// How far joints are apart, m.
    pub gap: Spread,
    /// How far joints are beyond their limits, rad.
    pub excess: Spread,
    /// Bodies outside the box.
    pub outside: usize,
    /// Bodies with a number that is not finite.
    pub not_finite: usize,
    /// Mean kinetic energy of a body that can move and has finite numbers, J.
    pub kinetic_energy: f64,
}

/// The largest of some values, and what 99 of 100 don't exceed; 0 of none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spread {
    pub p99: f64,
    pub largest: f64,
}

impl Spread {
    /// Of those that are numbers.
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let values = sorted(values.filter(|value| !value.is_nan()));
        Self {
            p99: percentile(&values, 99),
            largest: percentile(&values, 100),
        }
    }
}

impl Errors {
    /// Of a state that has the scene's bodies.
    pub fn of(scene: &Scene, state: &State) -> Self {
        Self {
            penetration: Penetration::of_all_pairs(scene, state),
            gap: Spread::of(joint_separations(scene, state)),
            excess: Spread::of(limit_excesses(scene, state)),
            outside: escaped(scene, state).unwrap_or(0),
            not_finite: state.not_finite(),
            kinetic_energy: kinetic_energy(scene, state),
        }
    }
}

fn kinetic_energy(scene: &Scene, state: &State) -> f64 {
    let moving = (0..state.len()).filter(|&i| !scene.bodies[i].is_static());
    let energies = moving.map(|i| kinetic_energy_of(&scene.bodies[i], state, i));
    let sum: f64 = energies.filter(|energy| energy.is_finite()).sum();
    sum / scene.dynamic_count().max(1) as f64
}

/// The median of a number over some moments.
pub fn median(moments: &[Errors], number: impl Fn(&Errors) -> f64) -> f64 {
    percentile(&sorted(moments.iter().map(number)), 50)
}

/// The largest of a number over some moments.
pub fn largest(moments: &[Errors], number: impl Fn(&Errors) -> f64) -> f64 {
    moments.iter().map(number).fold(0.0, f64::max)
}

/// In order, the smallest first.
pub fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}
