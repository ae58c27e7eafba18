//! Threads: who goes through the rows of a pass.

use std::ops::Range;
use std::sync::Arc;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};

/// Fewer bodies than this aren't worth a second thread: waking it takes longer than their step.
pub const FEWEST_BODIES: usize = 256;

/// The most threads that a run may have.
pub const MOST_THREADS: usize = 256;

/// Rows of a pass that are worth a thread's turn.
const LEAST_BODIES: usize = 256;

/// The threads of a run. Whatever their number, the bits are the same: who works changes nothing, since
/// every row writes itself.
#[derive(Clone, Debug, Default)]
pub struct Threads {
    pool: Option<Arc<rayon::ThreadPool>>,
}

impl Threads {
    /// So many threads.
    ///
    /// # Errors
    /// What the system says where it has no more of them.
    pub fn of(count: usize) -> Result<Self, rayon::ThreadPoolBuildError> {
        if count <= 1 {
            return Ok(Self::default());
        }
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(count)
            .thread_name(|index| format!("lanes {index}"))
            .build()?;
        Ok(Self {
            pool: Some(Arc::new(pool)),
        })
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.pool
            .as_ref()
            .map_or(1, |pool| pool.current_num_threads())
    }

    /// Does something for so many bodies, on the threads if it is worth it.
    pub fn run<T: Send>(&self, bodies: usize, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) if bodies >= FEWEST_BODIES => pool.install(work),
            _ => work(),
        }
    }

    /// The fewest bodies that go together in a pass, where there are so many; all, for who isn't one of the
    /// threads.
    #[must_use]
    pub fn least(&self, bodies: usize) -> usize {
        let is_one = self.pool.is_some() && rayon::current_thread_index().is_some();
        if is_one && bodies >= FEWEST_BODIES {
            LEAST_BODIES
        } else {
            usize::MAX
        }
    }
}

/// The fewest that go together where each is much work: one, if others may share it at all.
#[must_use]
pub fn one_by_one(least: usize) -> usize {
    if least == usize::MAX { least } else { 1 }
}

// ANCHOR: each
/// Does something with every row, on as many threads as there are; at least `least` rows go together.
pub fn each<T: Send>(rows: &mut [T], least: usize, work: impl Fn(usize, &mut T) + Sync) {
    rows.par_iter_mut()
        .enumerate()
        .with_min_len(least)
        .for_each(|(row, value)| work(row, value));
}
// ANCHOR_END: each

/// The same with some of the rows.
pub fn each_in<T: Send>(
    rows: &mut [T],
    runs: &[Range<usize>],
    least: usize,
    work: impl Fn(usize, &mut T) + Sync,
) {
    for run in runs {
        each(&mut rows[run.clone()], least, |row, value| {
            work(run.start + row, value);
        });
    }
}
