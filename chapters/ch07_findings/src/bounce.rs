//! A ball that bounces, against its exact solution: scenarios 11 (e = 1) and 12 (e = 1/2), for
//! steps of 1/30 to 1/960 s and drop heights of 4.95 to 5.05 m, since the error goes up and down
//! with where in the step the ball meets the floor.
//!
//! An apex lies between two steps. In flight Δp = vΔt exactly, v being the speed half-way, so two
//! positions p*, p of a flight give it: ½(p* + p) + ⅛gΔt² + (Δp/Δt)²/2g. The two highest are taken.

use std::fmt::Write as _;

use ch00_scenes::{Scene, Settings, State, builtin};
use ch04_ragdolls::ENGINE;
use glam::DVec3;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::product::{Product, Say};
use crate::table::{Table, percent, three_digits};

/// m/s², as in the scene.
const G: f64 = 9.81;
/// m.
const RADIUS: f64 = 0.1;
/// Steps per second.
pub const RATES: [u32; 6] = [30, 60, 120, 240, 480, 960];
/// s, after which a run ends: every flight of interest has ended in a hit before.
const END: f64 = 12.0;

/// A scene with its exact solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// Name of the built-in scene.
    pub scene: &'static str,
    /// e of ball and floor.
    pub restitution: f64,
    /// How many apexes after hits are compared.
    pub apexes: usize,
}

/// Scenario 11, with the apexes of ten seconds, and scenario 12.
pub const CASES: [Case; 2] = [
    Case {
        scene: "bounce",
        restitution: 1.0,
        apexes: 5,
    },
    Case {
        scene: "bounce_half",
        restitution: 0.5,
        apexes: 4,
    },
];

/// The methods that are compared.
pub const METHODS: [&str; 2] = ["printed", "corrected"];

/// Errors of one run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// Height of the centre at the start, m.
    pub height: f64,
    /// Largest error of an apex, over its height above the radius; infinite where one is missing.
    pub apex: f64,
    /// How much too late the floor is hit first, s; infinite where it isn't.
    pub first_hit: f64,
}

/// The runs of a scene with a method and a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The scene.
    pub case: Case,
    /// The method.
    pub method: &'static str,
    /// Steps per second.
    pub rate: u32,
    /// A run for each drop height.
    pub runs: Vec<Run>,
}

/// Drop heights, m: 21, or 3 in a hurry.
#[must_use]
pub fn heights(quick: bool) -> Vec<f64> {
    let every = if quick { 10 } else { 1 };
    (0..=20)
        .step_by(every)
        .map(|k| 4.95 + 0.005 * f64::from(k))
        .collect()
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let heights = heights(quick);
    let mut samples = Vec::new();
    for case in CASES {
        for method in METHODS {
            for rate in RATES {
                samples.push(measured(case, method, rate, &heights)?);
            }
            say(&format!("{} {method}", case.scene));
        }
    }
    Ok(Product {
        charts: vec![chart(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples)),
    })
}

/// Drops the ball from each height.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn measured(
    case: Case,
    method: &'static str,
    rate: u32,
    heights: &[f64],
) -> Result<Sample, FindingsError> {
    let runs: Result<_, _> = heights
        .iter()
        .map(|&height| dropped(case, method, rate, height))
        .collect();
    Ok(Sample {
        case,
        method,
        rate,
        runs: runs?,
    })
}

fn dropped(case: Case, method: &str, rate: u32, height: f64) -> Result<Run, FindingsError> {
    let mut scene: Scene = builtin::build(case.scene, None, None)?;
    let ball = scene
        .bodies
        .iter()
        .position(|body| !body.is_static())
        .unwrap_or(0);
    scene.bodies[ball].position.y = height;
    scene.dt = 1.0 / f64::from(rate);
    let mut engine = (ENGINE.load)(&scene, &Settings::defaults().with_method(method))?;
    let mut state = State::default();
    let mut flights = Flights::new(height, scene.dt);
    for _ in 0..(END / scene.dt) as u32 {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        let acts = |depth: f64, impulse: DVec3| depth > 0.0 || impulse != DVec3::ZERO;
        let is_hit = engine.contacts().iter().any(|c| acts(c.depth, c.impulse));
        flights.advance(state.position[ball].y, is_hit);
    }
    Ok(Run {
        height,
        apex: apex_error(case, height, &flights.apexes),
        first_hit: flights.first_hit - (2.0 * (height - RADIUS) / G).sqrt(),
    })
}

/// The largest error of the apexes, each over its height above the radius.
fn apex_error(case: Case, height: f64, apexes: &[f64]) -> f64 {
    let mut above = height - RADIUS;
    (0..case.apexes).fold(0.0, |worst: f64, n| {
        above *= case.restitution * case.restitution;
        let error = apexes
            .get(n)
            .map_or(f64::INFINITY, |apex| ((apex - RADIUS) / above - 1.0).abs());
        if error > worst || error.is_nan() {
            error
        } else {
            worst
        }
    })
}

/// Takes a path of heights apart into hits and flights.
struct Flights {
    dt: f64,
    /// Height after the last step, m.
    last: f64,
    steps: u32,
    /// End of the first step that found ball and floor in touch, s: that is when the engine knows.
    first_hit: f64,
    /// Speed (absolute) half-way between the two highest positions of this flight, m/s, and
    /// its apex, m.
    flight: Option<(f64, f64)>,
    /// Apexes of the flights that ended, without the fall at the start, m.
    apexes: Vec<f64>,
}

impl Flights {
    fn new(start: f64, dt: f64) -> Self {
        Self {
            dt,
            last: start,
            steps: 0,
            first_hit: f64::INFINITY,
            flight: None,
            apexes: Vec::new(),
        }
    }

    /// The next height; `is_hit` where the engine changed the flight in this step.
    fn advance(&mut self, height: f64, is_hit: bool) {
        self.steps += 1;
        if is_hit {
            let ended = self.flight.take();
            if self.first_hit.is_finite() {
                self.apexes.extend(ended.map(|(_, apex)| apex));
            } else {
                self.first_hit = f64::from(self.steps) * self.dt;
            }
        } else {
            let speed = (height - self.last).abs() / self.dt;
            if self.flight.is_none_or(|(slowest, _)| speed < slowest) {
                let middle = 0.5 * (height + self.last) + 0.125 * G * self.dt * self.dt;
                self.flight = Some((speed, middle + 0.5 * speed * speed / G));
            }
        }
        self.last = height;
    }
}

impl Sample {
    /// Median and largest of an error's size over the drop heights.
    fn median_and_worst(&self, error: fn(&Run) -> f64) -> (f64, f64) {
        let mut errors: Vec<f64> = self.runs.iter().map(|run| error(run).abs()).collect();
        errors.sort_by(f64::total_cmp);
        let worst = errors.last().copied().unwrap_or(f64::NAN);
        (
            errors.get(errors.len() / 2).copied().unwrap_or(f64::NAN),
            worst,
        )
    }
}

/// Slope of log error over log step by least squares: the order in the step. Infinite and zero
/// errors have no logarithm and don't count; none with less than two others.
#[must_use]
pub fn order(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points
        .iter()
        .filter(|(_, error)| error.is_finite() && *error > 0.0)
        .map(|(dt, error)| (dt.ln(), error.ln()))
        .collect();
    let n = logs.len() as f64;
    let (sum_x, sum_y) = logs.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0, y + p.1));
    let (x0, y0) = (sum_x / n, sum_y / n);
    let spread: f64 = logs.iter().map(|(x, _)| (x - x0) * (x - x0)).sum();
    let shared: f64 = logs.iter().map(|(x, y)| (x - x0) * (y - y0)).sum();
    (spread > 0.0).then(|| shared / spread)
}

/// The samples of a scene and a method, by step.
fn of<'a>(samples: &'a [Sample], case: Case, method: &str) -> Vec<&'a Sample> {
    let same = |sample: &&Sample| sample.case == case && sample.method == method;
    samples.iter().filter(same).collect()
}

fn chart(samples: &[Sample]) -> Chart {
    let curve = |case: Case, method: &str, name: &str, style| {
        let samples = of(samples, case, method).into_iter();
        let worst = |s: &Sample| s.median_and_worst(|run| run.apex).1;
        let points = samples.map(|s| (f64::from(s.rate).recip(), worst(s)));
        Series::new(name, style, points)
    };
    let [one, half] = CASES;
    let steps: Vec<f64> = RATES.iter().map(|&rate| f64::from(rate).recip()).collect();
    Chart {
        name: "bounce",
        title: "A bouncing ball: worst error of an apex over all drop heights".to_owned(),
        x: Axis::log("time step (s)"),
        y: Axis::log("relative error of the apex height"),
        series: vec![
            curve(one, "printed", "printed, e = 1", Style::Printed),
            curve(half, "printed", "printed, e = ½", Style::Other(2)),
            curve(one, "corrected", "corrected, e = 1", Style::Corrected),
            curve(half, "corrected", "corrected, e = ½", Style::Other(3)),
            Series::of("1 %", Style::Theory, &steps, |_| 0.01),
        ],
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text =
        "scene,method,step_s,drop_height_m,worst_relative_apex_error,first_hit_late_s\n".to_owned();
    for sample in samples {
        let (scene, method, dt) = (
            sample.case.scene,
            sample.method,
            1.0 / f64::from(sample.rate),
        );
        for run in &sample.runs {
            let Run {
                height,
                apex,
                first_hit,
            } = run;
            // Writing into a String can't fail.
            let _ = writeln!(
                text,
                "{scene},{method},{dt:?},{height:?},{apex:?},{first_hit:?}"
            );
        }
    }
    text
}

/// A row of the table: a scene, a method, and how one error shrinks with the step.
fn row(
    samples: &[&Sample],
    what: &str,
    error: impl Fn(&Sample) -> f64,
    shown: fn(f64) -> String,
) -> Vec<String> {
    let errors: Vec<f64> = samples.iter().map(|sample| error(sample)).collect();
    let steps = samples.iter().map(|sample| f64::from(sample.rate).recip());
    let points: Vec<(f64, f64)> = steps.zip(errors.iter().copied()).collect();
    let fitted = order(&points).map_or("–".to_owned(), |order| {
        format!("{order:.1}").replace('-', "−")
    });
    let (e, method) = samples
        .first()
        .map_or((0.0, ""), |s| (s.case.restitution, s.method));
    let mut cells = vec![e.to_string(), format!("`{method}`"), what.to_owned()];
    cells.extend(errors.into_iter().map(shown));
    cells.push(fitted);
    cells
}

/// The table with a line on how it was measured.
fn page(samples: &[Sample]) -> String {
    let rates: Vec<String> = RATES.iter().map(|rate| format!("{rate} Hz")).collect();
    let mut headings = vec!["e", "method", "error"];
    headings.extend(rates.iter().map(String::as_str));
    headings.push("order");
    let mut table = Table::new(&headings);
    let milliseconds = |late: f64| format!("{} ms", three_digits(1e3 * late));
    for case in CASES {
        for method in METHODS {
            let of = of(samples, case, method);
            let apex = |run: &Run| run.apex;
            let hit = |run: &Run| run.first_hit;
            table.push(row(
                &of,
                "apex, median",
                |s| s.median_and_worst(apex).0,
                percent,
            ));
            table.push(row(
                &of,
                "apex, worst",
                |s| s.median_and_worst(apex).1,
                percent,
            ));
            table.push(row(
                &of,
                "first hit, worst",
                |s| s.median_and_worst(hit).1,
                milliseconds,
            ));
        }
    }
    let heights = samples.first().map_or(0, |sample| sample.runs.len());
    format!(
        "A ball of 0.1 m dropped from {heights} heights, 4.95 to 5.05 m; median and worst over them. \
         Apex: the largest error of the apexes 1 to {one} (e = 1, ten seconds) or 1 to {half} \
         (e = 0.5), over their height above the radius, from the parabola through the two highest \
         positions of each flight. First hit: from the exact time to the end of the step that \
         noticed. Order: slope of log error over log step, which says nothing where rounding \
         makes the error.\n\n{table}",
        one = CASES[0].apexes,
        half = CASES[1].apexes,
        table = table.markdown(3),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_a_square_is_two() {
        let points: Vec<_> = [0.1, 0.05, 0.025].map(|dt| (dt, 3.0 * dt * dt)).to_vec();
        assert!((order(&points).expect("three points") - 2.0).abs() < 1e-12);
        assert_eq!(
            order(&[(0.1, 1.0), (0.05, f64::INFINITY), (0.02, 0.0)]),
            None
        );
    }

    #[test]
    fn an_apex_between_two_steps_is_found_from_positions_alone() {
        let (dt, v0) = (0.03, 7.0);
        let mut flights = Flights::new(1.0, dt);
        flights.advance(0.1, true);
        let path = |t: f64| 0.1 + v0 * t - 0.5 * G * t * t;
        for k in 1..=40 {
            flights.advance(path(f64::from(k) * dt), false);
        }
        flights.advance(0.1, true);
        let exact = 0.1 + 0.5 * v0 * v0 / G;
        assert_eq!(flights.apexes.len(), 1);
        assert!(
            (flights.apexes[0] - exact).abs() < 1e-12,
            "{:?}",
            flights.apexes
        );
    }

    #[test]
    fn a_missing_apex_counts_as_lost() {
        assert_eq!(apex_error(CASES[0], 5.0, &[5.0, 5.0]), f64::INFINITY);
        assert_eq!(apex_error(CASES[0], 5.0, &[5.0; 5]), 0.0);
    }
}
