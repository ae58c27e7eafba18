//! The report's Table 1 again: bouncing balls, 600 steps, without a window. Frame rates as the
//! report counts them (largest and smallest mean of ten steps) beside the report's own, and what
//! a rate alone hides: the time of a step, escapes, overlaps and energy gained.
//!
//! The report's numbers include drawing, and values near 59 are its display's limit.

use std::fmt::Write as _;

use ch00_scenes::{Scene, Settings, builtin};
use ch00_shell::Session;
use ch00_shell::headless::{Options, simulate};
use ch00_shell::summary::Timing;
use ch03_collision::ENGINE;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::product::{Product, Say};
use crate::table::{Table, percent, three_digits};

/// Numbers of balls.
pub const COUNTS: [u64; 10] = [0, 10, 20, 30, 40, 50, 60, 100, 1000, 10_000];
/// Numbers of balls above which a run takes long: timed once, and left out where it must be quick.
const LONG: u64 = 1000;
/// Runs of the first seed that are timed, up to [`LONG`].
const RUNS: usize = 5;
/// Seeds of the balls; times are those of the first.
const SEEDS: [u64; 3] = [1, 2, 3];
/// Steps of a run.
const STEPS: u32 = 600;

/// What the report says of a number of balls: largest and smallest ten-frame mean, 1/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reported {
    /// Number of balls.
    pub count: u64,
    /// Largest mean.
    pub max_fps: f64,
    /// Smallest mean.
    pub min_fps: f64,
}

/// What was measured of a number of balls.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Number of balls.
    pub count: u64,
    /// Times of the runs with the first seed.
    pub timings: Vec<Timing>,
    /// Most balls that were outside the box after any step: the worst seed.
    pub escaped: usize,
    /// Deepest overlap after the last step, m: the worst seed.
    pub deepest_m: f64,
    /// 99 of 100 overlaps are no deeper, m: the worst seed.
    pub p99_m: f64,
    /// Energy above the start's, relative, the largest of the run: the worst seed.
    pub energy_gained: f64,
    /// Things that a limit left undone: the worst seed.
    pub overflow: usize,
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let counts = COUNTS.into_iter().filter(|&count| !quick || count <= LONG);
    let mut rows = Vec::new();
    for count in counts {
        let row = measured(count, STEPS)?;
        say(&format!(
            "{count} balls: {} ms a step",
            three_digits(row.median_ms())
        ));
        rows.push(row);
    }
    let reported = reported()?;
    Ok(Product {
        chart: chart(&rows, &reported),
        csv: csv(&rows, &reported),
        page: Some(page(&rows, &reported)),
    })
}

/// Runs balls with every seed, the first one as often as it is timed.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn measured(count: u64, steps: u32) -> Result<Row, FindingsError> {
    let mut row = Row::empty(count);
    let timed = if count > LONG { 1 } else { RUNS };
    for run in 0..timed {
        row.add_run(SEEDS[0], steps, run == 0, true)?;
    }
    for seed in &SEEDS[1..] {
        row.add_run(*seed, steps, true, false)?;
    }
    Ok(row)
}

impl Row {
    fn empty(count: u64) -> Self {
        Self {
            count,
            timings: Vec::new(),
            escaped: 0,
            deepest_m: 0.0,
            p99_m: 0.0,
            energy_gained: 0.0,
            overflow: 0,
        }
    }

    /// Half of the steps took no longer, ms: the median of the runs.
    #[must_use]
    pub fn median_ms(&self) -> f64 {
        middle(&self.of_runs(|timing| timing.median_ms))
    }

    /// 99 of 100 steps took no longer, ms: the median of the runs.
    #[must_use]
    pub fn p99_ms(&self) -> f64 {
        middle(&self.of_runs(|timing| timing.p99_ms))
    }

    /// Largest ten-step mean, 1/s: the median of the runs.
    #[must_use]
    pub fn max_fps(&self) -> f64 {
        middle(&self.of_runs(|timing| timing.max_fps))
    }

    /// Smallest ten-step mean, 1/s: the median of the runs.
    #[must_use]
    pub fn min_fps(&self) -> f64 {
        middle(&self.of_runs(|timing| timing.min_fps))
    }

    /// A time of each run, in increasing order.
    fn of_runs(&self, time: fn(&Timing) -> Option<f64>) -> Vec<f64> {
        let mut times: Vec<f64> = self.timings.iter().filter_map(time).collect();
        times.sort_by(f64::total_cmp);
        times
    }

    /// Makes a run; its physics counts once a seed, its times where they are wanted.
    fn add_run(
        &mut self,
        seed: u64,
        steps: u32,
        is_new: bool,
        is_timed: bool,
    ) -> Result<(), FindingsError> {
        let mut scene: Scene = builtin::build("balls", Some(self.count), Some(seed))?;
        scene.steps = steps;
        let settings = Settings::defaults().with_method("corrected");
        let mut session = Session::new(scene, ENGINE, settings)?;
        let quiet = Options {
            json: true,
            ..Options::default()
        };
        let summary = simulate(&mut session, &quiet)?;
        if is_timed {
            self.timings.push(summary.timing);
        }
        if is_new {
            let depth = |value: Option<f64>| value.unwrap_or(f64::INFINITY);
            let escaped = summary.escaped.unwrap_or(0) + summary.nan;
            self.escaped = self.escaped.max(escaped);
            self.deepest_m = self.deepest_m.max(depth(summary.max_penetration_final_m));
            self.p99_m = self.p99_m.max(depth(summary.p99_penetration_final_m));
            self.overflow = self.overflow.max(summary.overflow);
            let samples = session.history().samples().iter();
            let errors = samples.filter_map(|sample| sample.energy_error);
            self.energy_gained = errors.fold(self.energy_gained, f64::max);
        }
        Ok(())
    }
}

/// The one in the middle of sorted times.
fn middle(times: &[f64]) -> f64 {
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The report's Table 1.
///
/// # Errors
/// [`FindingsError::Report`] for a line that is no row.
pub fn reported() -> Result<Vec<Reported>, FindingsError> {
    let text = include_str!("../../../tests/reference/report_tables.csv");
    let lines = text.lines().enumerate().skip(2);
    lines
        .filter(|(_, line)| line.starts_with("1,"))
        .map(|(k, line)| {
            reported_row(line).ok_or_else(|| FindingsError::Report {
                line: k + 1,
                text: line.to_owned(),
            })
        })
        .collect()
}

/// `table,scene,count,bodies,max_fps,min_fps`.
fn reported_row(line: &str) -> Option<Reported> {
    let fields: Vec<_> = line.split(',').collect();
    let [_, _, count, _, max_fps, min_fps] = fields[..] else {
        return None;
    };
    Some(Reported {
        count: count.parse().ok()?,
        max_fps: max_fps.parse().ok()?,
        min_fps: min_fps.parse().ok()?,
    })
}

/// Time of a frame against the number of balls.
fn chart(rows: &[Row], reported: &[Reported]) -> Chart {
    let series = |name: &str, style, points: Vec<(u64, f64)>| Series {
        name: name.to_owned(),
        style,
        points: points
            .into_iter()
            .map(|(count, fps)| (count as f64, 1e3 / fps))
            .collect(),
    };
    let report = |fps: fn(&Reported) -> f64| reported.iter().map(|r| (r.count, fps(r))).collect();
    let ours = |fps: fn(&Row) -> f64| rows.iter().map(|r| (r.count, fps(r))).collect();
    let counts = rows.iter().map(|row| (row.count, 60.0)).collect();
    Chart {
        name: "table1",
        title: "Bouncing balls: time of a frame, slowest and fastest mean of ten".to_owned(),
        x: Axis::log("balls"),
        y: Axis::log("1000 / FPS (ms)"),
        series: vec![
            series(
                "report, slowest (with drawing)",
                Style::Printed,
                report(|r| r.min_fps),
            ),
            series("report, fastest", Style::Other(2), report(|r| r.max_fps)),
            series(
                "corrected, slowest (steps alone)",
                Style::Corrected,
                ours(Row::min_fps),
            ),
            series("corrected, fastest", Style::Other(3), ours(Row::max_fps)),
            series("60 frames a second", Style::Theory, counts),
        ],
    }
}

fn csv(rows: &[Row], reported: &[Reported]) -> String {
    let mut text = "balls,report_max_fps,report_min_fps,max_fps,min_fps,median_ms,\
        least_median_ms,largest_median_ms,p99_ms,timed_runs,escaped,deepest_m,p99_depth_m,\
        energy_gained,overflow\n"
        .to_owned();
    for row in rows {
        let theirs = reported.iter().find(|theirs| theirs.count == row.count);
        let (max, min) = theirs.map_or((String::new(), String::new()), |theirs| {
            (theirs.max_fps.to_string(), theirs.min_fps.to_string())
        });
        let medians = row.of_runs(|timing| timing.median_ms);
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{max},{min},{:?},{:?},{:?},{:?},{:?},{:?},{},{},{:?},{:?},{:?},{}",
            row.count,
            row.max_fps(),
            row.min_fps(),
            row.median_ms(),
            medians.first().copied().unwrap_or(f64::NAN),
            medians.last().copied().unwrap_or(f64::NAN),
            row.p99_ms(),
            medians.len(),
            row.escaped,
            row.deepest_m,
            row.p99_m,
            row.energy_gained,
            row.overflow,
        );
    }
    text
}

/// The table with a line on how it was measured.
fn page(rows: &[Row], reported: &[Reported]) -> String {
    let mut table = Table::new(&[
        "balls",
        "report, FPS max / min",
        "FPS max / min",
        "ms a step, median (runs)",
        "ms, 99 % of steps",
        "escaped",
        "overlap, deepest / 99 % (mm)",
        "energy gained",
    ]);
    for row in rows {
        let theirs = reported.iter().find(|theirs| theirs.count == row.count);
        table.push(vec![
            three_digits_of(row.count),
            theirs.map_or("–".to_owned(), |t| {
                format!("{:.2} / {:.2}", t.max_fps, t.min_fps)
            }),
            format!(
                "{} / {}",
                three_digits(row.max_fps()),
                three_digits(row.min_fps())
            ),
            format!(
                "{}{}",
                three_digits(row.median_ms()),
                spread(&row.of_runs(|timing| timing.median_ms))
            ),
            three_digits(row.p99_ms()),
            row.escaped.to_string(),
            format!(
                "{} / {}",
                millimetres(row.deepest_m),
                millimetres(row.p99_m)
            ),
            percent(row.energy_gained),
        ]);
    }
    let build = if cfg!(debug_assertions) {
        " Built without `--release`: slower than it is."
    } else {
        ""
    };
    format!(
        "Method `corrected` on one core of {cpu}; {STEPS} steps of 1/60 s, the first not timed, steps \
         alone, without drawing.{build} Each time is the median of {RUNS} runs (above {LONG_TEXT} balls \
         there is one); the range of the runs is in parentheses. FPS: the largest and the smallest mean of \
         ten steps. Escaped: the most balls outside the box after any step. Overlap: after the last step. \
         Energy gained: the most above the start's during the run (at 10,000 balls after every second \
         step). Of all these the worst of the seeds 1, 2, 3. \
         The report's numbers include drawing.\n\n{table}",
        cpu = processor(),
        LONG_TEXT = three_digits_of(LONG),
        table = table.markdown(0),
    )
}

fn three_digits_of(count: u64) -> String {
    crate::draw::grouped(&count.to_string())
}

fn spread(medians: &[f64]) -> String {
    match medians {
        [least, .., largest] => {
            format!(" ({} … {})", three_digits(*least), three_digits(*largest))
        }
        _ => String::new(),
    }
}

fn millimetres(depth: f64) -> String {
    three_digits(1e3 * depth)
}

/// What the system calls the processor, as far as it says.
fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(':'))
        .map(|(_, name)| name.trim().to_owned());
    let unnamed = || format!("an unnamed {} processor", std::env::consts::ARCH);
    name.filter(|name| !name.is_empty()).unwrap_or_else(unnamed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_has_seven_rows() {
        let rows = reported().expect("the file is part of the repository");
        let counts: Vec<_> = rows.iter().map(|row| row.count).collect();
        assert_eq!(counts, [0, 10, 20, 30, 40, 50, 60]);
        assert_eq!((rows[6].max_fps, rows[6].min_fps), (31.05, 15.12));
    }

    #[test]
    fn a_short_run_of_ten_balls_fills_a_row() {
        let row = measured(10, 30).expect("ten balls load");
        assert_eq!(row.timings.len(), RUNS);
        assert!(
            row.max_fps() >= row.min_fps() && row.min_fps() > 0.0,
            "{row:?}"
        );
        assert!(row.p99_ms() >= row.median_ms(), "{row:?}");
        assert_eq!((row.escaped, row.overflow), (0, 0));
        let page = page(&[row], &reported().expect("it is there"));
        assert!(page.contains(" 59.17 / 56.17 |"), "{page}");
    }
}
