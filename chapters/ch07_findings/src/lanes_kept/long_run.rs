//! A million steps: energy, overlap and memory, from a table that is kept in the book.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, millimetres, three_digits};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_long_run.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example long_run -- --csv FILE",
};
/// The steps that the page tells of.
const TOLD: [f64; 5] = [0.0, 12_500.0, 100_000.0, 500_000.0, 1_000_000.0];

/// What there was after so many steps.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    steps: f64,
    /// All energy, and what of it is kinetic, J.
    energy: [f64; 2],
    /// The deepest overlap, m.
    deepest: f64,
    /// Bodies outside, and of numbers that are not finite.
    gone: u64,
    /// Memory that the program has, KiB.
    memory: f64,
}

/// Lays out picture, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where the table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    let made = drawn(&SOURCE.read()?)?;
    say(&format!("from {}", SOURCE.file));
    Ok(made)
}

fn drawn(kept: &Kept) -> Result<Product, FindingsError> {
    let samples = kept
        .lines()
        .map(Sample::of)
        .collect::<Result<Vec<_>, _>>()?;
    Ok(Product {
        charts: vec![chart(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples, &kept.origin())),
    })
}

impl Sample {
    fn of(line: Line) -> Result<Self, FindingsError> {
        Ok(Self {
            steps: line.number("step")?,
            energy: [line.number("energy_j")?, line.number("kinetic_energy_j")?],
            deepest: line.number("deepest_m")?,
            gone: line.number::<u64>("escaped")? + line.number::<u64>("not_finite")?,
            memory: line.positive("resident_kib")?,
        })
    }
}

fn chart(samples: &[Sample]) -> Chart {
    let points = samples
        .iter()
        .filter(|s| s.steps > 0.0)
        .map(|s| (s.steps, s.energy[1]))
        .collect();
    Chart {
        name: "long_run",
        title: "A million steps of sixty balls: what is left of motion".to_owned(),
        x: Axis::log("steps"),
        y: Axis::log("kinetic energy (J)"),
        series: vec![Series {
            name: "own rows".to_owned(),
            style: Style::Other(0),
            points,
            bars: Vec::new(),
        }],
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "steps,energy (J),kinetic energy (J),deepest (m),gone,memory (KiB)\n".to_owned();
    for s in samples {
        let [energy, kinetic] = s.energy;
        let _ = writeln!(
            text,
            "{},{energy},{kinetic:e},{},{},{}",
            s.steps, s.deepest, s.gone, s.memory
        );
    }
    text
}

fn page(samples: &[Sample], origin: &str) -> String {
    let mut table = Table::new(&[
        "steps",
        "energy (J)",
        "of it kinetic (J)",
        "deepest (mm)",
        "gone",
        "memory (KiB)",
    ]);
    for s in samples.iter().filter(|s| TOLD.contains(&s.steps)) {
        table.push(vec![
            draw::grouped(&s.steps.to_string()),
            draw::grouped(&format!("{:.3}", s.energy[0])),
            three_digits(s.energy[1]),
            millimetres(s.deepest),
            s.gone.to_string(),
            draw::grouped(&s.memory.to_string()),
        ]);
    }
    format!("{}\nSome of its lines; {origin}.\n", table.markdown(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_the_book_a_million_steps_leave_energy_and_memory_where_they_were() {
        let kept = SOURCE.read().expect("it is in the book");
        let samples: Result<Vec<_>, _> = kept.lines().map(Sample::of).collect();
        let samples = samples.expect("it can be read");
        let (settled, last) = (&samples[1], &samples[samples.len() - 1]);
        assert!(last.steps >= 1e6, "{last:?}");
        for s in &samples[1..] {
            assert!(s.energy[0] <= settled.energy[0] + 1e-3, "{s:?}");
            assert!(s.energy[1] <= settled.energy[1], "{s:?}");
            assert_eq!((s.gone, s.memory), (0, settled.memory), "{s:?}");
        }
    }
}
