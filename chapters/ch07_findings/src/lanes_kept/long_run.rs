//! A million steps: energy, overlap and memory, from two tables that are kept in the book.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, millimetres, three_digits};

/// The kept tables: what the method is called, its curve, and where the table is.
const SOURCES: [(&str, Style, Source); 2] = [
    (
        "own rows",
        Style::Other(0),
        Source {
            file: "ch06_long_run.csv",
            command: "cargo run --release -p ch06_compute --no-default-features --example long_run -- --csv FILE",
        },
    ),
    (
        "colours",
        Style::Other(1),
        Source {
            file: "ch06_long_run_coloured.csv",
            command: "cargo run --release -p ch06_compute --no-default-features --example long_run -- \
                      --method coloured --csv FILE",
        },
    ),
];

/// The steps that the page tells of.
const TOLD: [f64; 5] = [0.0, 12_500.0, 100_000.0, 500_000.0, 1_000_000.0];

/// The run of a method.
struct Run {
    method: &'static str,
    style: Style,
    samples: Vec<Sample>,
    /// Where it is kept.
    origin: String,
}

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
    let runs = SOURCES.map(|(method, style, source)| Run::of(method, style, &source.read()?));
    let runs = runs.into_iter().collect::<Result<Vec<_>, _>>()?;
    for (_, _, source) in &SOURCES {
        say(&format!("from {}", source.file));
    }
    Ok(Product {
        charts: vec![chart(&runs).into()],
        csv: csv(&runs),
        page: Some(page(&runs)),
    })
}

impl Run {
    fn of(method: &'static str, style: Style, kept: &Kept) -> Result<Self, FindingsError> {
        Ok(Self {
            method,
            style,
            samples: kept.samples(Sample::of)?,
            origin: kept.origin(),
        })
    }
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

fn chart(runs: &[Run]) -> Chart {
    let series = runs.iter().map(|run| {
        let moving = run.samples.iter().filter(|s| s.steps > 0.0);
        Series::new(
            run.method,
            run.style,
            moving.map(|s| (s.steps, s.energy[1])),
        )
    });
    Chart {
        name: "long_run",
        title: "A million steps of sixty balls: what is left of motion".to_owned(),
        x: Axis::log("steps"),
        y: Axis::log("kinetic energy (J)"),
        series: series.collect(),
    }
}

fn csv(runs: &[Run]) -> String {
    let mut text =
        "method,steps,energy (J),kinetic energy (J),deepest (m),gone,memory (KiB)\n".to_owned();
    for run in runs {
        for s in &run.samples {
            let [energy, kinetic] = s.energy;
            let _ = writeln!(
                text,
                "{},{},{energy},{kinetic:e},{},{},{}",
                run.method, s.steps, s.deepest, s.gone, s.memory
            );
        }
    }
    text
}

fn page(runs: &[Run]) -> String {
    let mut table = Table::new(&[
        "method",
        "steps",
        "energy (J)",
        "of it kinetic (J)",
        "deepest (mm)",
        "gone",
        "memory (KiB)",
    ]);
    for run in runs {
        for s in run.samples.iter().filter(|s| TOLD.contains(&s.steps)) {
            table.push(vec![
                run.method.to_owned(),
                draw::grouped(&s.steps.to_string()),
                draw::grouped(&format!("{:.3}", s.energy[0])),
                three_digits(s.energy[1]),
                millimetres(s.deepest),
                s.gone.to_string(),
                draw::grouped(&s.memory.to_string()),
            ]);
        }
    }
    let origins: Vec<_> = runs.iter().map(|run| run.origin.as_str()).collect();
    format!(
        "{}\nSome of their lines; {}.\n",
        table.markdown(1),
        origins.join("; ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept() -> [Run; 2] {
        SOURCES.map(|(method, style, source)| {
            let kept = source.read().expect("it is in the book");
            Run::of(method, style, &kept).expect("it can be read")
        })
    }

    #[test]
    fn in_the_book_a_million_steps_leave_energy_and_memory_where_they_were() {
        for Run {
            method, samples, ..
        } in kept()
        {
            let (settled, last) = (&samples[1], &samples[samples.len() - 1]);
            assert!(last.steps >= 1e6, "{method}: {last:?}");
            // By colours balls creep, and lift others by parts of a millimetre: the page says so.
            let creep = if method == "colours" { 3e-4 } else { 2e-7 };
            let most = settled.energy[0] * (1.0 + creep);
            for s in &samples[1..] {
                assert!(s.energy[0] <= most, "{method}: {s:?}");
                assert!(s.energy[1] <= settled.energy[1], "{method}: {s:?}");
                assert_eq!((s.gone, s.memory), (0, settled.memory), "{method}: {s:?}");
            }
        }
    }
}
