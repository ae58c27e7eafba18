//! The table itself. Of all its rows only those in sight are laid out, and only their cells are
//! asked for, in one go a column.

use ch00_scenes::{ColumnData, ColumnInfo, Engine, Kind, RowId, TableError, TableInfo};
use egui::{Label, RichText, Sense};
use egui_extras::{Column as Width, TableBuilder, TableRow};

use super::editor::Editor;
use super::headline;
use crate::tables::rows::Rows;
use crate::tables::sort::{By, Part, Sort};
use crate::tables::value::shown;

/// Height of a row, points.
const ROW: f32 = 16.0;

/// What to show.
pub struct Grid<'a> {
    /// Whose table it is.
    pub engine: &'a dyn Engine,
    /// The table.
    pub table: &'a TableInfo,
    /// Its columns to show.
    pub columns: &'a [&'a ColumnInfo],
    /// Its rows to show.
    pub rows: &'a Rows,
    /// What they are sorted by.
    pub sort: Option<Sort>,
    /// The row that was clicked last.
    pub selected: Option<RowId>,
    /// The row that is followed.
    pub followed: Option<RowId>,
    /// The place that has to be in sight.
    pub scroll_to: Option<usize>,
}

/// What was asked for by clicks.
#[derive(Default)]
pub struct Asked {
    /// What the rows are to be sorted by.
    pub sort: Option<Sort>,
    /// A row that was clicked, and its ID.
    pub select: Option<(usize, RowId)>,
    /// A cell that was double-clicked.
    pub edit: Option<(ColumnInfo, RowId)>,
    /// Whether what was typed into a cell is to be applied.
    pub apply: bool,
}

impl Grid<'_> {
    /// Shows it, with a cell that is being edited as fields to type into.
    pub fn show(&self, ui: &mut egui::Ui, mut editor: Option<&mut Editor>) -> Asked {
        let mut asked = Asked {
            sort: self.sort,
            ..Asked::default()
        };
        let names: Vec<&str> = self.columns.iter().map(|column| column.name).collect();
        let in_sight = (ui.available_height() / ROW).max(1.0) as usize + 2;
        let mut builder = TableBuilder::new(ui)
            .id_salt((self.table.name, names))
            .striped(true)
            .sense(Sense::click())
            .cell_layout(egui::Layout::left_to_right(egui::Align::Center))
            .min_scrolled_height(0.0)
            .auto_shrink([true, false])
            .animate_scrolling(false)
            .column(Width::exact(62.0));
        for column in self.columns {
            let width = Width::initial(width(column.kind));
            builder = builder.column(width.resizable(true).clip(true));
        }
        if let Some(place) = self.scroll_to {
            builder = builder.scroll_to_row(place, None);
        }
        builder
            .header(18.0, |mut header| {
                header.col(|ui| self.id_header(ui, &mut asked));
                for column in self.columns {
                    header.col(|ui| self.header(ui, column, &mut asked));
                }
            })
            .body(|body| {
                let mut block = Block::default();
                body.rows(ROW, self.rows.len(), |mut row| {
                    let place = row.index();
                    if !block.has(place) {
                        block = Block::read(self, place, in_sight);
                    }
                    self.row(&mut row, &block, editor.as_deref_mut(), &mut asked);
                });
            });
        asked
    }

    fn id_header(&self, ui: &mut egui::Ui, asked: &mut Asked) {
        let text = format!("ID{}", self.arrow(By::Id));
        let tip = "A row's number. 12.3 is the fourth row that has the number 12. Click to sort.";
        if sort_label(ui, text).on_hover_text(tip).clicked() {
            asked.sort = Sort::after_click(self.sort, By::Id, Part::Whole);
        }
    }

    fn header(&self, ui: &mut egui::Ui, column: &ColumnInfo, asked: &mut Asked) {
        let by = By::Column(column.name);
        let parts = Part::of(column.kind);
        let now = self.sort.filter(|sort| sort.by == by);
        let text = format!("{}{}", headline(column), self.arrow(by));
        let tip = format!("{}\nClick to sort.", column.about);
        if sort_label(ui, text).on_hover_text(tip).clicked() {
            asked.sort = Sort::after_click(self.sort, by, parts[0].0);
        }
        if parts.len() < 2 {
            return;
        }
        let part = now.map_or(parts[0].0, |sort| sort.part);
        let name = parts.iter().find(|(known, _)| *known == part);
        let name = name.map_or("…", |(_, name)| name.as_str());
        ui.menu_button(RichText::new(format!("by {name}")).small(), |ui| {
            for (part, name) in &parts {
                let is_now = now.is_some_and(|sort| sort.part == *part);
                if ui.selectable_label(is_now, name).clicked() {
                    asked.sort = Some(Sort {
                        by,
                        part: *part,
                        is_descending: now.is_some_and(|sort| sort.is_descending),
                    });
                }
            }
        });
    }

    /// Which way the rows run by this column, if they do.
    fn arrow(&self, by: By) -> &'static str {
        match self.sort {
            Some(sort) if sort.by == by && sort.is_descending => "  ▼",
            Some(sort) if sort.by == by => "  ▲",
            _ => "",
        }
    }

    fn row(
        &self,
        row: &mut TableRow<'_, '_>,
        block: &Block,
        mut editor: Option<&mut Editor>,
        asked: &mut Asked,
    ) {
        let place = row.index();
        let Some((index, id)) = block.row(place) else {
            return;
        };
        row.set_selected(self.selected == Some(id));
        row.col(|ui| {
            let text = RichText::new(id.to_string()).monospace();
            let is_followed = self.followed == Some(id);
            let text = if is_followed {
                text.strong().underline()
            } else {
                text
            };
            ui.add(Label::new(text).selectable(false));
        });
        for (column, cells) in self.columns.iter().zip(&block.cells) {
            let editor = editor
                .as_deref_mut()
                .filter(|editor| editor.is_at(column, id));
            let is_edited = editor.is_some();
            let (_, response) = row.col(|ui| match editor {
                Some(editor) => asked.apply |= editor.show(ui),
                None => cell(ui, cells, place - block.from),
            });
            if response.double_clicked() && !is_edited {
                asked.edit = Some(((*column).clone(), id));
            }
        }
        if row.response().clicked() {
            asked.select = Some((index, id));
        }
    }
}

/// A headline that can be clicked.
fn sort_label(ui: &mut egui::Ui, text: String) -> egui::Response {
    let text = RichText::new(text).strong();
    ui.add(Label::new(text).selectable(false).sense(Sense::click()))
}

/// A cell's text; where the column can't be read, a dash whose hover says why.
fn cell(ui: &mut egui::Ui, cells: &Result<ColumnData, TableError>, i: usize) {
    let label = |text: String| Label::new(RichText::new(text).monospace()).selectable(false);
    match cells {
        Ok(cells) => {
            if let Some(cell) = cells.cell(i) {
                ui.add(label(shown(&cell)));
            }
        }
        Err(error) => {
            ui.add(label("–".to_owned()))
                .on_hover_text(error.to_string());
        }
    }
}

/// Of a column at the start, points: about ten letters a number.
fn width(kind: Kind) -> f32 {
    match kind {
        Kind::Scalar | Kind::Index => 110.0,
        Kind::Vector => 230.0,
        Kind::Quaternion => 290.0,
        Kind::Matrix => 640.0,
    }
}

/// The cells of the rows in sight.
#[derive(Default)]
struct Block {
    from: usize,
    rows: Vec<usize>,
    ids: Vec<RowId>,
    /// A column's cells each.
    cells: Vec<Result<ColumnData, TableError>>,
}

impl Block {
    fn read(grid: &Grid, from: usize, count: usize) -> Self {
        let rows = grid.rows.block(from, count);
        let (engine, table) = (grid.engine, grid.table.name);
        let cells = |column: &&ColumnInfo| engine.cells(table, column.name, &rows);
        Self {
            from,
            ids: engine.row_ids(table, &rows),
            cells: grid.columns.iter().map(cells).collect(),
            rows,
        }
    }

    fn has(&self, place: usize) -> bool {
        (self.from..self.from + self.rows.len()).contains(&place)
    }

    /// The row at a place, and its ID.
    fn row(&self, place: usize) -> Option<(usize, RowId)> {
        let i = place.checked_sub(self.from)?;
        Some((*self.rows.get(i)?, *self.ids.get(i)?))
    }
}
