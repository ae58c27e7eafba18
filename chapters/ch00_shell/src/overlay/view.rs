//! In which colours the scene is drawn, how large it is, and by what.

use super::Section;
use crate::render::{Theme, grid_cell};
use crate::stage::Stage;

/// The section.
pub struct View;

impl Section for View {
    fn name(&self) -> &'static str {
        "View"
    }

    fn is_open_at_start(&self) -> bool {
        false
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        ui.horizontal(|ui| {
            ui.weak("colours");
            ui.selectable_value(&mut stage.theme, Theme::Dark, "dark");
            ui.selectable_value(&mut stage.theme, Theme::Light, "light");
        });
        let cell = grid_cell(stage.camera.distance);
        ui.weak(format!("grid: a line every {cell} m"));
        ui.weak(format!("drawn by {}", stage.adapter));
        if let Some(start_up) = stage.start_up {
            ui.weak(format!("first frame after {} ms", start_up.as_millis()));
        }
    }
}
