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
    if let Some(body) = stage.picked {
        ui.horizontal(|ui| picked(ui, stage, body));
    }
    if let Some(notice) = stage.notice.clone() {
        ui.colored_label(style::WARNING, notice);
        if ui.small_button("dismiss").clicked() {
            stage.notice = None;
        }
    }
}

fn buttons(ui: &mut egui::Ui, stage: &mut Stage) {
    clock_buttons(ui, stage);
    if ui.button("Throw").on_hover_text("F or T").clicked() {
        stage.throw_ball();
    }
}

/// What stops, steps and begins anew, whether one run is shown or several.
pub(super) fn clock_buttons(ui: &mut egui::Ui, stage: &mut Stage) {
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
}

/// The picked body, and what can be done with it.
fn picked(ui: &mut egui::Ui, stage: &mut Stage, body: usize) {
    ui.weak(format!("picked: body {body}"));
    let mut is_followed = stage.followed_body() == Some(body);
    let tip = "the camera stays with it, and so does its table";
    if ui
        .checkbox(&mut is_followed, "follow")
        .on_hover_text(tip)
        .changed()
    {
        stage.follow_body(is_followed.then_some(body));
    }
    let tip = "Delete; a reset brings it back";
    if ui.small_button("remove").on_hover_text(tip).clicked() {
        stage.remove_picked();
    }
}
