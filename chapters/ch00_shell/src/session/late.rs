//! A run whose bodies stay on a device: their states come back some frames late, so that no frame
//! waits for them, and a device may be lost.
//!
//! Without a window every step's state is waited for. In one, an engine that can be drawn from where it
//! keeps its bodies ([`Engine::resident`]) is only glanced at, once a frame.

use ch00_scenes::{Engine, EngineEntry, Settings};
use glam::{DQuat, DVec3};

use super::Session;
use crate::resident::Resident;

/// The engine that takes over when another one fails: it needs no device.
const FALLBACK: &str = "lanes";

/// For longer than this a late position is not carried on, s.
const MOST_AHEAD: f64 = 0.1;

impl Session {
    /// The same in a window, where no step waits for a device.
    #[must_use]
    pub fn in_window(mut self) -> Self {
        self.is_in_window = true;
        self
    }

    /// The same with engines to go on with if its own fails.
    #[must_use]
    pub fn with_fallbacks(mut self, engines: &'static [EngineEntry]) -> Self {
        self.fallbacks = engines;
        self
    }

    /// Takes over what has come back since the last frame, if anything has, and asks for more. To be
    /// called once a frame, also while time stands still; it never waits.
    pub fn look(&mut self) {
        let stands_still = self.steps == self.steps_at_look;
        self.steps_at_look = self.steps;
        self.moments.show_frame();
        self.check_engine();
        if !self.is_late() {
            return;
        }
        // The first glance may find what was asked for, the second then asks for the next.
        for _ in 0..2 {
            let behind = self.steps - self.seen.step;
            let is_due = behind >= self.history.every()
                || (stands_still && behind > 0)
                || self.engine.lacks_cells();
            if !is_due && !self.has_asked {
                return;
            }
            let Some(age) = self.engine.glance(&mut self.before) else {
                self.has_asked = true;
                return;
            };
            self.has_asked = false;
            self.take_over(age);
        }
    }

    /// Whether the state that is known may be older than the bodies that are drawn.
    #[must_use]
    pub fn is_late(&self) -> bool {
        self.is_in_window && self.engine.resident().is_some()
    }

    /// How many frames ago the bodies were where [`Self::state_now`] says; 0 while that is the last
    /// step's state.
    #[must_use]
    pub fn frames_late(&self) -> u64 {
        if self.seen.step == self.steps {
            return 0;
        }
        self.moments.frames_since(self.seen).max(1)
    }

    /// The rows to draw the bodies from, if the engine keeps them on a device.
    #[must_use]
    pub fn resident(&self) -> Option<&Resident> {
        self.engine.resident()?.downcast_ref()
    }

    /// Why the run can't go on: its engine has failed, and there is no other one.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// What the user should know and hasn't been told.
    pub fn take_notice(&mut self) -> Option<String> {
        self.notice.take()
    }

    /// A late position, carried on to the moment that is drawn: close enough to pick and to follow a
    /// body by.
    pub(super) fn carried_on(&self, body: usize, alpha: f64) -> (DVec3, DQuat) {
        let drawn = self.time - (1.0 - alpha) * self.scene.dt;
        let ahead = (drawn - self.seen.time).clamp(-MOST_AHEAD, MOST_AHEAD);
        let position = self.now.position[body] + ahead * self.now.linear_velocity[body];
        (position, self.now.orientation[body])
    }

    /// A state that has come back, so many steps old. One of other bodies was asked for before these came or
    /// went.
    fn take_over(&mut self, age: u64) {
        let step = self.steps.saturating_sub(age);
        if self.before.len() != self.scene.bodies.len() || step < self.seen.step {
            return;
        }
        std::mem::swap(&mut self.before, &mut self.now);
        let last = self.seen;
        self.seen = self.moments.of(step);
        self.revision += 1;
        self.measure(last.step);
    }

    /// Reads the last step's state, which an engine on a device has to wait for.
    pub(super) fn catch_up(&mut self) {
        if self.seen.step < self.steps && self.engine.failure().is_none() {
            let last = self.seen.step;
            self.read_state();
            self.measure(last);
        }
    }

    /// Goes on with another engine if this one has failed; whether it has.
    pub(super) fn check_engine(&mut self) -> bool {
        let why = self.engine.failure().filter(|_| self.failure.is_none());
        let Some(why) = why else {
            return false;
        };
        let failed = self.entry.name;
        let told = if let Some((entry, engine)) = self.replacement() {
            self.go_on_with(entry, engine);
            format!(
                "The engine `{failed}` failed: {why}. `{}` goes on after step {}, whose state came back \
                 last",
                entry.name, self.steps
            )
        } else {
            let told =
                format!("The engine `{failed}` failed: {why}. No other engine can go on here");
            self.failure = Some(told.clone());
            told
        };
        self.notice = Some(told);
        true
    }

    /// The first other engine that takes the scene.
    fn replacement(&self) -> Option<(EngineEntry, Box<dyn Engine>)> {
        let others = || {
            self.fallbacks
                .iter()
                .filter(|entry| entry.name != self.entry.name)
        };
        let first = others().filter(|entry| entry.name == FALLBACK);
        let rest = others().filter(|entry| entry.name != FALLBACK);
        first.chain(rest).find_map(|entry| {
            let engine = (entry.load)(&self.scene, &Settings::defaults()).ok()?;
            Some((*entry, engine))
        })
    }

    /// Takes a replacement into the last state that is known, and goes back to when that was.
    fn go_on_with(&mut self, entry: EngineEntry, mut engine: Box<dyn Engine>) {
        engine.write_state(&self.now, self.scene.dt as f32);
        self.engine = engine;
        self.entry = entry;
        self.settings = Settings::defaults();
        (self.steps, self.time) = (self.seen.step, self.seen.time);
        self.moments.go_back_to(self.seen);
        self.pulled_until = 0;
        self.has_asked = false;
        self.reread();
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{Pull, Scene};

    use super::*;
    use crate::test_engine::{
        FALLING, GLANCES, RESIDENT, ball, lose_device, resident_balls, scene_of_balls,
    };

    const BOTH: &[EngineEntry] = &[RESIDENT, FALLING];

    fn height(session: &Session) -> f64 {
        session.state_now().position[0].y
    }

    /// A frame with so many steps.
    fn frame(session: &mut Session, steps: u32) {
        for _ in 0..steps {
            session.step();
        }
        session.look();
    }

    /// Frames until the state of the last step has come back.
    fn settle(session: &mut Session) {
        for _ in 0..2 * GLANCES + 2 {
            frame(session, 0);
        }
    }

    #[test]
    fn without_a_window_each_steps_state_is_waited_for() {
        let scene = scene_of_balls(1);
        let mut session = Session::new(scene, RESIDENT, Settings::defaults()).expect("it falls");
        session.step();
        assert_eq!((height(&session), session.frames_late()), (9.75, 0));
        assert!(!session.is_late());
    }

    #[test]
    fn in_a_window_states_come_back_some_frames_late_and_say_so() {
        let mut session = resident_balls(1);
        let mut lateness = Vec::new();
        for _ in 0..6 {
            frame(&mut session, 1);
            lateness.push((height(&session), session.frames_late()));
        }
        // Asked for after the first step, there three frames later; in that frame the next is asked for.
        let start = (1..=3).map(|late| (10.0, late));
        let first = (3..=5).map(|late| (9.75, late));
        assert_eq!(lateness, start.chain(first).collect::<Vec<_>>());
    }

    #[test]
    fn while_time_stands_still_the_last_state_comes_back() {
        let mut session = resident_balls(1);
        for _ in 0..3 {
            frame(&mut session, 1);
        }
        settle(&mut session);
        assert_eq!((height(&session), session.frames_late()), (7.75, 0));
        assert_eq!(session.state_before(), session.state_now());
    }

    #[test]
    fn a_late_body_is_looked_for_where_it_has_moved_to_meanwhile() {
        let mut scene = scene_of_balls(1);
        scene.dt = 1.0 / 64.0;
        scene.bodies[0].linear_velocity.x = 4.0;
        let session = Session::new(scene, RESIDENT, Settings::defaults()).expect("it falls");
        let mut session = session.in_window();
        for _ in 0..5 {
            frame(&mut session, 1);
        }
        assert!(session.frames_late() > 0);
        let across = |alpha| session.pose(0, alpha).0.x;
        assert_eq!(
            [0.0, 0.5, 1.0].map(across),
            [4.0, 4.5, 5.0].map(|steps| steps / 16.0)
        );
    }

    #[test]
    fn late_states_are_measured_once_and_at_their_own_time() {
        let mut session = resident_balls(1);
        for _ in 0..10 {
            frame(&mut session, 1);
        }
        settle(&mut session);
        let samples = session.history().samples();
        let times: Vec<f64> = samples.iter().map(|sample| sample.time).collect();
        assert_eq!(times, [0.0, 0.25, 1.0, 1.75, 2.5]);
        let errors = samples.iter().filter_map(|sample| sample.energy_error);
        assert!(errors.map(f64::abs).fold(0.0, f64::max) < 1e-6);
    }

    #[test]
    fn hands_see_the_last_state_and_not_a_late_one() {
        let mut session = resident_balls(1);
        frame(&mut session, 1);
        frame(&mut session, 1);
        session.add_body(ball(1.0)).expect("there is room");
        assert_eq!((height(&session), session.state_now().len()), (9.0, 2));
        frame(&mut session, 1);
        settle(&mut session);
        assert_eq!(height(&session), 7.75);
        let last = session.history().samples().back().expect("measured");
        assert!(last.energy_error.is_some_and(|error| error.abs() < 1e-6));
    }

    #[test]
    fn what_happened_while_a_body_was_dragged_is_no_error_when_it_comes_back_later() {
        let mut session = resident_balls(1);
        let heavy = Settings::defaults().with_method("heavy");
        session.change_engine(RESIDENT, heavy).expect("it has that");
        session.pull(Some(Pull {
            body: 0,
            anchor: DVec3::ZERO,
            target: DVec3::ZERO,
        }));
        frame(&mut session, 1);
        session.pull(None);
        settle(&mut session);
        let last = session.history().samples().back().expect("measured");
        assert!(last.energy_error.is_some_and(|error| error.abs() < 1e-6));
    }

    #[test]
    fn another_engine_goes_on_from_the_last_step() {
        let mut session = resident_balls(1);
        frame(&mut session, 2);
        session
            .change_engine(FALLING, Settings::defaults())
            .expect("it is there");
        assert_eq!((height(&session), session.steps()), (9.0, 2));
        frame(&mut session, 1);
        assert_eq!((height(&session), session.frames_late()), (7.75, 0));
    }

    #[test]
    fn after_a_loss_another_engine_goes_on_from_the_state_that_came_back_last() {
        let mut session = resident_balls(1).with_fallbacks(BOTH);
        for _ in 0..4 {
            frame(&mut session, 1);
        }
        assert_eq!((height(&session), session.steps()), (9.75, 4));
        lose_device();
        frame(&mut session, 1);
        assert_eq!(session.entry().name, FALLING.name);
        let state = (height(&session), session.steps(), session.time());
        assert_eq!(state, (9.0, 2, 0.5), "one step after the first");
        let notice = session.take_notice().expect("it is said");
        for part in [
            "`resident` failed",
            "lost",
            "`falling` goes on after step 1",
        ] {
            assert!(notice.contains(part), "{notice}");
        }
        frame(&mut session, 1);
        assert_eq!((session.take_notice(), session.failure()), (None, None));
    }

    #[test]
    fn without_a_window_a_loss_costs_no_step() {
        let scene = scene_of_balls(1);
        let mut session = Session::new(scene, RESIDENT, Settings::defaults())
            .expect("it falls")
            .with_fallbacks(BOTH);
        session.step();
        lose_device();
        session.step();
        assert_eq!((height(&session), session.steps()), (9.0, 2));
        assert!(session.take_notice().is_some());
    }

    #[test]
    fn a_loss_while_time_stands_still_is_noticed_too() {
        let mut session = resident_balls(1).with_fallbacks(BOTH);
        lose_device();
        frame(&mut session, 0);
        assert_eq!(session.entry().name, FALLING.name);
    }

    #[test]
    fn where_no_other_engine_can_go_on_the_run_stops_and_says_so() {
        let mut session = resident_balls(1).with_fallbacks(&[RESIDENT]);
        frame(&mut session, 1);
        lose_device();
        frame(&mut session, 1);
        assert_eq!(session.steps(), 1);
        assert!(session.failure().is_some_and(|why| why.contains("lost")));
        assert!(session.take_notice().is_some());
        session.reset().expect("another device is opened");
        frame(&mut session, 1);
        assert_eq!((session.steps(), session.failure()), (1, None));
    }

    #[test]
    fn an_empty_scene_can_be_late_too() {
        let scene = Scene::new("empty");
        let session = Session::new(scene, RESIDENT, Settings::defaults()).expect("it fits");
        let mut session = session.in_window();
        frame(&mut session, 1);
        settle(&mut session);
        assert_eq!(session.frames_late(), 0);
    }
}
