//! The CPU twin: the own-row step on lanes and threads, by the names of the kernels. It is what
//! runs where there is no graphics device, and what the kernels are compared with.
//!
//! As on the device, a pass reads any row and writes only its own; so a pass may go through its rows in lanes
//! of four or eight and on any number of threads, and the bits are the same.

pub mod batches;
pub mod broad_phase;
pub mod coloured;
mod engine;
mod explain;
pub mod forces;
pub mod joints;
pub mod movers;
pub mod pairs;
pub mod plan;
pub mod sleep;
pub mod threads;
pub mod work;

use std::ops::Range;

use ch00_scenes::{Body, Scene, State};

use crate::bodies::Bodies;
use crate::own_row::body::Gathered;
use crate::rows::Step;
use crate::rules::{Method, Rules};
use crate::simd::{Real, Widest};
use broad_phase::BroadPhase;
use coloured::Live;
use forces::{Forces, Spring};
use joints::Joints;
use movers::Movers;
use pairs::Pairs;
use plan::{Part, Plan};
use sleep::Sleep;
use threads::Threads;
use work::{Bounces, PressAgain, Restore, Solve};

pub use engine::{ENGINE, LanesEngine, METHODS, OWN_ROW, unsupported};

/// All state of a run, and what a step does with it.
#[derive(Clone, Debug)]
pub struct Lanes<R: Real = Widest> {
    /// The bodies' rows.
    pub bodies: Bodies,
    /// The pairs of the last step.
    pub pairs: Pairs<R>,
    /// Those of the step before, whose memory the next one takes.
    last_pairs: Pairs<R>,
    /// Which bodies may touch.
    pub broad: BroadPhase,
    /// What pulls beyond gravity.
    pub forces: Forces,
    /// Joints and angle limits.
    pub joints: Joints<R>,
    /// The constants of the run.
    pub rules: Rules,
    /// What is kept although nothing needs it.
    pub plan: Plan,
    /// Who works.
    pub threads: Threads,
    /// Who sleeps, if somebody may.
    pub sleep: Sleep,
    /// By body: what its pairs did to it in this substep.
    gathered: Vec<Gathered>,
    /// By body: how it moves by now, while the colours are gone through.
    live: Live,
}

impl<R: Real> Lanes<R> {
    /// The start of a scene.
    ///
    /// # Errors
    /// What it doesn't model, and the index of the body.
    pub fn of(scene: &Scene, rules: Rules) -> Result<Self, (String, usize)> {
        forces::check_fixed_points(scene)?;
        let mut bodies = Bodies::of(scene);
        let forces = Forces::of(scene, &mut bodies)?;
        let mut broad = BroadPhase::default();
        broad.ignored = ignored(scene);
        broad.aside = forces
            .pivots
            .iter()
            .map(|pivot| pivot.body as u32)
            .collect();
        broad.look_at(&bodies);
        Ok(Self {
            threads: Threads::default(),
            gathered: vec![Gathered::default(); bodies.rows()],
            live: Live::default(),
            sleep: Sleep::of(bodies.rows()),
            joints: Joints::of(scene),
            bodies,
            pairs: Pairs::default(),
            last_pairs: Pairs::default(),
            broad,
            forces,
            rules,
            plan: Plan::default(),
        })
    }

    /// Takes over where bodies are and how they move; what they pressed is forgotten.
    pub fn write_state(&mut self, state: &State) {
        self.wake_all();
        self.sleep.woken().clear();
        self.bodies.write(state);
        self.pairs = Pairs::default();
        self.joints.forget();
        self.broad.forget();
    }

    /// Adds a body at the end.
    pub fn add_body(&mut self, body: &Body) {
        self.bodies.push(body);
        self.bodies.found();
        self.gathered.push(Gathered::default());
        self.joints.add_body();
        self.sleep.add_body();
        let row = self.bodies.rows() - 1;
        if body.is_static() {
            let near: Vec<usize> = self.broad.near(&self.bodies, row).collect();
            self.wake(near.into_iter());
        }
        self.broad.forget();
    }

    /// Removes a body that no joint and no force holds; those after it move up.
    pub fn remove_body(&mut self, row: usize) {
        self.wake_about(row);
        self.bodies.remove(row);
        self.bodies.found();
        self.sleep.remove_body(row);
        self.gathered.pop();
        self.pairs.remove_body(row);
        self.broad.remove_body(row);
        self.forces.remove_body(row);
        self.joints.remove_body(row);
    }

    /// The mouse pulls a body from now on, or lets go.
    pub fn pull(&mut self, spring: Option<Spring>) {
        self.wake(spring.iter().map(|spring| spring.body));
        self.forces.mouse = spring;
    }

    // ANCHOR: step
    /// A step of `dt` seconds. `done` hears of each part when it is done.
    pub fn step(&mut self, dt: f32, done: impl FnMut(&'static str) + Send) {
        let threads = self.threads.clone();
        threads.run(self.bodies.awake(), || self.step_here(dt, done));
    }

    fn step_here(&mut self, dt: f32, mut done: impl FnMut(&'static str)) {
        let step = self.rules.step(dt, self.bodies.rows());
        self.find_pairs(dt, &mut done);
        self.start(&step);
        for substep in 1..=self.rules.substeps {
            match self.rules.method {
                Method::OwnRow => self.solve_own_rows(&step),
                Method::Coloured => self.solve_colours(&step),
            }
            let kicks = substep < self.rules.substeps;
            if self.is_plain() {
                self.move_at_once(kicks, &step);
                continue;
            }
            self.exchange();
            self.joints.solve_trees(&mut self.bodies, step.h);
            self.advance(&step);
            if kicks {
                self.kick(&step);
            }
        }
        done("substeps");
        self.bounce(&step);
        self.pairs.write_back(self.least());
        done("restitution");
        if self.rules.sleeping {
            self.fall_asleep(dt);
            done("sleep");
        }
    }
    // ANCHOR_END: step

    /// Broad and narrow phase; and again with those whom that has woken.
    fn find_pairs(&mut self, dt: f32, done: &mut impl FnMut(&'static str)) {
        std::mem::swap(&mut self.pairs, &mut self.last_pairs);
        broad_phase::find_pairs(&self.bodies, dt, &mut self.broad);
        done("broad phase");
        self.meet(dt);
        done("narrow phase");
        while self.wake_touched() {
            broad_phase::find_pairs(&self.bodies, dt, &mut self.broad);
            self.meet(dt);
            done("waking");
        }
    }

    /// The fewest rows that go together in a pass.
    fn least(&self) -> usize {
        self.threads.least(self.bodies.awake())
    }

    /// The fewest blocks of bodies that do, and batches of pairs.
    fn least_in_lanes(&self) -> usize {
        self.least() / R::LANES
    }

    /// Narrow phase over what the broad phase found.
    fn meet(&mut self, dt: f32) {
        self.last_pairs.recall(self.sleep.woken());
        let (found, last) = (&self.broad.pairs, &self.last_pairs);
        let least = self.least();
        let way = (self.rules.method, self.plan);
        pairs::meet(found, &self.bodies, dt, last, way, &mut self.pairs, least);
    }

    // ANCHOR: start
    /// What held the bodies in the last step, where their points are now; then the first kick.
    fn start(&mut self, step: &Step) {
        let bodies = &self.bodies;
        let least = self.least_in_lanes();
        let work = PressAgain { bodies, h: step.h };
        self.pairs.batches.each(least, &work);
        self.gather();
        let least = self.least_in_lanes();
        let gathered = &self.gathered;
        Movers::of(&mut self.bodies, least).each::<R>(|block| block.start(gathered));
        self.kick(step);
    }
    // ANCHOR_END: start

    /// Every body's mass is shared among as many pairs as count.
    fn share(&mut self) {
        for run in self.bodies.runs().to_vec() {
            let sums = &self.gathered[run.clone()];
            movers::share(&mut self.bodies.motion[run], sums);
        }
    }

    /// Every pair, limit and loop writes its own impulses, all from the same velocities.
    fn solve_own_rows(&mut self, step: &Step) {
        let bodies = &self.bodies;
        let least = self.least_in_lanes();
        self.pairs.batches.each(least, &Solve { bodies, step });
        self.joints.solve_rows(&self.bodies, step.h);
        self.gather();
    }

    /// Every body sums what its pairs did to it, in the order of their IDs; then its limits and loops.
    fn gather(&mut self) {
        let (least, joints) = (self.least(), &self.joints);
        let whole = self.rules.method == Method::Coloured;
        let runs = self.bodies.runs();
        gather(&self.pairs, &mut self.gathered, runs, least, |row, sum| {
            joints.gather(row, sum);
            if whole {
                sum.share_among_limits();
            }
        });
    }

    /// What its pairs did to each body.
    fn gather_pairs(&mut self) {
        let (least, runs) = (self.least(), self.bodies.runs());
        gather(&self.pairs, &mut self.gathered, runs, least, |_, _| {});
    }

    /// Every body takes up what pulls and holds it.
    fn kick(&mut self, step: &Step) {
        let least = self.least_in_lanes();
        self.forces.gather(&self.bodies);
        let (pulls, joints) = (&self.forces.pulls, &self.joints);
        let mut movers = Movers::of(&mut self.bodies, least);
        movers.each::<R>(|block| block.kick::<R>(pulls, joints, step));
    }

    /// Every body puts what holds it now in the place of what it started the substep with.
    fn exchange(&mut self) {
        let least = self.least_in_lanes();
        let gathered = &self.gathered;
        let mut movers = Movers::of(&mut self.bodies, least);
        movers.each::<R>(|block| block.exchange::<R>(gathered));
    }

    /// Whether no joints hold the bodies and nothing but gravity pulls.
    fn is_plain(&self) -> bool {
        self.joints.is_empty()
            && !self.forces.any_pull()
            && self.forces.pivots.is_empty()
            && !self.plan.keeps(Part::Joints)
    }

    /// What bodies do in a substep, in one pass.
    fn move_at_once(&mut self, kicks: bool, step: &Step) {
        let least = self.least_in_lanes();
        let gathered = &self.gathered;
        let mut movers = Movers::of(&mut self.bodies, least);
        movers.each::<R>(|block| block.substep::<R>(gathered, kicks, step));
    }

    // ANCHOR: advance
    /// Every body moves.
    fn advance(&mut self, step: &Step) {
        self.joints.note_floating(&self.gathered);
        let least = self.least_in_lanes();
        let (gathered, joints) = (&self.gathered, &self.joints);
        let mut movers = Movers::of(&mut self.bodies, least);
        movers.each::<R>(|block| block.advance::<R>(gathered, joints, step));
        self.forces.turn_pivots(&mut self.bodies, step);
    }
    // ANCHOR_END: advance

    // ANCHOR: bounce
    /// Restitution, once at the end of a step: a body's mass is now shared among the pairs that bounce.
    fn bounce(&mut self, step: &Step) {
        let least = self.least_in_lanes();
        let bounces = Bounces::of(step);
        self.pairs.batches.each(least, &bounces);
        if !bounces.any() {
            return;
        }
        if self.rules.method == Method::Coloured {
            self.restore_colours(step);
            return;
        }
        self.gather_pairs();
        self.share();
        let bodies = &self.bodies;
        self.pairs.batches.each(least, &Restore { bodies, step });
        self.gather_pairs();
        let least = self.least_in_lanes();
        let gathered = &self.gathered;
        let mut movers = Movers::of(&mut self.bodies, least);
        movers.each::<R>(|block| block.take_up::<R>(gathered));
    }
    // ANCHOR_END: bounce
}

// ANCHOR: gather
/// Every body sums what its pairs did to it, in the order of their IDs; then what `more` adds.
fn gather<R: Real>(
    pairs: &Pairs<R>,
    sums: &mut [Gathered],
    runs: &[Range<usize>],
    least: usize,
    more: impl Fn(usize, &mut Gathered) + Sync,
) {
    threads::each_in(sums, runs, least, |row, sum| {
        *sum = Gathered::default();
        for &entry in pairs.of(row) {
            sum.add(&pairs.batches.press[(entry >> 1) as usize], entry & 1 == 1);
        }
        more(row, sum);
    });
}
// ANCHOR_END: gather

/// The pairs of bodies that joints connect, the smaller row first, in order.
fn ignored(scene: &Scene) -> Vec<(usize, usize)> {
    let mut ignored: Vec<_> = scene
        .joints
        .iter()
        .map(|joint| {
            let (a, b) = joint.bodies();
            (a.min(b), a.max(b))
        })
        .collect();
    ignored.sort_unstable();
    ignored.dedup();
    ignored
}
