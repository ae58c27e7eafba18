//! Choosing what to see: which table, which of its columns, which of its rows.

use ch00_scenes::{BODIES, ColumnInfo, TableInfo};

use super::headline;
use crate::tables::View;

/// The list of tables; gives the chosen one.
pub fn table<'a>(ui: &mut egui::Ui, tables: &'a [TableInfo], now: &'a TableInfo) -> &'a TableInfo {
    let mut chosen = now.name;
    ui.horizontal(|ui| {
        ui.weak("table");
        egui::ComboBox::from_id_salt("table")
            .selected_text(now.name)
            .show_ui(ui, |ui| {
                for table in tables {
                    let text = format!("{}  ({} rows)", table.name, table.rows);
                    ui.selectable_value(&mut chosen, table.name, text)
                        .on_hover_text(table.about);
                }
            });
    });
    let table = tables.iter().find(|table| table.name == chosen);
    let table = table.unwrap_or(now);
    ui.weak(table.about);
    table
}

/// A tick for each column.
pub fn columns(ui: &mut egui::Ui, table: &TableInfo, view: &mut View) {
    ui.horizontal(|ui| {
        ui.weak("columns of the table at the bottom");
        if ui.small_button("all").clicked() {
            let possible = table
                .columns
                .iter()
                .filter(|column| column.left_out.is_none());
            view.columns = possible.map(|column| column.name).collect();
        }
        if ui.small_button("none").clicked() {
            view.columns.clear();
        }
    });
    for column in &table.columns {
        match &column.left_out {
            Some(why) => left_out(ui, column, why),
            None => tick(ui, column, view),
        }
    }
}

fn tick(ui: &mut egui::Ui, column: &ColumnInfo, view: &mut View) {
    let mut is_chosen = view.columns.contains(&column.name);
    let mut tip = column.about.to_owned();
    if column.editable {
        tip += "\nDouble-click a cell while time stands still to edit it.";
    }
    let response = ui.checkbox(&mut is_chosen, headline(column));
    if response.on_hover_text(tip).changed() {
        view.toggle(column.name);
    }
}

/// A column that this scene doesn't need: greyed, and the hover says why.
fn left_out(ui: &mut egui::Ui, column: &ColumnInfo, why: &str) {
    let tip = format!("{}\nLeft out of this scene's plan: {why}", column.about);
    let mut never = false;
    ui.add_enabled(false, egui::Checkbox::new(&mut never, headline(column)))
        .on_disabled_hover_text(tip);
}

/// Which rows.
pub fn rows(ui: &mut egui::Ui, table: &TableInfo, view: &mut View) {
    ui.horizontal(|ui| {
        ui.weak("IDs");
        let field = egui::TextEdit::singleline(&mut view.filter.text)
            .id_salt("IDs")
            .hint_text("all, or 7, 9-20, 12.3")
            .desired_width(160.0);
        let tip = "12.3 is the row 12 that had three others of this number before it";
        if ui.add(field).on_hover_text(tip).changed() {
            view.filter.read();
        }
    });
    if let Some(error) = view.filter.error() {
        ui.colored_label(ui.visuals().error_fg_color, error.to_string());
    }
    if table.name == BODIES {
        ui.checkbox(&mut view.only_picked, "only the picked body");
    }
}
