//! What stands above the table: how many rows it shows, what is followed, what can be undone, and
//! why something can't be done.

use ch00_scenes::{ColumnInfo, RowId, TableInfo};

use super::editor::Editor;
use crate::overlay::format::as_of;
use crate::stage::{Followed, PAUSE_FIRST, Stage};
use crate::tables::rows::Rows;

/// What it needs to know.
pub struct Head<'a> {
    /// The table.
    pub table: &'a TableInfo,
    /// Its columns that are shown.
    pub columns: &'a [&'a ColumnInfo],
    /// Its rows that are shown.
    pub rows: &'a Rows,
    /// The row that was clicked last.
    pub selected: Option<RowId>,
}

impl Head<'_> {
    /// Shows it and does what its buttons say.
    pub fn show(
        &self,
        ui: &mut egui::Ui,
        stage: &mut Stage,
        editor: &mut Option<Editor>,
        message: &mut Option<String>,
    ) {
        ui.horizontal_wrapped(|ui| {
            ui.strong(self.table.name);
            ui.weak(format!("{} of {} rows", self.rows.len(), self.table.rows));
            if let Some(when) = as_of(stage.session()) {
                ui.weak(when);
            }
            self.following(ui, stage);
            undoing(ui, stage);
            match editor {
                Some(_) => editing(ui, stage, editor),
                None => self.hint(ui, stage),
            }
            if let Some(text) = message.as_ref() {
                ui.colored_label(ui.visuals().error_fg_color, text);
            }
        });
    }

    /// A tick that follows the row that was clicked last, and what is followed instead.
    fn following(&self, ui: &mut egui::Ui, stage: &mut Stage) {
        let table = self.table.name;
        let followed = stage.followed();
        if let Some(row) = self.selected {
            let this = Followed { table, row };
            let mut is_followed = followed == Some(this);
            let tip = "the table stays with this row, wherever sorting moves it; with a body, the \
                       camera too";
            let response = ui.checkbox(&mut is_followed, format!("follow {row}"));
            if response.on_hover_text(tip).changed() {
                stage.follow(is_followed.then_some(this));
            }
        }
        let Some(Followed { row, .. }) = followed.filter(|followed| followed.table == table) else {
            return;
        };
        if Some(row) != self.selected {
            ui.weak(format!("following {row}"));
            if ui.small_button("let go").clicked() {
                stage.follow(None);
            }
        }
        let place = stage.session().engine().row_of(table, row);
        if place.is_some_and(|place| self.rows.place_of(place).is_none()) {
            ui.weak(format!("({row} is not among the rows shown)"));
        }
    }

    fn hint(&self, ui: &mut egui::Ui, stage: &Stage) {
        if self.columns.iter().any(|column| column.editable) {
            ui.weak(if stage.is_paused {
                "double-click a cell to edit it"
            } else {
                PAUSE_FIRST
            });
        }
    }
}

/// Buttons that say what they would undo and redo.
fn undoing(ui: &mut egui::Ui, stage: &mut Stage) {
    if let Some(cell) = stage.edits().next_undo() {
        let tip = "Ctrl-Z: sets this cell back to what it was before the edit. Steps made since then \
                   are not taken back.";
        let button = ui.small_button(format!("undo {cell}"));
        if button.on_hover_text(tip).clicked() {
            stage.undo();
        }
    }
    if let Some(cell) = stage.edits().next_redo() {
        let button = ui.small_button(format!("redo {cell}"));
        if button.on_hover_text("Ctrl-Shift-Z or Ctrl-Y").clicked() {
            stage.redo();
        }
    }
}

/// What is being edited, and how that ends; also while the cell is scrolled out of sight.
fn editing(ui: &mut egui::Ui, stage: &mut Stage, slot: &mut Option<Editor>) {
    let Some(editor) = slot else {
        return;
    };
    ui.label(format!("editing {}", editor.name()));
    let applies = ui.small_button("apply").on_hover_text("Enter").clicked();
    let cancels = ui.small_button("cancel").on_hover_text("Esc").clicked()
        || ui.input(|input| input.key_pressed(egui::Key::Escape));
    if let Some(error) = editor.error() {
        ui.colored_label(ui.visuals().error_fg_color, error.to_string());
    }
    if cancels || (applies && editor.apply(stage)) {
        *slot = None;
    }
}
