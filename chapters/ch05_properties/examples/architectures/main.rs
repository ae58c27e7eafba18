//! Hierarchy, components, hybrid, properties and an ECS on the same scene: what each operation takes,
//! what each holds in memory, and what a property and a behaviour cost to add. Writes what the book
//! shows of it: `ch05_architectures*` in `book/src/charts`.
//!
//! `cargo run --release -p ch05_properties --no-default-features --example architectures`; with
//! `-- --quick` up to N = 1,000, printed and not written. `-- --only NAME OPERATION N REPEATS` does
//! one thing and prints nothing, for profilers.

mod chart;
mod cost;
mod ecs;
mod measure;
mod memory;
mod moves;
mod operation;
mod people;
mod perf;
mod properties;
mod same;
mod tables;

use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{env, fs};

use operation::Operation;
use tables::{Counted, Counts};

/// A frame, s.
pub const DT: f32 = 1.0 / 60.0;

const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];
/// For which the book has tables.
const FEW: usize = 1_000;
const MANY: usize = 1_000_000;
/// How many objects are compared bit by bit.
const COMPARED: usize = 777;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let Some(("--only", what)) = arguments.split_first().map(|(a, b)| (a.as_str(), b)) {
        return only(what);
    }
    let quick = arguments.iter().any(|argument| argument == "--quick");
    same::check(COMPARED).map_err(|name| format!("{name} computes other bits"))?;
    println!("{COMPARED} objects in 5 architectures, some replaced by others: the same bits.\n");

    let measured = Measured::new(quick);
    let tables = measured.tables();
    for (_, table) in &tables {
        println!("{table}");
    }
    if quick {
        return Ok(());
    }
    let charts = charts()?;
    for (name, table) in &tables {
        fs::write(charts.join(name), table)?;
    }
    measured.draw(&charts)?;
    println!("written to {}", charts.display());
    Ok(())
}

/// All that is measured.
struct Measured {
    /// The counts that have tables.
    tabled: &'static [usize],
    rows: Vec<measure::Row>,
    held: Vec<memory::Held>,
    moves: Vec<moves::Row>,
    counted: Counts,
}

impl Measured {
    fn new(quick: bool) -> Self {
        let shortest = Duration::from_millis(if quick { 1 } else { 10 });
        let counts = if quick { &COUNTS[..3] } else { &COUNTS[..] };
        let tabled: &[usize] = if quick { &[FEW] } else { &[FEW, MANY] };
        let of_counts = |count: &usize| measure::all(*count, shortest);
        Self {
            tabled,
            rows: counts.iter().flat_map(of_counts).collect(),
            held: tabled.iter().flat_map(|&n| memory::all(n)).collect(),
            moves: tabled.iter().flat_map(|&n| moves::all(n)).collect(),
            counted: count_misses(tabled),
        }
    }

    /// The tables, with the names of their files.
    fn tables(&self) -> Vec<(String, String)> {
        let named = |name: &str, table| (format!("ch05_architectures_{name}.txt"), table);
        let times = |&count: &usize| named(&count.to_string(), tables::times(&self.rows, count));
        let mut all: Vec<_> = self.tabled.iter().map(times).collect();
        all.extend([
            named("memory", tables::memory(&self.held)),
            named("costs", tables::costs(&cost::all())),
            named("marks", tables::marks(&self.moves)),
            named("misses", tables::misses(&self.counted)),
        ]);
        all
    }

    /// Writes the numbers and the charts into a folder.
    fn draw(&self, charts: &Path) -> Result<(), Box<dyn std::error::Error>> {
        fs::write(
            charts.join("ch05_architectures.csv"),
            tables::csv(&self.rows, &self.held, &self.moves, &self.counted),
        )?;
        let panels = [
            ("ch05_architectures_all.svg", &Operation::OVER_ALL[..]),
            ("ch05_architectures_one.svg", &Operation::OF_ONE[..]),
            ("ch05_architectures_changes.svg", &Operation::OF_CHANGE[..]),
        ];
        for (name, operations) in panels {
            chart::draw(&self.rows, operations, &charts.join(name))?;
        }
        Ok(())
    }
}

/// Cache misses of what lasts, where they can be counted.
fn count_misses(counts: &[usize]) -> Counts {
    perf::available()?;
    let mut all = Vec::new();
    for &count in counts {
        for operation in Operation::LASTING {
            for architecture in operation::NAMES {
                all.push(Counted {
                    architecture,
                    operation,
                    count,
                    misses: perf::misses(architecture, operation.name(), count)?,
                });
            }
        }
    }
    Ok(all)
}

/// `NAME OPERATION N REPEATS`: one architecture, one operation, again and again.
fn only(what: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let [name, operation, count, repeats] = what else {
        return Err("--only wants NAME OPERATION N REPEATS".into());
    };
    let operation = Operation::LASTING
        .into_iter()
        .find(|known| known.name() == operation)
        .ok_or_else(|| format!("no operation `{operation}`"))?;
    let count: usize = count.parse()?;
    let mut subject = operation::subject_named(name, count.max(2))
        .ok_or_else(|| format!("no architecture `{name}`"))?;
    for _ in 0..repeats.parse()? {
        subject.carry_out(operation);
    }
    Ok(())
}

/// The book's folder for what commands write.
fn charts() -> std::io::Result<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/charts");
    fs::create_dir_all(&folder)?;
    folder.canonicalize()
}
