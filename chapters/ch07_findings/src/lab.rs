//! A run as the laboratory makes it: a scene on the book's engine, each step timed alone and looked
//! at when it is over.

use std::time::{Duration, Instant};

use ch00_scenes::{Engine, Scene, Settings, State};
use ch04_ragdolls::ENGINE;

use crate::FindingsError;
use crate::chart::Style;

/// The methods that are compared, with how their curves look.
pub const METHODS: [(&str, Style); 2] =
    [("printed", Style::Printed), ("corrected", Style::Corrected)];

/// What there is to look at after a step.
pub struct Moment<'a> {
    /// Number of the step, from 1.
    pub step: u32,
    /// Since the start, s.
    pub time: f64,
    /// Where everything is.
    pub state: &'a State,
    /// Who made the step.
    pub engine: &'a dyn Engine,
}

/// Makes the scene's steps; gives the time that each took.
///
/// # Errors
/// [`FindingsError::Load`] where the engine can't take the scene.
pub fn run(
    scene: &Scene,
    settings: &Settings,
    mut look: impl FnMut(&Moment),
) -> Result<Vec<Duration>, FindingsError> {
    let mut engine = (ENGINE.load)(scene, settings)?;
    let mut state = State::default();
    let mut times = Vec::with_capacity(scene.steps as usize);
    for step in 1..=scene.steps {
        let start = Instant::now();
        engine.step(scene.dt as f32);
        times.push(start.elapsed());
        engine.read_state(&mut state);
        look(&Moment {
            step,
            time: f64::from(step) * scene.dt,
            state: &state,
            engine: &*engine,
        });
    }
    Ok(times)
}

/// A method with its default number of sweeps.
pub fn by(method: &str) -> Settings {
    Settings::defaults().with_method(method)
}

/// The scene at so many steps a second for so long, s.
pub fn at_rate(scene: Scene, rate: f64, seconds: f64) -> Scene {
    Scene {
        dt: rate.recip(),
        steps: (rate * seconds).round() as u32,
        ..scene
    }
}

/// The one in the middle; of two, the larger. NaN of none.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The largest; what is no number is larger than all others. 0 of none.
pub fn worst(values: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
    values.into_iter().fold(0.0, larger)
}

/// The median time of a step, ms.
pub fn median_ms(times: &[Duration]) -> f64 {
    median(times.iter().map(|time| 1e3 * time.as_secs_f64()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_the_worst() {
        assert_eq!(worst([1.0, 3.0, 2.0]), 3.0);
        assert!(worst([1.0, f64::NAN, 2.0]).is_nan());
        assert_eq!(worst([]), 0.0);
    }

    #[test]
    fn the_median_needs_no_order() {
        assert_eq!(median([3.0, 1.0, 2.0]), 2.0);
        assert!(median([]).is_nan());
    }
}
