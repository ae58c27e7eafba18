//! What an error of one per cent costs, scenario by scenario.

use std::fmt::Write as _;
use std::ops::RangeInclusive;

use super::cell::Cell;
use super::charts::by;
use super::contenders::{CONTENDERS, Contender};
use super::scenario::Scenario;
use super::scenarios::SCENARIOS;
use crate::chart::{Bar, Bars, Group, Picture};
use crate::table::three_digits;

/// A chart's name, what it is about, and the numbers of its scenarios.
type Part = (&'static str, &'static str, RangeInclusive<u32>);

/// The charts of what one per cent costs.
const COSTS: [Part; 3] = [
    ("laboratory_costs", "bodies that are alone", 1..=8),
    ("laboratory_costs_contacts", "joints and impacts", 9..=17),
    (
        "laboratory_costs_crowds",
        "crowds, towers and chains",
        18..=24,
    ),
];

/// The charts.
pub fn charts(cells: &[Cell]) -> Vec<Picture> {
    COSTS.iter().map(|part| cost(cells, part).into()).collect()
}

/// What the cheapest run of a contender costs that errs by one per cent at most, s/s.
fn cost_of_one_percent(cells: &[Cell], scenario: &Scenario, contender: &Contender) -> Option<f64> {
    let good = |cell: &&&Cell| cell.is_measured() && cell.error <= scenario.one_percent;
    let cells = by(cells, scenario.name, contender);
    let costs = cells.iter().filter(good).map(|cell| cell.cost);
    costs.min_by(f64::total_cmp)
}

fn cost(cells: &[Cell], (name, what, numbers): &Part) -> Bars {
    let group = |scenario: &Scenario| Group {
        name: scenario.heading(),
        bars: CONTENDERS
            .iter()
            .filter(|contender| !by(cells, scenario.name, contender).is_empty())
            .map(|contender| {
                let cost = cost_of_one_percent(cells, scenario, contender);
                Bar {
                    name: contender.name.to_owned(),
                    lengths: vec![cost.map_or(0.0, |cost| (1e6 * cost).log10().max(0.0))],
                    spread: None,
                    note: cost.map_or("never".to_owned(), |cost| three_digits(1e6 * cost)),
                }
            })
            .collect(),
    };
    Bars {
        name,
        title: format!(
            "What an error of one per cent costs, {what}: µs of processor time for a second of the scene"
        ),
        label: "powers of ten (µs)".to_owned(),
        parts: vec!["cheapest run within one per cent"],
        groups: SCENARIOS
            .iter()
            .filter(|scenario| numbers.contains(&scenario.number))
            .map(group)
            .collect(),
    }
}

/// The same as numbers.
pub fn csv(cells: &[Cell]) -> String {
    let mut text = "scenario,contender,one per cent,unit,CPU time (s/s)\n".to_owned();
    for scenario in SCENARIOS {
        for contender in CONTENDERS {
            let cost = cost_of_one_percent(cells, scenario, contender);
            let cost = cost.map_or("never".to_owned(), |cost| format!("{cost:e}"));
            let _ = writeln!(
                text,
                "{},{},{},{},{cost}",
                scenario.name, contender.name, scenario.one_percent, scenario.unit
            );
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::cell::End;
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
            end: End::Measured,
        }
    }

    #[test]
    fn what_never_errs_by_so_little_costs_nothing_that_could_be_told() {
        let cells = [
            cell("splitting", 60, 1.0, 0.5),
            cell("splitting", 120, 2.0, 0.001),
        ];
        let scenario = SCENARIOS
            .iter()
            .find(|known| known.name == "free_top")
            .expect("4");
        let by_name = |name| {
            CONTENDERS
                .iter()
                .find(|known| known.name == name)
                .expect("known")
        };
        let cost = |name| cost_of_one_percent(&cells, scenario, by_name(name));
        assert_eq!(cost("splitting"), Some(2.0));
        assert_eq!(cost("runge-kutta"), None);
    }
}
