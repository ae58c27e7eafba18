//! The comparison: worlds of the same scene with different plans, stepped in turn.

use std::time::Instant;

use ch00_scenes::{Scene, Settings};
use ch05_properties::PropertiesEngine;
use ch05_properties::columns::AnyTable;
use ch05_properties::plan::{Part, Plan};
use ch05_properties::world::{Method, World};

use super::{More, Sample, built};
use crate::FindingsError;
use crate::draw;
use crate::lab::{Spread, median, turns};

/// A scene and how it is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    name: &'static str,
    count: Option<u64>,
    steps: u32,
}

impl Case {
    /// A built-in scene, how many there are of what it counts, and its steps.
    #[must_use]
    pub const fn new(name: &'static str, count: Option<u64>, steps: u32) -> Self {
        Self { name, count, steps }
    }

    /// The same with fewer of what it counts and fewer steps.
    #[must_use]
    pub fn shortened(self, by: u32) -> Self {
        Self {
            count: self.count.map(|count| count / u64::from(by)),
            steps: self.steps / by,
            ..self
        }
    }
}

/// Compares the planned run with the others, so many times.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded or a part changes what comes out.
pub fn measured(case: Case, repeats: usize) -> Result<super::Scene, FindingsError> {
    let scene = built(case.name, case.count)?;
    let runs = runs(&scene);
    let mut planned = Vec::new();
    let mut micros = vec![Vec::new(); runs.len()];
    let mut shares = vec![Vec::new(); runs.len()];
    let mut bytes = Vec::new();
    for _ in 0..repeats {
        let mut engines = load(&scene, &runs)?;
        let times = steps(case, &scene, &mut engines);
        same_bits(&scene, &runs, &engines)?;
        let step = median(times[0].iter().copied());
        planned.push(1e-3 * step);
        for (k, times_of_run) in times[1..].iter().enumerate() {
            let more = times_of_run.iter().zip(&times[0]);
            let more = median(more.map(|(with, without)| with - without));
            micros[k].push(more);
            shares[k].push(more / step);
        }
        bytes = engines.iter().map(|e| bytes_a_body(e.world())).collect();
    }
    let sample = |k: usize| Sample {
        more: runs[k].0,
        bytes: bytes[k + 1],
        micros: Spread::of_all(&micros[k]),
        share: Spread::of_all(&shares[k]),
    };
    let count = case.count.map(|count| draw::grouped(&count.to_string()));
    Ok(super::Scene {
        name: count.map_or(case.name.to_owned(), |n| format!("{}, {n}", case.name)),
        bodies: scene.dynamic_count(),
        bytes: bytes[0],
        planned: Spread::of_all(&planned),
        samples: (0..runs.len()).map(sample).collect(),
    })
}

/// What runs beside the planned one.
fn runs(scene: &Scene) -> Vec<(More, Plan)> {
    let method = Method::Corrected;
    let plan = Plan::of(scene, method);
    let parts = plan.left_out();
    let with = |part: Part| (More::Part(part.name()), plan.clone().with(part));
    let mut runs = vec![(More::Nothing, plan.clone())];
    runs.extend(parts.map(with));
    runs.push((More::All, Plan::full(method)));
    runs
}

/// The planned run, and the others.
fn load(scene: &Scene, runs: &[(More, Plan)]) -> Result<Vec<PropertiesEngine>, FindingsError> {
    let settings = Settings::defaults();
    let mut engines = vec![PropertiesEngine::load(scene, &settings)?];
    for (_, plan) in runs {
        let plan = |_: &Scene, _| plan.clone();
        engines.push(PropertiesEngine::load_with(scene, &settings, plan)?);
    }
    Ok(engines)
}

/// Makes all steps of all engines, in turn; gives what each step of each took, µs.
fn steps(case: Case, scene: &Scene, engines: &mut [PropertiesEngine]) -> Vec<Vec<f64>> {
    let dt = scene.dt as f32;
    let mut times = vec![Vec::new(); engines.len()];
    for (k, turn) in turns(case.steps, engines.len()) {
        let world = engines[k].world_mut();
        for _ in 0..turn {
            let start = Instant::now();
            world.step(dt, |_, _| ());
            times[k].push(1e6 * start.elapsed().as_secs_f64());
        }
    }
    times
}

/// Of a row of the bodies, and of their notes while they are resolved.
fn bytes_a_body(world: &World) -> usize {
    world.data.bodies.row_bytes() + world.data.motions.row_bytes()
}

/// Whether all runs have the same bits in every column of the bodies that the first one keeps.
fn same_bits(
    scene: &Scene,
    runs: &[(More, Plan)],
    engines: &[PropertiesEngine],
) -> Result<(), FindingsError> {
    let first = &engines[0].world().data.bodies;
    for (engine, (more, _)) in engines[1..].iter().zip(runs) {
        let other = &engine.world().data.bodies;
        let kept = (0..first.specs().len()).filter(|&place| first.column(place).is_kept());
        for place in kept {
            if first.column(place).memory() != other.column(place).memory() {
                return Err(FindingsError::Differs {
                    chart: "left_out",
                    scene: scene.name.clone(),
                    run: more.name().to_owned(),
                    what: format!("the bodies' column `{}`", first.specs()[place].name),
                });
            }
        }
    }
    Ok(())
}
