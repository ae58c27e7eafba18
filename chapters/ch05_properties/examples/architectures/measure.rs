//! Times of all operations, median of several runs. The architectures take turns within a run, so
//! that a noisy neighbour disturbs all of them alike.

use std::time::{Duration, Instant};

use crate::operation::{Operation, Subject, Visited, subjects};

/// Runs of each operation.
pub const RUNS: usize = 15;
/// A hundredth of all is replaced so many times before a world counts as aged.
pub const ROUNDS: usize = 25;

/// Nanoseconds an object or a read.
#[derive(Clone, Copy, Debug)]
pub struct Nanoseconds {
    pub median: f64,
    pub fastest: f64,
    pub slowest: f64,
}

/// What one architecture takes for one operation and N.
pub struct Row {
    pub architecture: &'static str,
    pub operation: Operation,
    pub count: usize,
    pub time: Nanoseconds,
    pub visited: Visited,
}

/// The runs of one operation, for each architecture.
type Runs = [Vec<f64>; 5];

/// All architectures and operations for one N.
///
/// A run repeats its operation until it took at least `shortest`.
pub fn all(count: usize, shortest: Duration) -> Vec<Row> {
    let mut subjects = subjects(count);
    let some = (count / 100).max(1);
    let mut runs: [Runs; Operation::ALL.len()] = Default::default();
    let of = |operation| Operation::ALL.iter().position(|other| *other == operation);
    let of = |operation| of(operation).expect("all are listed");

    for operation in Operation::LASTING {
        in_turn(&mut subjects, |place, subject| {
            runs[of(operation)][place].push(lasting(subject, operation, shortest));
        });
    }
    in_turn(&mut subjects, |place, subject| {
        let (remove, insert) = replacing(subject, some, shortest);
        runs[of(Operation::Remove)][place].push(remove);
        runs[of(Operation::Insert)][place].push(insert);
        let (remove, _) = replacing(subject, 1, shortest);
        runs[of(Operation::RemoveOne)][place].push(remove);
    });
    for subject in &mut subjects {
        for _ in 0..ROUNDS {
            subject.replace(some, &mut |_, work| work());
        }
    }
    in_turn(&mut subjects, |place, subject| {
        runs[of(Operation::AgedUpdate)][place].push(lasting(
            subject,
            Operation::AgedUpdate,
            shortest,
        ));
    });

    let mut rows = Vec::new();
    for (operation, runs) in Operation::ALL.into_iter().zip(runs) {
        for (subject, runs) in subjects.iter().zip(runs) {
            rows.push(Row {
                architecture: subject.name(),
                operation,
                count,
                time: spread(runs),
                visited: subject.visited(),
            });
        }
    }
    rows
}

/// Lets all do the same, run by run. The first run warms up: its times are thrown away.
fn in_turn(subjects: &mut [Box<dyn Subject>; 5], mut one: impl FnMut(usize, &mut dyn Subject)) {
    for _ in 0..=RUNS {
        for (place, subject) in subjects.iter_mut().enumerate() {
            one(place, subject.as_mut());
        }
    }
}

/// Mean time over a run, ns an object or a read.
fn lasting(subject: &mut dyn Subject, operation: Operation, shortest: Duration) -> f64 {
    let start = Instant::now();
    let (mut repeats, mut done) = (0_u32, 0);
    while repeats == 0 || start.elapsed() < shortest {
        // Asking for the time costs as much as ten objects: ask seldom.
        let batch = repeats.max(1);
        for _ in 0..batch {
            done += subject.carry_out(operation);
        }
        repeats += batch;
    }
    start.elapsed().as_secs_f64() * 1e9 / done as f64
}

/// Mean times of removing and of inserting over a run, ns an object.
fn replacing(subject: &mut dyn Subject, count: usize, shortest: Duration) -> (f64, f64) {
    let start = Instant::now();
    let (mut remove, mut insert, mut done) = (0.0, 0.0, 0);
    while done == 0 || start.elapsed() < shortest {
        subject.replace(count, &mut |operation, work| {
            let start = Instant::now();
            work();
            let seconds = start.elapsed().as_secs_f64() - clock();
            match operation {
                Operation::Remove => remove += seconds,
                _ => insert += seconds,
            }
        });
        done += count;
    }
    let an_object = |seconds: f64| seconds.max(0.0) * 1e9 / done as f64;
    (an_object(remove), an_object(insert))
}

/// What asking for the time costs, s: as much as removing one object.
fn clock() -> f64 {
    static COST: std::sync::OnceLock<f64> = std::sync::OnceLock::new();
    *COST.get_or_init(|| {
        let mut costs = [0.0; 1001];
        for cost in &mut costs {
            *cost = Instant::now().elapsed().as_secs_f64();
        }
        costs.sort_by(f64::total_cmp);
        costs[costs.len() / 2]
    })
}

/// Median and extremes of all runs but the first.
pub fn spread(runs: Vec<f64>) -> Nanoseconds {
    let mut runs = runs;
    runs.remove(0);
    runs.sort_by(f64::total_cmp);
    Nanoseconds {
        median: runs[runs.len() / 2],
        fastest: runs[0],
        slowest: runs[runs.len() - 1],
    }
}
