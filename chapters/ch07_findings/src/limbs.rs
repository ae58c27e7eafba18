//! The report's observation about ragdolls at low frame rates, where a step is as long as a frame:
//! limbs sink into the floor and get through it. Five ragdolls for ten seconds with steps of 1/5 to
//! 1/60 s, which is what `--variable-step` does where frames take as long.

use std::fmt::Write as _;

use ch00_scenes::measures::{Placed, depth, escaped};
use ch00_scenes::{Scene, State, builtin};

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::lab::{self, METHODS, by, worst};
use crate::product::{Product, Say};
use crate::table::{Table, millimetres, three_digits};

/// Frames a second.
pub const RATES: [f64; 5] = [5.0, 10.0, 20.0, 30.0, 60.0];
/// Seeds of the scene.
pub const SEEDS: [u64; 5] = [1, 2, 3, 4, 5];
/// Ragdolls in it.
const RAGDOLLS: u64 = 5;

/// A run's end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The method.
    pub method: &'static str,
    /// Frames, and steps, a second.
    pub rate: f64,
    /// Seed of the scene.
    pub seed: u64,
    /// Bodies outside of the box, or nowhere, at the end.
    pub outside: usize,
    /// Of these: bodies that are no number.
    pub nowhere: usize,
    /// Deepest overlap of a body with the floor after any step, m.
    pub deepest: f64,
    /// The same in the last second, m.
    pub deepest_at_end: f64,
}

/// A row of the table: what it is, of a sample, and as text.
type Measured = (&'static str, fn(&Sample) -> f64, fn(f64) -> String);

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let seeds = if quick { &SEEDS[..2] } else { &SEEDS[..] };
    let mut samples = Vec::new();
    for (method, _) in METHODS {
        for rate in RATES {
            for &seed in seeds {
                samples.push(dropped(method, rate, seed)?);
            }
        }
        say(method);
    }
    Ok(Product {
        charts: vec![outside(&samples).into(), overlap(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples, seeds.len())),
    })
}

/// Drops five ragdolls.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn dropped(method: &'static str, rate: f64, seed: u64) -> Result<Sample, FindingsError> {
    let scene = builtin::build("ragdolls", Some(RAGDOLLS), Some(seed))?;
    let scene = lab::at_rate(scene, rate, 10.0);
    let mut sample = Sample {
        method,
        rate,
        seed,
        outside: 0,
        nowhere: 0,
        deepest: 0.0,
        deepest_at_end: 0.0,
    };
    lab::run(&scene, &by(method), |now| {
        let deepest = in_floor(&scene, now.state);
        sample.deepest = worst([sample.deepest, deepest]);
        if now.step + rate as u32 > scene.steps {
            sample.deepest_at_end = worst([sample.deepest_at_end, deepest]);
        }
        if now.step == scene.steps {
            sample.nowhere = now.state.not_finite();
            sample.outside = escaped(&scene, now.state).unwrap_or(0) + sample.nowhere;
        }
    })?;
    Ok(sample)
}

/// The deepest overlap with the floor, body 0, m.
fn in_floor(scene: &Scene, state: &State) -> f64 {
    let floor = Placed::new(scene, state, 0);
    let moving = (1..scene.bodies.len()).filter(|&i| !scene.bodies[i].is_static());
    let there =
        moving.filter(|&i| state.position[i].is_finite() && state.orientation[i].is_finite());
    let depths = there.filter_map(|i| depth(&Placed::new(scene, state, i), &floor));
    depths.fold(0.0, f64::max)
}

/// Mean over the seeds, and the least and the largest.
fn over_seeds(
    samples: &[Sample],
    method: &str,
    rate: f64,
    of: impl Fn(&Sample) -> f64,
) -> (f64, f64, f64) {
    let same = |s: &&Sample| s.method == method && s.rate == rate;
    let values: Vec<f64> = samples.iter().filter(same).map(of).collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    (mean, least, worst(values))
}

/// Two curves with bars from the best to the worst seed.
fn curves(samples: &[Sample], of: impl Fn(&Sample) -> f64 + Copy) -> Vec<Series> {
    METHODS
        .into_iter()
        .map(|(method, style)| {
            let all = RATES.map(|rate| (rate, over_seeds(samples, method, rate, of)));
            Series::new(method, style, all.map(|(rate, (mean, ..))| (rate, mean)))
                .with_bars(all.map(|(_, (_, least, most))| (least, most)).to_vec())
        })
        .collect()
}

fn outside(samples: &[Sample]) -> Chart {
    Chart {
        name: "limbs",
        title: "Five ragdolls (60 bodies): how many are outside after 10 s, mean and range of the seeds"
            .to_owned(),
        x: Axis::log("frames a second, a step each (Hz)"),
        y: Axis::linear("bodies outside of the box"),
        series: curves(samples, |s| s.outside as f64),
    }
}

fn overlap(samples: &[Sample]) -> Chart {
    let mut series = curves(samples, |s| 1e3 * s.deepest);
    series.push(Series::of(
        "radius of a forearm",
        Style::Theory,
        &RATES,
        |_| 45.0,
    ));
    Chart {
        name: "limbs_overlap",
        title: "Five ragdolls: deepest overlap with the floor in 10 s, mean and range of the seeds"
            .to_owned(),
        x: Axis::log("frames a second, a step each (Hz)"),
        y: Axis::log("overlap (mm)"),
        series,
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text =
        "method,rate_hz,seed,outside,not_finite,deepest_m,deepest_last_second_m\n".to_owned();
    for s in samples {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{:?},{},{},{},{:?},{:?}",
            s.method, s.rate, s.seed, s.outside, s.nowhere, s.deepest, s.deepest_at_end
        );
    }
    text
}

fn page(samples: &[Sample], seeds: usize) -> String {
    let mut headings = vec!["method", "measured"];
    let rates = RATES.map(|rate| format!("{rate} Hz"));
    headings.extend(rates.iter().map(String::as_str));
    let mut table = Table::new(&headings);
    let rows: [Measured; 3] = [
        (
            "bodies outside at the end",
            |s| s.outside as f64,
            three_digits,
        ),
        ("deepest in the floor (mm)", |s| s.deepest, millimetres),
        (
            "the same, last second (mm)",
            |s| s.deepest_at_end,
            millimetres,
        ),
    ];
    for (method, _) in METHODS {
        for (what, of, shown) in rows {
            let mut cells = vec![format!("`{method}`"), what.to_owned()];
            cells.extend(RATES.map(|rate| {
                let (mean, least, most) = over_seeds(samples, method, rate, of);
                if least == most {
                    shown(mean)
                } else {
                    format!("{} ({} … {})", shown(mean), shown(least), shown(most))
                }
            }));
            table.push(cells);
        }
    }
    format!(
        "{RAGDOLLS} ragdolls, {bodies} bodies, ten seconds with steps as long as the frames; mean (least … \
         largest) of {seeds} seeds.\n\n{table}",
        bodies = 12 * RAGDOLLS,
        table = table.markdown(2),
    )
}
