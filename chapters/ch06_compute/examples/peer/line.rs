//! A line of the table that is printed.

use ch00_scenes::measures::percentile;

use crate::errors::{Errors, largest, median};
use crate::runner::Facts;

/// What one engine did with one scene.
pub struct Line {
    pub scene: String,
    pub count: Option<u64>,
    pub bodies: usize,
    pub joints: usize,
    pub facts: Facts,
    pub settle: u32,
    /// Of every timed step, ms, the shortest first.
    pub times: Vec<f64>,
    /// After every block.
    pub moments: Vec<Errors>,
    /// The median time over that of rapier's fastest line.
    pub of_rapier: f64,
}

/// A column's name, with its unit, and its value in a line.
type Column = (&'static str, fn(&Line) -> String);

const COLUMNS: &[Column] = &[
    ("scene", |line| line.scene.clone()),
    ("count", |line| {
        line.count
            .map_or_else(String::new, |count| count.to_string())
    }),
    ("bodies", |line| line.bodies.to_string()),
    ("joints", |line| line.joints.to_string()),
    ("engine", |line| line.facts.engine.to_owned()),
    ("method", |line| line.facts.method.to_owned()),
    ("threads", |line| line.facts.threads.to_string()),
    ("substeps", |line| line.facts.substeps.to_string()),
    ("settle_steps", |line| line.settle.to_string()),
    ("timed_steps", |line| line.times.len().to_string()),
    ("blocks", |line| line.moments.len().to_string()),
    ("ms_p05", |line| ms(percentile(&line.times, 5))),
    ("ms_median", |line| ms(line.median_time())),
    ("ms_mean", |line| ms(line.mean_time())),
    ("ms_p95", |line| ms(percentile(&line.times, 95))),
    ("touching", |line| {
        let touching = |at: &Errors| at.penetration.pairs_touching as f64;
        median(&line.moments, touching).to_string()
    }),
    ("not_measured", |line| {
        let not_measured = |at: &Errors| at.penetration.pairs_not_measured as f64;
        largest(&line.moments, not_measured).to_string()
    }),
    ("depth_p99_m", |line| {
        short(median(&line.moments, |at| at.penetration.p99))
    }),
    ("depth_max_m", |line| {
        short(largest(&line.moments, |at| at.penetration.deepest))
    }),
    ("depth_p99_of_r", |line| {
        short(median(&line.moments, |at| at.penetration.relative.p99))
    }),
    ("depth_max_of_r", |line| {
        short(largest(&line.moments, |at| at.penetration.relative.deepest))
    }),
    ("gap_p99_m", |line| {
        line.of_joints(median(&line.moments, |at| at.gap.p99))
    }),
    ("gap_max_m", |line| {
        line.of_joints(largest(&line.moments, |at| at.gap.largest))
    }),
    ("excess_p99_rad", |line| {
        line.of_joints(median(&line.moments, |at| at.excess.p99))
    }),
    ("excess_max_rad", |line| {
        line.of_joints(largest(&line.moments, |at| at.excess.largest))
    }),
    ("kinetic_energy_j_a_body", |line| {
        short(median(&line.moments, |at| at.kinetic_energy))
    }),
    ("outside", |line| {
        largest(&line.moments, |at| at.outside as f64).to_string()
    }),
    ("not_finite", |line| {
        largest(&line.moments, |at| at.not_finite as f64).to_string()
    }),
    ("time_of_rapier", |line| format!("{:.3}", line.of_rapier)),
];

impl Line {
    pub fn names() -> String {
        let names: Vec<_> = COLUMNS.iter().map(|(name, _)| *name).collect();
        names.join(",")
    }

    pub fn values(&self) -> String {
        let values: Vec<_> = COLUMNS.iter().map(|(_, value)| value(self)).collect();
        values.join(",")
    }

    fn median_time(&self) -> f64 {
        percentile(&self.times, 50)
    }

    fn mean_time(&self) -> f64 {
        self.times.iter().sum::<f64>() / self.times.len() as f64
    }

    /// A measure of joints, where there are any.
    fn of_joints(&self, value: f64) -> String {
        if self.joints == 0 {
            String::new()
        } else {
            short(value)
        }
    }
}

/// Fills in what the times are of rapier's fastest.
pub fn compare_with_rapier(lines: &mut [Line]) {
    let rapier = lines.iter().filter(|line| line.facts.engine == "rapier");
    let fastest = rapier.map(Line::median_time).fold(f64::INFINITY, f64::min);
    for line in lines {
        line.of_rapier = line.median_time() / fastest;
    }
}

fn short(value: f64) -> String {
    format!("{value:.3e}")
}

fn ms(time: f64) -> String {
    format!("{time:.4}")
}
