//! What the comparison is told as: picture, CSV and page.

use std::fmt::Write as _;

use super::{Facts, More, Outcome, SETTLE, Sample};
use crate::chart::{Bar, Bars, Group};
use crate::draw;
use crate::lab::{self, Spread, TURN};
use crate::left_out::signed_percent;
use crate::table::{Table, three_digits};

pub fn chart(outcomes: &[Outcome]) -> Bars {
    Bars {
        name: "lanes_left_out",
        title: "What a part that a scene doesn't need would add to a step on lanes".to_owned(),
        label: "more time for a step than planned (%)".to_owned(),
        powers: false,
        parts: vec!["more time"],
        groups: outcomes.iter().map(group).collect(),
    }
}

fn group(outcome: &Outcome) -> Group {
    let bar = |sample: &Sample| Bar {
        name: sample.more.name().to_owned(),
        lengths: vec![100.0 * sample.share.median],
        spread: Some((100.0 * sample.share.low, 100.0 * sample.share.high)),
        note: signed_percent(sample.share.median),
    };
    let (chance, others) = outcome.samples.split_at(1);
    Group {
        name: format!(
            "{}, {}: {} ms a step",
            outcome.name,
            outcome.method,
            three_digits(outcome.planned.median)
        ),
        bars: others.iter().chain(chance).map(bar).collect(),
    }
}

pub fn csv(outcomes: &[Outcome]) -> String {
    let mut text = "scene,method,pairs,run,planned_ms,more_share,least_more_share,\
        largest_more_share,operations_a_pair,bytes_a_pair,p99_of_r,same_bits\n"
        .to_owned();
    for outcome in outcomes {
        let planned = Sample {
            more: More::Nothing,
            facts: outcome.facts,
            share: Spread::default(),
        };
        let runs = std::iter::once(("planned", &planned));
        let others = outcome.samples.iter().map(|s| (s.more.name(), s));
        for (name, sample) in runs.chain(others) {
            // Writing into a String can't fail.
            let _ = writeln!(
                text,
                "{},{},{},{name},{:?},{:?},{:?},{:?},{:.1},{:.1},{:.5},{}",
                draw::quoted(&outcome.name),
                outcome.method,
                outcome.pairs,
                outcome.planned.median,
                sample.share.median,
                sample.share.low,
                sample.share.high,
                sample.facts.operations,
                sample.facts.bytes,
                sample.facts.p99,
                sample.more.keeps_bits(),
            );
        }
    }
    text
}

pub fn page(outcomes: &[Outcome], repeats: usize) -> String {
    let mut table = Table::new(&[
        "scene and method",
        "run",
        "a step takes longer by",
        "operations",
        "bytes",
        "99 of 100 depths, of r",
    ]);
    for outcome in outcomes {
        let numbers = |facts: Facts, depth: String| {
            [
                format!("{:.0}", facts.operations),
                format!("{:.0}", facts.bytes),
                depth,
            ]
        };
        let mut row = vec![
            format!("{}, {}", outcome.name, outcome.method),
            "as planned".to_owned(),
            format!("({} ms)", three_digits(outcome.planned.median)),
        ];
        row.extend(numbers(outcome.facts, format!("{:.4}", outcome.facts.p99)));
        table.push(row);
        for sample in &outcome.samples {
            let [low, high] = [sample.share.low, sample.share.high].map(signed_percent);
            let median = signed_percent(sample.share.median);
            let depth = if sample.more.keeps_bits() {
                "same bits".to_owned()
            } else {
                format!("{:.4}", sample.facts.p99)
            };
            let mut row = vec![
                String::new(),
                sample.more.name().to_owned(),
                format!("{median} ({low} … {high})"),
            ];
            row.extend(numbers(sample.facts, depth));
            table.push(row);
        }
    }
    format!(
        "The processor's time on one core of {cpu}, after {SETTLE} steps. The planned run and the others take turns \
         of {TURN} steps; of {repeats} comparisons with engines loaded anew the median (and the least … the largest). Operations: additions, \
         multiplications, divisions and roots of the pairs' and bodies' passes in a substep, over the number of \
         pairs. Bytes: of a pair in its batch, and of what its bodies gather from it, lanes that are left over \
         included.\n\n{table}",
        cpu = lab::processor(),
        table = table.markdown(2),
    )
}
