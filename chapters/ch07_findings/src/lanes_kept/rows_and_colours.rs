//! Own rows beside colours: the error of settled heaps against work, in visits: a pair that is solved once.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_rows_and_colours.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example rows_and_colours",
};
/// So many times a depth counts as alike.
const NEARLY: f64 = 1.25;
/// The scenes that are drawn: crowds.
const DRAWN: [&str; 4] = ["balls", "pile", "mixed", "ragdolls"];
const METHODS: [(&str, &str); 2] = [("own-row", "own rows"), ("coloured", "colours")];

/// How their curves look: a colour a scene.
const STYLES: [fn(usize) -> Style; 2] = [Style::Other, Style::Dashed];

/// A run of a settled heap.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    scene: String,
    count: u32,
    /// Place in [`METHODS`].
    method: usize,
    substeps: u32,
    /// Pairs that are solved in a step, each as often as it is.
    visits: f64,
    /// Depth that 99 of 100 contacts don't exceed, radii.
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
        line.one_of("method", &METHODS.map(|method| method.0))?;
        let method = line.text("method")?;
        let place = METHODS.iter().position(|known| known.0 == method);
        Ok(Self {
            scene: line.text("scene")?.to_owned(),
            count: line.number("count")?,
            method: place.unwrap_or(0),
            substeps: line.number("substeps")?,
            visits: line.positive("visits_a_step")?,
            p99: line.positive("p99_of_r")?,
        })
    }

    fn name(&self) -> String {
        format!("{} {}", self.scene, draw::grouped(&self.count.to_string()))
    }
}

/// The scenes of the table, in its order.
fn scenes(samples: &[Sample]) -> Vec<String> {
    let mut scenes: Vec<_> = samples.iter().map(Sample::name).collect();
    scenes.dedup();
    scenes
}

fn chart(samples: &[Sample]) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    for sample in samples.iter().filter(|s| DRAWN.contains(&s.scene.as_str())) {
        let name = format!("{}, {}", sample.name(), METHODS[sample.method].1);
        let point = (sample.visits, sample.p99);
        if let Some(known) = series.iter_mut().find(|known| known.name == name) {
            known.points.push(point);
            continue;
        }
        let scene = DRAWN.iter().position(|scene| *scene == sample.scene);
        let style = STYLES[sample.method](scene.unwrap_or(0));
        series.push(Series::new(&name, style, [point]));
    }
    Chart {
        name: "rows_and_colours",
        title: "Depth of contacts of settled heaps, 99th percentile, against work: own rows and, in dashes, colours".to_owned(),
        x: Axis::log("visits of pairs in a step"),
        y: Axis::log("depth, 99th percentile (radii)"),
        series,
    }
}

/// The fewest visits of either method that nearly reach the least depth that both reach. Both stop at the slop,
/// within which nothing is pushed apart, and about there a depth is a matter of chance.
fn alike<'s>(samples: &'s [Sample], scene: &str) -> Option<[&'s Sample; 2]> {
    let of = |method: usize| {
        samples
            .iter()
            .filter(move |s| s.name() == scene && s.method == method)
    };
    let least = |method: usize| of(method).map(|s| s.p99).reduce(f64::min);
    let bound = NEARLY * least(0)?.max(least(1)?);
    let cheapest = |method: usize| {
        of(method)
            .filter(|s| s.p99 <= bound)
            .min_by(|a, b| a.visits.total_cmp(&b.visits))
    };
    Some([cheapest(0)?, cheapest(1)?])
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "scene,count,method,substeps,visits a step,p99 (radii)\n".to_owned();
    for s in samples {
        let _ = writeln!(
            text,
            "{},{},{},{},{},{}",
            s.scene, s.count, METHODS[s.method].0, s.substeps, s.visits, s.p99
        );
    }
    text
}

fn page(samples: &[Sample], origin: &str) -> String {
    let mut table = Table::new(&[
        "scene",
        "own rows: substeps",
        "visits",
        "depth (radii)",
        "colours: substeps",
        "visits",
        "depth (radii)",
        "share of visits",
    ]);
    for scene in scenes(samples) {
        let Some(both) = alike(samples, &scene) else {
            continue;
        };
        let told = |s: &Sample| {
            [
                s.substeps.to_string(),
                draw::grouped(&s.visits.to_string()),
                three_digits(s.p99),
            ]
        };
        let mut row = vec![scene];
        row.extend(both.into_iter().flat_map(told));
        row.push(format!("{:.2}", both[1].visits / both[0].visits));
        table.push(row);
    }
    format!(
        "{}\nThe fewest visits by which either method comes within a quarter of the least depth that both reach; {origin}.\n",
        table.markdown(1)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_every_heap_of_the_book_colours_need_less_than_half_of_the_visits_and_for_ragdolls_nothing_is_gained()
     {
        let kept = SOURCE.read().expect("it is in the book");
        let samples = kept.samples(Sample::of);
        let samples = samples.expect("it can be read");
        let crowds = samples.iter().filter(|s| DRAWN.contains(&s.scene.as_str()));
        let crowds = scenes(&crowds.cloned().collect::<Vec<_>>());
        assert_eq!(crowds.len(), DRAWN.len(), "{crowds:?}");
        for scene in crowds {
            let [rows, colours] = alike(&samples, &scene).expect("both have runs");
            assert_eq!([rows.method, colours.method], [0, 1]);
            let share = colours.visits / rows.visits;
            // Joints and limits are solved once a substep by either method: the page says so.
            let is_as_told = if rows.scene == "ragdolls" {
                share > 0.9
            } else {
                share < 0.5
            };
            assert!(is_as_told, "{rows:?} {colours:?}");
        }
    }
}
