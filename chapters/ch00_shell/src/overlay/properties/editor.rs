//! A cell that someone types into: a field for each of its numbers. Enter applies them, Esc leaves
//! the cell as it was.

use ch00_scenes::{ColumnInfo, Edit, RowId, TableError};

use crate::edits::cell_name;
use crate::stage::{PAUSE_FIRST, Stage};
use crate::tables::value::{parsed, typed};

/// Width of a field, points.
const FIELD: f32 = 64.0;

/// The cell, and what was typed into it.
pub struct Editor {
    table: &'static str,
    column: ColumnInfo,
    row: RowId,
    /// That of the stage when the cell was read: afterwards something else may stand in it.
    revision: (u32, u64),
    texts: Vec<String>,
    error: Option<TableError>,
    /// Whether its first field is still to get the keyboard.
    is_new: bool,
}

impl Editor {
    /// Opens a cell with what stands in it, or says why not.
    pub fn open(
        stage: &Stage,
        table: &'static str,
        column: ColumnInfo,
        row: RowId,
    ) -> Result<Self, String> {
        if !column.editable {
            return Err(format!("`{}` can't be edited", column.name));
        }
        if !stage.is_paused {
            return Err(PAUSE_FIRST.to_owned());
        }
        let engine = stage.session().engine();
        let place = engine.row_of(table, row);
        let place = place.ok_or_else(|| TableError::Stale {
            table: table.to_owned(),
            row,
        });
        let cells = place.and_then(|place| engine.cells(table, column.name, &[place]));
        let cell = cells.map_err(|error| error.to_string())?.cell(0);
        let cell = cell.ok_or_else(|| format!("`{}` has no row {row}", column.name))?;
        Ok(Self {
            table,
            column,
            row,
            revision: stage.revision(),
            texts: typed(&cell),
            error: None,
            is_new: true,
        })
    }

    /// Whether nothing has changed in the engine's tables since the cell was opened.
    pub fn is_of(&self, revision: (u32, u64)) -> bool {
        self.revision == revision
    }

    /// Whether this is its cell.
    pub fn is_at(&self, column: &ColumnInfo, row: RowId) -> bool {
        self.column.name == column.name && self.row == row
    }

    /// The cell for a reader.
    pub fn name(&self) -> String {
        cell_name(self.table, self.column.name, self.row)
    }

    /// Why the last try to apply it failed.
    pub fn error(&self) -> Option<&TableError> {
        self.error.as_ref()
    }

    /// Shows the fields in place of the cell; whether they are to be applied.
    pub fn show(&mut self, ui: &mut egui::Ui) -> bool {
        let mut applies = false;
        for (i, text) in self.texts.iter_mut().enumerate() {
            let field = egui::TextEdit::singleline(text)
                .id_salt(("cell", i))
                .font(egui::TextStyle::Monospace)
                .margin(egui::Margin::symmetric(2, 0))
                .desired_width(FIELD);
            let response = ui.add(field);
            if self.is_new && i == 0 {
                response.request_focus();
            }
            applies |=
                response.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
        }
        self.is_new = false;
        applies
    }

    /// Gives the cell what was typed; whether it took it.
    pub fn apply(&mut self, stage: &mut Stage) -> bool {
        let value = parsed(self.table, &self.column, &self.texts);
        let outcome = value.and_then(|value| {
            stage.edit(Edit {
                table: self.table.to_owned(),
                column: self.column.name.to_owned(),
                row: self.row,
                value,
            })
        });
        self.error = outcome.err();
        self.is_new = self.error.is_some();
        self.error.is_none()
    }
}
