//! Where rounding takes over: the same methods in single and in double precision, against the rate. A
//! method's own error falls with the step; what is rounded off is more the more steps there are.

use ch00_scenes::EngineEntry;

use super::cell::{Cell, HEADINGS};
use super::contenders::Contender;
use super::runs::measure;
use super::scenario::Scenario;
use super::scenarios::SCENARIOS;
use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::methods::{double, single};
use crate::product::{Product, Say};

/// The scenarios, and the files of their charts.
const SHOWN: [(&str, &str); 2] = [
    ("free_top", "single_precision"),
    ("start_up", "single_precision_start_up"),
];

const fn contender(
    name: &'static str,
    method: &'static str,
    engine: EngineEntry,
    style: Style,
) -> Contender {
    Contender {
        name,
        method,
        substeps: None,
        engine,
        style,
        ours: false,
    }
}

/// Who is compared.
const WHO: [Contender; 6] = [
    contender(
        "splitting, double",
        "splitting",
        double::engine::ENGINE,
        Style::Other(8),
    ),
    contender(
        "splitting, single",
        "splitting",
        single::engine::ENGINE,
        Style::Other(0),
    ),
    contender(
        "runge-kutta, double",
        "runge-kutta",
        double::engine::ENGINE,
        Style::Other(9),
    ),
    contender(
        "runge-kutta, single",
        "runge-kutta",
        single::engine::ENGINE,
        Style::Other(1),
    ),
    contender(
        "own-row, single",
        "own-row",
        ch06_compute::LANES,
        Style::Other(3),
    ),
    contender(
        "corrected, single",
        "corrected",
        ch05_properties::ENGINE,
        Style::Corrected,
    ),
];

/// Measures, and lays out pictures and CSV.
///
/// # Errors
/// [`FindingsError`] where a scene can't be built.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let (mut charts, mut cells) = (Vec::new(), Vec::new());
    for (scenario, file) in SHOWN {
        let found = SCENARIOS.iter().find(|known| known.name == scenario);
        let Some(scenario) = found else { continue };
        let mut series = Vec::new();
        for who in &WHO {
            let mine = curve(scenario, who, quick)?;
            let points = mine.iter().map(|cell| (f64::from(cell.rate), cell.drawn()));
            series.push(Series::new(who.name, who.style, points));
            cells.extend(mine);
            say(&format!("{} by {}", scenario.name, who.name));
        }
        charts.push(chart(scenario, file, series).into());
    }
    let lines: Vec<String> = cells.iter().map(Cell::line).collect();
    Ok(Product {
        charts,
        csv: format!("{HEADINGS}\n{}\n", lines.join("\n")),
        page: None,
    })
}

fn curve(scenario: &Scenario, who: &Contender, quick: bool) -> Result<Vec<Cell>, FindingsError> {
    let rates = scenario.rates.iter().step_by(if quick { 4 } else { 1 });
    rates
        .map(|&rate| measure(scenario, who, rate, true))
        .map(named)
        .collect()
}

/// The names have commas, which a line of CSV can't hold.
fn named(cell: Result<Cell, FindingsError>) -> Result<Cell, FindingsError> {
    cell.map(|cell| Cell {
        contender: cell.contender.replace(',', ""),
        ..cell
    })
}

fn chart(scenario: &Scenario, name: &'static str, series: Vec<Series>) -> Chart {
    Chart {
        name,
        title: format!("{}: {}", scenario.heading(), scenario.error),
        x: Axis::log("steps a second (1/s)"),
        y: Axis::log(&format!("error ({})", scenario.unit)).lost("failed"),
        series,
    }
}
