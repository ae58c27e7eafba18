//! Which pair's narrow phase is looked at: clicked in the scene, chosen from what the picked body
//! touches, or the deepest contact of all.

use crate::overlay::Section;
use crate::show::{Neighbour, neighbours};
use crate::stage::Stage;

/// Neighbours that are listed at most.
const MOST: usize = 8;

/// The section.
pub struct Choice;

impl Section for Choice {
    fn name(&self) -> &'static str {
        "Narrow phase of a pair"
    }

    fn is_open_at_start(&self) -> bool {
        true
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        ui.weak("Click a body, then Shift-click another, or choose:");
        ui.horizontal_wrapped(|ui| {
            let is_shown = stage.show.pair.is_some();
            let word = match (is_shown, stage.picked) {
                (true, _) => "close",
                (false, Some(_)) => "its deepest contact",
                (false, None) => "deepest contact",
            };
            if ui.button(word).on_hover_text("G").clicked() {
                stage.toggle_pair();
            }
            if is_shown && ui.button("go near").on_hover_text("B").clicked() {
                stage.move_camera_near();
            }
        });
        if let Some(picked) = stage.picked {
            list(ui, stage, picked);
        }
    }
}

/// What the picked body touches, and what is near it.
fn list(ui: &mut egui::Ui, stage: &mut Stage, picked: usize) {
    let found = neighbours(stage.session(), picked);
    if found.is_empty() {
        ui.weak(format!("Nothing is near body {picked}."));
        return;
    }
    ui.weak(format!("Near body {picked}:"));
    let shown = stage.show.pair.map(|pair| pair.bodies);
    for Neighbour { body, impulse } in found.iter().take(MOST) {
        let text = match impulse {
            Some(impulse) => format!("body {body}, pressed by {impulse:.3} N s"),
            None => format!("body {body}, not touching"),
        };
        let is_chosen = shown.is_some_and(|pair| pair.contains(body) && pair.contains(&picked));
        if ui.selectable_label(is_chosen, text).clicked() {
            stage.look_at([picked, *body]);
        }
    }
    if found.len() > MOST {
        ui.weak(format!("and {} more", found.len() - MOST));
    }
}
