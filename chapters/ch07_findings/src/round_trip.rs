//! What a round trip to the GPU costs every frame, and from how many bodies on it is worth it: drawn from
//! two tables that are kept in the book, one of balls and one of boxes, as few readers have their machine.

mod crossover;
mod sample;

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Bar, Bars, Chart, Group, Series, Style};
use crate::draw;
use crate::kept::{Kept, Source};
use crate::product::{Product, Say};
use crate::table::{Table, percent, three_digits};
use crossover::{Crossover, grouped};
use sample::Sample;

/// The kept tables, of what flies, with the name of the picture.
const SOURCES: [(&str, &str, Source); 2] = [
    (
        "balls",
        "round_trip",
        Source {
            file: "ch06_round_trip_balls_nvidia_h200.csv",
            command: "cargo run --release -p ch06_compute --no-default-features \
                      --example round_trip -- --csv FILE",
        },
    ),
    (
        "boxes",
        "round_trip_boxes",
        Source {
            file: "ch06_round_trip_boxes_nvidia_h200.csv",
            command: "cargo run --release -p ch06_compute --no-default-features \
                      --example round_trip -- --boxes --csv FILE",
        },
    ),
];
/// The parts of a round trip, in order.
const PARTS: [&str; 3] = ["upload", "compute, with its start", "download"];

/// A kept table.
#[derive(Clone, Debug, PartialEq)]
struct Trip {
    /// What flies.
    things: &'static str,
    /// Name of its picture.
    chart: &'static str,
    device: String,
    processor: String,
    origin: String,
    /// In order of their numbers of bodies.
    samples: Vec<Sample>,
}

/// Lays out pictures, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where a table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    let mut trips = Vec::new();
    for (things, chart, source) in SOURCES {
        let trip = Trip::of(things, chart, &source.read()?)?;
        say(&format!("{things}, on {}: {}", trip.device, source.file));
        trips.push(trip);
    }
    let mut charts: Vec<_> = trips.iter().map(|trip| trip.curves().into()).collect();
    charts.push(shares(&trips).into());
    Ok(Product {
        charts,
        csv: csv(&trips),
        page: Some(page(&trips)),
    })
}

impl Trip {
    fn of(things: &'static str, chart: &'static str, kept: &Kept) -> Result<Self, FindingsError> {
        let mut samples = kept.samples(Sample::of)?;
        samples.sort_by(|a, b| a.bodies.total_cmp(&b.bodies));
        Ok(Self {
            things,
            chart,
            device: kept.common("device")?.to_owned(),
            processor: kept.common("processor")?.to_owned(),
            origin: kept.origin(),
            samples,
        })
    }

    /// ms a frame against the number of bodies.
    fn curves(&self) -> Chart {
        let curve = |name: &str, style, of: fn(&Sample) -> f64| {
            let measured = self.samples.iter().filter(|sample| of(sample).is_finite());
            Series::new(
                name,
                style,
                measured.map(|sample| (sample.bodies, of(sample))),
            )
        };
        let mut series = vec![
            curve("chapter 5, one thread", Style::Printed, |s| s.properties),
            curve("round trip", Style::Corrected, |s| s.round_trip),
            curve("kernels alone, by the GPU's clock", Style::Other(0), |s| {
                s.kernels
            }),
        ];
        series.extend(self.mark(&series));
        Chart {
            name: self.chart,
            title: format!(
                "Flying {}: chapter 5 on the CPU ({}), and a round trip to the GPU ({}) in every frame; {}",
                self.things,
                self.processor,
                self.device,
                Crossover::of(&self.samples).text(),
            ),
            x: Axis::log("bodies"),
            y: Axis::log("time (ms a frame)"),
            series,
        }
    }

    /// An upright line where the two cross, as high as all curves.
    fn mark(&self, curves: &[Series]) -> Option<Series> {
        let Crossover::At(bodies) = Crossover::of(&self.samples) else {
            return None;
        };
        let heights = || {
            curves
                .iter()
                .flat_map(|one| &one.points)
                .map(|point| point.1)
        };
        let ends = [
            heights().fold(f64::MAX, f64::min),
            heights().fold(0.0, f64::max),
        ];
        let name = format!("both alike: about {} bodies", grouped(bodies));
        let points = ends.map(|height| (bodies, height));
        Some(Series::new(&name, Style::Theory, points))
    }

    fn group(&self) -> Group {
        let bar = |sample: &Sample| Bar {
            name: grouped(sample.bodies),
            lengths: sample.shares().map(|share| 100.0 * share).to_vec(),
            spread: None,
            note: format!("{} ms", three_digits(sample.round_trip)),
        };
        Group {
            name: format!("{}, round trips of", self.things),
            bars: self.samples.iter().map(bar).collect(),
        }
    }

    fn table(&self) -> Table {
        let mut table = Table::new(&[
            self.things,
            "chapter 5 (ms)",
            "round trip (ms)",
            "times as fast",
            "upload",
            "compute",
            "download",
            "kernels alone (ms)",
            "GB/s up",
            "GB/s down",
        ]);
        for sample in &self.samples {
            let [up, compute, down] = sample.shares().map(percent);
            // Half of the bytes travel in each direction; 10⁶ bytes a ms are a GB/s.
            let rate = |ms: f64| three_digits(0.5e-6 * sample.bytes * sample.bodies / ms);
            table.push(vec![
                grouped(sample.bodies),
                three_digits(sample.properties),
                three_digits(sample.round_trip),
                three_digits(sample.gain()),
                up,
                compute,
                down,
                three_digits(sample.kernels),
                rate(sample.parts[0]),
                rate(sample.parts[2]),
            ]);
        }
        table
    }
}

/// Where the time of a round trip goes.
fn shares(trips: &[Trip]) -> Bars {
    let mut devices: Vec<&str> = trips.iter().map(|trip| trip.device.as_str()).collect();
    devices.dedup();
    Bars {
        name: "round_trip_shares",
        title: format!(
            "Where a round trip's time goes, on {}",
            devices.join(" and ")
        ),
        label: "share of the three parts, each waited for by itself (%)".to_owned(),
        powers: false,
        parts: PARTS.to_vec(),
        groups: trips.iter().map(Trip::group).collect(),
    }
}

fn csv(trips: &[Trip]) -> String {
    let mut text = "bodies_are,device,processor,bodies,ch05_ms,round_trip_ms,kernels_ms,\
        upload_share,compute_share,download_share,times_as_fast,crossover_bodies\n"
        .to_owned();
    for trip in trips {
        let [device, processor] = [&trip.device, &trip.processor].map(|name| draw::quoted(name));
        let crossover = match Crossover::of(&trip.samples) {
            Crossover::At(bodies) => format!("{bodies:?}"),
            Crossover::Below(_) | Crossover::Beyond(_) => String::new(),
        };
        for s in &trip.samples {
            let [up, compute, down] = s.shares();
            // Writing into a String can't fail.
            let _ = writeln!(
                text,
                "{},{device},{processor},{},{:?},{:?},{:?},{up:?},{compute:?},{down:?},{:?},{crossover}",
                trip.things,
                s.bodies,
                s.properties,
                s.round_trip,
                s.kernels,
                s.gain(),
            );
        }
    }
    text
}

fn page(trips: &[Trip]) -> String {
    let mut text = String::new();
    for trip in trips {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{device}, and one thread of {processor}; {origin}. Medians, ms a frame. The parts are those of \
             frames in which each was waited for. Of flying {things} the round trip is {crossover}.\n\n{table}",
            device = trip.device,
            processor = trip.processor,
            origin = trip.origin,
            things = trip.things,
            crossover = Crossover::of(&trip.samples).text(),
            table = trip.table().markdown(0),
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;

    fn trip(lines: &str) -> Result<Trip, FindingsError> {
        let names = "device,processor,bodies,bytes_a_body,ch05_ms,round_trip_ms,upload_ms,compute_ms,\
                     download_ms,kernels_ms\n";
        let (things, chart, source) = SOURCES[0];
        let kept = source.parse(PathBuf::from(source.file), &(names.to_owned() + lines))?;
        Trip::of(things, chart, &kept)
    }

    #[test]
    fn curves_cross_between_the_samples_where_both_take_as_long() {
        // Twice as long, and half as long: as long half-way, by powers of ten.
        let lines = "\"A, B\",C,100,112,0.1,0.2,1,1,2,NaN\n\"A, B\",C,10000,112,2,1,1,1,2,0.1\n";
        let trip = trip(lines).expect("a table");
        let Crossover::At(bodies) = Crossover::of(&trip.samples) else {
            panic!("they cross: {trip:?}");
        };
        assert!((bodies - 1000.0).abs() < 1e-9);
        let chart = trip.curves();
        assert_eq!(chart.series.len(), 4, "three curves and the mark");
        assert!(chart.title.contains("A, B"), "{}", chart.title);
        assert_eq!(
            chart.series[2].points,
            [(10_000.0, 0.1)],
            "one has no clock"
        );
        assert_eq!(trip.samples[0].shares(), [0.25, 0.25, 0.5]);
    }

    #[test]
    fn curves_that_do_not_cross_have_no_mark() {
        let below = trip("A,C,10,112,2,1,1,1,2,0.1\nA,C,20,112,2,1,1,1,2,0.1\n").expect("a table");
        assert_eq!(Crossover::of(&below.samples), Crossover::Below(10.0));
        let beyond = trip("A,C,10,112,1,2,1,1,2,0.1\nA,C,20,112,1,2,1,1,2,0.1\n").expect("a table");
        assert_eq!(Crossover::of(&beyond.samples), Crossover::Beyond(20.0));
        assert_eq!(beyond.curves().series.len(), 3);
        let alone = trip("A,C,10,112,2,1,1,1,2,0.1\n").expect("a table");
        assert_eq!(alone.curves().series.len(), 3);
    }

    #[test]
    fn two_devices_and_times_of_nothing_are_refused() {
        let two = trip("A,C,10,112,2,1,1,1,2,0.1\nB,C,20,112,2,1,1,1,2,0.1\n");
        assert!(two.is_err_and(|error| error.to_string().contains("another `device`")));
        let none = trip("A,C,10,112,2,0,1,1,2,0.1\n");
        assert!(none.is_err_and(|error| error.to_string().contains("`round_trip_ms`")));
    }

    #[test]
    fn the_tables_in_the_book_can_be_read_and_a_million_bodies_are_worth_the_trip() {
        let mut said = Vec::new();
        let product = product(true, &mut |text| said.push(text.to_owned())).expect("they are kept");
        assert_eq!((product.charts.len(), said.len()), (3, SOURCES.len()));
        for (things, chart, source) in SOURCES {
            let trip =
                Trip::of(things, chart, &source.read().expect("it is kept")).expect("a table");
            let last = trip.samples.last().expect("it has lines");
            assert!(last.bodies == 1e6 && last.gain() > 1.0, "{last:?}");
            let page = product.page.as_deref().unwrap_or_default();
            assert!(
                page.contains(&trip.device) && page.contains(source.file),
                "{page}"
            );
        }
    }
}
