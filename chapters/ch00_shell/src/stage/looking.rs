//! What a window's user can do about the engine's inner state: show layers, choose a pair of
//! bodies, and go through the iterations of its narrow phase.

use ch00_scenes::Layer;

use super::Stage;
use crate::camera::Ray;
use crate::show::{Pair, worth_looking_at};

impl Stage {
    /// Shows a layer or takes it away, if the engine has it.
    pub fn toggle_layer(&mut self, layer: Layer) {
        if self.session.engine().layers().contains(&layer) {
            self.show.toggle(layer);
        }
    }

    /// Looks at the narrow phase of a pair from now on. Time stops, as iterations of one moment
    /// are of interest.
    pub fn look_at(&mut self, bodies: [usize; 2]) {
        let count = self.session.scene().bodies.len();
        if bodies.iter().any(|&i| i >= count) {
            return; // one of them was removed after the contact was found
        }
        if !self.is_paused {
            self.toggle_pause();
        }
        let last = self.show.pair;
        let pair = Pair::new(bodies);
        self.show.pair = Some(Pair {
            turn: last.map_or(pair.turn, |last| last.turn),
            ..pair
        });
    }

    /// Looks at the picked body and the one under a line of sight; without a picked body, picks
    /// that one.
    pub fn pick_partner(&mut self, sight: Ray) {
        let Some(hit) = self.under(sight).filter(|_| self.beside.is_none()) else {
            return;
        };
        match self.picked {
            Some(first) if first != hit.body => self.look_at([first, hit.body]),
            _ => self.picked = Some(hit.body),
        }
    }

    /// Looks at a pair that is worth it, of the picked body if there is one; or stops looking.
    pub fn toggle_pair(&mut self) {
        if self.show.pair.take().is_some() {
            return;
        }
        match worth_looking_at(&self.session, self.picked) {
            Some(bodies) => self.look_at(bodies),
            None => {
                self.notice = Some(
                    "no two bodies are near each other now: click one and Shift-click another"
                        .to_owned(),
                );
            }
        }
    }

    /// Goes so many iterations on, or back; far enough goes to the first or the last.
    pub fn move_step(&mut self, by: isize) {
        if let Some(mut pair) = self.show.pair
            && let Some(dissection) = pair.dissect(&self.session)
        {
            pair.move_step(by, &dissection);
            self.show.pair = Some(pair);
        }
    }

    /// Moves the camera so that the pair fills the picture, or else the picked body and what is
    /// around it.
    pub fn move_camera_near(&mut self) {
        let corners = match (&self.show.pair, self.picked) {
            (Some(pair), _) => pair.corners(&self.session),
            (None, Some(body)) => {
                let radius = self.session.scene().bodies[body].shape.bounding_radius();
                let centre = self.session.state_now().position[body];
                let room = 2.0 * radius;
                ((centre - room).as_vec3(), (centre + room).as_vec3())
            }
            (None, None) => return,
        };
        let viewport = self.viewport();
        self.camera_to_move().frame(corners.0, corners.1, viewport);
    }
}
