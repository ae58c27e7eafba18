//! Runs side by side for the shell's own tests: falling balls, and one that can't run.

use std::cell::Cell;
use std::rc::Rc;

use super::balls;
use crate::side_by_side::{Opening, SideBySide, View};
use crate::{Gpu, Session};

/// So many runs, and after them one without a session.
pub(crate) struct Falls {
    pub sessions: Vec<Session>,
    /// Frames that have ended.
    pub frames: Rc<Cell<u32>>,
}

impl Falls {
    /// So many runs of two balls.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            sessions: (0..count).map(|_| balls(2)).collect(),
            frames: Rc::default(),
        }
    }

    /// The same, to be shown.
    pub(crate) fn opening(count: usize) -> Opening {
        Opening {
            runs: Box::new(Self::new(count)),
            session: balls(2),
        }
    }
}

impl SideBySide for Falls {
    fn views(&self) -> Vec<View<'_>> {
        let runs = self.sessions.iter().map(|session| View {
            name: "a fall".to_owned(),
            color: [200, 100, 0],
            text: format!("step {}", session.steps()),
            trouble: None,
            session: Some(session),
        });
        let refused = View {
            name: "no fall".to_owned(),
            color: [0, 100, 200],
            text: String::new(),
            trouble: Some("it floats".to_owned()),
            session: None,
        };
        runs.chain([refused]).collect()
    }

    fn dt(&self) -> f64 {
        self.sessions[0].dt()
    }

    fn cost(&self) -> f64 {
        0.0
    }

    fn step(&mut self) {
        self.sessions.iter_mut().for_each(Session::step);
    }

    fn end_frame(&mut self) {
        self.frames.set(self.frames.get() + 1);
    }

    fn reset(&mut self) {
        for session in &mut self.sessions {
            session.reset().expect("it was loaded before");
        }
    }

    fn move_to(&mut self, _: &Gpu) {}

    fn show_panel(&mut self, ui: &mut egui::Ui) {
        ui.label("who falls");
    }

    fn show_plots(&mut self, ui: &mut egui::Ui) {
        ui.label("how far");
    }
}
