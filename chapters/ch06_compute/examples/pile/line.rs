//! A line of the table.

use std::time::Duration;

use ch00_scenes::measures::Measures;
use ch00_scenes::{Engine, Scene};
use ch01_hierarchy::styles::report::processor;

use crate::heap::Timed;
use crate::table::{Column, short};

pub struct Line {
    pub scene: Scene,
    pub count: Option<u64>,
    pub settle: u32,
    pub steps: u32,
    pub loading: Duration,
    pub settling: Duration,
    /// Time of a step in each batch, the shortest first.
    pub batches: Vec<Duration>,
    pub timed: Box<dyn Timed>,
    pub measures: Measures,
    pub fastest: f64,
}

pub const COLUMNS: &[Column<Line>] = &[
    ("scene", |line| line.scene.name.clone()),
    ("count", |line| optional(line.count)),
    ("bodies", |line| line.scene.bodies.len().to_string()),
    ("joints", |line| line.scene.joints.len().to_string()),
    ("engine", |line| {
        line.timed.engine().info().engine.to_owned()
    }),
    ("method", |line| {
        line.timed.engine().info().method.to_owned()
    }),
    ("device", |line| device(line.timed.engine())),
    ("threads", |line| {
        line.timed.engine().info().threads.to_string()
    }),
    ("substeps", |line| {
        line.timed.engine().info().substeps.to_string()
    }),
    ("sweeps", |line| optional(line.timed.engine().info().sweeps)),
    ("dt_s", |line| line.scene.dt.to_string()),
    ("load_s", |line| seconds(line.loading)),
    ("settle_steps", |line| line.settle.to_string()),
    ("settle_s", |line| seconds(line.settling)),
    ("timed_steps", |line| line.steps.to_string()),
    ("ms_median", |line| ms(line.batches[line.batches.len() / 2])),
    ("ms_fastest", |line| ms(line.batches[0])),
    (
        "ms_slowest",
        |line| ms(line.batches[line.batches.len() - 1]),
    ),
    ("pairs", |line| {
        line.timed.engine().counters().pairs.to_string()
    }),
    ("contacts", |line| {
        line.timed.engine().counters().contacts.to_string()
    }),
    ("overflow", |line| {
        line.timed.engine().counters().overflow.to_string()
    }),
    ("kinetic_energy_j_a_body", |line| {
        let bodies = line.scene.dynamic_count() as f64;
        short(line.measures.conserved.kinetic_energy / bodies)
    }),
    ("fastest_m_s", |line| short(line.fastest)),
    ("escaped", |line| optional(line.measures.escaped)),
    ("not_finite", |line| line.measures.not_finite.to_string()),
    ("touching", |line| {
        line.measures.penetration.pairs_touching.to_string()
    }),
    ("not_measured", |line| {
        line.measures.penetration.pairs_not_measured.to_string()
    }),
    ("p50_of_r", |line| {
        short(line.measures.penetration.relative.p50)
    }),
    ("p99_of_r", |line| {
        short(line.measures.penetration.relative.p99)
    }),
    ("max_of_r", |line| {
        short(line.measures.penetration.relative.deepest)
    }),
    ("p99_m", |line| short(line.measures.penetration.p99)),
    ("max_m", |line| short(line.measures.penetration.deepest)),
    ("separation_m", |line| {
        optional(line.measures.joint_separation.map(short))
    }),
    ("limit_excess_rad", |line| {
        optional(line.measures.limit_excess.map(short))
    }),
    ("asleep", |line| {
        line.timed.engine().counters().asleep.to_string()
    }),
];

/// The name of what it runs on, without the commas that separate columns.
fn device(engine: &dyn Engine) -> String {
    let name = engine.info().device;
    let name = if name == "cpu" {
        processor().unwrap_or(name)
    } else {
        name
    };
    name.replace(',', ";")
}

fn optional(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn seconds(time: Duration) -> String {
    format!("{:.3}", time.as_secs_f64())
}

fn ms(time: Duration) -> String {
    format!("{:.4}", 1e3 * time.as_secs_f64())
}
