//! Runs side by side in place of the session: they share the stage's clock, pause and camera.

use glam::Vec2;

use super::Stage;
use crate::camera::Viewport;
use crate::clock::Pace;
use crate::show::Show;
use crate::side_by_side::{Opening, SideBySide};

impl Stage {
    /// Shows these runs from now on. The session becomes one of their scene, for when they are closed.
    pub fn open_beside(&mut self, opening: Opening) {
        let engines = self.chapter.engines;
        self.let_go();
        self.session = opening.session.in_window().with_fallbacks(engines);
        self.notice = None;
        self.is_paused = false;
        self.show_beside(opening.runs);
        self.look_around();
        self.move_camera_home();
        self.after_restart();
    }

    /// Shows these runs, whose scene the session has.
    pub fn show_beside(&mut self, runs: Box<dyn SideBySide>) {
        self.beside = Some(runs);
        self.picked = None;
        self.followed = None;
        self.show = Show::default();
        self.clock.set_pace(Pace::Fixed);
    }

    /// Goes back to the one session.
    pub fn close_beside(&mut self) {
        self.beside = None;
        self.rooms.clear();
        self.move_camera_home();
        self.after_restart();
    }

    /// A frame of the runs that are side by side.
    pub(super) fn advance_beside(&mut self, elapsed: f64) {
        let Some(runs) = &mut self.beside else {
            return;
        };
        if !self.is_paused {
            let frame = self.clock.frame(elapsed, runs.dt(), runs.cost());
            for _ in 0..frame.steps {
                runs.step();
            }
            self.alpha = frame.alpha;
        }
        runs.end_frame();
    }

    /// Where in the window the views are, in their order.
    pub fn set_rooms(&mut self, rooms: Vec<Viewport>) {
        if let Some(first) = rooms.first() {
            self.set_viewport(*first);
        }
        self.rooms = rooms;
    }

    /// Whether the scene, or one of the views of it, is at a pixel of the window.
    #[must_use]
    pub fn is_scene_at(&self, pixel: Vec2) -> bool {
        if self.beside.is_some() {
            return self.rooms.iter().any(|room| room.contains(pixel));
        }
        self.viewport.contains(pixel)
    }
}
