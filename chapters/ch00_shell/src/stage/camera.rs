//! From where the scene is seen, and where in the window.

use glam::Vec2;

use super::Stage;
use crate::camera::{Camera, Ray, Viewport};

impl Stage {
    /// Where in the window the scene is from now on. A camera that nobody has moved keeps
    /// all of the scene in the picture.
    pub fn set_viewport(&mut self, viewport: Viewport) {
        if self.viewport != viewport {
            self.viewport = viewport;
            if !self.is_camera_moved {
                self.move_camera_home();
            }
        }
    }

    /// Where in the window the scene is.
    #[must_use]
    pub fn viewport(&self) -> Viewport {
        self.viewport
    }

    /// Puts the camera where it starts.
    pub fn move_camera_home(&mut self) {
        self.camera = Camera::framing(&self.surroundings, self.viewport);
        if let Some(sight) = self.beside.as_ref().and_then(|runs| runs.sight()) {
            sight.place(&mut self.camera, self.viewport);
        }
        self.is_camera_moved = false;
    }

    /// The camera, to move it.
    pub fn camera_to_move(&mut self) -> &mut Camera {
        self.is_camera_moved = true;
        &mut self.camera
    }

    /// The line of sight through a pixel of the window.
    #[must_use]
    pub fn sight(&self, pixel: Vec2) -> Ray {
        self.camera.ray(self.viewport, pixel)
    }
}
