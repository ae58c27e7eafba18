//! How well a run keeps energy and momentum, step by step.
//!
//! The sums are compared with the start of the scene, as [`Reference`] says. What someone
//! does from outside (throwing a body in, dragging one) is no error of the engine, so the
//! start moves along with it: the curve goes on where it was.

use std::collections::VecDeque;

use ch00_scenes::measures::{Conserved, Reference};
use ch00_scenes::{Scene, State};

/// The errors after one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Simulated time, s.
    pub time: f64,
    /// Kinetic energy, J.
    pub kinetic_energy: f64,
    /// Potential energy, J.
    pub potential_energy: f64,
    /// Energy gained since the start, relative; none where the scene feeds energy in.
    pub energy_error: Option<f64>,
    /// Momentum off the start's, relative; none where walls or weight take momentum up.
    pub momentum_error: Option<f64>,
}

/// Bodies up to which every step is measured; beyond, every second step for twice as many,
/// and so on, so that the sums over all bodies cost no more than those over so many. The
/// interval follows from the scene and not from the time that measuring takes, so that two
/// runs measure the same steps.
pub const BODIES_MEASURED_A_STEP: usize = 10_000;

/// How many samples are kept for the plot: a minute at 60 Hz.
pub const SAMPLES_KEPT: usize = 3600;

/// The errors so far.
#[derive(Clone, Debug)]
pub struct History {
    reference: Reference,
    every: u64,
    samples: VecDeque<Sample>,
    largest_momentum_error: Option<f64>,
}

impl History {
    /// A history that begins with the scene's start.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut history = Self {
            reference: Reference::of(scene),
            every: scene.bodies.len().div_ceil(BODIES_MEASURED_A_STEP).max(1) as u64,
            samples: VecDeque::new(),
            largest_momentum_error: None,
        };
        history.record(scene, &State::start_of(scene), 0.0);
        history
    }

    /// The last samples, oldest first, at most [`SAMPLES_KEPT`].
    #[must_use]
    pub fn samples(&self) -> &VecDeque<Sample> {
        &self.samples
    }

    /// Every how many steps there is a sample.
    #[must_use]
    pub fn every(&self) -> u64 {
        self.every
    }

    /// The largest momentum error of all samples, those no longer kept too; none where
    /// momentum isn't kept.
    #[must_use]
    pub fn largest_momentum_error(&self) -> Option<f64> {
        self.largest_momentum_error
    }

    /// Whether the state after this step is to be measured, where the one after step `last` was.
    pub(crate) fn is_due(&self, last: u64, step: u64) -> bool {
        step / self.every > last / self.every
    }

    /// Measures a state.
    pub(crate) fn record(&mut self, scene: &Scene, state: &State, time: f64) {
        let now = Conserved::of(scene, state);
        let sample = Sample {
            time,
            kinetic_energy: now.kinetic_energy,
            potential_energy: now.potential_energy,
            energy_error: self.reference.energy_error(&now),
            momentum_error: self.reference.momentum_error(&now),
        };
        if self.samples.len() == SAMPLES_KEPT {
            self.samples.pop_front();
        }
        self.samples.push_back(sample);
        self.largest_momentum_error = larger(self.largest_momentum_error, sample.momentum_error);
    }

    /// Moves the start by what came from outside: the change from `before` to `after`. From sums
    /// that are no numbers there is no way back: the start is then what is now.
    pub(crate) fn forgive(&mut self, before: &Conserved, after: &Conserved) {
        let start = &mut self.reference.start;
        if !is_finite(before) {
            *start = *after;
            return;
        }
        start.kinetic_energy += after.kinetic_energy - before.kinetic_energy;
        start.potential_energy += after.potential_energy - before.potential_energy;
        start.momentum += after.momentum - before.momentum;
        start.angular_momentum += after.angular_momentum - before.angular_momentum;
        start.momentum_sum += after.momentum_sum - before.momentum_sum;
        start.angular_momentum_sum += after.angular_momentum_sum - before.angular_momentum_sum;
    }
}

fn is_finite(sums: &Conserved) -> bool {
    let energies = [sums.kinetic_energy, sums.potential_energy];
    let sizes = [sums.momentum_sum, sums.angular_momentum_sum];
    energies.iter().chain(&sizes).all(|sum| sum.is_finite())
}

/// The larger of two values that may be absent; an error that is not a number is the
/// largest there can be.
pub(crate) fn larger(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b > a || b.is_nan() { b } else { a }),
        (a, b) => a.or(b),
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{Body, Shape, builtin};
    use glam::DVec3;

    use super::*;

    fn pair() -> Scene {
        builtin::build("pair", None, None).expect("`pair` is built in")
    }

    #[test]
    fn the_start_has_no_error() {
        let history = History::new(&pair());
        let start = history.samples()[0];
        assert_eq!(
            (start.energy_error, start.momentum_error),
            (Some(0.0), Some(0.0))
        );
    }

    #[test]
    fn the_largest_momentum_error_stays_after_the_error_has_gone() {
        let scene = pair();
        let mut history = History::new(&scene);
        let mut state = State::start_of(&scene);
        state.linear_velocity[0] += DVec3::X;
        history.record(&scene, &state, 1.0);
        history.record(&scene, &State::start_of(&scene), 2.0);
        assert_eq!(history.samples()[2].momentum_error, Some(0.0));
        assert!(history.largest_momentum_error() > Some(0.1));
    }

    #[test]
    fn what_comes_from_outside_is_no_error() {
        let scene = pair();
        let mut history = History::new(&scene);
        let mut state = State::start_of(&scene);
        let before = Conserved::of(&scene, &state);
        state.linear_velocity[0] += DVec3::X;
        history.forgive(&before, &Conserved::of(&scene, &state));
        history.record(&scene, &state, 1.0);
        let error = history.samples()[1].energy_error.expect("energy is kept");
        assert!(error.abs() < 1e-12, "{error}");
    }

    #[test]
    fn from_what_is_no_number_the_errors_begin_anew() {
        let scene = pair();
        let mut history = History::new(&scene);
        let mut state = State::start_of(&scene);
        state.linear_velocity[0].x = f64::NAN;
        let before = Conserved::of(&scene, &state);
        state.linear_velocity[0].x = 3.0;
        history.forgive(&before, &Conserved::of(&scene, &state));
        history.record(&scene, &state, 1.0);
        assert_eq!(history.samples()[1].energy_error, Some(0.0));
    }

    #[test]
    fn a_scene_of_thirty_thousand_bodies_is_measured_every_third_step() {
        let mut scene = Scene::new("many");
        let shape = Shape::Sphere { radius: 0.1 };
        scene.bodies = vec![Body::new(shape, 1.0, DVec3::ZERO); 30_000];
        let history = History::new(&scene);
        let is_due = |&step: &u64| history.is_due(step - 1, step);
        assert_eq!((1..=6).filter(is_due).collect::<Vec<_>>(), [3, 6]);
        assert!(history.is_due(2, 7), "of late states the first after it");
    }

    #[test]
    fn a_long_run_keeps_the_last_minute() {
        let scene = pair();
        let mut history = History::new(&scene);
        for step in 1..=SAMPLES_KEPT {
            history.record(&scene, &State::start_of(&scene), step as f64);
        }
        assert_eq!(history.samples().len(), SAMPLES_KEPT);
        assert_eq!(history.samples()[0].time, 1.0);
    }

    #[test]
    fn an_error_that_is_no_number_outweighs_all_others() {
        assert!(larger(Some(1.0), Some(f64::NAN)).is_some_and(f64::is_nan));
        assert!(larger(Some(f64::NAN), Some(1.0)).is_some_and(f64::is_nan));
        assert_eq!(larger(None, Some(1.0)), Some(1.0));
    }
}
