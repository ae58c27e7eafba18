//! Frame rates as the report counts them, largest and smallest mean of ten frames, beside the
//! report's own; and what a rate hides, the median, the 99th percentile and the worst of the steps.
//! Tables 1 and 2 share this.
//!
//! The report's numbers include drawing, and values near 59 are its display's limit.

use std::time::Duration;

use ch00_shell::frame_rate::FrameRate;
use ch00_shell::summary::Timing;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::lab::{median, processor, worst};
use crate::table::three_digits;

/// What the report says of a scene: largest and smallest ten-frame mean, 1/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reported {
    /// Number of balls or ragdolls.
    pub count: u64,
    /// Largest mean.
    pub max_fps: f64,
    /// Smallest mean.
    pub min_fps: f64,
}

/// Times of the steps of one run, but for the first.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    timing: Timing,
    worst_ms: f64,
}

/// How fast a scene with a number of things is: the same run several times.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rates {
    /// Number of balls or ragdolls.
    pub count: u64,
    runs: Vec<Run>,
}

impl Rates {
    /// Of so many things, before the first run.
    #[must_use]
    pub fn of(count: u64) -> Self {
        Self {
            count,
            runs: Vec::new(),
        }
    }

    /// Adds a run by the times of its steps, of which the first doesn't count.
    pub fn add(&mut self, steps: &[Duration]) {
        let mut times = FrameRate::of_run();
        let timed = steps.get(1..).unwrap_or_default();
        for &time in timed {
            times.record(time);
        }
        self.runs.push(Run {
            timing: Timing::of(&times),
            worst_ms: worst(timed.iter().map(|time| 1e3 * time.as_secs_f64())),
        });
    }

    /// Half of the steps took no longer, ms: the median of the runs.
    #[must_use]
    pub fn median_ms(&self) -> f64 {
        median(self.medians())
    }

    /// 99 of 100 steps took no longer, ms: the median of the runs.
    #[must_use]
    pub fn p99_ms(&self) -> f64 {
        median(self.runs.iter().filter_map(|run| run.timing.p99_ms))
    }

    /// The longest step, ms: the median of the runs.
    #[must_use]
    pub fn worst_ms(&self) -> f64 {
        median(self.runs.iter().map(|run| run.worst_ms))
    }

    /// Largest ten-step mean, 1/s: the median of the runs.
    #[must_use]
    pub fn max_fps(&self) -> f64 {
        median(self.runs.iter().filter_map(|run| run.timing.max_fps))
    }

    /// Smallest ten-step mean, 1/s: the median of the runs.
    #[must_use]
    pub fn min_fps(&self) -> f64 {
        median(self.runs.iter().filter_map(|run| run.timing.min_fps))
    }

    /// The runs' medians, ms.
    fn medians(&self) -> impl Iterator<Item = f64> {
        self.runs.iter().filter_map(|run| run.timing.median_ms)
    }

    /// Number of runs, and the least and the largest of their medians, ms.
    #[must_use]
    pub fn range(&self) -> (usize, f64, f64) {
        let least = self.medians().fold(f64::INFINITY, f64::min);
        (self.runs.len(), least, worst(self.medians()))
    }

    /// The first fields of a row of CSV, under [`CSV_FIELDS`].
    #[must_use]
    pub fn csv(&self, reported: &[Reported]) -> String {
        let (max, min) = self
            .find(reported)
            .map_or((String::new(), String::new()), |theirs| {
                (theirs.max_fps.to_string(), theirs.min_fps.to_string())
            });
        let (runs, least, largest) = self.range();
        format!(
            "{},{max},{min},{:?},{:?},{:?},{least:?},{largest:?},{:?},{:?},{runs}",
            self.count,
            self.max_fps(),
            self.min_fps(),
            self.median_ms(),
            self.p99_ms(),
            self.worst_ms(),
        )
    }

    /// The first cells of a row of a table, under [`HEADINGS`].
    #[must_use]
    pub fn cells(&self, reported: &[Reported]) -> Vec<String> {
        let rates = |max: &str, min: &str| format!("{max} / {min}");
        let theirs = self.find(reported).map_or("–".to_owned(), |theirs| {
            rates(
                &format!("{:.2}", theirs.max_fps),
                &format!("{:.2}", theirs.min_fps),
            )
        });
        let range = match self.range() {
            (0 | 1, ..) => String::new(),
            (_, least, largest) => {
                format!(" ({} … {})", three_digits(least), three_digits(largest))
            }
        };
        vec![
            draw::grouped(&self.count.to_string()),
            theirs,
            rates(&three_digits(self.max_fps()), &three_digits(self.min_fps())),
            three_digits(self.median_ms()) + &range,
            three_digits(self.p99_ms()),
            three_digits(self.worst_ms()),
        ]
    }

    fn find<'a>(&self, reported: &'a [Reported]) -> Option<&'a Reported> {
        reported.iter().find(|theirs| theirs.count == self.count)
    }
}

/// Names of the fields of [`Rates::csv`] after the count.
pub const CSV_FIELDS: &str = "report_max_fps,report_min_fps,max_fps,min_fps,median_ms,\
    least_median_ms,largest_median_ms,p99_ms,worst_ms,timed_runs";

/// Headings of [`Rates::cells`] after the count.
pub const HEADINGS: [&str; 5] = [
    "report, FPS max / min",
    "FPS max / min",
    "ms a step, median (runs)",
    "ms, 99 % of steps",
    "ms, worst step",
];

/// What [`HEADINGS`] mean, and how it was measured: sentences of a page.
#[must_use]
pub fn how(steps: u32, runs: &str) -> String {
    let build = if cfg!(debug_assertions) {
        " Built without `--release`: slower than it is."
    } else {
        ""
    };
    format!(
        "Method `corrected` on one core of {cpu}; {steps} steps of 1/60 s, the first not timed, steps \
         alone, without drawing.{build} Each time is the median of {runs}; the range of the runs is in \
         parentheses. FPS: the largest and the smallest mean of ten steps. The report's numbers include \
         drawing.",
        cpu = processor(),
    )
}

/// Time of a frame against the number of things, the report's and ours.
#[must_use]
pub fn chart<'a>(
    name: &'static str,
    title: &str,
    things: &str,
    rates: &(impl Iterator<Item = &'a Rates> + Clone),
    reported: &[Reported],
) -> Chart {
    let millis = |count: u64, fps: f64| (count as f64, 1e3 / fps);
    let report = |name: &str, style, fps: fn(&Reported) -> f64| {
        Series::new(
            name,
            style,
            reported.iter().map(|r| millis(r.count, fps(r))),
        )
    };
    let ours = |name: &str, style, fps: fn(&Rates) -> f64| {
        Series::new(name, style, rates.clone().map(|r| millis(r.count, fps(r))))
    };
    Chart {
        name,
        title: title.to_owned(),
        x: Axis::log(things),
        y: Axis::log("1000 / FPS (ms)"),
        series: vec![
            report("report, slowest (with drawing)", Style::Printed, |r| {
                r.min_fps
            }),
            report("report, fastest", Style::Other(2), |r| r.max_fps),
            ours(
                "corrected, slowest (steps alone)",
                Style::Corrected,
                Rates::min_fps,
            ),
            ours("corrected, fastest", Style::Other(3), Rates::max_fps),
            ours("60 frames a second", Style::Theory, |_| 60.0),
        ],
    }
}

/// One of the report's tables, 1 or 2.
///
/// # Errors
/// [`FindingsError::Report`] for a line that is no row.
pub fn reported(table: u32) -> Result<Vec<Reported>, FindingsError> {
    let text = include_str!("../../../tests/reference/report_tables.csv");
    let lines = text.lines().enumerate().skip(2);
    lines
        .filter(|(_, line)| line.starts_with(&format!("{table},")))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reports_tables_have_seven_and_nine_rows() {
        let rows = |table| reported(table).expect("the file is part of the repository");
        let counts = |table| -> Vec<u64> { rows(table).iter().map(|row| row.count).collect() };
        assert_eq!(counts(1), [0, 10, 20, 30, 40, 50, 60]);
        assert_eq!(counts(2), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!((rows(1)[6].max_fps, rows(1)[6].min_fps), (31.05, 15.12));
        assert_eq!((rows(2)[8].max_fps, rows(2)[8].min_fps), (18.93, 2.75));
    }

    #[test]
    fn the_first_step_does_not_count() {
        let mut rates = Rates::of(3);
        let steps: Vec<Duration> = [900, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 6]
            .map(Duration::from_millis)
            .to_vec();
        rates.add(&steps);
        assert_eq!((rates.median_ms(), rates.worst_ms()), (4.0, 6.0));
        assert!((rates.max_fps() - 250.0).abs() < 1e-9);
        assert!((rates.min_fps() - 10.0 / 0.042).abs() < 1e-9);
    }
}
