//! The measurements as CSV and as the book's tables.

use std::fmt::Write;

use ch01_hierarchy::styles::report::{taken_on, thousands};

use crate::cost::Prices;
use crate::measure::{Nanoseconds, RUNS, Row};
use crate::memory::Held;
use crate::moves;
use crate::operation::{Operation, Visited};
use crate::perf::{EVENTS, Misses};

/// Bytes of a position, which is what gathering delivers for each object.
const POSITION: f64 = 12.0;

/// What was counted of an architecture's operation, an object or a read.
pub struct Counted {
    pub architecture: &'static str,
    pub operation: Operation,
    pub count: usize,
    pub misses: Misses,
}

/// Cache misses, or why there are none.
pub type Counts = Result<Vec<Counted>, String>;

/// One line an architecture, operation and N: ns and bytes an object or a read.
pub fn csv(rows: &[Row], held: &[Held], moves: &[moves::Row], counts: &Counts) -> String {
    let mut text = String::from("architecture,operation,n,ns,ns_fastest,ns_slowest,bytes,pieces");
    for event in EVENTS {
        let _ = write!(text, ",{event}");
    }
    text.push_str(",counters\n");
    let said = counts.as_ref().map_or_else(String::as_str, |_| "counted");
    for row in rows {
        let bytes = visited(row.visited, row.operation).map_or(String::new(), |b| b.to_string());
        let events = events(row, counts);
        let (name, operation) = (row.architecture, row.operation.name());
        let (count, time) = (row.count, three(row.time));
        let _ = writeln!(
            text,
            "{name},{operation},{count},{time},{bytes},,{events},{said}"
        );
    }
    for held in held {
        let (name, count) = (held.architecture, held.count);
        let (fresh, pieces, aged) = (held.fresh, held.pieces, held.aged);
        let _ = writeln!(text, "{name},held,{count},,,,{fresh:.1},{pieces:.3},,,,,");
        let _ = writeln!(text, "{name},held_aged,{count},,,,{aged:.1},,,,,,");
    }
    for row in moves {
        let (way, count) = (row.way.replace(", ", ": "), row.count);
        let _ = writeln!(text, "{way},mark,{count},{},,,,,,,", three(row.mark));
        let _ = writeln!(text, "{way},unmark,{count},{},,,,,,,", three(row.unmark));
    }
    text
}

/// The four numbers of a row, or nothing between the commas.
fn events(row: &Row, counts: &Counts) -> String {
    let of_row = |counted: &&Counted| {
        (counted.architecture, counted.operation, counted.count)
            == (row.architecture, row.operation, row.count)
    };
    match counts.iter().flatten().find(of_row) {
        None => ",".repeat(EVENTS.len() - 1),
        Some(counted) => counted.misses.map(|miss| format!("{miss:.4}")).join(","),
    }
}

/// All operations for one N, an architecture a column.
pub fn times(rows: &[Row], count: usize) -> String {
    let names = architectures(rows);
    let mut text = format!(
        "| N = {}, ns | {} |\n|---|",
        thousands(count),
        names.join(" | ")
    );
    text += &"--:|".repeat(names.len());
    text.push('\n');
    for operation in Operation::ALL {
        line(
            &mut text,
            operation.label(),
            rows,
            count,
            operation,
            |row| with_spread(row.time),
        );
        if operation == Operation::Gather {
            line(&mut text, "the same, GB/s", rows, count, operation, |row| {
                format!("{:.1}", POSITION / row.time.median)
            });
        }
    }
    for operation in [Operation::Update, Operation::Gather, Operation::Count] {
        let label = format!("{}: bytes visited", operation.name());
        line(&mut text, &label, rows, count, operation, |row| {
            visited(row.visited, operation).map_or(String::new(), |bytes| bytes.to_string())
        });
    }
    text + &format!("\n*{}*\n", taken_on(RUNS))
}

fn line(
    text: &mut String,
    label: &str,
    rows: &[Row],
    count: usize,
    operation: Operation,
    cell: impl Fn(&Row) -> String,
) {
    let rows = rows.iter();
    let rows = rows.filter(|row| row.count == count && row.operation == operation);
    let cells: Vec<String> = rows.map(cell).collect();
    let _ = writeln!(text, "| {label} | {} |", cells.join(" | "));
}

/// Names in the order of their first rows.
pub fn architectures(rows: &[Row]) -> Vec<&'static str> {
    rows.iter().take(5).map(|row| row.architecture).collect()
}

fn visited(visited: Visited, operation: Operation) -> Option<usize> {
    match operation {
        Operation::Update => Some(visited.update),
        Operation::Gather => Some(visited.gather),
        Operation::Count => Some(visited.count),
        _ => None,
    }
}

/// Bytes that a world holds, an object.
pub fn memory(held: &[Held]) -> String {
    let mut text = String::from(
        "| N | architecture | bytes/object | pieces/object | bytes/object, a quarter replaced |\n\
         |--:|---|--:|--:|--:|\n",
    );
    for held in held {
        let _ = writeln!(
            text,
            "| {} | {} | {:.0} | {:.2} | {:.0} |",
            thousands(held.count),
            held.architecture,
            held.fresh,
            held.pieces,
            held.aged
        );
    }
    text
}

/// Files and lines for a property and for a behaviour.
pub fn costs(prices: &[Prices]) -> String {
    let mut text = String::from(
        "| architecture | `glow`: files changed | files added | places | lines \
         | spinning: files changed | files added | places | lines |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for prices in prices {
        let cells = [prices.property, prices.behaviour].map(|cost| {
            let (changed, added) = (cost.changed, cost.added);
            format!("{changed} | {added} | {} | {}", cost.places, cost.lines)
        });
        let _ = writeln!(text, "| {} | {} |", prices.architecture, cells.join(" | "));
    }
    text
}

/// Marking and unmarking.
pub fn marks(rows: &[moves::Row]) -> String {
    let mut text = String::from(
        "| N | a property for a while | give, ns | take away, ns |\n|--:|---|--:|--:|\n",
    );
    for row in rows {
        let (mark, unmark) = (with_spread(row.mark), with_spread(row.unmark));
        let _ = writeln!(
            text,
            "| {} | {} | {mark} | {unmark} |",
            thousands(row.count),
            row.way
        );
    }
    text + &format!("\n*{}*\n", taken_on(RUNS))
}

/// Cache misses, or why there are none.
pub fn misses(counts: &Counts) -> String {
    let counts = match counts {
        Err(why) => return format!("*Cache misses: {why}.*\n"),
        Ok(counts) => counts,
    };
    let mut text = format!(
        "| N | operation | architecture | {} |\n|--:|---|---|{}\n",
        EVENTS.join(" | "),
        "--:|".repeat(EVENTS.len())
    );
    for counted in counts {
        let cells = counted.misses.map(|miss| format!("{miss:.2}")).join(" | ");
        let (count, operation) = (thousands(counted.count), counted.operation.label());
        let _ = writeln!(
            text,
            "| {count} | {operation} | {} | {cells} |",
            counted.architecture
        );
    }
    text
}

fn three(time: Nanoseconds) -> String {
    format!("{:.3},{:.3},{:.3}", time.median, time.fastest, time.slowest)
}

/// In ns, as all tables; from 10 µs on in a unit that it names.
fn with_spread(time: Nanoseconds) -> String {
    let (size, unit) = match time.median {
        ..1e4 => (1.0, ""),
        ..1e7 => (1e3, " µs"),
        _ => (1e6, " ms"),
    };
    let shown = |nanoseconds: f64| match nanoseconds / size {
        time @ ..1.0 => format!("{time:.2}"),
        time @ ..10.0 => format!("{time:.1}"),
        time => thousands(time.round() as usize),
    };
    let (fastest, slowest) = (shown(time.fastest), shown(time.slowest));
    format!("{}{unit} ({fastest}–{slowest})", shown(time.median))
}
