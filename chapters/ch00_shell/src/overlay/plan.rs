//! What the engine does with this scene and why, in its own words.

use super::Section;
use crate::stage::Stage;

/// The section.
pub struct Plan;

impl Section for Plan {
    fn name(&self) -> &'static str {
        "Plan"
    }

    fn is_open_at_start(&self) -> bool {
        false
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        let info = stage.session().engine().info();
        ui.weak(format!(
            "{} · {} · {} · {} thread(s) · {} substep(s) · {}-bit reals",
            info.engine,
            info.method,
            info.device,
            info.threads,
            info.substeps,
            8 * info.real_size
        ));
        explanation(ui, stage.session().engine().explain().trim_end());
    }
}

/// Sentences are wrapped. Tables, which are aligned with spaces, are not: they scroll sideways.
fn explanation(ui: &mut egui::Ui, text: &str) {
    if !text.contains("  ") {
        ui.label(text);
        return;
    }
    egui::ScrollArea::horizontal()
        .id_salt("plan")
        .show(ui, |ui| {
            let text = egui::RichText::new(text).monospace();
            ui.add(egui::Label::new(text).extend());
        });
}
