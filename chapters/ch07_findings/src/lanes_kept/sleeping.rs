//! A settled pile awake and asleep: time of a step, from a table that is kept in the book.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_sleeping.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example pile -- --counts 1000,10000 \
              --settle 1500 --steps 200 --threads 1 --sleeping --csv FILE",
};

/// A pile's time.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    count: f64,
    /// How many sleep.
    asleep: f64,
    /// A step, ms: median.
    ms: f64,
    /// 99 of 100 contacts are no deeper, m.
    p99: f64,
}

/// Lays out picture, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where the table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    SOURCE.drawn(say, drawn)
}

fn drawn(kept: &Kept) -> Result<Product, FindingsError> {
    let samples = kept.samples(Sample::of)?;
    Ok(Product {
        charts: vec![chart(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples, &kept.origin())),
    })
}

impl Sample {
    fn of(line: Line) -> Result<Self, FindingsError> {
        line.one_of("scene", &["pile"])?;
        line.one_of("engine", &["lanes"])?;
        Ok(Self {
            count: line.positive("count")?,
            asleep: line.number("asleep")?,
            ms: line.positive("ms_median")?,
            p99: line.positive("p99_m")?,
        })
    }
}

/// Piles awake, each with the same one when all sleep.
fn pairs(samples: &[Sample]) -> impl Iterator<Item = (&Sample, &Sample)> {
    samples
        .iter()
        .filter(|s| s.asleep == 0.0)
        .filter_map(|awake| {
            let same = |s: &&Sample| s.count == awake.count && s.asleep == s.count;
            samples.iter().find(same).map(|asleep| (awake, asleep))
        })
}

fn chart(samples: &[Sample]) -> Chart {
    let (awake, asleep): (Vec<_>, Vec<_>) = pairs(samples)
        .map(|(awake, asleep)| ((awake.count, awake.ms), (asleep.count, asleep.ms)))
        .unzip();
    Chart {
        name: "sleeping",
        title: "A settled pile of balls, on one thread".to_owned(),
        x: Axis::log("balls"),
        y: Axis::log("time of a step (ms)"),
        series: vec![
            Series::new("awake", Style::Other(0), awake),
            Series::new("asleep", Style::Other(1), asleep),
        ],
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "balls,asleep,step (ms),p99 (m)\n".to_owned();
    for s in samples {
        let _ = writeln!(text, "{},{},{},{}", s.count, s.asleep, s.ms, s.p99);
    }
    text
}

fn page(samples: &[Sample], origin: &str) -> String {
    let mut table = Table::new(&["balls", "awake (ms)", "asleep (ms)", "share (%)"]);
    for (awake, asleep) in pairs(samples) {
        table.push(vec![
            draw::grouped(&awake.count.to_string()),
            three_digits(awake.ms),
            three_digits(asleep.ms),
            three_digits(100.0 * asleep.ms / awake.ms),
        ]);
    }
    format!("{}\nMedians of a step; {origin}.\n", table.markdown(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_the_book_a_sleeping_pile_costs_less_than_a_fiftieth_and_lies_as_well() {
        let kept = SOURCE.read().expect("it is in the book");
        let samples = kept.samples(Sample::of);
        let samples = samples.expect("it can be read");
        let largest = pairs(&samples)
            .map(|(awake, _)| awake.count)
            .fold(0.0, f64::max);
        assert!(largest >= 1e4, "no pile of ten thousand: {samples:?}");
        for (awake, asleep) in pairs(&samples) {
            assert!(asleep.ms < 0.02 * awake.ms, "{awake:?} {asleep:?}");
            assert!(asleep.p99 <= 1.1 * awake.p99, "{awake:?} {asleep:?}");
        }
    }
}
