//! Measures the three styles and writes what the book's chapter 1 shows of it:
//! `ch01_*.csv`, the tables `ch01_*.txt` in Markdown, and the chart `ch01_styles.svg`.
//!
//! `cargo run --release -p ch01_hierarchy --no-default-features --example styles_table`;
//! with `-- --quick` up to N = 1,000, printed and not written.

mod chart;
mod measure;
mod skipping;
mod tables;

use std::path::{Path, PathBuf};
use std::{env, fs};

const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let quick = env::args().any(|argument| argument == "--quick");
    let counts = if quick { &COUNTS[..3] } else { &COUNTS[..] };
    let rows: Vec<_> = counts
        .iter()
        .flat_map(|&count| measure::all(count))
        .collect();
    let skipping = skipping::measure(if quick { 1_000 } else { 100_000 });

    let times = tables::times(&rows);
    let costs = tables::costs(&rows);
    let skips = tables::skipping(&skipping);
    println!("{times}\n{costs}\n{skips}");
    if quick {
        return Ok(());
    }
    let charts = charts()?;
    fs::write(charts.join("ch01_styles.csv"), tables::csv(&rows))?;
    fs::write(
        charts.join("ch01_skipping.csv"),
        tables::skipping_csv(&skipping),
    )?;
    fs::write(charts.join("ch01_styles.txt"), times)?;
    fs::write(charts.join("ch01_styles_costs.txt"), costs)?;
    fs::write(charts.join("ch01_skipping.txt"), skips)?;
    chart::draw(&rows, &charts.join("ch01_styles.svg"))?;
    println!("written to {}", charts.display());
    Ok(())
}

/// The book's folder for what commands write.
fn charts() -> std::io::Result<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/charts");
    fs::create_dir_all(&folder)?;
    folder.canonicalize()
}
