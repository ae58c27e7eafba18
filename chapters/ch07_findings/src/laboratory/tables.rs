//! The cells as tables, in Markdown.

use super::cell::{Cell, End};
use super::charts::{USUAL, at, by};
use super::contenders::{CONTENDERS, Contender};
use super::scenario::Scenario;
use super::scenarios::SCENARIOS;
use crate::table::{Table, three_digits};

/// The first of the integrators of bodies that are alone.
const FIRST_ALONE: &str = "constant-spin";

/// How a cell stands in a table.
fn told(cell: Option<&Cell>, pass: f64) -> String {
    match cell {
        None => String::new(),
        Some(cell) => match &cell.end {
            End::Cannot(_) => "–".to_owned(),
            End::Failed(how) => how.clone(),
            End::Measured if cell.error <= pass => format!("**{}**", three_digits(cell.error)),
            End::Measured => three_digits(cell.error),
        },
    }
}

/// All scenarios at 60 Hz, and what counts as a pass, as one per cent and as a failure: parts of a page.
pub fn all(cells: &[Cell]) -> String {
    [("at_60_hz", at_usual(cells)), ("bounds", bounds())]
        .map(|(name, table)| {
            format!("<!-- ANCHOR: {name} -->\n{table}\n<!-- ANCHOR_END: {name} -->\n")
        })
        .concat()
}

/// What a pass is, what one per cent is, and when a run has failed.
fn bounds() -> String {
    let mut table = Table::new(&["scenario", "to reach", "one per cent is", "failed"]);
    for scenario in SCENARIOS {
        let number = |number: f64| format!("{number} {}", scenario.unit).trim_end().to_owned();
        let one = number(scenario.one_percent);
        table.push(vec![
            scenario.heading(),
            number(scenario.pass),
            format!("{one} ({})", scenario.scale),
            scenario.fails.to_owned(),
        ]);
    }
    table.markdown(4)
}

/// All scenarios at 60 Hz: by the book's methods, by others, and by integrators of bodies that are alone.
fn at_usual(cells: &[Cell]) -> String {
    let first = CONTENDERS
        .iter()
        .position(|contender| contender.name == FIRST_ALONE);
    let (solvers, alone) = CONTENDERS.split_at(first.unwrap_or(CONTENDERS.len()));
    let (ours, others): (Vec<_>, Vec<_>) = solvers.iter().partition(|contender| contender.ours);
    let alone: Vec<_> = alone.iter().collect();
    let free = |scenario: &&Scenario| {
        let any = |contender: &&Contender| !by(cells, scenario.name, contender).is_empty();
        alone.iter().any(any)
    };
    let all: Vec<&Scenario> = SCENARIOS.iter().collect();
    let free: Vec<&Scenario> = SCENARIOS.iter().filter(free).collect();
    format!(
        "{}\nThe same by other methods:\n\n{}\nBodies that are alone, by the usual integrators:\n\n{}",
        table(cells, &all, &ours),
        table(cells, &all, &others),
        table(cells, &free, &alone)
    )
}

fn table(cells: &[Cell], scenarios: &[&Scenario], contenders: &[&Contender]) -> String {
    let names = contenders.iter().map(|contender| contender.name);
    let headings: Vec<&str> = ["scenario at 60 Hz", "to reach"]
        .into_iter()
        .chain(names)
        .collect();
    let mut table = Table::new(&headings);
    for scenario in scenarios {
        let reach = format!("{} {}", scenario.pass, scenario.unit);
        let mut row = vec![scenario.heading(), reach];
        row.extend(contenders.iter().map(|contender| {
            told(
                at(cells, scenario.name, contender.name, USUAL),
                scenario.pass,
            )
        }));
        table.push(row);
    }
    table.markdown(1)
}

/// All runs of a scenario.
pub fn of_one(scenario: &Scenario, cells: &[Cell]) -> String {
    let mut table = Table::new(&[
        "method",
        "Hz",
        "substeps",
        "sweeps",
        "error",
        "µs a second",
        "",
    ]);
    for contender in CONTENDERS {
        for cell in by(cells, scenario.name, contender) {
            table.push(vec![
                cell.contender.clone(),
                cell.rate.to_string(),
                cell.substeps.to_string(),
                if cell.sweeps == 0 {
                    String::new()
                } else {
                    cell.sweeps.to_string()
                },
                three_digits(cell.error),
                three_digits(1e6 * cell.cost),
                match &cell.end {
                    End::Failed(how) => how.clone(),
                    _ => String::new(),
                },
            ]);
        }
    }
    table.markdown(1)
}
