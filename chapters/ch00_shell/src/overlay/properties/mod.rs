//! The engine's tables: at the left what to see of them is chosen, at the bottom they are shown.
//! The overlay knows no table and no column by name but the bodies', whose rows are what can be
//! picked in the scene.

mod choice;
mod editor;
mod grid;
mod head;
mod snapshot;
#[cfg(test)]
pub mod tests;

use std::collections::BTreeMap;

use ch00_scenes::{BODIES, ColumnInfo, RowId, TableInfo};

use super::{Section, style};
use crate::stage::{Followed, Stage};
use crate::tables::View;
use crate::tables::rows::{Rows, id_of};
use editor::Editor;
use grid::{Asked, Grid};
use snapshot::Snapshot;

/// What was chosen, and what is being edited.
#[derive(Default)]
pub struct Properties {
    /// Name of the chosen table; the engine's first where it has none of this name.
    table: &'static str,
    views: BTreeMap<&'static str, View>,
    snapshot: Snapshot,
    editor: Option<Editor>,
    /// Why something that was asked for in the table can't be.
    message: Option<String>,
}

impl Section for Properties {
    fn name(&self) -> &'static str {
        "Properties"
    }

    fn is_open_at_start(&self) -> bool {
        false
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        let tables = self.snapshot.tables(stage);
        let Some(now) = chosen(tables, self.table) else {
            ui.weak("This engine shows no tables.");
            return;
        };
        let table = choice::table(ui, tables, now);
        if table.name != now.name {
            self.editor = None;
            self.message = None;
        }
        self.table = table.name;
        let view = self.views.entry(table.name).or_default();
        choice::columns(ui, table, view);
        choice::rows(ui, table, view);
    }
}

impl Properties {
    /// Whether there is a table to show.
    pub fn is_table_shown(&self) -> bool {
        self.views.values().any(|view| !view.columns.is_empty())
    }

    /// Shows the table below the scene, if any of its columns is chosen.
    pub fn show_table(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        let tables = self.snapshot.tables(stage);
        let Some(table) = chosen(tables, self.table).cloned() else {
            return;
        };
        let view = self.views.entry(table.name).or_default().clone();
        let columns = view.shown_columns(&table);
        if columns.is_empty() {
            return;
        }
        let revision = stage.revision();
        self.editor = self.editor.take().filter(|editor| editor.is_of(revision));
        let rows = self.snapshot.rows(stage, &table, &view);
        egui::Panel::bottom("properties")
            .default_size(210.0)
            .size_range(90.0..=420.0)
            .frame(style::panel(ui))
            .show(ui, |ui| {
                let rows = match &rows {
                    Ok(rows) => rows,
                    Err(error) => {
                        ui.colored_label(ui.visuals().error_fg_color, error.to_string());
                        &Rows::All(table.rows)
                    }
                };
                self.show_rows(ui, stage, &table, &columns, rows);
            });
    }

    fn show_rows(
        &mut self,
        ui: &mut egui::Ui,
        stage: &mut Stage,
        table: &TableInfo,
        columns: &[&ColumnInfo],
        rows: &Rows,
    ) {
        let selected = self.selected(stage, table);
        let followed = stage
            .followed()
            .filter(|followed| followed.table == table.name);
        let head = head::Head {
            table,
            columns,
            rows,
            selected,
        };
        head.show(ui, stage, &mut self.editor, &mut self.message);
        let place = |Followed { row, .. }| {
            let row = stage.session().engine().row_of(table.name, row)?;
            rows.place_of(row)
        };
        let grid = Grid {
            engine: stage.session().engine(),
            table,
            columns,
            rows,
            sort: self.views.get(table.name).and_then(|view| view.sort),
            selected,
            followed: followed.map(|followed| followed.row),
            scroll_to: followed.and_then(place),
        };
        let asked = egui::ScrollArea::horizontal()
            .show(ui, |ui| grid.show(ui, self.editor.as_mut()))
            .inner;
        self.act(stage, table, asked);
    }

    /// The row that was clicked last; in the bodies' table, the picked body's.
    fn selected(&self, stage: &Stage, table: &TableInfo) -> Option<RowId> {
        if table.name == BODIES {
            return id_of(stage.session().engine(), BODIES, stage.picked?);
        }
        self.views.get(table.name)?.selected
    }

    /// Does what was asked for in the table.
    fn act(&mut self, stage: &mut Stage, table: &TableInfo, asked: Asked) {
        let view = self.views.entry(table.name).or_default();
        view.sort = asked.sort;
        if let Some((row, id)) = asked.select {
            self.message = None;
            view.selected = Some(id);
            if table.name == BODIES && row < stage.session().scene().bodies.len() {
                stage.picked = Some(row);
            }
        }
        if let Some((column, id)) = asked.edit {
            match Editor::open(stage, table.name, column, id) {
                Ok(editor) => self.editor = Some(editor),
                Err(why) => self.message = Some(why),
            }
        }
        if asked.apply
            && let Some(editor) = &mut self.editor
            && editor.apply(stage)
        {
            self.editor = None;
        }
    }
}

/// The table of this name, or else the first.
fn chosen<'a>(tables: &'a [TableInfo], name: &str) -> Option<&'a TableInfo> {
    let found = tables.iter().find(|table| table.name == name);
    found.or_else(|| tables.first())
}

/// A column for a reader: its name, its symbol where that is another, and its unit.
fn headline(column: &ColumnInfo) -> String {
    let mut text = column.name.to_owned();
    if column.symbol != column.name && !column.symbol.is_empty() {
        text = format!("{text}  {}", column.symbol);
    }
    if !column.unit.is_empty() {
        text = format!("{text}  ({})", column.unit);
    }
    text
}
