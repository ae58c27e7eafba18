//! Times of one frame and of gathering the position column, median of several runs. The
//! styles take turns, so that a noisy neighbour disturbs all of them alike.

use std::hint::black_box;
use std::time::{Duration, Instant};

use ch01_hierarchy::styles::items::{Item, scene};
use ch01_hierarchy::styles::{Bytes, Style, components, hierarchy, hybrid};

pub const RUNS: usize = 15;
/// A run repeats its frame until it took this long.
const SHORTEST_RUN: Duration = Duration::from_millis(20);
const DT: f32 = 1.0 / 60.0;

/// Nanoseconds an object.
#[derive(Clone, Copy)]
pub struct Nanoseconds {
    pub median: f64,
    pub fastest: f64,
    pub slowest: f64,
}

/// What one style takes for one N.
pub struct Row {
    pub style: &'static str,
    pub count: usize,
    pub update: Nanoseconds,
    pub gather: Nanoseconds,
    /// An object, on average over the items.
    pub bytes: Bytes,
}

/// A style's world as the runs see it.
trait Subject {
    fn update(&mut self);
    fn gather(&mut self);
}

struct World<S> {
    world: S,
    column: Vec<[f32; 3]>,
}

impl<S: Style> Subject for World<S> {
    fn update(&mut self) {
        self.world.update(DT);
    }

    fn gather(&mut self) {
        self.world.gather_positions(&mut self.column);
        black_box(&self.column);
    }
}

/// All styles for one N.
pub fn all(count: usize) -> Vec<Row> {
    let items = scene(count);
    let mut subjects = [
        subject::<hierarchy::World>(&items),
        subject::<components::World>(&items),
        subject::<hybrid::World>(&items),
    ];
    let mut updates = [[0.0; RUNS]; 3];
    let mut gathers = [[0.0; RUNS]; 3];
    for run in 0..=RUNS {
        for (place, (.., subject)) in subjects.iter_mut().enumerate() {
            let update = seconds(|| subject.update());
            let gather = seconds(|| subject.gather());
            // The first round warms up.
            if let Some(run) = run.checked_sub(1) {
                updates[place][run] = update;
                gathers[place][run] = gather;
            }
        }
    }
    let times = updates.into_iter().zip(gathers);
    let rows = subjects.iter().zip(times);
    rows.map(|((style, bytes, _), (update, gather))| Row {
        style,
        count,
        update: spread(update, count),
        gather: spread(gather, count),
        bytes: *bytes,
    })
    .collect()
}

fn subject<S: Style + 'static>(items: &[Item]) -> (&'static str, Bytes, Box<dyn Subject>) {
    let sum = S::bytes(items);
    let bytes = Bytes {
        update: sum.update / items.len(),
        gather: sum.gather / items.len(),
    };
    let world = World {
        world: S::build(items),
        column: Vec::new(),
    };
    (S::NAME, bytes, Box::new(world))
}

/// Mean time of `work` over a run, s.
pub fn seconds(mut work: impl FnMut()) -> f64 {
    let start = Instant::now();
    let mut repeats = 0_u32;
    while repeats == 0 || start.elapsed() < SHORTEST_RUN {
        // Asking for the time costs as much as ten objects: ask seldom.
        let batch = repeats.max(1);
        for _ in 0..batch {
            work();
        }
        repeats += batch;
    }
    start.elapsed().as_secs_f64() / f64::from(repeats)
}

/// Median and extremes, per object.
pub fn spread<const R: usize>(mut seconds: [f64; R], count: usize) -> Nanoseconds {
    seconds.sort_by(f64::total_cmp);
    let an_object = |seconds: f64| seconds * 1e9 / count as f64;
    Nanoseconds {
        median: an_object(seconds[R / 2]),
        fastest: an_object(seconds[0]),
        slowest: an_object(seconds[R - 1]),
    }
}
