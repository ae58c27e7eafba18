//! How long a step of a settled heap takes, and how good the heap is: a line of CSV for each size.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example pile -- [--engine NAME]
//! [--method NAME] [--scene NAME] [--counts N,N,…] [--settle STEPS] [--steps STEPS] [--substeps N]
//! [--threads N,N,…] [--turns N] [--csv FILE] [--sleeping]`
//!
//! A scene is loaded, makes its settling steps, and then the timed ones in five batches, of which the
//! median, the fastest and the slowest are told, ms a step. Nothing is read back before a batch is done.
//! What is left lying is measured from scene and state alone. Lines go to the standard output and, with
//! `--csv`, into a file. With `--sleeping` a second heap of each size may sleep; it has a second line.
//!
//! With `--turns` all heaps settle first, and then take turns, a batch of the timed steps each and so many times: what
//! else the machine does in the meantime is shared among them.
mod heap;
mod line;
mod options;
#[path = "../shared/table.rs"]
mod table;

use std::process::ExitCode;

use heap::Settled;
use line::{COLUMNS, Line};
use options::{Heap, Options};
use table::{Problem, Table};

/// Of the timed steps, where heaps take no turns.
const BATCHES: u32 = 5;

fn main() -> ExitCode {
    table::ended(run())
}

fn run() -> Result<(), Problem> {
    let options = Options::of(std::env::args().skip(1))?;
    let mut table = Table::begin(COLUMNS, options.csv.as_ref())?;
    let heaps = options.heaps();
    let together = if options.turns.is_some() {
        heaps.len()
    } else {
        1
    };
    for heaps in heaps.chunks(together) {
        for line in measured(&options, heaps)? {
            table.add(&line)?;
        }
    }
    Ok(())
}

/// Lets heaps settle, times them in turns, and judges what is left lying.
fn measured(options: &Options, heaps: &[Heap]) -> Result<Vec<Line>, Problem> {
    let settled = heaps.iter().map(|heap| Settled::of(options, *heap));
    let mut settled = settled.collect::<Result<Vec<_>, _>>()?;
    let turns = options.turns.unwrap_or(BATCHES);
    let each = (options.steps / turns).max(1);
    for _ in 0..turns {
        for heap in &mut settled {
            if heaps.len() > 1 {
                // The caches still hold the tables of the heap before.
                heap.steps(1);
            }
            heap.time(each);
        }
    }
    let lines = settled.into_iter();
    Ok(lines.map(|heap| heap.judged(options, each)).collect())
}
