//! Cache misses, counted by the processor and read by Linux's `perf`, where both are willing.
//!
//! A run counts everything, the building of the world too. So each operation is run twice, with few
//! and with many repeats, and the difference is counted.

use std::process::Command;

/// What is counted.
pub const EVENTS: [&str; 4] = [
    "cache-references",
    "cache-misses",
    "L1-dcache-load-misses",
    "LLC-load-misses",
];

/// An operation's events, an object or a read, in the order of [`EVENTS`].
pub type Misses = [f64; EVENTS.len()];

/// Whether the events can be counted here; if not, why.
pub fn available() -> Result<(), String> {
    stat(&["--only", "properties", "count", "10", "1"]).map(drop)
}

/// Events of an operation of an architecture, an object or a read.
pub fn misses(architecture: &str, operation: &str, count: usize) -> Result<Misses, String> {
    let many = (2_000_000 / count).clamp(4, 20_000);
    let run = |repeats: usize| {
        let (count, repeats) = (count.to_string(), repeats.to_string());
        stat(&["--only", architecture, operation, &count, &repeats])
    };
    let (few, many_times) = (run(1)?, run(1 + many)?);
    let times = (many * count.max(1)) as f64;
    let mut misses = Misses::default();
    for (place, miss) in misses.iter_mut().enumerate() {
        *miss = (many_times[place] - few[place]).max(0.0) / times;
    }
    Ok(misses)
}

/// Runs this program under `perf stat`.
fn stat(arguments: &[&str]) -> Result<[f64; EVENTS.len()], String> {
    let program = std::env::current_exe().map_err(|why| why.to_string())?;
    let run = Command::new("perf")
        .env("LC_ALL", "C")
        .args(["stat", "-x", ",", "-e", &EVENTS.join(","), "--"])
        .arg(program)
        .args(arguments)
        .output()
        .map_err(|_| "not counted: there is no `perf` here".to_owned())?;
    let text = String::from_utf8_lossy(&run.stderr);
    if !run.status.success() {
        let line = text.lines().find(|line| !line.trim().is_empty());
        return Err(format!(
            "not counted: perf: {}",
            line.unwrap_or("it failed")
        ));
    }
    parse(&text)
}

/// Reads what `perf stat -x ,` prints: a line an event, its value first, its name third.
fn parse(text: &str) -> Result<[f64; EVENTS.len()], String> {
    let mut values = [None; EVENTS.len()];
    for line in text.lines() {
        let fields: Vec<&str> = line.split(',').collect();
        let (Some(value), Some(event)) = (fields.first(), fields.get(2)) else {
            continue;
        };
        // A name may come back with what was counted: `cache-misses:u` is user space only.
        let event = event.split(':').next().unwrap_or(event);
        let Some(place) = EVENTS.iter().position(|name| *name == event) else {
            continue;
        };
        match *value {
            "<not supported>" => {
                return Err(
                    "not counted: this machine's kernel offers no hardware counters".to_owned(),
                );
            }
            "<not counted>" => {
                return Err(format!("not counted: perf had no counter free for {event}"));
            }
            value => values[place] = value.parse().ok(),
        }
    }
    let mut found = [0.0; EVENTS.len()];
    for (place, value) in values.into_iter().enumerate() {
        let event = EVENTS[place];
        found[place] = value.ok_or(format!("not counted: perf said nothing of {event}"))?;
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_machine_without_counters_is_told_from_one_without_misses() {
        // perf 6.1 in a virtual machine.
        let text = "<not supported>,,cache-references,0,100.00,,\n\
                    <not supported>,,cache-misses,0,100.00,,\n\
                    <not supported>,,L1-dcache-load-misses,0,100.00,,\n\
                    <not supported>,,LLC-load-misses,0,100.00,,\n";
        let why = parse(text).expect_err("nothing was counted");
        assert_eq!(
            why,
            "not counted: this machine's kernel offers no hardware counters"
        );
    }

    #[test]
    fn values_are_read_by_the_names_of_their_events() {
        // The format of perf 6.1, which printed `100,,page-faults,1357089,100.00,73.687,K/sec` for
        // an event that this machine does count. The third field names the event, whatever is before.
        let text = "# started on Thu May  1 12:00:00 2025\n\n\
                    4208341,,LLC-load-misses:u,812345678,50.01,,\n\
                    91234567,,cache-references:u,812345678,50.00,112.309,M/sec\n\
                    8123456,,cache-misses:u,812345678,49.99,8.90,of all cache refs\n\
                    20123456,,L1-dcache-load-misses:u,812345678,50.00,,\n\
                    100,,page-faults,1357089,100.00,73.687,K/sec\n";
        assert_eq!(
            parse(text),
            Ok([91_234_567.0, 8_123_456.0, 20_123_456.0, 4_208_341.0])
        );
    }

    #[test]
    fn an_event_that_is_missing_or_had_to_wait_is_not_taken_for_zero() {
        let text = "5,,cache-references,1,100.00,,\n";
        assert_eq!(
            parse(text),
            Err("not counted: perf said nothing of cache-misses".to_owned())
        );
        let text = "<not counted>,,cache-misses,0,0.00,,\n";
        assert!(parse(text).is_err());
    }
}
