//! What a scenario is: a set-up, what to look at, and what a pass is.

use ch00_scenes::Scene;

use super::scenarios::SCENARIOS;
use crate::FindingsError;
use crate::lab::Moment;

/// What became of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// The error, in the scenario's unit.
    pub error: f64,
    /// How it failed, in a word, where it did; the error is then no measure of anything.
    pub failed: Option<&'static str>,
}

impl Verdict {
    /// An error; one that is no number is a failure.
    #[must_use]
    pub fn of(error: f64) -> Self {
        let failed = (!error.is_finite()).then_some("lost");
        Self { error, failed }
    }

    /// A failure.
    #[must_use]
    pub fn failed(how: &'static str) -> Self {
        Self {
            error: f64::INFINITY,
            failed: Some(how),
        }
    }
}

/// Looks at a run, step by step, and judges it at the end.
pub trait Watch {
    /// After each step.
    fn see(&mut self, now: &Moment);

    /// After the last.
    fn verdict(&self) -> Verdict;
}

/// A scenario. Its scenes are independent runs of which the worst counts.
#[derive(Clone, Copy)]
pub struct Scenario {
    /// As in the reference, 1 to 24; scenarios of one number are told apart by letters, see [`Scenario::heading`].
    pub number: u32,
    /// As `chart scenario_NAME` says it.
    pub name: &'static str,
    /// What happens, in a few words.
    pub title: &'static str,
    /// One sentence: what to look at, and what fails.
    pub watch: &'static str,
    /// What the error is, without its unit.
    pub error: &'static str,
    /// Its unit; empty for a share.
    pub unit: &'static str,
    /// An error of one per cent, in its unit: of what the quantity itself is.
    pub one_percent: f64,
    /// Of what that is one per cent.
    pub scale: &'static str,
    /// The best method's error at 60 Hz must not be larger.
    pub pass: f64,
    /// How a run can fail, and when; that its numbers stop being finite goes without saying.
    pub fails: &'static str,
    /// Steps a second that are tried.
    pub rates: &'static [u32],
    /// Its set-ups at so many steps a second; fewer in a hurry.
    pub scenes: fn(u32, bool) -> Result<Vec<Scene>, FindingsError>,
    /// Who looks at one of them.
    pub watcher: fn(&Scene) -> Box<dyn Watch>,
    /// How long the steps are that make up a run, s; as the scene says if None.
    pub steps: Option<fn(u32) -> Vec<f64>>,
    /// The page of the book that tells more.
    pub page: &'static str,
}

impl Scenario {
    /// Its number and title, `9b. …`: with a letter where several scenarios have the number.
    #[must_use]
    pub fn heading(&self) -> String {
        let same = || SCENARIOS.iter().filter(|one| one.number == self.number);
        let before = same().take_while(|one| one.name != self.name).count();
        let letter = match same().count() {
            1 => None,
            _ => ('a'..='z').nth(before),
        };
        let letter = letter.map(String::from).unwrap_or_default();
        format!("{}{letter}. {}", self.number, self.title)
    }
}

/// For what is cheap.
pub const MANY_RATES: &[u32] = &[30, 60, 120, 240, 480, 960, 1920, 3840, 7680];
/// For single bodies with contacts and joints.
pub const SOME_RATES: &[u32] = &[30, 60, 120, 240, 480, 960];
/// For crowds.
pub const FEW_RATES: &[u32] = &[30, 60, 120, 240];

/// A scene at so many steps a second for so long, s.
#[must_use]
pub fn timed(mut scene: Scene, rate: u32, seconds: f64) -> Scene {
    scene.dt = f64::from(rate).recip();
    scene.steps = (f64::from(rate) * seconds).round() as u32;
    scene
}

/// Judges the state at given times, s; the worst counts. A time between two steps is taken by the nearer.
pub struct AtTimes<E> {
    /// The times, s.
    pub times: Vec<f64>,
    /// The error of a state at one of them.
    pub error: E,
    /// The worst so far.
    pub worst: f64,
    /// How many times have been seen.
    pub seen: usize,
}

impl<E: Fn(&Moment, f64) -> f64> AtTimes<E> {
    /// Nothing seen yet.
    pub fn new(times: impl Into<Vec<f64>>, error: E) -> Self {
        Self {
            times: times.into(),
            error,
            worst: 0.0,
            seen: 0,
        }
    }
}

impl<E: Fn(&Moment, f64) -> f64> Watch for AtTimes<E> {
    fn see(&mut self, now: &Moment) {
        while let Some(&time) = self.times.get(self.seen) {
            if now.time < time - 1e-9 * time.max(1.0) {
                break;
            }
            self.worst = crate::lab::worst([self.worst, (self.error)(now, time)]);
            self.seen += 1;
        }
    }

    fn verdict(&self) -> Verdict {
        if self.seen < self.times.len() {
            return Verdict::failed("short");
        }
        Verdict::of(self.worst)
    }
}

/// Judges every step; the worst counts.
pub struct Always<E> {
    /// The error of a state.
    pub error: E,
    /// The worst so far.
    pub worst: f64,
    /// An error above this is a failure, which has a name.
    pub fails: (f64, &'static str),
}

impl<E: Fn(&Moment) -> f64> Always<E> {
    /// Nothing seen yet.
    pub fn new(error: E, fails: (f64, &'static str)) -> Self {
        Self {
            error,
            worst: 0.0,
            fails,
        }
    }
}

impl<E: Fn(&Moment) -> f64> Watch for Always<E> {
    fn see(&mut self, now: &Moment) {
        self.worst = crate::lab::worst([self.worst, (self.error)(now)]);
    }

    fn verdict(&self) -> Verdict {
        let verdict = Verdict::of(self.worst);
        if verdict.failed.is_none() && self.worst > self.fails.0 {
            let failed = Some(self.fails.1);
            return Verdict { failed, ..verdict };
        }
        verdict
    }
}
