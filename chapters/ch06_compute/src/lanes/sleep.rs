//! Sleeping islands: bodies that have come to rest cost nothing until something touches them.
//!
//! An island is what hangs together by pairs of the narrow phase and by joints; what is fixed connects nobody.
//! It falls asleep as a whole and wakes as a whole. Its bodies are then as good as fixed: two of them are no
//! pair, and passes over bodies leave them out. What their pairs pressed is kept, and they wake with it.

mod calm;
mod islands;
mod kept;

pub use calm::{Calm, DISTANCE, FASTEST_SPIN, TIME};
pub use islands::Islands;
pub use kept::KeptPair;

use super::Lanes;
use crate::simd::Real;

/// How often islands are looked for, s.
pub const BETWEEN: f32 = 0.1;

/// Awake.
const NO_ISLAND: u32 = u32::MAX;

/// Who sleeps, and who soon will.
#[derive(Clone, Debug, Default)]
pub struct Sleep {
    /// By row.
    calm: Vec<Calm>,
    /// By row: the smallest row of the island that it sleeps with.
    island: Vec<u32>,
    /// How many bodies sleep.
    asleep: usize,
    /// What sleeping pairs pressed, in the order of their bodies.
    kept: Vec<KeptPair>,
    /// The same of those that have woken, for the next narrow phase.
    woken: Vec<KeptPair>,
    islands: Islands,
    /// Since islands were looked for, s.
    since: f32,
}

impl Sleep {
    /// All of so many bodies are awake.
    #[must_use]
    pub fn of(bodies: usize) -> Self {
        Self {
            calm: vec![Calm::default(); bodies],
            island: vec![NO_ISLAND; bodies],
            ..Self::default()
        }
    }

    /// How many bodies sleep.
    #[must_use]
    pub fn asleep(&self) -> usize {
        self.asleep
    }

    /// By body: where it was, and for how long it has been near.
    #[must_use]
    pub fn calm(&self) -> &[Calm] {
        &self.calm
    }

    /// How many islands they are.
    #[must_use]
    pub fn islands(&self) -> usize {
        let rows = self.island.iter().enumerate();
        rows.filter(|&(row, &island)| island == row as u32).count()
    }

    /// What sleeping pairs pressed when they fell asleep.
    #[must_use]
    pub fn kept(&self) -> &[KeptPair] {
        &self.kept
    }

    /// What pairs pressed that have woken since the last narrow phase.
    pub fn woken(&mut self) -> &mut Vec<KeptPair> {
        &mut self.woken
    }

    /// An awake body came.
    pub fn add_body(&mut self) {
        self.calm.push(Calm::default());
        self.island.push(NO_ISLAND);
    }

    /// A body that is awake is gone, and those after it have moved up.
    pub fn remove_body(&mut self, row: usize) {
        self.calm.remove(row);
        self.island.remove(row);
        for island in &mut self.island {
            if *island != NO_ISLAND && *island as usize > row {
                *island -= 1;
            }
        }
        kept::remove_body(&mut self.kept, row);
        kept::remove_body(&mut self.woken, row);
    }

    /// The islands that some rows sleep in, in order.
    fn islands_of(&self, rows: impl Iterator<Item = usize>) -> Vec<u32> {
        let islands = rows.map(|row| self.island[row]);
        let mut islands: Vec<_> = islands.filter(|&island| island != NO_ISLAND).collect();
        islands.sort_unstable();
        islands.dedup();
        islands
    }
}

impl<R: Real> Lanes<R> {
    /// Islands that have come to rest fall asleep, at the end of a step.
    pub(super) fn fall_asleep(&mut self, dt: f32) {
        let (bodies, sleep) = (&self.bodies, &mut self.sleep);
        let mut any = false;
        for row in bodies.runs().iter().cloned().flatten() {
            sleep.calm[row].look(bodies, row, dt);
            any |= sleep.calm[row].time >= TIME && !bodies.is_static(row);
        }
        for row in self.forces.pulled() {
            sleep.calm[row].time = 0.0;
        }
        sleep.since += dt;
        if any && sleep.since >= BETWEEN {
            sleep.since = 0.0;
            self.lay_down();
        }
    }

    // ANCHOR: fall_asleep
    /// Lays down all islands that may sleep.
    fn lay_down(&mut self) {
        let (bodies, sleep) = (&mut self.bodies, &mut self.sleep);
        sleep.islands.start(bodies.rows());
        for (&pair, impulse) in self.pairs.bodies.iter().zip(&self.pairs.impulse) {
            let presses = impulse.normal.max_element() > 0.0;
            sleep.islands.join(bodies, pair, presses);
        }
        for &joined in &self.broad.ignored {
            sleep.islands.join(bodies, joined, true);
        }
        sleep.islands.tell(&sleep.calm);
        let before = sleep.asleep;
        for row in 0..bodies.rows() {
            if !bodies.is_static(row) && sleep.islands.may_sleep(row) {
                sleep.island[row] = sleep.islands.of(row as u32);
                sleep.asleep += 1;
                bodies.lay_down(row);
            }
        }
        if sleep.asleep > before {
            self.keep_pairs();
            self.regroup();
        }
    }
    // ANCHOR_END: fall_asleep

    /// Keeps what the pairs of those pressed who have just fallen asleep.
    fn keep_pairs(&mut self) {
        let (bodies, pairs) = (&self.bodies, &self.pairs);
        let sleeps = |&pair: &usize| {
            let (a, b) = pairs.bodies[pair];
            bodies.is_static(a) && bodies.is_static(b)
        };
        let asleep = (0..pairs.bodies.len()).filter(sleeps);
        let kept = &mut self.sleep.kept;
        kept.extend(asleep.map(|pair| KeptPair::of(pairs, pair)));
        kept.sort_by_key(|pair| pair.bodies);
    }

    // ANCHOR: wake_touched
    /// Wakes the islands of which a body is a pair with one that is awake. Whether there were any.
    pub(super) fn wake_touched(&mut self) -> bool {
        if self.sleep.asleep == 0 {
            return false;
        }
        let bodies = &self.bodies;
        let ends = self
            .pairs
            .bodies
            .iter()
            .flat_map(|&(a, b)| [(a, b), (b, a)]);
        let touched =
            ends.filter(|&(row, other)| bodies.is_asleep(row) && !bodies.is_static(other));
        let touched: Vec<usize> = touched.map(|(row, _)| row).collect();
        self.wake(touched.into_iter())
    }
    // ANCHOR_END: wake_touched

    /// Wakes the islands that some rows sleep in. Whether there were any.
    pub(super) fn wake(&mut self, rows: impl Iterator<Item = usize>) -> bool {
        let (bodies, sleep) = (&mut self.bodies, &mut self.sleep);
        let islands = sleep.islands_of(rows);
        if islands.is_empty() {
            return false;
        }
        let wakes = |row: usize| islands.binary_search(&sleep.island[row]).is_ok();
        let woken = |pair: &KeptPair| wakes(pair.bodies.0) || wakes(pair.bodies.1);
        sleep
            .woken
            .extend(sleep.kept.extract_if(.., |pair| woken(pair)));
        for row in 0..bodies.rows() {
            if islands.binary_search(&sleep.island[row]).is_ok() {
                sleep.island[row] = NO_ISLAND;
                sleep.calm[row] = Calm::default();
                sleep.asleep -= 1;
                bodies.wake(row);
            }
        }
        self.regroup();
        true
    }

    /// Wakes all.
    pub(super) fn wake_all(&mut self) {
        self.wake(0..self.sleep.island.len());
    }

    /// Wakes whom a body holds up or touches that somebody is about to change.
    pub(super) fn wake_about(&mut self, row: usize) {
        let pairs = self.sleep.kept.iter().filter(|pair| pair.has(row));
        let ends = pairs.flat_map(|pair| [pair.bodies.0, pair.bodies.1]);
        let joined = self.broad.ignored.iter();
        let joined = joined.filter(|&&(a, b)| a == row || b == row);
        let joined = joined.flat_map(|&(a, b)| [a, b]);
        let rows: Vec<usize> = ends.chain(joined).chain([row]).collect();
        self.wake(rows.into_iter());
    }

    /// Others sleep now than before: passes, joints and the broad phase must know.
    fn regroup(&mut self) {
        self.bodies.find_runs();
        self.joints.group(&self.bodies);
        self.live.forget();
        self.regions.forget();
        self.broad.forget();
    }
}
