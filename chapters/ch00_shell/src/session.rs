//! A running scene: the scene, the engine that steps it, where its bodies were and are, and
//! how well energy and momentum were kept. No window, no GPU and no overlay in it, so that
//! the window, the headless runner and the tests run exactly the same steps.

mod hands;
mod late;
mod moments;
#[cfg(test)]
mod tests;

use std::time::Duration;

use ch00_scenes::measures::Conserved;
use ch00_scenes::{Engine, EngineEntry, LoadError, Scene, Settings, State};
use glam::{DQuat, DVec3};
use web_time::Instant;

use crate::history::History;
use moments::{Moment, Moments};

/// A scene on an engine, at some step.
pub struct Session {
    /// The scene as it was loaded: bodies come and go in [`Self::scene`].
    loaded: Scene,
    scene: Scene,
    entry: EngineEntry,
    settings: Settings,
    engine: Box<dyn Engine>,
    /// Engines to go on with when this one fails.
    fallbacks: &'static [EngineEntry],
    /// Whether no step may wait for a device.
    is_in_window: bool,
    /// The state one step before [`Self::now`], or the one known before it if that is late.
    before: State,
    now: State,
    /// When the bodies were where [`Self::now`] says.
    seen: Moment,
    moments: Moments,
    /// Whether a state was asked for and hasn't come.
    has_asked: bool,
    steps_at_look: u64,
    time: f64,
    steps: u64,
    step_time: Duration,
    history: History,
    /// The step that was measured last.
    measured: u64,
    /// Bodies with a number that is not finite, when they were measured last.
    not_finite: usize,
    /// Up to which step a body was dragged.
    pulled_until: u64,
    /// How often the engine's rows may have changed.
    revision: u64,
    /// Why the engine can't go on, if no other one can.
    failure: Option<String>,
    notice: Option<String>,
}

impl Session {
    /// Loads the scene into the engine; the step size is the scene's.
    ///
    /// # Errors
    /// [`LoadError`] where the engine can't take the scene or the settings.
    pub fn new(scene: Scene, entry: EngineEntry, settings: Settings) -> Result<Self, LoadError> {
        let engine = (entry.load)(&scene, &settings)?;
        let now = read(engine.as_ref());
        let moments = Moments::start();
        Ok(Self {
            history: History::new(&scene),
            loaded: scene.clone(),
            scene,
            entry,
            settings,
            engine,
            fallbacks: &[],
            is_in_window: false,
            before: now.clone(),
            not_finite: now.not_finite(),
            now,
            seen: moments.of(0),
            moments,
            has_asked: false,
            steps_at_look: 0,
            time: 0.0,
            steps: 0,
            step_time: Duration::ZERO,
            measured: 0,
            pulled_until: 0,
            revision: 0,
            failure: None,
            notice: None,
        })
    }

    /// Makes one step of `dt` seconds and reads the new state; where that would have to be waited for
    /// in a window, [`Self::look`] reads it later. If the engine fails, another one makes the step.
    ///
    /// `dt` must be positive and finite.
    pub fn step_by(&mut self, dt: f64) {
        if self.failure.is_some() {
            return;
        }
        self.step_time = self.advance(dt);
        if self.check_engine() {
            if self.failure.is_some() {
                return;
            }
            self.step_time = self.advance(dt);
        }
        self.time += dt;
        self.steps += 1;
        self.moments.note(self.steps, self.time);
        if !self.is_late() {
            let last = self.seen.step;
            self.read_state();
            self.measure(last);
        }
    }

    /// Makes one step of the scene's own size.
    pub fn step(&mut self) {
        self.step_by(self.scene.dt);
    }

    /// Starts the scene again with the same engine, settings and step size; bodies thrown in are
    /// gone, removed ones are back, edits are forgotten.
    ///
    /// # Errors
    /// [`LoadError`] where the engine can't be loaded again; the session then stays as it is.
    pub fn reset(&mut self) -> Result<(), LoadError> {
        let scene = self.scene_at_start();
        let revision = self.revision + 1;
        *self = Self {
            revision,
            fallbacks: self.fallbacks,
            is_in_window: self.is_in_window,
            ..Self::new(scene, self.entry, self.settings.clone())?
        };
        Ok(())
    }

    /// Goes on from the same state with another engine, or the same one with other settings.
    /// A body that was being dragged is let go.
    ///
    /// # Errors
    /// [`LoadError`] where it can't take the scene or the settings; the session then goes on
    /// as before.
    pub fn change_engine(
        &mut self,
        entry: EngineEntry,
        settings: Settings,
    ) -> Result<(), LoadError> {
        let mut engine = (entry.load)(&self.scene, &settings)?;
        self.catch_up();
        engine.write_state(&self.now, self.scene.dt as f32);
        self.engine = engine;
        self.entry = entry;
        self.settings = settings;
        self.failure = None;
        self.has_asked = false;
        self.pulled_until = self.pulled_until.min(self.steps);
        self.reread();
        Ok(())
    }

    /// Sets the step size from the next step on, s; it must be positive and finite.
    pub fn set_dt(&mut self, dt: f64) {
        self.scene.dt = dt;
    }

    /// Where a body is drawn: `alpha` of the way from the last state but one (0) to the last
    /// (1); about there while the last is late. Position in m; body to world.
    ///
    /// # Panics
    /// If there is no such body.
    #[must_use]
    pub fn pose(&self, body: usize, alpha: f64) -> (DVec3, DQuat) {
        if self.is_late() {
            return self.carried_on(body, alpha);
        }
        let position = self.before.position[body].lerp(self.now.position[body], alpha);
        let orientation = self.before.orientation[body].lerp(self.now.orientation[body], alpha);
        (position, orientation)
    }

    /// The scene as it was loaded, with the step's size as it is now.
    #[must_use]
    pub fn scene_at_start(&self) -> Scene {
        Scene {
            dt: self.scene.dt,
            ..self.loaded.clone()
        }
    }

    /// The scene as it is now, with the bodies thrown in and without those removed.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The engine, for its columns, contacts, layers, pass times and counters.
    #[must_use]
    pub fn engine(&self) -> &dyn Engine {
        self.engine.as_ref()
    }

    /// The engine's entry in the chapter's list.
    #[must_use]
    pub fn entry(&self) -> EngineEntry {
        self.entry
    }

    /// What the user chose.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The state one step ago; the same as [`Self::state_now`] before the first step, and where that is
    /// late, as it has none to be interpolated with.
    #[must_use]
    pub fn state_before(&self) -> &State {
        if self.is_late() {
            &self.now
        } else {
            &self.before
        }
    }

    /// The state after the last step, or the last one that has come back.
    #[must_use]
    pub fn state_now(&self) -> &State {
        &self.now
    }

    /// Step size, s.
    #[must_use]
    pub fn dt(&self) -> f64 {
        self.scene.dt
    }

    /// Simulated time since the start, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Steps since the start.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Wall time of the last step: the engine alone, without reading or measuring. In a window a step
    /// on a device is only handed over in it.
    #[must_use]
    pub fn step_time(&self) -> Duration {
        self.step_time
    }

    /// What a step costs: its wall time, or that on a device which makes it meanwhile, as far as it has
    /// said how long it took.
    #[must_use]
    pub fn cost(&self) -> Duration {
        if !self.is_late() {
            return self.step_time;
        }
        let passes = self.engine.pass_times();
        let on_device = passes.iter().map(|pass| pass.time).sum();
        self.step_time.max(on_device)
    }

    /// A number that changes whenever the engine's rows may have: what was worked out from them
    /// under the same number still holds.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Energy and momentum errors so far.
    #[must_use]
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Bodies with a number that is not finite, in the state that was measured last.
    #[must_use]
    pub fn not_finite(&self) -> usize {
        self.not_finite
    }

    /// The engine's step and nothing else; gives its wall time.
    fn advance(&mut self, dt: f64) -> Duration {
        let start = Instant::now();
        self.engine.step(dt as f32);
        if !self.is_late() {
            self.engine.finish();
        }
        self.revision += 1;
        start.elapsed()
    }

    fn read_state(&mut self) {
        std::mem::swap(&mut self.before, &mut self.now);
        self.engine.read_state(&mut self.now);
        self.seen = self.moments.of(self.steps);
    }

    /// After something other than a step has changed the state there is nothing to
    /// interpolate.
    fn reread(&mut self) {
        self.engine.read_state(&mut self.now);
        self.before.clone_from(&self.now);
        self.seen = self.moments.of(self.steps);
        self.revision += 1;
    }

    /// Measures the state that is known now; the one known before it was of step `last`.
    fn measure(&mut self, last: u64) {
        if last < self.pulled_until {
            let before = Conserved::of(&self.scene, &self.before);
            self.history.forgive(&before, &self.sums());
        }
        if self.history.is_due(self.measured, self.seen.step) {
            self.measured = self.seen.step;
            self.not_finite = self.now.not_finite();
            self.history.record(&self.scene, &self.now, self.seen.time);
        }
    }

    fn sums(&self) -> Conserved {
        Conserved::of(&self.scene, &self.now)
    }
}

fn read(engine: &dyn Engine) -> State {
    let mut state = State::default();
    engine.read_state(&mut state);
    state
}
