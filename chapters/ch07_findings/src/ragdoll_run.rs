//! Eight ragdolls against time: how far their joints come apart, how far beyond their limits they are
//! turned, how deep bodies overlap and how much they move, for ten seconds at 60 Hz, with the bounds
//! that the book promises.

use std::fmt::Write as _;

use ch00_scenes::builtin;
use ch00_scenes::measures::Measures;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::lab::{self, by, median, worst};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// Seeds of the scene.
pub const SEEDS: [u64; 5] = [1, 2, 3, 4, 5];
/// Ragdolls in it.
const RAGDOLLS: u64 = 8;
/// At rest: the steps of the last second.
const AT_REST: usize = 60;

/// A quantity, and what is promised of it.
struct Quantity {
    chart: &'static str,
    title: &'static str,
    unit: &'static str,
    label: &'static str,
    of: fn(&Sample) -> f64,
    /// Bound during the whole run.
    in_run: Option<f64>,
    /// Bound in the last second.
    at_rest: Option<f64>,
}

const QUANTITIES: [Quantity; 4] = [
    Quantity {
        chart: "ragdoll_run",
        title: "how far joints come apart",
        unit: "mm",
        label: "widest joint (mm)",
        of: |s| 1e3 * s.separation,
        in_run: Some(50.0),
        at_rest: Some(5.0),
    },
    Quantity {
        chart: "ragdoll_run_limits",
        title: "how far beyond their limits joints are turned",
        unit: "°",
        label: "largest excess of an angle (°)",
        of: |s| s.excess.to_degrees(),
        in_run: None,
        at_rest: Some(5.0),
    },
    Quantity {
        chart: "ragdoll_run_overlap",
        title: "how deep bodies overlap",
        unit: "mm",
        label: "99th percentile of the overlaps (mm)",
        of: |s| 1e3 * s.p99,
        in_run: None,
        at_rest: Some(10.0),
    },
    Quantity {
        chart: "ragdoll_run_energy",
        title: "how much bodies move",
        unit: "J",
        label: "kinetic energy a body (J)",
        of: |s| s.kinetic,
        in_run: None,
        at_rest: Some(1e-3),
    },
];

/// What is measured after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Since the start, s.
    pub time: f64,
    /// Widest joint, m.
    pub separation: f64,
    /// Largest angle beyond a limit, rad.
    pub excess: f64,
    /// 99th percentile of the overlaps, m.
    pub p99: f64,
    /// Deepest overlap, m.
    pub deepest: f64,
    /// Kinetic energy a body, J.
    pub kinetic: f64,
    /// Bodies outside of the box, or nowhere.
    pub outside: usize,
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let seeds = if quick { &SEEDS[..2] } else { &SEEDS[..] };
    let mut runs = Vec::new();
    for &seed in seeds {
        runs.push(dropped(RAGDOLLS, seed, 600)?);
        say(&format!("seed {seed}"));
    }
    Ok(Product {
        charts: QUANTITIES.iter().map(|q| q.chart(&runs).into()).collect(),
        csv: csv(seeds, &runs),
        page: Some(page(&runs)),
    })
}

/// Drops ragdolls, and measures after each step.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn dropped(ragdolls: u64, seed: u64, steps: u32) -> Result<Vec<Sample>, FindingsError> {
    let mut scene = builtin::build("ragdolls", Some(ragdolls), Some(seed))?;
    scene.steps = steps;
    let bodies = scene.dynamic_count() as f64;
    let mut samples = Vec::new();
    lab::run(&scene, &by("corrected"), |now| {
        let measured = Measures::of(&scene, now.state);
        let is_number = measured.not_finite == 0;
        let unless_lost = |value: Option<f64>| match value {
            Some(value) if is_number => value,
            _ => f64::NAN,
        };
        samples.push(Sample {
            time: now.time,
            separation: unless_lost(measured.joint_separation),
            excess: unless_lost(measured.limit_excess),
            p99: unless_lost(Some(measured.penetration.p99)),
            deepest: unless_lost(Some(measured.penetration.deepest)),
            kinetic: measured.conserved.kinetic_energy / bodies,
            outside: measured.escaped.unwrap_or(0) + measured.not_finite,
        });
    })?;
    Ok(samples)
}

impl Quantity {
    fn chart(&self, runs: &[Vec<Sample>]) -> Chart {
        let steps = runs.iter().map(Vec::len).min().unwrap_or(0);
        let over_seeds = |k: usize, how: fn(Vec<f64>) -> f64| {
            let values = runs.iter().map(|run| (self.of)(&run[k])).collect();
            (runs[0][k].time, how(values))
        };
        let mut series = vec![
            Series::new(
                "worst seed",
                Style::Other(2),
                (0..steps).map(|k| over_seeds(k, worst)),
            ),
            Series::new(
                "median of the seeds",
                Style::Corrected,
                (0..steps).map(|k| over_seeds(k, median)),
            ),
        ];
        let both = self.in_run.is_some() && self.at_rest.is_some();
        let name = if both {
            "bounds: in the run and, below, at rest"
        } else {
            "bound at rest"
        };
        let bounds = [(0.0, self.in_run), (9.0, self.at_rest)];
        let bounds = bounds
            .into_iter()
            .filter_map(|(from, value)| Some((from, value?)));
        series.extend(bounds.enumerate().map(|(k, (from, value))| {
            let name = if k == 0 { name } else { "" };
            Series::of(name, Style::Theory, &[from, 10.0], |_| value)
        }));
        Chart {
            name: self.chart,
            title: format!("{RAGDOLLS} ragdolls: {}", self.title),
            x: Axis::linear("time (s)"),
            y: Axis::log(self.label),
            series,
        }
    }

    /// The largest of a run's steps from number `from`, counted from 0.
    fn worst_from(&self, run: &[Sample], from: usize) -> f64 {
        worst(run.iter().skip(from).map(self.of))
    }
}

fn csv(seeds: &[u64], runs: &[Vec<Sample>]) -> String {
    let mut text = "seed,time_s,joint_separation_m,limit_excess_rad,p99_overlap_m,\
        deepest_overlap_m,kinetic_energy_a_body_j,outside\n"
        .to_owned();
    for (seed, run) in seeds.iter().zip(runs) {
        for s in run {
            // Writing into a String can't fail.
            let _ = writeln!(
                text,
                "{seed},{:?},{:?},{:?},{:?},{:?},{:?},{}",
                s.time, s.separation, s.excess, s.p99, s.deepest, s.kinetic, s.outside
            );
        }
    }
    text
}

/// A row a quantity; median and worst of the seeds beside the bounds.
fn page(runs: &[Vec<Sample>]) -> String {
    let mut table = Table::new(&[
        "measured",
        "bound",
        "median of the seeds",
        "worst",
        "bound at rest",
        "median, at rest",
        "worst, at rest",
    ]);
    for q in &QUANTITIES {
        let shown = |value: f64| format!("{} {}", three_digits(value), q.unit);
        let bound = |bound: Option<f64>| bound.map_or("–".to_owned(), shown);
        let of_seeds = |at_rest: bool| -> Vec<f64> {
            let from = |run: &Vec<Sample>| {
                if at_rest {
                    run.len().saturating_sub(AT_REST)
                } else {
                    0
                }
            };
            runs.iter()
                .map(|run| q.worst_from(run, from(run)))
                .collect()
        };
        let (run, rest) = (of_seeds(false), of_seeds(true));
        table.push(vec![
            q.label.split(" (").next().unwrap_or(q.label).to_owned(),
            bound(q.in_run),
            shown(median(run.clone())),
            shown(worst(run)),
            bound(q.at_rest),
            shown(median(rest.clone())),
            shown(worst(rest)),
        ]);
    }
    let outside = runs.iter().flatten().map(|s| s.outside).max().unwrap_or(0);
    let deepest = 1e3 * worst(runs.iter().flatten().map(|s| s.deepest));
    format!(
        "{RAGDOLLS} ragdolls, 600 steps of 1/60 s, {} seeds. Each number is the largest of the run or, at rest, \
         of its last second. The most bodies outside of the box, or nowhere, after any step: {outside}. The \
         deepest overlap after any step: {} mm.\n\n{table}",
        runs.len(),
        three_digits(deepest),
        table = table.markdown(1),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_from_the_last_second_forgets_the_fall() {
        let sample = |separation| Sample {
            time: 0.0,
            separation,
            excess: 0.0,
            p99: 0.0,
            deepest: 0.0,
            kinetic: 0.0,
            outside: 0,
        };
        let run = [sample(0.04), sample(0.001), sample(0.002)];
        assert_eq!(QUANTITIES[0].worst_from(&run, 0), 40.0);
        assert_eq!(QUANTITIES[0].worst_from(&run, 1), 2.0);
    }
}
