//! Which layers of the engine's inner state are drawn over the bodies.

use ch00_scenes::Layer;

use super::Section;
use super::format::as_of;
use crate::stage::Stage;

/// The section.
pub struct Layers;

impl Section for Layers {
    fn name(&self) -> &'static str {
        "Layers"
    }

    fn is_open_at_start(&self) -> bool {
        true
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        let possible = stage.session().engine().layers();
        if possible.is_empty() {
            ui.weak("This engine draws nothing of its inner state.");
        }
        for (i, layer) in Layer::ALL.into_iter().enumerate() {
            if !possible.contains(&layer) {
                continue;
            }
            let mut is_shown = stage.show.layers.contains(&layer);
            let response = ui.checkbox(&mut is_shown, layer.name());
            if response.on_hover_text(format!("{}", i + 1)).changed() {
                stage.show.toggle(layer);
            }
        }
        if !possible.is_empty() {
            ui.checkbox(&mut stage.show.is_see_through, "bodies of glass meanwhile")
                .on_hover_text("X");
        }
        let when = as_of(stage.session()).filter(|_| stage.show.is_any());
        if let Some(when) = when {
            ui.weak(format!("bodies and layers as they were: {when}"));
        }
    }
}
