//! A table of any properties of any bodies: columns are chosen by checkbox, rows by a range
//! of indices or by clicking a body.

use ch00_scenes::{Column, ColumnData};
use egui_extras::{Column as Width, TableBuilder};

use super::{Section, style};
use crate::stage::Stage;

/// Rows that the table shows at the start.
const FIRST_ROWS: usize = 100;

/// What was chosen.
pub struct Properties {
    columns: Vec<&'static str>,
    from: usize,
    to: usize,
    only_picked: bool,
}

impl Default for Properties {
    fn default() -> Self {
        Self {
            columns: Vec::new(),
            from: 0,
            to: FIRST_ROWS - 1,
            only_picked: false,
        }
    }
}

impl Section for Properties {
    fn name(&self) -> &'static str {
        "Properties"
    }

    fn is_open_at_start(&self) -> bool {
        false
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        ui.weak("Columns of the table at the bottom");
        for column in stage.session().engine().columns() {
            let mut is_chosen = self.columns.contains(&column.name);
            let response = ui
                .checkbox(&mut is_chosen, headline(&column))
                .on_hover_text(column.about);
            if response.changed() {
                self.columns.retain(|&name| name != column.name);
                if is_chosen {
                    self.columns.push(column.name);
                }
            }
        }
        ui.horizontal(|ui| {
            ui.weak("rows");
            ui.add(egui::DragValue::new(&mut self.from).range(0..=self.to));
            ui.weak("to");
            ui.add(egui::DragValue::new(&mut self.to).range(self.from..=usize::MAX));
        });
        ui.checkbox(&mut self.only_picked, "only the picked body");
    }
}

impl Properties {
    /// Whether there is a table to show.
    pub fn is_table_shown(&self) -> bool {
        !self.columns.is_empty()
    }

    /// Shows the table below the scene.
    pub fn show_table(&self, ui: &mut egui::Ui, stage: &mut Stage) {
        let columns: Vec<Column> = stage.session().engine().columns();
        let chosen: Vec<&Column> = columns
            .iter()
            .filter(|column| self.columns.contains(&column.name))
            .collect();
        let count = stage.session().scene().bodies.len();
        let rows: Vec<usize> = match stage.picked {
            Some(picked) if self.only_picked => vec![picked],
            _ => (self.from..=self.to.min(count.saturating_sub(1))).collect(),
        };
        egui::Panel::bottom("properties")
            .default_size(190.0)
            .size_range(90.0..=400.0)
            .frame(style::panel(ui))
            .show(ui, |ui| {
                egui::ScrollArea::horizontal().show(ui, |ui| {
                    table(ui, &chosen, &rows, &mut stage.picked);
                });
            });
    }
}

/// The table; clicking a row picks its body.
fn table(ui: &mut egui::Ui, columns: &[&Column], rows: &[usize], picked: &mut Option<usize>) {
    let width = |column: &&Column| match column.data {
        ColumnData::Scalar(_) => 90.0,
        ColumnData::Vector(_) => 210.0,
        ColumnData::Quaternion(_) => 260.0,
    };
    let mut builder = TableBuilder::new(ui)
        .striped(true)
        .sense(egui::Sense::click())
        .column(Width::exact(52.0));
    for column in columns {
        builder = builder.column(Width::initial(width(column)).resizable(true).clip(true));
    }
    builder
        .header(18.0, |mut header| {
            header.col(|ui| {
                ui.strong("body");
            });
            for column in columns {
                header.col(|ui| {
                    ui.strong(headline(column)).on_hover_text(column.about);
                });
            }
        })
        .body(|body| {
            body.rows(16.0, rows.len(), |mut row| {
                let i = rows[row.index()];
                row.set_selected(*picked == Some(i));
                row.col(|ui| {
                    ui.monospace(i.to_string());
                });
                for column in columns {
                    row.col(|ui| {
                        ui.monospace(cell(&column.data, i));
                    });
                }
                if row.response().clicked() {
                    *picked = Some(i);
                }
            });
        });
}

fn headline(column: &Column) -> String {
    if column.unit.is_empty() {
        column.name.to_owned()
    } else {
        format!("{} ({})", column.name, column.unit)
    }
}

/// A value as text; nothing where an engine has no such row.
fn cell(data: &ColumnData, i: usize) -> String {
    let join = |values: &[f32]| {
        let texts: Vec<String> = values.iter().map(|value| format!("{value:9.4}")).collect();
        texts.join(" ")
    };
    match data {
        ColumnData::Scalar(values) => values.get(i).map(|value| join(&[*value])),
        ColumnData::Vector(values) => values.get(i).map(|value| join(value)),
        ColumnData::Quaternion(values) => values.get(i).map(|value| join(value)),
    }
    .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_shows_all_parts_of_a_value() {
        let data = ColumnData::Vector(vec![[1.0, -2.5, 0.0]]);
        assert_eq!(cell(&data, 0), "   1.0000   -2.5000    0.0000");
        assert_eq!(cell(&data, 1), "");
    }
}
