//! The test engine's tables: its points, which can be edited and have IDs that outlive those
//! before them, and the pairs of neighbours, which follow from them.

use ch00_scenes::{BODIES, Cell, ColumnData, ColumnInfo, Edit, Kind, RowId, TableError, TableInfo};
use glam::Vec3;

use super::Falling;

/// A table that nobody can edit.
pub(crate) const PAIRS: &str = "pairs";

/// Farther out than this no point can be put, m.
pub(crate) const FARTHEST: f32 = 1000.0;

/// The IDs of the points, in their order.
#[derive(Default)]
pub(super) struct Ids {
    of_rows: Vec<RowId>,
    /// IDs of rows that are gone, to be used again with the next generation.
    free: Vec<RowId>,
}

impl Ids {
    pub(super) fn add(&mut self) {
        let id = self.free.pop().map_or_else(
            || RowId::first(self.of_rows.len() as u32),
            |gone| RowId {
                generation: gone.generation + 1,
                ..gone
            },
        );
        self.of_rows.push(id);
    }

    pub(super) fn remove(&mut self, row: usize) {
        self.free.push(self.of_rows.remove(row));
    }
}

fn column(name: &'static str, symbol: &'static str, unit: &'static str, kind: Kind) -> ColumnInfo {
    ColumnInfo {
        name,
        symbol,
        unit,
        about: "A column of the test engine.",
        kind,
        editable: false,
        left_out: None,
    }
}

impl Falling {
    pub(super) fn table_infos(&self) -> Vec<TableInfo> {
        let editable = |info: ColumnInfo| ColumnInfo {
            editable: true,
            ..info
        };
        let spin = ColumnInfo {
            left_out: Some("points don't turn".to_owned()),
            ..column("spin", "ω", "rad/s", Kind::Vector)
        };
        vec![
            TableInfo {
                name: BODIES,
                about: "The points.",
                rows: self.position.len(),
                columns: vec![
                    editable(column("position", "p", "m", Kind::Vector)),
                    editable(column("velocity", "v", "m/s", Kind::Vector)),
                    column("height", "h", "m", Kind::Scalar),
                    spin,
                ],
            },
            TableInfo {
                name: PAIRS,
                about: "Neighbours.",
                rows: self.position.len().saturating_sub(1),
                columns: vec![
                    column("second", "j", "", Kind::Index),
                    column("distance", "d", "m", Kind::Scalar),
                ],
            },
        ]
    }

    pub(super) fn cells_of(
        &self,
        table: &str,
        column: &str,
        rows: &[usize],
    ) -> Result<ColumnData, TableError> {
        let vectors = |values: &[Vec3]| {
            ColumnData::Vector(rows.iter().map(|&i| values[i].to_array()).collect())
        };
        match (table, column) {
            (BODIES, "position") => Ok(vectors(&self.position)),
            (BODIES, "velocity") => Ok(vectors(&self.velocity)),
            (BODIES, "height") => Ok(ColumnData::Scalar(
                rows.iter().map(|&i| self.position[i].y).collect(),
            )),
            (BODIES, "spin") => Err(TableError::LeftOut {
                table: table.to_owned(),
                column: column.to_owned(),
                why: "points don't turn".to_owned(),
            }),
            (PAIRS, "second") => Ok(ColumnData::Index(
                rows.iter().map(|&i| i as u32 + 1).collect(),
            )),
            (PAIRS, "distance") => {
                let distance = |&i: &usize| self.position[i].distance(self.position[i + 1]);
                Ok(ColumnData::Scalar(rows.iter().map(distance).collect()))
            }
            (BODIES | PAIRS, _) => Err(TableError::unknown_column(table, column, [])),
            _ => Err(TableError::unknown_table(table, [BODIES, PAIRS])),
        }
    }

    pub(super) fn ids_of(&self, table: &str, rows: &[usize]) -> Vec<RowId> {
        let id = |&row: &usize| match table {
            BODIES => self.ids.of_rows.get(row).copied(),
            _ => Some(RowId::first(row as u32)),
        };
        rows.iter().filter_map(id).collect()
    }

    pub(super) fn row_with(&self, table: &str, id: RowId) -> Option<usize> {
        if table == BODIES {
            return self.ids.of_rows.iter().position(|&known| known == id);
        }
        let row = id.slot as usize;
        (id.generation == 0 && row + 1 < self.position.len()).then_some(row)
    }

    pub(super) fn change(&mut self, edit: &Edit) -> Result<Cell, TableError> {
        let (table, column) = (edit.table.clone(), edit.column.clone());
        let row = self.row_with(&table, edit.row).ok_or(TableError::Stale {
            table: table.clone(),
            row: edit.row,
        })?;
        let cells = match (table.as_str(), column.as_str()) {
            (BODIES, "position") => &mut self.position,
            (BODIES, "velocity") => &mut self.velocity,
            _ => {
                let why = "it follows from the points".to_owned();
                return Err(TableError::NotEditable { table, column, why });
            }
        };
        let Cell::Vector(value) = edit.value else {
            let what = "a vector is needed".to_owned();
            return Err(TableError::BadValue {
                table,
                column,
                what,
            });
        };
        if value.iter().any(|part| part.abs() > FARTHEST) {
            let what = format!("more than {FARTHEST} m away");
            return Err(TableError::BadValue {
                table,
                column,
                what,
            });
        }
        let old = std::mem::replace(&mut cells[row], Vec3::from(value));
        Ok(Cell::Vector(old.to_array()))
    }
}
