//! What a substep costs on the GPU and what it buys: time of a step against the deepest overlap that heaps of
//! balls and fields of ragdolls are left with, drawn from a table that is kept in the book.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, millimetres, percent, three_digits};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_substeps_nvidia_h200.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example pile -- \
              --engine compute --scene NAME --counts N,N,… --substeps N --csv FILE",
};
/// What its scenes are made of.
const SCENES: [(&str, &str); 2] = [("pile", "balls"), ("ragdoll_field", "ragdolls")];
/// So deep an overlap is allowed to balls at most, in radii.
const BUDGET: f64 = 0.05;
/// And 99 of 100.
const BUDGET_P99: f64 = 0.01;
/// The budget: the scene, how many, in so many ms.
const BUDGET_TIMES: [(&str, f64, f64); 5] = [
    ("pile", 1e4, 0.20),
    ("pile", 1e5, 0.35),
    ("pile", 4e5, 1.0),
    ("pile", 1e6, 2.5),
    ("ragdoll_field", 1e4, 1.5),
];

/// A run's time and errors.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    scene: String,
    things: &'static str,
    count: f64,
    device: String,
    substeps: u32,
    /// A step, ms.
    ms: f64,
    /// Overlap in radii: 99 of 100 are no deeper.
    p99: f64,
    /// The deepest.
    deepest: f64,
    /// The widest joint, m.
    separation: Option<f64>,
    /// Bodies outside, and of numbers that are not finite.
    gone: u64,
}

/// Lays out picture, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where the table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    SOURCE.drawn(say, drawn)
}

fn drawn(kept: &Kept) -> Result<Product, FindingsError> {
    let mut samples = kept.samples(Sample::of)?;
    samples.sort_by(|a, b| {
        a.place()
            .partial_cmp(&b.place())
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    Ok(Product {
        charts: vec![chart(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples, &kept.origin())),
    })
}

impl Sample {
    fn of(line: Line) -> Result<Self, FindingsError> {
        line.one_of("scene", &SCENES.map(|(scene, _)| scene))?;
        line.one_of("engine", &["compute"])?;
        let scene = line.text("scene")?;
        let things = SCENES.iter().find(|known| known.0 == scene);
        let separation = match line.text("separation_m")? {
            "" => None,
            _ => Some(line.number("separation_m")?),
        };
        Ok(Self {
            scene: scene.to_owned(),
            things: things.map_or("", |known| known.1),
            count: line.positive("count")?,
            device: line.text("device")?.to_owned(),
            substeps: line.number("substeps")?,
            ms: line.positive("ms_median")?,
            p99: line.number("p99_of_r")?,
            deepest: line.number("max_of_r")?,
            separation,
            gone: line.number::<u64>("escaped")? + line.number::<u64>("not_finite")?,
        })
    }

    fn place(&self) -> (&str, f64, u32) {
        (&self.scene, self.count, self.substeps)
    }

    fn name(&self) -> String {
        format!("{} {}", draw::grouped(&self.count.to_string()), self.things)
    }

    /// The budget, ms.
    fn budget(&self) -> Option<f64> {
        let same = |known: &&(&str, f64, f64)| known.0 == self.scene && known.1 == self.count;
        BUDGET_TIMES.iter().find(same).map(|known| known.2)
    }

    /// Whether time and overlaps are within the budget; overlaps of balls only.
    fn keeps_all(&self) -> bool {
        let good = self.scene != "pile" || (self.p99 <= BUDGET_P99 && self.deepest <= BUDGET);
        let open = self.separation.is_some_and(|separation| separation > 1e-3);
        good && !open && self.gone == 0 && self.budget().is_some_and(|budget| self.ms <= budget)
    }
}

fn chart(samples: &[Sample]) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    for sample in samples {
        let (name, point) = (sample.name(), (sample.ms, sample.deepest));
        let note = sample.substeps.to_string();
        if let Some(last) = series.last_mut().filter(|last| last.name == name) {
            last.points.push(point);
            last.notes.push(note);
            continue;
        }
        let one = Series::new(&name, Style::Other(series.len()), [point]);
        series.push(one.with_notes(vec![note]));
    }
    let ends = [1e-1, 3.0];
    series.push(Series::of(
        "0.05 radii, allowed to balls",
        Style::Theory,
        &ends,
        |_| BUDGET,
    ));
    Chart {
        name: "substeps_on_the_gpu",
        title: "Deepest overlap against time; beside each mark its number of substeps".to_owned(),
        x: Axis::log("time of a step (ms)"),
        y: Axis::log("deepest overlap (radii)"),
        series,
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text =
        "scene,count,device,substeps,step (ms),p99 (radii),deepest (radii),joints (m),gone\n"
            .to_owned();
    for s in samples {
        let joints = s
            .separation
            .map(|open| open.to_string())
            .unwrap_or_default();
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{joints},{}",
            s.scene, s.count, s.device, s.substeps, s.ms, s.p99, s.deepest, s.gone
        );
    }
    text
}

fn page(samples: &[Sample], origin: &str) -> String {
    let mut table = Table::new(&[
        "scene",
        "substeps",
        "ms/step",
        "budget",
        "p99 (radii)",
        "deepest (radii)",
        "joints (mm)",
        "gone",
        "",
    ]);
    for s in samples {
        table.push(vec![
            s.name(),
            s.substeps.to_string(),
            three_digits(s.ms),
            s.budget().map(three_digits).unwrap_or_default(),
            percent(s.p99),
            percent(s.deepest),
            s.separation.map(millimetres).unwrap_or_default(),
            s.gone.to_string(),
            if s.keeps_all() { "kept" } else { "" }.to_owned(),
        ]);
    }
    let device = samples.first().map_or("", |sample| sample.device.as_str());
    format!("{}\n{device}; {origin}.\n", table.markdown(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "scene,count,engine,device,substeps,ms_median,escaped,not_finite,p99_of_r,max_of_r,separation_m\n\
        pile,400000,compute,card,6,0.9,0,0,0.005,0.03,\n\
        pile,400000,compute,card,4,0.7,0,0,0.011,0.11,\n\
        ragdoll_field,10000,compute,card,7,1.4,0,0,0.02,0.2,1e-5\n";

    fn samples(text: &str) -> Result<Vec<Sample>, FindingsError> {
        SOURCE
            .parse("here.csv".into(), text)?
            .lines()
            .map(Sample::of)
            .collect()
    }

    #[test]
    fn what_is_fast_but_deep_is_not_kept() {
        let samples = samples(TABLE).expect("it is a table");
        let kept: Vec<_> = samples.iter().map(Sample::keeps_all).collect();
        assert_eq!(kept, [true, false, true]);
    }

    #[test]
    fn another_engine_is_refused_by_line() {
        let error = samples(&TABLE.replace("compute,card,6", "lanes,card,6")).expect_err("lanes");
        let message = error.to_string();
        assert!(
            message.contains("here.csv") && message.contains("lanes"),
            "{message}"
        );
    }

    #[test]
    fn the_table_of_the_book_keeps_the_budget() {
        let kept = SOURCE.read().expect("it is in the book");
        let samples = kept.samples(Sample::of);
        let samples = samples.expect("it can be read");
        for (scene, count, _) in BUDGET_TIMES {
            let same = |s: &&Sample| s.scene == scene && s.count == count;
            assert!(
                samples.iter().filter(same).any(Sample::keeps_all),
                "{scene} {count}"
            );
        }
    }
}
