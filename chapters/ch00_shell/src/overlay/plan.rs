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
        ui.label(stage.session().engine().explain());
    }
}
