//! The measurements as CSV and as the book's tables.

use std::fmt::Write;

use ch01_hierarchy::styles::cost;
use ch01_hierarchy::styles::report::{taken_on, thousands};

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
    text + &format!("\n*{}*\n", taken_on(RUNS))
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
    text + &format!("\n*{}*\n", taken_on(RUNS))
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
