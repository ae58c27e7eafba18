//! What other engines reach, as it was published or measured elsewhere: errors without times, since times of
//! other machines say nothing here. They stand on the charts of errors against the rate, as stars.

use crate::chart::{Series, Style};

/// The kept table: scenario, engine, steps a second, error in the scenario's unit, and where it is from: R was
/// measured again for the reference, S is read in the source's own data.
const TABLE: &str = include_str!("../../../../tests/reference/published.csv");

/// A line of it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Published {
    scenario: &'static str,
    engine: &'static str,
    rate: f64,
    error: f64,
    mark: &'static str,
}

fn lines() -> impl Iterator<Item = Published> {
    TABLE.lines().skip(1).filter_map(|line| {
        let mut fields = line.split(',');
        Some(Published {
            scenario: fields.next()?,
            engine: fields.next()?,
            rate: fields.next()?.parse().ok()?,
            error: fields.next()?.parse().ok()?,
            mark: fields.next()?,
        })
    })
}

/// Stars for a scenario, a series an engine.
#[must_use]
pub fn stars(scenario: &str) -> Vec<Series> {
    let mut series: Vec<Series> = Vec::new();
    for line in lines().filter(|line| line.scenario == scenario) {
        let name = format!("{} [{}]", line.engine, line.mark);
        let point = (line.rate, line.error);
        if let Some(known) = series.iter_mut().find(|known| known.name == name) {
            known.points.push(point);
            known.notes.push(name);
        } else {
            let one = Series::new(&name, Style::Published, [point]);
            series.push(one.with_notes(vec![name]));
        }
    }
    series
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laboratory::SCENARIOS;

    #[test]
    fn every_line_is_read_and_belongs_to_a_scenario() {
        assert_eq!(lines().count(), TABLE.lines().count() - 1);
        for line in lines() {
            assert!(
                SCENARIOS.iter().any(|known| known.name == line.scenario),
                "{line:?}"
            );
            assert!(["R", "S"].contains(&line.mark), "{line:?}");
            assert!(line.rate > 0.0 && line.error > 0.0, "{line:?}");
        }
    }

    #[test]
    fn an_engine_at_several_rates_is_one_series() {
        let stars = stars("slip_to_roll");
        let counts: Vec<usize> = stars.iter().map(|series| series.points.len()).collect();
        assert_eq!(counts, [2, 3]);
    }
}
