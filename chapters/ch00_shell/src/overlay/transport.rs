//! The head of the overlay: what runs, since when, and the buttons that stop and start it.

use super::style;
use crate::stage::Stage;

/// Shows it.
pub fn show(ui: &mut egui::Ui, stage: &mut Stage) {
    ui.add_space(4.0);
    ui.heading(stage.chapter.title);
    let session = stage.session();
    let bodies = session.scene().bodies.len();
    let time = format!(
        "{}: {bodies} bodies, t = {:.2} s, step {}",
        session.scene().name,
        session.time(),
        session.steps()
    );
    ui.add(egui::Label::new(egui::RichText::new(time).weak()).truncate());
    ui.horizontal(|ui| buttons(ui, stage));
    if let Some(notice) = stage.notice.clone() {
        ui.colored_label(style::WARNING, notice);
        if ui.small_button("dismiss").clicked() {
            stage.notice = None;
        }
    }
}

fn buttons(ui: &mut egui::Ui, stage: &mut Stage) {
    let pause = if stage.is_paused { "Run" } else { "Pause" };
    if ui.button(pause).on_hover_text("Space").clicked() {
        stage.toggle_pause();
    }
    if ui.button("Step").on_hover_text(". or N").clicked() {
        stage.step_once();
    }
    if ui.button("Reset").on_hover_text("R").clicked() {
        stage.reset();
    }
    if ui.button("Throw").on_hover_text("F or T").clicked() {
        stage.throw_ball();
    }
}
