//! What the machine could do: how fast one thread copies, and how fast it multiplies and adds; and what a
//! second thread costs.

use std::hint::black_box;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Instant;

use ch06_compute::lanes::threads::{self, Threads};
use ch06_compute::simd::{Eight, Real};

/// A ceiling that was measured.
pub struct Ceiling {
    /// What it is.
    pub what: String,
    /// Time of all of it, s.
    pub seconds: f64,
    /// Bytes read and written.
    pub bytes: f64,
    /// Additions and multiplications.
    pub arithmetic: f64,
}

/// Sizes of the columns that are copied, KiB: in each of the caches, and in none.
const COPIED: [usize; 4] = [8, 256, 4096, 65_536];

/// Bytes that are copied for a time, at least.
const ENOUGH: usize = 1 << 24;

/// The fastest of so many tries counts: nothing but other work on the machine makes one slower.
const TRIES: usize = 51;

/// Chains of multiply and add that don't need each other: as many as it takes to hide that each waits for its
/// own last result, and as fit into the registers.
const CHAINS: usize = if cfg!(target_feature = "avx") { 12 } else { 6 };

/// Links of each.
const LINKS: usize = 100_000;

/// Bytes between what two threads write: in one line of 64, and in two.
const APART: [usize; 2] = [16, 128];

/// How often each of the two writes.
const WRITES: u32 = 1_000_000;

/// So many threads go through a pass, of so many rows.
const WOKEN: [usize; 3] = [1, 2, 8];
const ROWS: usize = 2048;

/// Passes one after the other.
const PASSES: usize = 100;

/// All ceilings.
pub fn ceilings() -> Vec<Ceiling> {
    let mut all: Vec<Ceiling> = COPIED.into_iter().map(copied).collect();
    all.push(computed());
    all.extend(WOKEN.map(woken));
    all.extend(APART.map(beside));
    all
}

/// The tries in the order of their times, s.
fn tries(mut work: impl FnMut()) -> [f64; TRIES] {
    let mut times = [(); TRIES].map(|()| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    });
    times.sort_by(f64::total_cmp);
    times
}

/// The fastest try, s.
fn fastest(work: impl FnMut()) -> f64 {
    tries(work)[0]
}

/// The try in the middle, s.
fn middle(work: impl FnMut()) -> f64 {
    tries(work)[TRIES / 2]
}

/// A column of so many KiB, copied into another.
fn copied(kib: usize) -> Ceiling {
    let numbers = 256 * kib;
    let from = vec![1.0_f32; numbers];
    let mut to = vec![0.0_f32; numbers];
    let times = (ENOUGH / (4 * numbers)).max(1);
    let seconds = fastest(|| {
        for _ in 0..times {
            black_box(&mut to[..]).copy_from_slice(black_box(&from));
        }
    });
    Ceiling {
        what: format!("copy {kib} KiB"),
        seconds,
        bytes: (8 * numbers * times) as f64,
        arithmetic: 0.0,
    }
}

// ANCHOR: computed
/// x ← x f + g in eight lanes, in chains that don't need each other; the product is rounded before the sum,
/// as everywhere here.
fn computed() -> Ceiling {
    let (f, g) = black_box((Eight::splat(0.5), Eight::splat(1.0)));
    let mut chains = black_box([Eight::splat(0.1); CHAINS]);
    let seconds = fastest(|| {
        let mut xs = chains;
        for _ in 0..LINKS {
            for x in &mut xs {
                *x = *x * f + g;
            }
        }
        chains = black_box(xs);
    });
    Ceiling {
        what: "multiply and add".to_owned(),
        seconds,
        bytes: 0.0,
        arithmetic: (2 * Eight::LANES * CHAINS * LINKS) as f64,
    }
}
// ANCHOR_END: computed

// ANCHOR: woken
/// A pass over rows that take some 60 ns each, on so many threads.
fn woken(count: usize) -> Ceiling {
    let threads = Threads::of(count).unwrap_or_default();
    let mut rows = [1.5_f32; ROWS];
    let all = middle(|| {
        threads.run(ROWS, || {
            let least = threads.least(ROWS);
            for _ in 0..PASSES {
                threads::each(&mut rows, least, |_, row| {
                    for _ in 0..16 {
                        *row = 2.0 / (*row + 1.0);
                    }
                });
            }
        });
    });
    Ceiling {
        what: format!("a pass on {count} thread(s)"),
        seconds: all / PASSES as f64,
        bytes: 0.0,
        arithmetic: 0.0,
    }
}
// ANCHOR_END: woken

/// Numbers of which none begins before a line does.
#[repr(align(128))]
struct Lines([AtomicU32; 33]);

// ANCHOR: beside
/// Two threads, each of which adds to a number of its own, so many bytes apart; the time of an addition.
fn beside(apart: usize) -> Ceiling {
    let lines = Lines([const { AtomicU32::new(0) }; 33]);
    let own = |place: usize| {
        let number = &lines.0[place];
        for k in 0..WRITES {
            number.fetch_add(k, Ordering::Relaxed);
        }
    };
    // The fastest would be one in which they didn't run at the same time.
    let all = middle(|| {
        std::thread::scope(|scope| {
            scope.spawn(|| own(0));
            own(apart / size_of::<AtomicU32>());
        });
    });
    Ceiling {
        what: format!("additions {apart} bytes apart"),
        seconds: all / f64::from(WRITES),
        bytes: 0.0,
        arithmetic: 0.0,
    }
}
// ANCHOR_END: beside
