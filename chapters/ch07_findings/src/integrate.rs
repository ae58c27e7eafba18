//! What it takes to advance a body: objects, columns, and the bound that memory sets, which is to copy as
//! many bytes as the columns' system reads and writes. And what it takes to gather all bodies' places for
//! an upload.

mod flight;

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::lab::{self, Spread};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

pub use flight::measured;

/// Numbers of bodies.
pub const COUNTS: [usize; 6] = [10, 100, 1000, 10_000, 100_000, 1_000_000];
/// From so many bodies on, the time to gather them is told.
const GATHERED_FROM: usize = 1000;

/// What is timed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The objects' update, of bodies that turn.
    Objects,
    /// Both systems, for places and for turns.
    Columns,
    /// The objects' update, of balls that don't turn.
    ObjectsPlaces,
    /// The system for places, which is all that balls need that don't turn.
    ColumnsPlaces,
    /// As many bytes as that one reads and writes, copied.
    Copy,
    /// The places and turns of all objects, written into one list.
    GatherObjects,
    /// The columns of both, copied.
    GatherColumns,
}

/// What is drawn, with names and looks.
const DRAWN: [(Way, &str, Style); 5] = [
    (Way::Objects, "objects, turning", Style::Printed),
    (Way::ObjectsPlaces, "objects, not turning", Style::Other(2)),
    (Way::Columns, "columns, turning", Style::Corrected),
    (
        Way::ColumnsPlaces,
        "columns, not turning: places alone",
        Style::Other(3),
    ),
    (
        Way::Copy,
        "copying what that reads and writes",
        Style::Other(0),
    ),
];

/// How long a way took.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The way.
    pub way: Way,
    /// Number of bodies.
    pub count: usize,
    /// For one of them, ns: the median of the runs, the least and the largest.
    pub ns: Spread,
}

impl Way {
    /// As the CSV calls it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Way::Objects => "objects turning",
            Way::Columns => "columns turning",
            Way::ObjectsPlaces => "objects not turning",
            Way::ColumnsPlaces => "columns not turning",
            Way::Copy => "copy",
            Way::GatherObjects => "gather objects",
            Way::GatherColumns => "gather columns",
        }
    }

    /// Bytes a body that it must read and write at least; of what is gathered, bytes that come out.
    #[must_use]
    pub const fn bytes(self) -> usize {
        match self {
            // p, p*: read and written; 1/m: read.
            Way::ObjectsPlaces | Way::ColumnsPlaces | Way::Copy => 4 * 12 + 4,
            // The same, 1/m again, q, q*: read and written; I, 1/I: read.
            Way::Objects | Way::Columns => 4 * 12 + 4 + 4 + 4 * 16 + 2 * 12,
            Way::GatherObjects | Way::GatherColumns => 12 + 16,
        }
    }
}

impl Sample {
    /// 10⁹ bytes a second.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.way.bytes() as f64 / self.ns.median
    }
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where objects and columns come to different places.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let most = if quick { 10_000 } else { 1_000_000 };
    let mut samples = Vec::new();
    for count in COUNTS.into_iter().filter(|&count| count <= most) {
        samples.extend(measured(count)?);
        say(&format!("{} bodies", draw::grouped(&count.to_string())));
    }
    Ok(Product {
        charts: vec![chart(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples)),
    })
}

/// The sample of a way with so many bodies.
fn find(samples: &[Sample], way: Way, count: usize) -> Option<&Sample> {
    let same = |s: &&Sample| (s.way, s.count) == (way, count);
    samples.iter().find(same)
}

fn chart(samples: &[Sample]) -> Chart {
    let curve = |(way, name, style)| {
        let same = || samples.iter().filter(move |sample| sample.way == way);
        let points = same().map(|sample| (sample.count as f64, sample.ns.median));
        let bars = same().map(|sample| (sample.ns.low, sample.ns.high));
        Series::new(name, style, points).with_bars(bars.collect())
    };
    Chart {
        name: "integrate",
        title: "Advancing bodies that fly: objects, columns, and what memory allows".to_owned(),
        x: Axis::log("bodies"),
        y: Axis::log("time (ns a body)"),
        series: DRAWN.map(curve).to_vec(),
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "what,bodies,median_ns,least_ns,largest_ns,bytes,gb_per_s\n".to_owned();
    for s in samples {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{:?},{:?},{:?},{},{:?}",
            s.way.name(),
            s.count,
            s.ns.median,
            s.ns.low,
            s.ns.high,
            s.way.bytes(),
            s.rate(),
        );
    }
    text
}

fn page(samples: &[Sample]) -> String {
    let mut counts: Vec<usize> = samples.iter().map(|sample| sample.count).collect();
    counts.dedup();
    counts.sort_unstable();
    counts.dedup();
    format!(
        "One core of {cpu}; free flight: balls far apart, nothing touches. ns a body: the median of 15 runs, \
         each after one that doesn't count. Objects walk their list, advance and tell the scene graph where \
         they are; columns run the plan's systems, for places, and for turns where something turns. Both have the same \
         bits after all runs. The objects were made one after the other and lie in memory in that order. \
         Places alone read and write {bytes} bytes a body; beside it, copying half as many, which reads and \
         writes {bytes} too.\n\n{advance}\n\
         Places and turns of all bodies written into one list for an upload, 28 bytes a body:\n\n{gather}",
        cpu = lab::processor(),
        bytes = Way::Copy.bytes(),
        advance = advance(samples, &counts).markdown(0),
        gather = gathered(samples, &counts).markdown(0),
    )
}

fn advance(samples: &[Sample], counts: &[usize]) -> Table {
    let mut table = Table::new(&[
        "bodies",
        "turning: objects (ns)",
        "columns (ns)",
        "ratio",
        "not turning: objects (ns)",
        "columns (ns)",
        "ratio",
        "copy (ns)",
        "columns (GB/s)",
        "copy (GB/s)",
        "times the copy",
    ]);
    for &count in counts {
        let ways = DRAWN.map(|(way, ..)| find(samples, way, count));
        let [
            Some(turning),
            Some(gliding),
            Some(both),
            Some(places),
            Some(copy),
        ] = ways
        else {
            continue;
        };
        let ns = |sample: &Sample| three_digits(sample.ns.median);
        let ratio = |a: &Sample, b: &Sample| format!("{:.2}", a.ns.median / b.ns.median);
        table.push(vec![
            draw::grouped(&count.to_string()),
            ns(turning),
            ns(both),
            ratio(turning, both),
            ns(gliding),
            ns(places),
            ratio(gliding, places),
            ns(copy),
            three_digits(places.rate()),
            three_digits(copy.rate()),
            ratio(places, copy),
        ]);
    }
    table
}

fn gathered(samples: &[Sample], counts: &[usize]) -> Table {
    let mut table = Table::new(&[
        "bodies",
        "objects (ms)",
        "columns (ms)",
        "ratio",
        "objects (GB/s)",
        "columns (GB/s)",
    ]);
    for &count in counts.iter().filter(|&&count| count >= GATHERED_FROM) {
        let ways = [Way::GatherObjects, Way::GatherColumns];
        let [Some(objects), Some(columns)] = ways.map(|way| find(samples, way, count)) else {
            continue;
        };
        let ms = |sample: &Sample| three_digits(1e-6 * sample.ns.median * count as f64);
        table.push(vec![
            draw::grouped(&count.to_string()),
            ms(objects),
            ms(columns),
            format!("{:.1}", objects.ns.median / columns.ns.median),
            three_digits(objects.rate()),
            three_digits(columns.rate()),
        ]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_ways_are_timed_and_fill_their_tables() {
        let samples = measured(1000).expect("both fly alike");
        assert_eq!(samples.len(), 7);
        assert!(samples.iter().all(|s| s.ns.low > 0.0), "{samples:?}");
        assert_eq!(chart(&samples).series.len(), DRAWN.len());
        let page = page(&samples);
        assert_eq!(
            page.matches("\n| 1,000 |").count(),
            0,
            "the first column is on the right"
        );
        assert_eq!(page.matches("|  1,000 |").count(), 2, "{page}");
        assert_eq!(csv(&samples).lines().count(), 8);
    }

    #[test]
    fn a_nanosecond_for_a_byte_is_a_gigabyte_a_second() {
        let ns = Spread::of_all(&[52.0]);
        let way = Way::Copy;
        assert_eq!((Sample { way, count: 1, ns }).rate(), 1.0);
    }
}
