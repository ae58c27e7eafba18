//! Times of one `integrate` and of reading whole balls in a random order, median of several runs.
//! The steps take turns, so that a noisy neighbour disturbs all of them alike.

use std::collections::HashSet;
use std::hint::black_box;
use std::time::{Duration, Instant};

use ch00_scenes::random::SplitMix64;

use crate::ball::balls;
use crate::world::{LINE, World};
use crate::{DT, Step};

pub const RUNS: usize = 15;
/// A run repeats its work until it took this long.
const SHORTEST_RUN: Duration = Duration::from_millis(20);

/// Nanoseconds a ball.
#[derive(Clone, Copy)]
pub struct Nanoseconds {
    pub median: f64,
    pub fastest: f64,
    pub slowest: f64,
}

/// What one step takes for one N.
pub struct Row {
    pub number: usize,
    pub name: &'static str,
    pub count: usize,
    pub bytes: Bytes,
    pub integrate: Nanoseconds,
    pub whole: Nanoseconds,
}

/// Memory, a ball.
#[derive(Clone, Copy)]
pub struct Bytes {
    /// What it takes.
    pub all: usize,
    /// What `integrate` needs of it.
    pub needed: usize,
    /// What the cache lines have in which that lies.
    pub fetched: f64,
}

/// All steps for one N.
pub fn all(steps: &[&Step], count: usize) -> Vec<Row> {
    let balls = balls(count, DT);
    let mut worlds: Vec<_> = steps.iter().map(|step| (step.build)(&balls)).collect();
    let order = shuffled(count);
    let mut integrate = vec![[0.0; RUNS]; steps.len()];
    let mut whole = integrate.clone();
    for run in 0..=RUNS {
        for (place, world) in worlds.iter_mut().enumerate() {
            let times = [
                seconds(|| world.integrate(black_box(DT))),
                seconds(|| read_all(world.as_ref(), &order)),
            ];
            // The first round warms up.
            if let Some(run) = run.checked_sub(1) {
                [integrate[place][run], whole[place][run]] = times;
            }
        }
    }
    let row = |(place, step): (usize, &&Step)| Row {
        number: step.number,
        name: step.name,
        count,
        bytes: bytes(worlds[place].as_ref(), count),
        integrate: spread(integrate[place], count),
        whole: spread(whole[place], count),
    };
    steps.iter().enumerate().map(row).collect()
}

/// Asks for all properties of each ball.
fn read_all(world: &dyn World, order: &[usize]) {
    for &number in order {
        black_box(world.ball(number));
    }
}

/// The numbers below `count` in a random order [Fisher and Yates].
fn shuffled(count: usize) -> Vec<usize> {
    let mut random = SplitMix64::new(1);
    let mut order: Vec<usize> = (0..count).collect();
    for place in (1..count).rev() {
        let other = (random.unit() * (place + 1) as f64) as usize;
        order.swap(place, other);
    }
    order
}

/// What `integrate` needs, and the lines that come with it: counted from the addresses.
pub fn bytes(world: &dyn World, count: usize) -> Bytes {
    let mut lines = HashSet::new();
    for number in 0..count {
        for span in world.visits(number) {
            lines.extend(span.lines());
        }
    }
    Bytes {
        all: world.bytes(),
        needed: world.visits(0).iter().map(|span| span.bytes).sum(),
        fetched: (lines.len() * LINE) as f64 / count as f64,
    }
}

/// Mean time of `work` over a run, s.
fn seconds(mut work: impl FnMut()) -> f64 {
    let start = Instant::now();
    let mut repeats = 0_u32;
    while repeats == 0 || start.elapsed() < SHORTEST_RUN {
        // Asking for the time costs as much as ten balls: ask seldom.
        let batch = repeats.max(1);
        for _ in 0..batch {
            work();
        }
        repeats += batch;
    }
    start.elapsed().as_secs_f64() / f64::from(repeats)
}

/// Median and extremes, a ball.
fn spread(mut seconds: [f64; RUNS], count: usize) -> Nanoseconds {
    seconds.sort_by(f64::total_cmp);
    let a_ball = |seconds: f64| seconds * 1e9 / count as f64;
    Nanoseconds {
        median: a_ball(seconds[RUNS / 2]),
        fastest: a_ball(seconds[0]),
        slowest: a_ball(seconds[RUNS - 1]),
    }
}
