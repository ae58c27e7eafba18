//! The measurements as CSV and as the book's tables.

use std::fmt::Write;

use ch01_hierarchy::styles::cost;

use crate::measure::{Nanoseconds, RUNS, Row};
use crate::skipping;

/// One line a style and N; times in ns an object, bytes an object.
pub fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "style,n,update_ns,update_ns_fastest,update_ns_slowest,gather_ns,gather_ns_fastest,\
         gather_ns_slowest,update_bytes,gather_bytes,files_changed,files_added,\
         places,lines\n",
    );
    for row in rows {
        let cost = cost::of(row.style);
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{},{},{}",
            row.style,
            row.count,
            three(row.update),
            three(row.gather),
            row.bytes.update,
            row.bytes.gather,
            cost.changed,
            cost.added,
            cost.places,
            cost.lines
        );
    }
    text
}

/// Update and gather times with their spread and their ratio to the fastest style.
pub fn times(rows: &[Row]) -> String {
    let mut text = String::from(
        "| N | style | update, ns/object | × fastest | gather, ns/object | × fastest |\n\
         |--:|---|--:|--:|--:|--:|\n",
    );
    for row in rows {
        let peers = || rows.iter().filter(|other| other.count == row.count);
        let update = peers()
            .map(|peer| peer.update.median)
            .fold(f64::MAX, f64::min);
        let gather = peers()
            .map(|peer| peer.gather.median)
            .fold(f64::MAX, f64::min);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {:.2} | {} | {:.2} |",
            thousands(row.count),
            row.style,
            with_spread(row.update),
            row.update.median / update,
            with_spread(row.gather),
            row.gather.median / gather,
        );
    }
    text + &footnote()
}

/// Bytes at the largest N, and the price of a property.
pub fn costs(rows: &[Row]) -> String {
    let mut text = String::from(
        "| style | update, bytes/object | gather, bytes/object | new property: files changed | files added | places | lines |\n\
         |---|--:|--:|--:|--:|--:|--:|\n",
    );
    let largest = rows.last().map_or(0, |row| row.count);
    for row in rows.iter().filter(|row| row.count == largest) {
        let cost = cost::of(row.style);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} |",
            row.style,
            row.bytes.update,
            row.bytes.gather,
            cost.changed,
            cost.added,
            cost.places,
            cost.lines
        );
    }
    text
}

/// Skipping against recomputing.
pub fn skipping(rows: &[skipping::Row]) -> String {
    let count = rows.first().map_or(0, |row| row.count);
    let mut text = format!(
        "| nodes set, of {} | nodes that move | skip the others, ns/node | compute all, ns/node | gain |\n\
         |--:|--:|--:|--:|--:|\n",
        thousands(count)
    );
    for row in rows {
        let _ = writeln!(
            text,
            "| {:.0} % | {:.0} % | {} | {} | × {:.2} |",
            row.set,
            row.moved,
            with_spread(row.skipping),
            with_spread(row.recomputing),
            row.recomputing.median / row.skipping.median,
        );
    }
    text + &footnote()
}

/// The same as CSV.
pub fn skipping_csv(rows: &[skipping::Row]) -> String {
    let mut text = String::from(
        "n,set_percent,moved_percent,skipping_ns,skipping_ns_fastest,skipping_ns_slowest,\
         recomputing_ns,recomputing_ns_fastest,recomputing_ns_slowest\n",
    );
    for row in rows {
        let (skipping, recomputing) = (three(row.skipping), three(row.recomputing));
        let (set, moved) = (row.set, row.moved);
        let _ = writeln!(
            text,
            "{},{set:.1},{moved:.1},{skipping},{recomputing}",
            row.count
        );
    }
    text
}

/// What the times are, and where they were taken.
fn footnote() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let machine = processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    format!("\n*Median (fastest–slowest) of {RUNS} runs, one core of {cores}: {machine}.*\n")
}

/// The processor's name where Linux tells it.
fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

fn three(time: Nanoseconds) -> String {
    format!("{:.2},{:.2},{:.2}", time.median, time.fastest, time.slowest)
}

fn with_spread(time: Nanoseconds) -> String {
    let digits = usize::from(time.slowest < 10.0);
    format!(
        "{:.digits$} ({:.digits$}–{:.digits$})",
        time.median, time.fastest, time.slowest
    )
}

/// 1234567 as 1,234,567.
pub fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
