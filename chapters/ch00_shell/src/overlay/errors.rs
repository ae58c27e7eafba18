//! How well energy and momentum are kept: their relative errors over time. Where a scene
//! doesn't keep one of them (weight takes up momentum), it has no curve.

use egui_plot::{Corner, Legend, Line, Plot, PlotPoints};

use super::Section;
use super::format::{as_of, every_step, or_dash, row, rows};
use crate::Session;
use crate::history::Sample;
use crate::stage::Stage;

/// Points of a curve at most, so that a long run costs no more to draw than a short one.
const MOST_POINTS: usize = 300;

/// The section.
pub struct Errors;

impl Section for Errors {
    fn name(&self) -> &'static str {
        "Energy and momentum error"
    }

    fn is_open_at_start(&self) -> bool {
        true
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        let samples = stage.session().history().samples();
        let last = samples.back();
        let relative = |error: f64| format!("{error:+.3e}");
        rows(ui, "energies", |ui| {
            let energies = or_dash(last, |sample| {
                let (kinetic, potential) = (sample.kinetic_energy, sample.potential_energy);
                format!("{kinetic:.2} / {potential:.2} J")
            });
            row(ui, "kinetic / potential", energies);
            let error = last.and_then(|sample| sample.energy_error);
            row(ui, "energy error", or_dash(error, relative));
            let error = last.and_then(|sample| sample.momentum_error);
            row(ui, "momentum error", or_dash(error, relative));
            if let Some(measured) = measured(stage.session()) {
                row(ui, "measured", measured)
                    .on_hover_text("sums over all bodies: many bodies are not summed every step, and states on a device come back late");
            }
        });
        let stride = samples.len().div_ceil(MOST_POINTS).max(1);
        let curve = |error: fn(&Sample) -> Option<f64>| -> PlotPoints<'static> {
            samples
                .iter()
                .step_by(stride)
                .filter_map(|sample| Some([sample.time, error(sample)?]))
                .collect()
        };
        let energy = curve(|sample| sample.energy_error);
        let momentum = curve(|sample| sample.momentum_error);
        if energy.points().is_empty() && momentum.points().is_empty() {
            ui.weak("This scene keeps neither, so there is no error.");
        } else {
            plot(ui, energy, momentum);
        }
    }
}

/// When and how often, where that is not after every step.
fn measured(session: &Session) -> Option<String> {
    let every = session.history().every();
    let often = (every > 1).then(|| every_step(every));
    match (as_of(session), often) {
        (Some(when), Some(often)) => Some(format!("{when}, {often}")),
        (when, often) => when.or(often),
    }
}

fn plot(ui: &mut egui::Ui, energy: PlotPoints<'static>, momentum: PlotPoints<'static>) {
    Plot::new("errors")
        .height(104.0)
        .y_axis_min_width(38.0)
        .legend(Legend::default().position(Corner::LeftTop))
        .allow_drag(false)
        .allow_scroll(false)
        .allow_zoom(false)
        .allow_boxed_zoom(false)
        .include_y(0.0)
        .x_axis_formatter(|mark, _| format!("{} s", mark.value))
        .y_axis_formatter(|mark, _| format!("{:.1e}", mark.value))
        .show(ui, |plot| {
            plot.line(Line::new("energy", energy).color(ENERGY));
            plot.line(Line::new("momentum", momentum).color(MOMENTUM));
        });
}

const ENERGY: egui::Color32 = egui::Color32::from_rgb(0xE6, 0x9F, 0x00);
const MOMENTUM: egui::Color32 = egui::Color32::from_rgb(0x56, 0xB4, 0xE9);
