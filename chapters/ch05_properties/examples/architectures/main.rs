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

    let shortest = Duration::from_millis(if quick { 1 } else { 10 });
    let counts = if quick { &COUNTS[..3] } else { &COUNTS[..] };
    let rows: Vec<_> = counts
        .iter()
        .flat_map(|&count| measure::all(count, shortest))
        .collect();
    let tabled: &[usize] = if quick { &[FEW] } else { &[FEW, MANY] };
    let held: Vec<_> = tabled
        .iter()
        .flat_map(|&count| memory::all(count))
        .collect();
    let moves: Vec<_> = tabled.iter().flat_map(|&count| moves::all(count)).collect();
    let counted = count_misses(tabled);

    let times: Vec<_> = tabled
        .iter()
        .map(|&count| (count, tables::times(&rows, count)))
        .collect();
    let memory = tables::memory(&held);
    let costs = tables::costs(&cost::all());
    let marks = tables::marks(&moves);
    let misses = tables::misses(&counted);
    for (_, table) in &times {
        println!("{table}");
    }
    println!("{memory}\n{costs}\n{marks}\n{misses}");
    if quick {
        return Ok(());
    }

    let charts = charts()?;
    let write = |name: &str, text: &str| fs::write(charts.join(name), text);
    write(
        "ch05_architectures.csv",
        &tables::csv(&rows, &held, &moves, &counted),
    )?;
    for (count, table) in &times {
        write(&format!("ch05_architectures_{count}.txt"), table)?;
    }
    write("ch05_architectures_memory.txt", &memory)?;
    write("ch05_architectures_costs.txt", &costs)?;
    write("ch05_architectures_marks.txt", &marks)?;
    write("ch05_architectures_misses.txt", &misses)?;
    let panels = [
        ("ch05_architectures_all.svg", &Operation::OVER_ALL[..]),
        ("ch05_architectures_one.svg", &Operation::OF_ONE[..]),
        ("ch05_architectures_changes.svg", &Operation::OF_CHANGE[..]),
    ];
    for (name, operations) in panels {
        chart::draw(&rows, operations, &charts.join(name))?;
    }
    println!("written to {}", charts.display());
    Ok(())
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
