//! A line of the table that is printed.

use ch00_scenes::measures::percentile;

use crate::errors::{Errors, largest, median};
use crate::runner::Facts;
use crate::table::{Column, short};

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

pub const COLUMNS: &[Column<Line>] = &[
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
    ("depth_p99_m", |line| short(line.depth())),
    ("depth_max_m", |line| {
        short(largest(&line.moments, |at| at.penetration.deepest))
    }),
    ("depth_p99_of_r", |line| {
        short(median(&line.moments, |at| at.penetration.relative.p99))
    }),
    ("depth_max_of_r", |line| {
        short(largest(&line.moments, |at| at.penetration.relative.deepest))
    }),
    ("gap_p99_m", |line| line.of_joints(line.gap())),
    ("gap_max_m", |line| {
        line.of_joints(largest(&line.moments, |at| at.gap.largest))
    }),
    ("excess_p99_rad", |line| line.of_joints(line.excess())),
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
    /// What 99 of 100 depths don't exceed, m.
    fn depth(&self) -> f64 {
        median(&self.moments, |at| at.penetration.p99)
    }

    /// The same of gaps between joints, m.
    fn gap(&self) -> f64 {
        median(&self.moments, |at| at.gap.p99)
    }

    /// The same of angles beyond limits, rad.
    fn excess(&self) -> f64 {
        median(&self.moments, |at| at.excess.p99)
    }

    /// Whether none of the three is larger than another line's, and nobody is lost.
    fn errs_no_more_than(&self, other: &Self) -> bool {
        let lost = |line: &Self| largest(&line.moments, |at| (at.outside + at.not_finite) as f64);
        self.depth() <= other.depth()
            && self.gap() <= other.gap()
            && self.excess() <= other.excess()
            && lost(self) <= lost(other)
    }

    fn is_rapier(&self) -> bool {
        self.facts.engine == "rapier"
    }

    /// Who it is, how long a step takes, and how large its errors are.
    fn told(&self) -> String {
        let Facts {
            engine,
            method,
            threads,
            substeps,
        } = self.facts;
        let joints = if self.joints == 0 {
            String::new()
        } else {
            let (gap, excess) = (1e3 * self.gap(), self.excess());
            format!(", gap {gap:.3} mm, excess {excess:.3} rad")
        };
        let (time, depth) = (self.median_time(), 1e3 * self.depth());
        format!(
            "{engine} ({method}, substeps {substeps}, threads {threads}) {time:.4} ms, depth {depth:.2} mm{joints}"
        )
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

/// The fastest of some lines.
fn fastest<'l>(lines: impl Iterator<Item = &'l Line>) -> Option<&'l Line> {
    lines.min_by(|one, other| one.median_time().total_cmp(&other.median_time()))
}

/// Fills in what the times are of rapier's fastest.
pub fn compare_with_rapier(lines: &mut [Line]) {
    let rapier = fastest(lines.iter().filter(|line| line.is_rapier()));
    let fastest = rapier.map_or(f64::INFINITY, Line::median_time);
    for line in lines {
        line.of_rapier = line.median_time() / fastest;
    }
}

/// Rapier's fastest line, and the fastest of ours that errs no more than it.
pub fn verdict(lines: &[Line]) -> String {
    let Some(rapier) = fastest(lines.iter().filter(|line| line.is_rapier())) else {
        return "# rapier has no line".to_owned();
    };
    let scene = format!("# {} of {} bodies", rapier.scene, rapier.bodies);
    let as_good = |line: &&Line| !line.is_rapier() && line.errs_no_more_than(rapier);
    match fastest(lines.iter().filter(as_good)) {
        None => format!("{scene}: {}; no other errs as little", rapier.told()),
        Some(ours) => format!(
            "{scene}: {}; {}: {:.2} times as fast",
            rapier.told(),
            ours.told(),
            1.0 / ours.of_rapier
        ),
    }
}

fn ms(time: f64) -> String {
    format!("{time:.4}")
}
