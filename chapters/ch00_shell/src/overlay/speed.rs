//! How fast it runs: frames per second as the report counts them, frame times that a mean
//! hides, and what the last step spent its time on.

use super::Section;
use super::format::{or_dash, row, rows, time};
use crate::Session;
use crate::stage::Stage;

/// The section.
pub struct Speed;

impl Section for Speed {
    fn name(&self) -> &'static str {
        "Speed"
    }

    fn is_open_at_start(&self) -> bool {
        true
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        let rate = &stage.frame_rate;
        let fps = |value| or_dash(value, |fps: f64| format!("{fps:.1}"));
        rows(ui, "frames", |ui| {
            row(ui, "FPS, last 10 frames", fps(rate.fps()))
                .on_hover_text("mean over the last ten frames, as in the report");
            let extremes = format!("{} / {}", fps(rate.max_fps()), fps(rate.min_fps()));
            row(ui, "max / min so far", extremes)
                .on_hover_text("the largest and the smallest ten-frame mean so far");
            let middle = or_dash(rate.p50(), time);
            let slow = or_dash(rate.p99(), time);
            row(ui, "frame p50 / p99", format!("{middle} / {slow}"))
                .on_hover_text("of the last 600 frames");
            step(ui, stage.session());
        });
        passes(ui, stage);
    }
}

/// The last step's time. Where a device makes the step, it is only handed over, and the device says later
/// how long it took.
fn step(ui: &mut egui::Ui, session: &Session) {
    let taken = time(session.step_time());
    if !session.is_late() {
        row(ui, "step", taken)
            .on_hover_text("the engine's last step, without reading and measuring it");
        return;
    }
    row(ui, "step handed over", taken)
        .on_hover_text("to the device, which makes it while the program goes on");
    let passes = session.engine().pass_times();
    if !passes.is_empty() {
        let sum = passes.iter().map(|pass| pass.time).sum();
        row(ui, "step on the device", time(sum))
            .on_hover_text("of a step some frames ago, without pauses between passes");
    }
}

/// Each part of the last step with a bar for its share.
fn passes(ui: &mut egui::Ui, stage: &Stage) {
    let passes = stage.session().engine().pass_times();
    let total: f32 = passes.iter().map(|pass| pass.time.as_secs_f32()).sum();
    if passes.is_empty() {
        return;
    }
    egui::Grid::new("passes")
        .num_columns(3)
        .spacing([8.0, 1.0])
        .show(ui, |ui| {
            for pass in passes {
                ui.weak(pass.name);
                ui.monospace(time(pass.time));
                let share = pass.time.as_secs_f32() / total.max(1e-9);
                bar(ui, share);
                ui.end_row();
            }
        });
}

fn bar(ui: &mut egui::Ui, share: f32) {
    let (whole, _) = ui.allocate_exact_size(egui::vec2(80.0, 8.0), egui::Sense::hover());
    let visuals = ui.visuals();
    let painter = ui.painter();
    painter.rect_filled(whole, 2.0, visuals.extreme_bg_color);
    let mut filled = whole;
    filled.set_width(whole.width() * share.clamp(0.0, 1.0));
    painter.rect_filled(filled, 2.0, visuals.selection.bg_fill);
}
