//! Which key and which drag does what.

use super::Section;
use super::format::rows;
use crate::stage::Stage;

/// The section.
pub struct Keys;

/// What to press, and what it does.
const KEYS: [(&str, &str); 22] = [
    ("Space", "pause or go on"),
    (". or N", "one step"),
    ("R", "reset"),
    ("F or T", "throw a ball where you look"),
    ("Delete", "remove the picked body"),
    ("Ctrl-Z", "undo an edit of a table's cell"),
    ("Ctrl-Shift-Z or Ctrl-Y", "redo it"),
    ("V", "variable step or fixed step"),
    ("L", "light or dark"),
    ("C", "camera back to the start"),
    ("1 to 6", "layers, in the order of the list"),
    ("X", "bodies of glass while layers are shown, or not"),
    ("G", "look into the narrow phase of a pair, or stop"),
    ("B", "camera near that pair, or the picked body"),
    ("Left Right Home End", "through its iterations"),
    ("H or F1", "this panel"),
    ("Esc", "close runs that are side by side"),
    ("Ctrl-Q", "close the window"),
    ("drag a body", "pull it by a spring"),
    (
        "Shift-click a body",
        "look at it and the one clicked before",
    ),
    ("drag elsewhere", "turn the camera"),
    ("wheel; Shift-drag", "closer or farther; move"),
];

impl Section for Keys {
    fn name(&self) -> &'static str {
        "Keys and mouse"
    }

    fn is_open_at_start(&self) -> bool {
        false
    }

    fn show(&mut self, ui: &mut egui::Ui, _stage: &mut Stage) {
        rows(ui, "keys", |ui| {
            for (key, about) in KEYS {
                ui.monospace(key);
                ui.label(about);
                ui.end_row();
            }
        });
    }
}
