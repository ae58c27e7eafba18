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
pub mod groups;
pub mod joints;
pub mod movers;
pub mod pairs;
pub mod plan;
pub mod regions;
pub mod sleep;
pub mod sums;
pub mod threads;
pub mod work;

use ch00_scenes::{Body, Scene, State};

use crate::bodies::Bodies;
use crate::own_row::body::Gathered;
use crate::rows::Step;
use crate::rules::{Method, Rules};
use crate::simd::{Real, Widest};
use batches::Work;
use broad_phase::BroadPhase;
use coloured::Live;
use forces::{Forces, Spring};
use joints::Joints;
use movers::{Block, Movers};
use pairs::{Found, Pairs};
use plan::{Part, Plan};
use regions::Regions;
use sleep::Sleep;
use sums::Sums;
use threads::Threads;
use work::{AnyBounces, Bounces, PressAgain, Restore, Solve};

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
    /// Who lies together.
    pub regions: Regions,
    /// By body: what its pairs did to it in this substep. By own rows region by region.
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
            regions: Regions::default(),
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
        self.regions.forget();
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
        self.regions.forget();
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
        self.regions.forget();
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
        if self.regions.find(&self.bodies) {
            self.gathered.fill(Gathered::default());
        }
        self.last_pairs.recall(self.sleep.woken());
        let found = Found {
            pairs: &self.broad.pairs,
            bodies: &self.bodies,
            dt,
            method: self.rules.method,
            plan: self.plan,
        };
        let (last, least) = (&self.last_pairs, self.least());
        pairs::meet(&found, last, &mut self.regions, &mut self.pairs, least);
    }

    // ANCHOR: start
    /// What held the bodies in the last step, where their points are now; then the first kick.
    fn start(&mut self, step: &Step) {
        match self.rules.method {
            Method::OwnRow => self.gather(|bodies| PressAgain { bodies, h: step.h }),
            Method::Coloured => self.press_colours(step),
        }
        self.each_body(|sums, block| block.start(sums));
        self.kick(step);
    }
    // ANCHOR_END: start

    /// Every body's mass is shared among as many pairs as count.
    fn share(&mut self) {
        let sums = Sums::at(&self.gathered, self.regions.spots());
        for run in self.bodies.runs().to_vec() {
            movers::share(&mut self.bodies.motion[run.clone()], run.start, &sums);
        }
    }

    /// Every pair, limit and loop writes its own impulses, all from the same velocities.
    fn solve_own_rows(&mut self, step: &Step) {
        self.joints.solve_rows(&self.bodies, step.h);
        self.gather(|bodies| Solve { bodies, step });
    }

    /// Does the work with all pairs, and every body sums what they did to it; then its limits and loops.
    fn gather<'s, W: Work<R>>(&'s mut self, work: impl FnOnce(&'s Bodies) -> W) {
        let (least, joints, runs) = (self.least(), &self.joints, self.bodies.runs());
        let (work, sums) = (work(&self.bodies), &mut self.gathered);
        let more = |row: usize, sum: &mut Gathered| joints.gather(row, sum);
        self.pairs
            .each_and_gather(&work, (&self.regions, runs), least, sums, more);
    }

    /// The same without limits and loops.
    fn gather_pairs<'s, W: Work<R>>(&'s mut self, work: impl FnOnce(&'s Bodies) -> W) {
        let (least, runs) = (self.least(), self.bodies.runs());
        let (work, sums) = (work(&self.bodies), &mut self.gathered);
        self.pairs
            .each_and_gather(&work, (&self.regions, runs), least, sums, |_, _| {});
    }

    /// Does something with all bodies, and with what they have gathered.
    fn each_body(&mut self, work: impl Fn(&Sums<'_>, &mut Block<'_>) + Sync) {
        let least = self.least_in_lanes();
        let sums = match self.rules.method {
            Method::OwnRow => Sums::at(&self.gathered, self.regions.spots()),
            Method::Coloured => Sums::live(&self.gathered, &self.live),
        };
        Movers::of(&mut self.bodies, least).each::<R>(|block| work(&sums, block));
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
        self.each_body(|sums, block| block.exchange::<R>(sums));
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
        self.each_body(|sums, block| block.substep::<R>(sums, kicks, step));
    }

    // ANCHOR: advance
    /// Every body moves.
    fn advance(&mut self, step: &Step) {
        let least = self.least_in_lanes();
        let sums = match self.rules.method {
            Method::OwnRow => Sums::at(&self.gathered, self.regions.spots()),
            Method::Coloured => Sums::of(&self.gathered),
        };
        self.joints.note_floating(&sums);
        let joints = &self.joints;
        let mut movers = Movers::of(&mut self.bodies, least);
        movers.each::<R>(|block| block.advance::<R>(&sums, joints, step));
        self.forces.turn_pivots(&mut self.bodies, step);
    }
    // ANCHOR_END: advance

    // ANCHOR: bounce
    /// Restitution, once at the end of a step: a body's mass is now shared among the pairs that bounce.
    fn bounce(&mut self, step: &Step) {
        let bounces = AnyBounces::of(step);
        self.pairs.sweep(false, self.least(), |_| &bounces);
        if !bounces.any() {
            return;
        }
        if self.rules.method == Method::Coloured {
            self.restore_colours(step);
            return;
        }
        self.gather_pairs(|_| Bounces { step });
        self.share();
        self.gather_pairs(|bodies| Restore { bodies, step });
        self.take_up();
    }
    // ANCHOR_END: bounce

    /// Every body takes up what its pairs gave it.
    fn take_up(&mut self) {
        self.each_body(|sums, block| block.take_up::<R>(sums));
    }
}

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
