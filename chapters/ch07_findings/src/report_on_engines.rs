//! The report's Tables 1 and 2 on every engine: the time of a step beside the report's time of a frame, from its
//! fastest to its slowest mean of ten, and what is left of bodies and joints at the end.
//!
//! All engines run the same scene in turn, so that whatever slows the machine down slows all of them.

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use ch00_scenes::measures::{Measures, joint_separation};
use ch00_scenes::{Scene, builtin};

use crate::FindingsError;
use crate::chart::{Axis, Chart, Picture, Series, Style};
use crate::draw;
use crate::engines::{KINDS, Kind};
use crate::lab;
use crate::product::{Product, Say};
use crate::rates::{Rates, Reported, reported};
use crate::stepped::Stepped;
use crate::table::{Table, millimetres, three_digits};

/// One of the report's tables.
struct Report {
    number: u32,
    scene: &'static str,
    chart: &'static str,
    /// The chart of engines that aren't the book's.
    others: &'static str,
}

const REPORTS: [Report; 2] = [
    Report {
        number: 1,
        scene: "balls",
        chart: "report_on_engines",
        others: "report_on_engines_others",
    },
    Report {
        number: 2,
        scene: "ragdolls",
        chart: "report_on_engines_ragdolls",
        others: "report_on_engines_ragdolls_others",
    },
];
/// Steps of a run, the first not timed.
const STEPS: u32 = 600;

/// An engine's run of one of the report's scenes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Of the report's table.
    pub table: u32,
    /// As [`KINDS`] call it.
    pub name: &'static str,
    /// What it ran on.
    pub device: String,
    /// How long steps took, for how many things.
    pub rates: Rates,
    /// 99 of 100 overlaps are no deeper after the last step, m.
    pub p99_m: f64,
    /// Widest joint after the last step, m; 0 where there is none.
    pub separation_m: f64,
    /// Bodies outside the box then, or nowhere.
    pub escaped: usize,
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a scene can't be built, or the report's tables can't be read.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let (mut samples, mut charts) = (Vec::new(), Vec::new());
    for report in &REPORTS {
        let rows = reported(report.number)?;
        let counts: Vec<u64> = rows
            .iter()
            .map(|row| row.count)
            .filter(|&n| n > 0)
            .collect();
        let ends = [counts[0], counts[counts.len() - 1]];
        for count in counts.into_iter().filter(|n| !quick || ends.contains(n)) {
            samples.extend(measured(report, count, if quick { 30 } else { STEPS })?);
            say(&format!("{count} {}", report.scene));
        }
        charts.extend(panels(report, &rows, &samples).map(Picture::from));
    }
    let csv = csv(&samples);
    let page = page(&samples)?;
    Ok(Product {
        charts,
        csv,
        page: Some(page),
    })
}

/// Runs a scene on all engines that can, in turn.
fn measured(report: &Report, count: u64, steps: u32) -> Result<Vec<Sample>, FindingsError> {
    let mut scene = builtin::build(report.scene, Some(count), Some(1))?;
    scene.steps = steps;
    let load = |kind: &'static Kind| {
        let engine = Stepped::load(kind.engine, &kind.settings(), &scene);
        engine.ok().map(|engine| (kind, engine))
    };
    let mut engines: Vec<_> = KINDS.iter().filter_map(load).collect();
    let mut times: Vec<Vec<Duration>> = vec![Vec::new(); engines.len()];
    for (k, turn) in lab::turns(steps, engines.len()) {
        for _ in 0..turn {
            let start = Instant::now();
            engines[k].1.steps(scene.dt as f32, 1);
            times[k].push(start.elapsed());
        }
    }
    let all = engines.iter().zip(&times);
    Ok(all
        .map(|((kind, engine), times)| sample(report, count, &scene, kind, engine, times))
        .collect())
}

fn sample(
    report: &Report,
    count: u64,
    scene: &Scene,
    kind: &Kind,
    engine: &Stepped,
    times: &[Duration],
) -> Sample {
    let state = engine.state();
    let measures = Measures::of(scene, &state);
    let mut rates = Rates::of(count);
    rates.add(times);
    Sample {
        table: report.number,
        name: kind.name,
        device: engine.device(),
        rates,
        p99_m: measures.penetration.p99,
        separation_m: joint_separation(scene, &state).unwrap_or(0.0),
        escaped: measures.escaped.unwrap_or(0) + state.not_finite(),
    }
}

/// The samples of an engine in one of the tables.
fn of<'a>(
    samples: &'a [Sample],
    table: u32,
    name: &'a str,
) -> impl Iterator<Item = &'a Sample> + Clone {
    let same = move |sample: &&Sample| sample.table == table && sample.name == name;
    samples.iter().filter(same)
}

/// Mean of ten, ms: the fastest and the slowest.
fn tens(rates: &Rates) -> (f64, f64) {
    (1e3 / rates.max_fps(), 1e3 / rates.min_fps())
}

/// The book's engines, and the others over the same axes.
fn panels(report: &Report, rows: &[Reported], samples: &[Sample]) -> [Chart; 2] {
    [true, false].map(|ours| chart(report, rows, samples, ours))
}

fn chart(report: &Report, rows: &[Reported], samples: &[Sample], ours: bool) -> Chart {
    let all = samples.iter().filter(|one| one.table == report.number);
    let times = all.flat_map(|one| <[f64; 2]>::from(tens(&one.rates)));
    let shown = rows.iter().filter(|row| row.count > 0);
    let ends = shown
        .clone()
        .map(|row| (1e3 / row.max_fps, 1e3 / row.min_fps));
    let middle = shown.map(|row| (row.count as f64, 1e3 / (row.max_fps * row.min_fps).sqrt()));
    let theirs = Series::new("report (with drawing)", Style::Other(5), middle);
    let mut series = vec![theirs.with_bars(ends.collect())];
    for kind in KINDS.iter().filter(|kind| kind.is_ours() == ours) {
        let mine = of(samples, report.number, kind.name);
        let points = mine
            .clone()
            .map(|s| (s.rates.count as f64, s.rates.median_ms()));
        let bars = mine.map(|s| tens(&s.rates)).collect();
        series.push(Series::new(kind.name, kind.style, points).with_bars(bars));
    }
    series.retain(|one| !one.points.is_empty());
    let counts: Vec<f64> = rows
        .iter()
        .map(|row| row.count as f64)
        .filter(|n| *n > 0.0)
        .collect();
    series.push(Series::of(
        "60 frames a second",
        Style::Theory,
        &counts,
        |_| 1e3 / 60.0,
    ));
    Chart {
        name: if ours { report.chart } else { report.others },
        title: format!(
            "Table {} on {}: time of a step, bars from the fastest to the slowest mean of ten",
            report.number,
            if ours {
                "the book's engines"
            } else {
                "other engines"
            }
        ),
        x: Axis::linear(report.scene),
        y: Axis::log("1000 / FPS; time of a step (ms)").reaching(times),
        series,
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "table,count,engine,device,median_ms,fastest_ten_ms,slowest_ten_ms,p99_depth_m,\
                    separation_m,escaped\n"
        .to_owned();
    for one in samples {
        let (fastest, slowest) = tens(&one.rates);
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{:?},{fastest:?},{slowest:?},{:?},{:?},{}",
            one.table,
            one.rates.count,
            one.name,
            draw::quoted(&one.device),
            one.rates.median_ms(),
            one.p99_m,
            one.separation_m,
            one.escaped
        );
    }
    text
}

/// A table a table of the report's: a row an engine, the report's own first.
fn page(samples: &[Sample]) -> Result<String, FindingsError> {
    let mut text = how(samples);
    for report in &REPORTS {
        let mut counts: Vec<u64> = samples
            .iter()
            .filter(|one| one.table == report.number)
            .map(|one| one.rates.count)
            .collect();
        counts.sort_unstable();
        counts.dedup();
        // The first, one in the middle, and the last.
        let half = counts.len() / 2;
        let mut shown = vec![counts[0], counts[half], counts[counts.len() - 1]];
        shown.dedup();
        let rows = reported(report.number)?;
        let _ = write!(text, "\n{}", table(report, &shown, &rows, samples));
    }
    Ok(text)
}

fn how(samples: &[Sample]) -> String {
    let on_gpu = samples.iter().find(|one| {
        let compute = |kind: &&Kind| kind.is_compute() && kind.name == one.name;
        KINDS.iter().any(|kind| compute(&kind))
    });
    let on_gpu = on_gpu.map_or(String::new(), |one| {
        format!(" `own-row on compute` ran on {}.", one.device)
    });
    let lack = samples.iter().all(|one| one.name != "rapier");
    let lack = if lack {
        " This build has no rapier."
    } else {
        ""
    };
    format!(
        "{STEPS} steps of 1/60 s, seed 1, the engines in turn on one thread of {}.{on_gpu}{lack} In brackets the \
         fastest and the slowest mean of ten steps, which is what the report counts; the report's frames include \
         drawing, by Python. A step on compute is waited for. At the end: after the last step, of the largest \
         number.\n",
        lab::processor()
    )
}

fn table(report: &Report, counts: &[u64], rows: &[Reported], samples: &[Sample]) -> String {
    let headings: Vec<String> = (counts.iter())
        .map(|count| format!("{count} {}, ms", report.scene))
        .collect();
    let mut all = vec!["engine"];
    all.extend(headings.iter().map(String::as_str));
    all.extend([
        "overlaps at the end, 99 % (mm)",
        "widest joint (mm)",
        "escaped",
    ]);
    let mut table = Table::new(&all);
    let range = |low: f64, high: f64| format!("{} … {}", three_digits(low), three_digits(high));
    let mut theirs = vec!["the report".to_owned()];
    theirs.extend(counts.iter().map(|count| {
        let found = rows.iter().find(|row| row.count == *count);
        found.map_or("–".to_owned(), |row| {
            range(1e3 / row.max_fps, 1e3 / row.min_fps)
        })
    }));
    theirs.extend(["–".to_owned(), "–".to_owned(), "–".to_owned()]);
    table.push(theirs);
    for kind in KINDS {
        let mine: Vec<&Sample> = of(samples, report.number, kind.name).collect();
        let Some(last) = mine.last() else { continue };
        let mut cells = vec![kind.name.to_owned()];
        cells.extend(counts.iter().map(|count| {
            let found = mine.iter().find(|one| one.rates.count == *count);
            found.map_or("–".to_owned(), |one| {
                let (fastest, slowest) = tens(&one.rates);
                let median = three_digits(one.rates.median_ms());
                format!("{median} ({})", range(fastest, slowest))
            })
        }));
        let joint = if report.number == 2 {
            millimetres(last.separation_m)
        } else {
            "–".to_owned()
        };
        cells.extend([millimetres(last.p99_m), joint, last.escaped.to_string()]);
        table.push(cells);
    }
    table.markdown(1)
}
