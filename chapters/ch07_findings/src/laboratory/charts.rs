//! What the laboratory shows of each scenario: work against precision, and error against rate.

use std::path::Path;
use std::time::Instant;

use super::cell::{Cell, End};
use super::contenders::{CONTENDERS, Contender};
use super::runs::measure;
use super::scenario::Scenario;
use super::scenarios::SCENARIOS;
use super::store::Store;
use super::{costs, published, tables};
use crate::FindingsError;
use crate::chart::{Axis, Chart, Picture, Series, Style};
use crate::draw::RINGED;
use crate::product::{Product, Say};
use crate::table::three_digits;

/// The rate at which methods are compared in the table, 1/s.
pub(super) const USUAL: u32 = 60;
/// Rates that are tried in a hurry, 1/s.
const QUICK_RATES: [u32; 2] = [60, 240];

/// All scenarios: every cell that is not in the folder's table yet is measured, then all is drawn.
///
/// # Errors
/// [`FindingsError`] where a scene can't be built, or the table can't be read or written.
pub fn product(quick: bool, folder: &Path, say: Say) -> Result<Product, FindingsError> {
    let store = measured(SCENARIOS, quick, folder, say)?;
    let mut charts = costs::charts(&store.cells);
    for scenario in SCENARIOS {
        charts.extend(pictures(scenario, &store.cells));
    }
    Ok(Product {
        charts,
        csv: costs::csv(&store.cells),
        page: Some(tables::all(&store.cells)),
    })
}

/// One scenario.
///
/// # Errors
/// As [`product`].
pub fn product_of(
    scenario: &'static Scenario,
    quick: bool,
    folder: &Path,
    say: Say,
) -> Result<Product, FindingsError> {
    let store = measured(std::slice::from_ref(scenario), quick, folder, say)?;
    let cells: Vec<Cell> = of(&store.cells, scenario.name).cloned().collect();
    let lines: Vec<String> = cells.iter().map(Cell::line).collect();
    Ok(Product {
        charts: pictures(scenario, &cells).into(),
        csv: format!("{}\n{}\n", super::cell::HEADINGS, lines.join("\n")),
        page: Some(tables::of_one(scenario, &cells)),
    })
}

fn rates(scenario: &Scenario, quick: bool) -> Vec<u32> {
    let tried = |rate: &u32| !quick || QUICK_RATES.contains(rate);
    scenario.rates.iter().copied().filter(tried).collect()
}

// ANCHOR: measured
/// Measures what the table lacks, a line at a time; what it has, it keeps.
fn measured(
    scenarios: &[Scenario],
    quick: bool,
    folder: &Path,
    say: Say,
) -> Result<Store<Cell>, FindingsError> {
    let name = if quick {
        "laboratory_quick.csv"
    } else {
        "laboratory.csv"
    };
    let mut store = Store::<Cell>::open(&folder.join(name))?;
    let mut missing = Vec::new();
    for scenario in scenarios {
        for contender in CONTENDERS {
            for rate in rates(scenario, quick) {
                if at(&store.cells, scenario.name, contender.name, rate).is_none() {
                    missing.push((scenario, contender, rate));
                }
            }
        }
    }
    let start = Instant::now();
    for (done, (scenario, contender, rate)) in missing.iter().enumerate() {
        let cell = measure(scenario, contender, *rate, quick)?;
        say(&progress(
            &cell,
            done + 1,
            missing.len(),
            start.elapsed().as_secs_f64(),
        ));
        store.add(cell)?;
    }
    Ok(store)
}
// ANCHOR_END: measured

fn progress(cell: &Cell, done: usize, all: usize, seconds: f64) -> String {
    let left = seconds / done as f64 * (all - done) as f64;
    let end = match &cell.end {
        End::Measured => three_digits(cell.error),
        End::Failed(how) => how.clone(),
        End::Cannot(_) => "cannot".to_owned(),
    };
    format!(
        "{done} of {all}, {left:.0} s left: {} by {} at {} Hz: {end}",
        cell.scenario, cell.contender, cell.rate
    )
}

/// The cells of a scenario.
pub(super) fn of<'a>(cells: &'a [Cell], scenario: &'a str) -> impl Iterator<Item = &'a Cell> {
    cells.iter().filter(move |cell| cell.scenario == scenario)
}

/// The cells of a contender, by rate; none of what it can't do.
pub(super) fn by<'a>(cells: &'a [Cell], scenario: &'a str, contender: &Contender) -> Vec<&'a Cell> {
    let name = contender.name;
    let same = |cell: &&Cell| cell.contender == name && !matches!(cell.end, End::Cannot(_));
    let mut cells: Vec<_> = of(cells, scenario).filter(same).collect();
    cells.sort_by_key(|cell| cell.rate);
    cells
}

/// One cell.
pub(super) fn at<'a>(
    cells: &'a [Cell],
    scenario: &str,
    contender: &str,
    rate: u32,
) -> Option<&'a Cell> {
    cells
        .iter()
        .find(|cell| cell.key() == (scenario, contender, rate))
}

/// Names of charts live as long as the program.
fn name(scenario: &Scenario, kind: &str) -> &'static str {
    Box::leak(format!("scenario_{}{kind}", scenario.name).into_boxed_str())
}

fn error_axis(scenario: &Scenario) -> Axis {
    let unit = match scenario.unit {
        "" => "share of 1",
        unit => unit,
    };
    Axis::log(&format!("error ({unit})")).lost("failed")
}

fn title(scenario: &Scenario, what: &str) -> String {
    format!("{}: {what}", scenario.heading())
}

fn pictures(scenario: &Scenario, cells: &[Cell]) -> [Picture; 2] {
    [
        work_precision(scenario, cells).into(),
        against_rate(scenario, cells).into(),
    ]
}

/// A curve for every contender that can run the scenario, over something of its cells, and which of its points
/// is that at the usual rate, unless it failed.
fn curves(
    scenario: &Scenario,
    cells: &[Cell],
    x: fn(&Cell) -> f64,
) -> Vec<(Series, Option<usize>)> {
    let curve = |contender: &Contender| {
        let cells = by(cells, scenario.name, contender);
        let points = cells.iter().map(|cell| (x(cell), cell.drawn()));
        let usual = cells
            .iter()
            .position(|cell| cell.rate == USUAL && cell.is_measured());
        let curve = Series::new(contender.name, contender.style, points);
        (curve, usual)
    };
    let all = CONTENDERS.iter().map(curve);
    all.filter(|(series, _)| !series.points.is_empty())
        .collect()
}

// ANCHOR: work_precision
/// A curve a method, a mark a rate; the dashed line goes along those that nobody beats in both.
fn work_precision(scenario: &Scenario, cells: &[Cell]) -> Chart {
    let all = curves(scenario, cells, |cell| cell.cost).into_iter();
    let ringed = all.map(|(one, usual)| one.with_rings(usual.into_iter().collect()));
    let mut series: Vec<Series> = ringed.collect();
    // For the legend: the rings are those of the curves.
    series.push(Series::new("at 60 Hz", RINGED, []));
    series.push(Series::new(
        "nothing is cheaper and better",
        Style::Theory,
        front(of(cells, scenario.name)),
    ));
    Chart {
        name: name(scenario, ""),
        title: title(scenario, scenario.error),
        x: Axis::log("processor time for a second of the scene (s)"),
        y: error_axis(scenario),
        series,
    }
}

/// Cost and error of those cells that are better than all that are cheaper.
fn front<'a>(cells: impl Iterator<Item = &'a Cell>) -> Vec<(f64, f64)> {
    let mut all: Vec<_> = cells
        .filter(|cell| cell.is_measured())
        .map(|cell| (cell.cost, cell.error))
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut best = f64::INFINITY;
    all.retain(|&(_, error)| {
        let better = error < best;
        best = best.min(error);
        better
    });
    all
}
// ANCHOR_END: work_precision

fn against_rate(scenario: &Scenario, cells: &[Cell]) -> Chart {
    let all = curves(scenario, cells, |cell| f64::from(cell.rate)).into_iter();
    let mut series: Vec<Series> = all.map(|(one, _)| one).collect();
    let ends = [scenario.rates[0], scenario.rates[scenario.rates.len() - 1]].map(f64::from);
    series.push(Series::of(
        "to reach at 60 Hz",
        Style::Theory,
        &ends,
        |_| scenario.pass,
    ));
    series.extend(published::stars(scenario.name));
    Chart {
        name: name(scenario, "_rates"),
        title: title(scenario, scenario.error),
        x: Axis::log("steps a second (1/s)"),
        y: error_axis(scenario),
        series,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(contender: &str, rate: u32, cost: f64, error: f64) -> Cell {
        Cell {
            scenario: "free_top".to_owned(),
            contender: contender.to_owned(),
            rate,
            substeps: 1,
            sweeps: 0,
            error,
            cost,
            runs: 1,
            end: if error.is_finite() {
                End::Measured
            } else {
                End::Failed("lost".to_owned())
            },
        }
    }

    #[test]
    fn the_front_has_those_that_nobody_beats_in_both() {
        let cells = [
            cell("splitting", 60, 1.0, 0.5),
            cell("splitting", 120, 2.0, 0.1),
            cell("runge-kutta", 60, 1.5, 0.7),
            cell("runge-kutta", 120, 3.0, f64::INFINITY),
            cell("runge-kutta", 240, 4.0, 0.01),
        ];
        assert_eq!(front(cells.iter()), [(1.0, 0.5), (2.0, 0.1), (4.0, 0.01)]);
    }

    #[test]
    fn failures_stay_in_the_chart() {
        let scenario = SCENARIOS
            .iter()
            .find(|known| known.name == "free_top")
            .expect("4");
        let cells = [cell("splitting", 60, 1.0, f64::INFINITY)];
        let chart = work_precision(scenario, &cells);
        let drawn: Vec<_> = chart
            .series
            .iter()
            .flat_map(|series| &series.points)
            .collect();
        assert_eq!(drawn, [&(1.0, f64::INFINITY)]);
    }
}
