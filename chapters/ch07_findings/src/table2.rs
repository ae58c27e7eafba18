//! The report's Table 2 again: stacked ragdolls, 600 steps, without a window. Frame rates
//! (`rates.rs`) beside the report's own, and what became of the ragdolls, which a rate doesn't tell.

use std::fmt::Write as _;
use std::time::Duration;

use ch00_scenes::measures::{Measures, escaped, joint_separation};
use ch00_scenes::{Scene, builtin};

use crate::FindingsError;
use crate::draw;
use crate::lab::{self, Moment, by, worst};
use crate::product::{Product, Say};
use crate::rates::{self, Rates, Reported, reported};
use crate::table::{Table, millimetres, three_digits};

/// Numbers of ragdolls.
pub const COUNTS: [u64; 12] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 20, 80, 200];
/// A number of ragdolls of which more take long: those are run once, with the first seed.
const LONG: u64 = 8;
/// Runs of the first seed that are timed, up to [`LONG`].
const RUNS: usize = 5;
/// Seeds of the ragdolls; times are those of the first.
const SEEDS: [u64; 3] = [1, 2, 3];
/// Steps of a run.
const STEPS: u32 = 600;
/// At rest: the steps of the last second.
const AT_REST: u32 = 60;

/// What was measured of a number of ragdolls; of everything but the times the worst seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Times of the runs with the first seed.
    pub rates: Rates,
    /// Widest joint after any step, m.
    pub separation: f64,
    /// The same in the last second, m.
    pub separation_at_rest: f64,
    /// Largest angle beyond a limit in the last second, rad.
    pub excess_at_rest: f64,
    /// Deepest overlap in the last second, m.
    pub deepest_at_rest: f64,
    /// Largest 99th percentile of the overlaps in the last second, m.
    pub p99_at_rest: f64,
    /// Kinetic energy a body after the last step, J.
    pub kinetic: f64,
    /// Most bodies that were outside the box after any step.
    pub escaped: usize,
    /// Bodies with a number that is not finite after the last step.
    pub not_finite: usize,
    /// Things that a limit left undone.
    pub overflow: usize,
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let mut rows = Vec::new();
    for count in COUNTS
        .into_iter()
        .filter(|&count| !quick || [0, 1, 2, 4, 8].contains(&count))
    {
        let row = measured(count, STEPS, if quick { 2 } else { RUNS })?;
        let median = three_digits(row.rates.median_ms());
        say(&format!("{count} ragdolls: {median} ms a step"));
        rows.push(row);
    }
    let reported = reported(2)?;
    let title = "Stacked ragdolls: time of a frame, slowest and fastest mean of ten";
    let all = rows.iter().map(|row| &row.rates);
    Ok(Product {
        charts: vec![rates::chart("table2", title, "ragdolls", &all, &reported).into()],
        csv: csv(&rows, &reported),
        page: Some(page(&rows, &reported)),
    })
}

/// Runs ragdolls with every seed, the first one `runs` times; a large number of them once.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn measured(count: u64, steps: u32, runs: usize) -> Result<Row, FindingsError> {
    let mut row = Row {
        rates: Rates::of(count),
        separation: 0.0,
        separation_at_rest: 0.0,
        excess_at_rest: 0.0,
        deepest_at_rest: 0.0,
        p99_at_rest: 0.0,
        kinetic: 0.0,
        escaped: 0,
        not_finite: 0,
        overflow: 0,
    };
    let (seeds, runs) = if count > LONG {
        (&SEEDS[..1], 1)
    } else {
        (&SEEDS[..], runs)
    };
    for &seed in seeds {
        let mut scene = builtin::build("ragdolls", Some(count), Some(seed))?;
        scene.steps = steps;
        let times = row.watch(&scene)?;
        if seed == SEEDS[0] {
            row.rates.add(&times);
            for _ in 1..runs {
                row.rates.add(&lab::run(&scene, &by("corrected"), |_| ())?);
            }
        }
    }
    Ok(row)
}

impl Row {
    /// Makes a run, whose physics counts; gives the times of its steps.
    fn watch(&mut self, scene: &Scene) -> Result<Vec<Duration>, FindingsError> {
        let bodies = scene.dynamic_count().max(1) as f64;
        lab::run(scene, &by("corrected"), |now: &Moment| {
            let lost = now.state.not_finite();
            let out = escaped(scene, now.state).unwrap_or(0) + lost;
            self.escaped = self.escaped.max(out);
            let apart = joint_separation(scene, now.state).unwrap_or(0.0);
            let apart = if lost == 0 { apart } else { f64::NAN };
            self.separation = worst([self.separation, apart]);
            if now.step + AT_REST > scene.steps {
                let measured = Measures::of(scene, now.state);
                let excess = measured.limit_excess.unwrap_or(0.0);
                self.separation_at_rest = worst([self.separation_at_rest, apart]);
                self.excess_at_rest = worst([self.excess_at_rest, excess]);
                self.deepest_at_rest = worst([self.deepest_at_rest, measured.penetration.deepest]);
                self.p99_at_rest = worst([self.p99_at_rest, measured.penetration.p99]);
                if now.step == scene.steps {
                    let kinetic = measured.conserved.kinetic_energy / bodies;
                    self.kinetic = worst([self.kinetic, kinetic]);
                    self.not_finite = self.not_finite.max(lost);
                    self.overflow = self.overflow.max(now.engine.counters().overflow);
                }
            }
        })
    }
}

fn csv(rows: &[Row], reported: &[Reported]) -> String {
    let fields = rates::CSV_FIELDS;
    let mut text = format!(
        "ragdolls,{fields},separation_m,separation_at_rest_m,limit_excess_at_rest_rad,\
         deepest_at_rest_m,p99_depth_at_rest_m,kinetic_energy_a_body_j,escaped,not_finite,overflow\n"
    );
    for row in rows {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{:?},{:?},{:?},{:?},{:?},{:?},{},{},{}",
            row.rates.csv(reported),
            row.separation,
            row.separation_at_rest,
            row.excess_at_rest,
            row.deepest_at_rest,
            row.p99_at_rest,
            row.kinetic,
            row.escaped,
            row.not_finite,
            row.overflow,
        );
    }
    text
}

/// Two tables, how fast and how well, with a line on how they were measured.
fn page(rows: &[Row], reported: &[Reported]) -> String {
    let mut headings = vec!["ragdolls"];
    headings.extend(rates::HEADINGS);
    let mut fast = Table::new(&headings);
    let mut well = Table::new(&[
        "ragdolls",
        "widest joint, run / at rest (mm)",
        "beyond limits at rest (°)",
        "overlap at rest, deepest / 99 % (mm)",
        "energy a body at the end (J)",
        "escaped",
        "NaN",
    ]);
    for row in rows {
        fast.push(row.rates.cells(reported));
        let two = |a: f64, b: f64| format!("{} / {}", millimetres(a), millimetres(b));
        well.push(vec![
            draw::grouped(&row.rates.count.to_string()),
            two(row.separation, row.separation_at_rest),
            three_digits(row.excess_at_rest.to_degrees()),
            two(row.deepest_at_rest, row.p99_at_rest),
            three_digits(row.kinetic),
            row.escaped.to_string(),
            row.not_finite.to_string(),
        ]);
    }
    let how = rates::how(
        STEPS,
        &format!("{RUNS} runs (above {LONG} ragdolls there is one)"),
    );
    format!(
        "{how}\n\n{fast}\n\
         At rest: the largest of the last second. Energy: kinetic, after the last step. Escaped: the most \
         bodies outside the box, or nowhere, after any step. Of these the worst of the seeds 1, 2, 3 (above \
         {LONG} ragdolls seed 1 alone).\n\n{well}",
        fast = fast.markdown(0),
        well = well.markdown(0),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_run_of_one_ragdoll_fills_a_row() {
        let row = measured(1, 30, 2).expect("a ragdoll loads");
        assert_eq!(row.rates.range().0, 2);
        assert!(row.rates.max_fps() >= row.rates.min_fps(), "{row:?}");
        assert_eq!((row.escaped, row.not_finite), (0, 0));
        let page = page(&[row], &reported(2).expect("it is there"));
        assert!(page.contains(" 59.52 / 37.17 |"), "{page}");
    }
}
