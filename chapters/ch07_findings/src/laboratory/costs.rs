//! What an error of one per cent costs, scenario by scenario.

use std::fmt::Write as _;
use std::ops::RangeInclusive;

use super::cell::Cell;
use super::charts::by;
use super::contenders::{CONTENDERS, Contender};
use super::scenario::Scenario;
use super::scenarios::SCENARIOS;
use crate::chart::{Axis, DotRow, Dots, Picture};

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

fn cost(cells: &[Cell], (name, what, numbers): &Part) -> Dots {
    let scenarios = || {
        let all = SCENARIOS.iter();
        all.filter(|scenario| numbers.contains(&scenario.number))
    };
    let runs = |scenario: &Scenario, contender: &Contender| {
        !by(cells, scenario.name, contender).is_empty()
    };
    let contenders = CONTENDERS.iter();
    let contenders: Vec<_> = contenders
        .filter(|contender| scenarios().any(|scenario| runs(scenario, contender)))
        .collect();
    let row = |scenario: &Scenario| {
        let all = contenders.iter().enumerate();
        let tried: Vec<_> = all
            .filter(|(_, contender)| runs(scenario, contender))
            .map(|(kind, contender)| (kind, cost_of_one_percent(cells, scenario, contender)))
            .collect();
        let there = tried.iter();
        let marks: Vec<_> = there
            .filter_map(|&(kind, cost)| Some((kind, 1e6 * cost?)))
            .collect();
        DotRow {
            name: scenario.heading(),
            note: format!("{} of {}", marks.len(), tried.len()),
            marks,
        }
    };
    Dots {
        name,
        title: format!(
            "What an error of one per cent costs, {what}: processor time for a second of the scene; on the right \
             how many methods get there"
        ),
        x: Axis::log("cheapest run within one per cent (µs for a second of the scene)"),
        kinds: contenders
            .iter()
            .map(|contender| (contender.name.to_owned(), contender.style))
            .collect(),
        rows: scenarios().map(row).collect(),
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
