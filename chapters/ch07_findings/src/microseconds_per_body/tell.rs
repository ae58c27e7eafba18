//! The samples as a picture, as CSV and as tables.

use std::fmt::Write as _;

use super::crossings::crossings;
use super::{CARD, GATE, LONGEST, MANY, STEPS, Sample, TURNS, WARM};
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw::grouped;
use crate::engines::{KINDS, is_ours};
use crate::laboratory::store::Kept;
use crate::table::{Table, percent, three_digits};

/// The names in the order of the chart.
fn names(samples: &[Sample]) -> Vec<(String, Style)> {
    let mut all: Vec<(String, Style)> = KINDS
        .iter()
        .map(|kind| (kind.name.to_owned(), kind.style))
        .collect();
    for sample in samples.iter().filter(|sample| sample.kept) {
        if all.iter().all(|(name, _)| *name != sample.name) {
            all.push((sample.name.clone(), Style::Other(9)));
        }
    }
    all.retain(|(name, _)| samples.iter().any(|sample| sample.name == *name));
    all
}

fn of<'a>(samples: &'a [Sample], name: &'a str) -> impl Iterator<Item = &'a Sample> + Clone {
    samples.iter().filter(move |sample| sample.name == name)
}

/// The engine that stands on both charts.
const ON_BOTH: &str = "coloured on lanes";

/// The book's engines, and the others beside the quickest of them on a thread, over the same axes.
pub fn charts(samples: &[Sample]) -> [Chart; 2] {
    [
        chart(
            samples,
            "microseconds_per_body",
            "the book's engines",
            is_ours,
        ),
        chart(samples, "microseconds_per_body_others", "others", |name| {
            name == ON_BOTH || !is_ours(name)
        }),
    ]
}

fn chart(
    samples: &[Sample],
    chart: &'static str,
    whose: &str,
    shown: impl Fn(&str) -> bool,
) -> Chart {
    let passing = || samples.iter().filter(|sample| sample.passes());
    let counts = samples.iter().map(|one| one.balls as f64);
    let times = passing().flat_map(|one| [one.micros.low, one.micros.high]);
    let curve = |(name, style): (String, Style)| {
        let passing = of(samples, &name).filter(|sample| sample.passes());
        let bars = passing.clone().map(|one| (one.micros.low, one.micros.high));
        let points = passing.map(|one| (one.balls as f64, one.micros.median));
        Series::new(&name, style, points).with_bars(bars.collect())
    };
    let names = names(samples).into_iter();
    let mut series: Vec<Series> = names.filter(|(name, _)| shown(name)).map(curve).collect();
    let failing = samples
        .iter()
        .filter(|sample| !sample.passes() && shown(&sample.name));
    let failing: Vec<_> = failing.map(|one| (one.balls as f64, f64::NAN)).collect();
    if !failing.is_empty() {
        series.push(Series::new(
            "doesn't pass the gate (see the table)",
            Style::Marks(5),
            failing,
        ));
    }
    Chart {
        name: chart,
        title: format!(
            "Time of a step of a settled pile, a ball, {whose}: one thread of {}, and a card where it is named",
            host(samples)
        ),
        x: Axis::log("balls").reaching(counts),
        y: Axis::log("time of a step over the number of balls (µs)")
            .lost("fails")
            .reaching(times),
        series,
    }
}

pub fn csv(samples: &[Sample]) -> String {
    let mut text = format!("{},passes\n", Sample::HEADINGS);
    for one in samples {
        // Writing into a String can't fail.
        let _ = writeln!(text, "{},{}", one.line(), one.passes());
    }
    text
}

/// Times, how well the piles lie, and where curves cross.
pub fn page(samples: &[Sample]) -> String {
    format!(
        "{}\n\n{}\n{}",
        how(samples),
        times(samples),
        crossed(samples)
    )
}

/// The processor that those on a thread ran on.
fn host(samples: &[Sample]) -> &str {
    let own = samples.iter().find(|one| !one.kept);
    own.map_or("", |one| one.device.as_str())
}

fn how(samples: &[Sample]) -> String {
    let host = host(samples);
    let other = samples.iter().find(|one| !one.kept && one.device != host);
    let other = other.map_or(String::new(), |one| {
        format!(" `{}` ran on {}.", one.name, one.device)
    });
    format!(
        "A pile that `coloured` let settle is handed to every engine, which makes {} steps with it (above {} \
         balls {}) and is then timed in {} turns of {} steps ({} of {}), one engine after the other, on one \
         thread of {host}.{other} The time is the median of the turns. Behind it stands the 99th percentile of the \
         overlaps at the end, of the smaller ball's radius; a time counts where that is below {}, and no ball is \
         gone. A dash: not measured; a step that would take more than {} ms never is. The card's numbers are kept in `{}`, and are of \
         another machine, with its pile settled on the card.",
        WARM[0],
        grouped(&MANY.to_string()),
        WARM[1],
        TURNS[0],
        STEPS[0],
        TURNS[1],
        STEPS[1],
        percent(GATE),
        three_digits(LONGEST),
        CARD.file,
    )
}

fn times(samples: &[Sample]) -> String {
    let mut counts: Vec<u64> = samples.iter().map(|sample| sample.balls).collect();
    counts.sort_unstable();
    counts.dedup();
    let headings: Vec<String> = (counts.iter())
        .map(|balls| grouped(&balls.to_string()))
        .collect();
    let mut all = vec!["µs a ball and a step, by balls"];
    all.extend(headings.iter().map(String::as_str));
    let mut table = Table::new(&all);
    for (name, _) in names(samples) {
        let mut cells = vec![name.clone()];
        cells.extend(counts.iter().map(|balls| {
            let found = of(samples, &name).find(|sample| sample.balls == *balls);
            found.map_or("–".to_owned(), |one| {
                let (micros, p99) = (three_digits(one.micros.median), percent(one.p99));
                if one.passes() {
                    format!("{micros} ({p99})")
                } else {
                    format!("~~{micros}~~ ({p99}; {} gone)", one.gone)
                }
            })
        }));
        table.push(cells);
    }
    table.markdown(1)
}

/// Crossings, in the order of the number of balls.
fn crossed(samples: &[Sample]) -> String {
    let found = crossings(samples);
    if found.is_empty() {
        return "No two of these curves cross.\n".to_owned();
    }
    let mut table = Table::new(&[
        "up to here the cheaper is",
        "from here on",
        "balls",
        "µs a ball",
    ]);
    for one in found {
        table.push(vec![
            one.below,
            one.above,
            three_digits(one.balls),
            three_digits(one.micros),
        ]);
    }
    format!(
        "Where two curves cross, between two numbers that were measured; straight in logarithms. Only where the \
         least times of the turns cross too:\n\n{}",
        table.markdown(2)
    )
}
