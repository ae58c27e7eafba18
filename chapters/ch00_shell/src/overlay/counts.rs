//! What the last step counted, and what was left undone: nothing is skipped in silence.

use super::Section;
use super::format::{as_of, row, rows};
use super::style::WARNING;
use crate::stage::Stage;

/// The section.
pub struct Counts;

impl Section for Counts {
    fn name(&self) -> &'static str {
        "Counts"
    }

    fn is_open_at_start(&self) -> bool {
        true
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        let counters = stage.session().engine().counters();
        rows(ui, "counters", |ui| {
            let found = format!("{} / {}", counters.pairs, counters.contacts);
            row(ui, "pairs / contacts", found);
            if counters.asleep > 0 {
                row(ui, "asleep", counters.asleep.to_string());
            }
            let overflow = counters.overflow.to_string();
            warn(ui, "overflow", &overflow, counters.overflow > 0).on_hover_text(
                "what a capacity or an iteration limit left undone since the scene was loaded",
            );
            let lost = stage.session().not_finite();
            if lost > 0 {
                warn(ui, "not finite", &lost.to_string(), true);
            }
            if let Some(counted) = as_of(stage.session()) {
                row(ui, "counted", counted);
            }
            let dropped = stage.clock().dropped();
            warn(ui, "dropped time", &format!("{dropped:.2} s"), dropped > 0.5).on_hover_text(
                "time that passed without being simulated, because steps took longer than they last",
            );
        });
    }
}

/// A row in the colour of a warning where one is due.
fn warn(ui: &mut egui::Ui, name: &str, value: &str, is_due: bool) -> egui::Response {
    if !is_due {
        return row(ui, name, value);
    }
    ui.weak(name);
    let response = ui.colored_label(WARNING, value);
    ui.end_row();
    response
}
