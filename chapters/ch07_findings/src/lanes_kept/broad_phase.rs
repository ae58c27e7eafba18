//! How engine `lanes` finds who may touch: grids by size and its tree, beside chapter 3's, from a table that is
//! kept in the book.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_broad_phases.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example broad_phases",
};

/// The crowds: name in the table, of its chart, and what it shows.
const CROWDS: [(&str, &str, &str); 4] = [
    (
        "settled",
        "lanes_broad_phase",
        "a pile of balls that has settled",
    ),
    (
        "crashing",
        "lanes_broad_phase_crashing",
        "balls that fall into a heap",
    ),
    (
        "sparse",
        "lanes_broad_phase_sparse",
        "balls that fly, far from each other",
    ),
    (
        "ragdolls",
        "lanes_broad_phase_ragdolls",
        "ragdolls in their fall",
    ),
];

/// Crowds of radii from 1 to so much are called so.
const UNEQUAL: &str = "unequal ";

/// Their number of bodies on the chart.
const OF_UNEQUAL: f64 = 10_000.0;

/// The ways, each with its looks.
const WAYS: [(&str, Style); 6] = [
    ("grids", Style::Other(0)),
    ("tree", Style::Corrected),
    ("grids anew", Style::Other(1)),
    ("tree anew", Style::Other(2)),
    ("chapter 3's tree", Style::Printed),
    ("chapter 3's grid", Style::Other(3)),
];

/// What a way took in a crowd.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    crowd: String,
    way: String,
    bodies: f64,
    pairs: f64,
    /// A step: mean, ms.
    ms: f64,
    /// Of how many steps all was built anew.
    anew: f64,
}

/// Lays out pictures, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where the table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    SOURCE.drawn(say, drawn)
}

fn drawn(kept: &Kept) -> Result<Product, FindingsError> {
    let samples = kept.samples(Sample::of)?;
    let processor = kept.common("processor")?;
    let charts = CROWDS.map(|(crowd, name, title)| chart(&samples, crowd, name, title));
    let charts = charts.into_iter().chain([spread_chart(&samples)]);
    Ok(Product {
        charts: charts.map(Into::into).collect(),
        csv: csv(&samples),
        page: Some(page(&samples, processor, &kept.origin())),
    })
}

impl Sample {
    fn of(line: Line) -> Result<Self, FindingsError> {
        if !line.text("crowd")?.starts_with(UNEQUAL) {
            line.one_of("crowd", &CROWDS.map(|(crowd, ..)| crowd))?;
        }
        line.one_of("way", &WAYS.map(|(way, _)| way))?;
        Ok(Self {
            crowd: line.text("crowd")?.to_owned(),
            way: line.text("way")?.to_owned(),
            bodies: line.positive("bodies")?,
            pairs: line.number("pairs")?,
            ms: line.positive("ms")?,
            anew: line.number("anew_of_steps")?,
        })
    }
}

/// A way's samples of a crowd.
fn of<'s>(samples: &'s [Sample], crowd: &'s str, way: &'s str) -> impl Iterator<Item = &'s Sample> {
    samples
        .iter()
        .filter(move |s| s.crowd == crowd && s.way == way)
}

fn chart(samples: &[Sample], crowd: &str, name: &'static str, title: &str) -> Chart {
    let curve = |(way, style): (&str, Style)| {
        let points = of(samples, crowd, way).map(|s| (s.bodies, 1e6 * s.ms / s.bodies));
        Series::new(way, style, points)
    };
    Chart {
        name,
        title: format!("Who may touch: {title}"),
        x: Axis::log("bodies"),
        y: Axis::log("time of a step (ns a body)"),
        series: WAYS.map(curve).to_vec(),
    }
}

/// From 1 to how much the radii of a crowd are.
fn spread(sample: &Sample) -> Option<f64> {
    sample.crowd.strip_prefix(UNEQUAL)?.parse().ok()
}

/// Time against the spread of the radii.
fn spread_chart(samples: &[Sample]) -> Chart {
    let of = |way: &str| -> Vec<(f64, f64)> {
        let same = samples
            .iter()
            .filter(|s| s.way == way && s.bodies == OF_UNEQUAL);
        same.filter_map(|s| Some((spread(s)?, s.ms))).collect()
    };
    // Chapter 3's grid would press the others together.
    let ways = WAYS
        .into_iter()
        .filter(|(way, _)| *way != "chapter 3's grid");
    Chart {
        name: "lanes_broad_phase_unequal",
        title: "Who may touch: 10,000 balls of unequal radii that fly".to_owned(),
        x: Axis::log("largest radius over the smallest"),
        y: Axis::log("time of a step (ms)"),
        series: ways
            .map(|(way, style)| Series::new(way, style, of(way)))
            .collect(),
    }
}

/// All crowds, in the order of the table.
fn crowds(samples: &[Sample]) -> Vec<&str> {
    let mut crowds: Vec<&str> = Vec::new();
    for sample in samples {
        if !crowds.contains(&&*sample.crowd) {
            crowds.push(&sample.crowd);
        }
    }
    crowds
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "crowd,way,bodies,pairs,step (ms),anew of all steps\n".to_owned();
    for s in samples {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{}",
            s.crowd, s.way, s.bodies, s.pairs, s.ms, s.anew
        );
    }
    text
}

fn page(samples: &[Sample], processor: &str, origin: &str) -> String {
    let names = WAYS.map(|(way, _)| way);
    let [grids, others @ ..] = names;
    let mut headings = vec!["crowd", "bodies", "pairs", "steps anew (%)", grids];
    headings.extend(others);
    let mut table = Table::new(&headings);
    for crowd in crowds(samples) {
        for first in of(samples, crowd, grids) {
            let mut row = vec![
                crowd.to_owned(),
                draw::grouped(&first.bodies.to_string()),
                draw::grouped(&first.pairs.to_string()),
                format!("{:.0}", 100.0 * first.anew),
            ];
            row.extend(names.map(|way| {
                let mut same = of(samples, crowd, way);
                let found = same.find(|s| s.bodies == first.bodies);
                found.map_or("–".to_owned(), |s| three_digits(s.ms))
            }));
            table.push(row);
        }
    }
    format!(
        "{}\nms a step on one core of {processor}. All ways took turns. Steps in which a way builds all anew and steps in \
         which it doesn't are timed apart. Of each sort the quickest tenth tells what such a step takes, and the \
         mean is by how many there were of each. \"Steps anew\" are those of the grids; {origin}.\n",
        table.markdown(1)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page and the plan say so: built anew, grids are quicker for bodies of about one size, and the tree for
    /// those of very unequal ones; and both beat chapter 3's tree.
    #[test]
    fn in_the_book_grids_win_among_equals_and_the_tree_among_unequals() {
        let kept = SOURCE.read().expect("it is in the book");
        let samples = kept.samples(Sample::of);
        let samples = samples.expect("it can be read");
        for (crowd, ..) in CROWDS {
            assert!(of(&samples, crowd, "grids").count() >= 3, "{crowd}");
        }
        let many = samples.iter().filter(|s| s.bodies >= 1000.0);
        for first in many.filter(|s| s.way == "grids") {
            let ms = |way: &str| {
                let mut same = of(&samples, &first.crowd, way);
                let sample = same.find(|s| s.bodies == first.bodies).expect("measured");
                assert!(sample.pairs.total_cmp(&first.pairs).is_eq(), "{sample:?}");
                sample.ms
            };
            let [grids, tree] = ["grids anew", "tree anew"].map(ms);
            assert!(grids.max(tree) < ms("chapter 3's tree"), "{first:?}");
            match spread(first).unwrap_or(1.0) {
                ..10.0 => assert!(grids < 1.1 * tree, "{first:?}"),
                10.0 => {}
                _ => assert!(tree < grids, "{first:?}"),
            }
        }
    }
}
