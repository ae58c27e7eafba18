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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_engine::{CHAPTER, Falls, balls};

    /// A stage with two runs.
    fn stage() -> Stage {
        let mut stage = Stage::new(CHAPTER, balls(3), Pace::Variable, Show::default());
        stage.open_beside(Falls::opening(2));
        stage
    }

    /// The steps of each run.
    fn steps(stage: &Stage) -> Vec<u64> {
        let runs = stage.beside.as_ref().expect("they are shown");
        let views = runs.views();
        let sessions = views.iter().filter_map(|view| view.session);
        sessions.map(crate::Session::steps).collect()
    }

    #[test]
    fn all_make_the_same_steps_of_one_clock_and_the_session_none() {
        let mut stage = stage();
        for _ in 0..5 {
            stage.advance(0.25);
        }
        assert_eq!((steps(&stage), stage.session().steps()), (vec![5, 5], 0));
        stage.toggle_pause();
        stage.advance(0.25);
        assert_eq!(steps(&stage), [5, 5]);
        stage.step_once();
        assert_eq!(steps(&stage), [6, 6]);
        stage.reset();
        assert_eq!(steps(&stage), [0, 0]);
    }

    #[test]
    fn closing_them_leaves_a_session_of_their_scene() {
        let mut stage = stage();
        assert_eq!(stage.session().scene().bodies.len(), 2);
        stage.close_beside();
        stage.advance(0.25);
        assert!(stage.beside.is_none());
        assert_eq!(stage.session().steps(), 1);
    }

    #[test]
    fn the_mouse_is_on_the_scene_in_every_view_but_not_between_them() {
        let mut stage = stage();
        let room = |x| Viewport {
            origin: Vec2::new(x, 0.0),
            size: Vec2::new(100.0, 50.0),
        };
        stage.set_rooms(vec![room(0.0), room(110.0)]);
        let at = |x| stage.is_scene_at(Vec2::new(x, 20.0));
        assert_eq!([50.0, 105.0, 150.0].map(at), [true, false, true]);
        assert_eq!(stage.viewport(), room(0.0));
    }
}
