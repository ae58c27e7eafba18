//! The measurements as CSV and as the book's tables.

use std::fmt::Write;

use ch01_hierarchy::styles::report::{taken_on, thousands};

use crate::ball::balls;
use crate::measure::{self, Nanoseconds, RUNS, Row};
use crate::{DT, Step};

/// The steps without times: the same on every machine with addresses of 64 bits.
pub fn checked(steps: &[&Step], hashes: &[u64]) -> String {
    let mut text = String::from("step         bytes  integrate needs  hash after 10 s\n");
    for (step, hash) in steps.iter().zip(hashes) {
        let bytes = measure::bytes((step.build)(&balls(1, DT)).as_ref(), 1);
        let (number, name, all, needed) = (step.number, step.name, bytes.all, bytes.needed);
        let _ = writeln!(text, "{number} {name:10} {all:5}  {needed:15}  {hash:016x}");
    }
    text
}

/// The steps with their times and hashes.
pub fn timed(rows: &[Row], hashes: &[u64]) -> String {
    let count = thousands(rows.first().map_or(0, |row| row.count));
    let mut text = format!(
        "{count} balls   bytes  integrate needs  fetches   integrate, ns    whole ball, ns   hash after 10 s\n"
    );
    for (row, hash) in rows.iter().zip(hashes) {
        let (integrate, whole) = (with_spread(row.integrate), with_spread(row.whole));
        let (number, name, bytes) = (row.number, row.name, row.bytes);
        let _ = writeln!(
            text,
            "{number} {name:10} {:7}  {:15} {:8.1}  {integrate:16} {whole:16} {hash:016x}",
            bytes.all, bytes.needed, bytes.fetched
        );
    }
    text
}

/// One line a step and N; times in ns a ball, bytes a ball.
pub fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "step,name,n,bytes,needed_bytes,fetched_bytes,integrate_ns,integrate_ns_fastest,\
         integrate_ns_slowest,whole_ns,whole_ns_fastest,whole_ns_slowest\n",
    );
    for row in rows {
        let bytes = row.bytes;
        let _ = writeln!(
            text,
            "{},{},{},{},{},{:.1},{},{}",
            row.number,
            row.name,
            row.count,
            bytes.all,
            bytes.needed,
            bytes.fetched,
            three(row.integrate),
            three(row.whole)
        );
    }
    text
}

/// Bytes and times for one N.
pub fn at(rows: &[Row], count: usize) -> String {
    let mut text = String::from(
        "| step | bytes/ball | integrate needs | integrate fetches | integrate, ns/ball | a whole ball, ns |\n\
         |---|--:|--:|--:|--:|--:|\n",
    );
    for row in rows.iter().filter(|row| row.count == count) {
        let _ = writeln!(
            text,
            "| {} {} | {} | {} | {:.1} | {} | {} |",
            row.number,
            row.name,
            row.bytes.all,
            row.bytes.needed,
            row.bytes.fetched,
            with_spread(row.integrate),
            with_spread(row.whole)
        );
    }
    let note = format!("N = {}. {}", thousands(count), taken_on(RUNS));
    format!("{text}\n*{note}*\n")
}

/// Median times of `integrate`, a row a step and a column an N.
pub fn counts(rows: &[Row]) -> String {
    let Some(first) = rows.first() else {
        return String::new();
    };
    let mut text = String::from("| integrate, ns/ball |");
    let of_first = rows.iter().filter(|row| row.number == first.number);
    for row in of_first.clone() {
        let _ = write!(text, " N = {} |", thousands(row.count));
    }
    let columns = of_first.count();
    let _ = writeln!(text, "\n|---|{}", "--:|".repeat(columns));
    for step in rows.iter().filter(|row| row.count == first.count) {
        let _ = write!(text, "| {} {} |", step.number, step.name);
        for row in rows.iter().filter(|row| row.number == step.number) {
            let _ = write!(text, " {:.2} |", row.integrate.median);
        }
        text.push('\n');
    }
    format!("{text}\n*{}*\n", taken_on(RUNS))
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
