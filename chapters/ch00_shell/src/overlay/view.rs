//! What is drawn besides the bodies, and in which colours.

use ch00_scenes::Layer;

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
        for layer in Layer::ALL {
            let can_show = stage.session().engine().layers().contains(&layer);
            let mut is_shown = stage.layers.contains(&layer);
            let checkbox = egui::Checkbox::new(&mut is_shown, layer.name());
            let response = ui
                .add_enabled(can_show, checkbox)
                .on_disabled_hover_text("this engine has no such thing");
            if response.changed() {
                stage.layers.retain(|&shown| shown != layer);
                if is_shown {
                    stage.layers.push(layer);
                }
            }
        }
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
