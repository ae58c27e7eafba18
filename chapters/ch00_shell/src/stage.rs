//! What the window shows and what its user can do about it: the session with its clock, what
//! is paused, picked, pulled and drawn. Keys, mouse and overlay all act through this one
//! type, and it knows none of them.

mod beside;
mod camera;
mod editing;
mod following;
mod hands;
mod looking;

use std::time::Duration;

use ch00_scenes::{EngineEntry, Pull, Scene, Settings};

use crate::camera::{Camera, Viewport};
use crate::clock::{Clock, Pace};
use crate::edits::Edits;
use crate::frame_rate::FrameRate;
use crate::gpu::Gpu;
use crate::render::{Surroundings, Theme};
use crate::resident::Resident;
use crate::show::Show;
use crate::side_by_side::SideBySide;
use crate::{Chapter, Session, ShellError};

pub use editing::PAUSE_FIRST;
pub use following::Followed;

/// A session in a window.
pub struct Stage {
    /// What there is to choose from.
    pub chapter: Chapter,
    /// The scene as it was loaded.
    loaded: Scene,
    session: Session,
    clock: Clock,
    alpha: f64,
    /// Whether time stands still.
    pub is_paused: bool,
    /// From where the scene is seen.
    pub camera: Camera,
    /// Whether the camera has been moved from where it starts.
    is_camera_moved: bool,
    /// Where in the window the scene is; of several views, the first.
    viewport: Viewport,
    /// Runs that are shown in place of the session.
    pub beside: Option<Box<dyn SideBySide>>,
    /// Where in the window each of them is.
    rooms: Vec<Viewport>,
    /// Frames as they come.
    pub frame_rate: FrameRate,
    /// Colours of the picture.
    pub theme: Theme,
    /// What is shown besides the bodies.
    pub show: Show,
    /// Whether the left panel is there.
    pub shows_overlay: bool,
    /// The body that was clicked last.
    pub picked: Option<usize>,
    pull: Option<Pull>,
    /// The row that table and camera stay with.
    followed: Option<Followed>,
    /// What was changed by hand, to be undone.
    edits: Edits,
    thrown: u32,
    surroundings: Surroundings,
    /// How often the surroundings have changed.
    generation: u32,
    /// What the user should know: an error, mostly.
    pub notice: Option<String>,
    /// From the program's start to the first frame.
    pub start_up: Option<Duration>,
    /// Name of the adapter that draws.
    pub adapter: String,
}

impl Stage {
    /// A session about to start.
    #[must_use]
    pub fn new(chapter: Chapter, session: Session, pace: Pace, show: Show) -> Self {
        let session = session.in_window();
        let surroundings = Surroundings::of(session.scene());
        let viewport = Viewport::whole([1280, 720]);
        Self {
            chapter,
            loaded: session.scene().clone(),
            camera: Camera::framing(&surroundings, viewport),
            is_camera_moved: false,
            viewport,
            beside: None,
            rooms: Vec::new(),
            surroundings,
            session,
            clock: Clock::new(pace),
            alpha: 1.0,
            is_paused: false,
            frame_rate: FrameRate::of_window(),
            theme: Theme::default(),
            show,
            shows_overlay: true,
            picked: None,
            pull: None,
            followed: None,
            edits: Edits::default(),
            thrown: 0,
            generation: 0,
            notice: None,
            start_up: None,
            adapter: String::new(),
        }
    }

    /// The session.
    #[must_use]
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The clock.
    #[must_use]
    pub fn clock(&self) -> &Clock {
        &self.clock
    }

    /// How far between the last two states to draw. Layers and pairs show the last state, and
    /// the bodies with them.
    #[must_use]
    pub fn alpha(&self) -> f64 {
        if !self.show.is_any() && self.pull.is_none() {
            self.alpha
        } else {
            1.0
        }
    }

    /// The mouse's spring, if it holds a body.
    #[must_use]
    pub fn pulled(&self) -> Option<&Pull> {
        self.pull.as_ref()
    }

    /// What stands around the bodies, and a number that changes when it does.
    #[must_use]
    pub fn surroundings(&self) -> (&Surroundings, u32) {
        (&self.surroundings, self.generation)
    }

    /// A number pair that changes whenever rows of the engine's tables may have.
    #[must_use]
    pub fn revision(&self) -> (u32, u64) {
        (self.generation, self.session.revision())
    }

    /// A frame that begins `elapsed` seconds after the last one.
    pub fn advance(&mut self, elapsed: f64) {
        if self.beside.is_some() {
            return self.advance_beside(elapsed);
        }
        if !self.is_paused {
            let cost = self.session.cost().as_secs_f64();
            let frame = self.clock.frame(elapsed, self.session.dt(), cost);
            for _ in 0..frame.steps {
                self.session.step_by(frame.dt);
            }
            self.alpha = frame.alpha;
        }
        self.session.look();
        self.hear_of_failure();
        self.keep_following();
    }

    /// Says so where the engine has failed and another one went on, or none could.
    fn hear_of_failure(&mut self) {
        if let Some(notice) = self.session.take_notice() {
            self.tell(&notice);
            self.is_paused |= self.session.failure().is_some();
            self.pull = None;
            self.edits.clear();
            self.show.keep_possible(&self.session);
        }
    }

    /// Tells the user something, after what is still to be read.
    pub fn tell(&mut self, text: &str) {
        self.notice = Some(match self.notice.take() {
            Some(before) => format!("{before}\n{text}"),
            None => text.to_owned(),
        });
    }

    /// The window draws with this device from now on. An engine that keeps its bodies on another one
    /// is loaded again, so that the window can draw from them.
    pub fn move_to(&mut self, gpu: &Gpu) {
        let is_elsewhere = |resident: &Resident| resident.gpu.device != gpu.device;
        let has_failed = self.session.engine().failure().is_some();
        if !has_failed && self.session.resident().is_some_and(is_elsewhere) {
            let settings = self.session.settings().clone();
            self.change_engine(self.session.entry(), settings);
        }
        if let Some(runs) = &mut self.beside {
            runs.move_to(gpu);
        }
    }

    /// Stops time, or lets it go on.
    pub fn toggle_pause(&mut self) {
        self.is_paused = !self.is_paused;
        self.clock.restart();
    }

    /// Makes one step and stops there.
    pub fn step_once(&mut self) {
        self.is_paused = true;
        match &mut self.beside {
            Some(runs) => runs.step(),
            None => self.session.step(),
        }
        self.alpha = 1.0;
    }

    /// Starts the scene again.
    pub fn reset(&mut self) {
        self.let_go();
        if let Some(runs) = &mut self.beside {
            runs.reset();
            return self.after_restart();
        }
        let body = self.followed_body();
        let outcome = self.session.reset();
        if outcome.is_ok() {
            self.name_as_loaded();
            self.follow_body(body.map(|body| self.surroundings.number(body)));
            self.look_around();
        }
        self.report(outcome.map_err(ShellError::from));
        self.after_restart();
    }

    /// From steps of one size to steps as long as frames are, or back.
    pub fn toggle_pace(&mut self) {
        self.clock.set_pace(match self.clock.pace() {
            Pace::Fixed => Pace::Variable,
            Pace::Variable => Pace::Fixed,
        });
        self.alpha = 1.0;
    }

    /// Sets the step's size, s.
    pub fn set_dt(&mut self, dt: f64) {
        self.session.set_dt(dt);
        self.clock.restart();
    }

    /// Starts a built-in scene, or the one that the program was started with, on the same
    /// engine. Where the method can't run it, the engine's default gets a try.
    pub fn change_scene(&mut self, name: &str, count: Option<u64>) {
        match self.load(name, count) {
            Ok(session) => {
                self.session = session;
                self.picked = None;
                self.show.pair = None;
                self.pull = None;
                self.followed = None;
                self.notice = None;
                self.look_around();
                self.move_camera_home();
                self.after_restart();
            }
            Err(error) => self.report(Err(error)),
        }
    }

    fn load(&self, name: &str, count: Option<u64>) -> Result<Session, ShellError> {
        let scene = self.open(name, count)?;
        let (entry, settings) = (self.session.entry(), self.session.settings().clone());
        let session = Session::new(scene.clone(), entry, settings)
            .or_else(|_| Session::new(scene, entry, Settings::defaults()))?;
        Ok(session.in_window().with_fallbacks(self.chapter.engines))
    }

    fn open(&self, name: &str, count: Option<u64>) -> Result<Scene, ShellError> {
        let is_built_in = self.chapter.scenes.contains(&name);
        if name == self.loaded.name && !is_built_in {
            return Ok(self.loaded.clone());
        }
        Ok(Scene::open(name, count, None)?)
    }

    /// The name of the scene that the program was started with.
    #[must_use]
    pub fn loaded_name(&self) -> &str {
        &self.loaded.name
    }

    /// Goes on from the same state with another engine or other settings.
    pub fn change_engine(&mut self, entry: EngineEntry, settings: Settings) {
        self.let_go();
        let body = self.followed_body();
        let outcome = self.session.change_engine(entry, settings);
        if outcome.is_ok() {
            self.edits.clear();
            self.follow_body(body);
        }
        self.report(outcome.map_err(ShellError::from));
        self.show.keep_possible(&self.session);
    }

    /// Names picked bodies as the scene does that is there again, with those that were removed.
    fn name_as_loaded(&mut self) {
        let around = &self.surroundings;
        self.picked = self.picked.map(|body| around.number(body));
        if let Some(pair) = &mut self.show.pair {
            pair.bodies = pair.bodies.map(|body| around.number(body));
        }
    }

    /// Looks at the scene as it starts.
    fn look_around(&mut self) {
        self.surroundings = Surroundings::of(self.session.scene());
        self.generation += 1;
    }

    fn after_restart(&mut self) {
        self.clock.restart();
        self.edits.clear();
        self.alpha = 1.0;
        let count = self.session.scene().bodies.len();
        self.picked = self.picked.filter(|&i| i < count);
        self.show.keep_possible(&self.session);
    }

    fn report(&mut self, outcome: Result<(), ShellError>) {
        self.notice = outcome.err().map(|error| error.to_string());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_engine::{CHAPTER, FALLING};

    pub(super) fn stage() -> Stage {
        let scene = Scene::open("pair", None, None).expect("`pair` is built in");
        let session = Session::new(scene, FALLING, Settings::defaults()).expect("it can fall");
        Stage::new(CHAPTER, session, Pace::Fixed, Show::default())
    }

    #[test]
    fn time_stands_still_while_paused_but_for_single_steps() {
        let mut stage = stage();
        stage.toggle_pause();
        stage.advance(1.0);
        assert_eq!(stage.session().steps(), 0);
        stage.step_once();
        assert_eq!(stage.session().steps(), 1);
        assert!(stage.is_paused);
    }

    #[test]
    fn an_unknown_scene_leaves_the_old_one_and_says_so() {
        let mut stage = stage();
        stage.change_scene("nothing", None);
        assert_eq!(stage.session().scene().name, "pair");
        assert!(stage.notice.is_some_and(|text| text.contains("nothing")));
    }

    #[test]
    fn another_scene_has_other_surroundings() {
        let mut stage = stage();
        let (_, before) = stage.surroundings();
        stage.change_scene("bounce", None);
        let (surroundings, after) = stage.surroundings();
        assert_ne!(before, after);
        assert!(surroundings.has_floor);
    }
}
