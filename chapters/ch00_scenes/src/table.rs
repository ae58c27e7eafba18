//! The tables of an engine, as the overlay sees them: what there is, the cells of chosen rows, and
//! a cell that someone wants to change. An engine states its tables once; the overlay knows none by name.

use std::fmt;

use thiserror::Error;

use crate::{Column, ColumnData};

/// A table: all rows of one kind of thing.
#[derive(Clone, Debug, PartialEq)]
pub struct TableInfo {
    /// `bodies`, `joints`, `contacts` …
    pub name: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// How many rows it has now.
    pub rows: usize,
    /// Its columns, in its order.
    pub columns: Vec<ColumnInfo>,
}

/// A column: one property of all rows.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnInfo {
    /// As the code calls it: `last_position`.
    pub name: &'static str,
    /// As the book's formulas call it: `p*`.
    pub symbol: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// What a cell is.
    pub kind: Kind,
    /// Whether [`crate::Engine::edit`] may change its cells.
    pub editable: bool,
    /// Why this scene doesn't need it, where the engine's plan left it out: then it has no cells.
    pub left_out: Option<String>,
}

impl ColumnInfo {
    /// Of a column that was gathered from objects.
    #[must_use]
    pub fn gathered(column: &Column) -> Self {
        Self {
            name: column.name,
            symbol: column.name,
            unit: column.unit,
            about: column.about,
            kind: column.data.kind(),
            editable: false,
            left_out: None,
        }
    }
}

/// What a cell of a column is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A number.
    Scalar,
    /// Three numbers: x, y, z.
    Vector,
    /// Four numbers: x, y, z, w.
    Quaternion,
    /// Nine numbers, column by column.
    Matrix,
    /// A whole number: a row of another table, a kind, a count.
    Index,
}

impl Kind {
    /// Bytes of a cell.
    #[must_use]
    pub const fn size(self) -> usize {
        4 * self.numbers()
    }

    /// Numbers in a cell.
    #[must_use]
    pub const fn numbers(self) -> usize {
        match self {
            Kind::Scalar | Kind::Index => 1,
            Kind::Vector => 3,
            Kind::Quaternion => 4,
            Kind::Matrix => 9,
        }
    }
}

/// Names a row for as long as it lives, whatever becomes of the rows before it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RowId {
    /// Its number: that of no other row that lives.
    pub slot: u32,
    /// How many rows had this number before.
    pub generation: u32,
}

impl RowId {
    /// The first row with this number.
    #[must_use]
    pub const fn first(slot: u32) -> Self {
        Self {
            slot,
            generation: 0,
        }
    }
}

impl fmt::Display for RowId {
    /// `12`, or `12.3` where three rows had the number before.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.generation == 0 {
            write!(f, "{}", self.slot)
        } else {
            write!(f, "{}.{}", self.slot, self.generation)
        }
    }
}

/// The value of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A number.
    Scalar(f32),
    /// x, y, z.
    Vector([f32; 3]),
    /// x, y, z, w.
    Quaternion([f32; 4]),
    /// Column by column.
    Matrix([f32; 9]),
    /// A whole number.
    Index(u32),
}

impl Cell {
    /// What it is.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self {
            Cell::Scalar(_) => Kind::Scalar,
            Cell::Vector(_) => Kind::Vector,
            Cell::Quaternion(_) => Kind::Quaternion,
            Cell::Matrix(_) => Kind::Matrix,
            Cell::Index(_) => Kind::Index,
        }
    }

    /// Its numbers, where it has real ones.
    #[must_use]
    pub fn numbers(&self) -> &[f32] {
        match self {
            Cell::Scalar(value) => std::slice::from_ref(value),
            Cell::Vector(values) => values,
            Cell::Quaternion(values) => values,
            Cell::Matrix(values) => values,
            Cell::Index(_) => &[],
        }
    }
}

/// A cell that is to get another value.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// Name of the table.
    pub table: String,
    /// Name of the column.
    pub column: String,
    /// Which row.
    pub row: RowId,
    /// What it shall be.
    pub value: Cell,
}

/// Why a cell can't be read or changed.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum TableError {
    /// There is no such table.
    #[error("there is no table `{table}`; there are: {known}")]
    UnknownTable {
        /// What was asked for.
        table: String,
        /// What there is, separated by commas.
        known: String,
    },
    /// The table has no such column.
    #[error("table `{table}` has no column `{column}`; it has: {known}")]
    UnknownColumn {
        /// Name of the table.
        table: String,
        /// What was asked for.
        column: String,
        /// What there is, separated by commas.
        known: String,
    },
    /// The table's rows are on a device, and those that were asked for haven't come.
    #[error("the rows of table `{table}` are on their way from the device")]
    OnTheWay {
        /// Name of the table.
        table: String,
    },
    /// The plan of this scene left the column out.
    #[error("column `{table}.{column}` was left out of this scene's plan: {why}")]
    LeftOut {
        /// Name of the table.
        table: String,
        /// Name of the column.
        column: String,
        /// Why the scene doesn't need it.
        why: String,
    },
    /// The row is gone.
    #[error("table `{table}` has no row {row} any more")]
    Stale {
        /// Name of the table.
        table: String,
        /// The row's ID.
        row: RowId,
    },
    /// What stands there is worked out anew in every step, or a change would break what depends on it.
    #[error("column `{table}.{column}` can't be edited: {why}")]
    NotEditable {
        /// Name of the table.
        table: String,
        /// Name of the column.
        column: String,
        /// Why not.
        why: String,
    },
    /// The value doesn't fit the column.
    #[error("column `{table}.{column}`: {what}")]
    BadValue {
        /// Name of the table.
        table: String,
        /// Name of the column.
        column: String,
        /// What is wrong with it.
        what: String,
    },
}

impl TableError {
    /// For a table that there isn't, with those that there are.
    pub fn unknown_table(table: &str, known: impl IntoIterator<Item = &'static str>) -> Self {
        Self::UnknownTable {
            table: table.to_owned(),
            known: listed(known),
        }
    }

    /// For a column that there isn't, with those that there are.
    pub fn unknown_column(
        table: &str,
        column: &str,
        known: impl IntoIterator<Item = &'static str>,
    ) -> Self {
        Self::UnknownColumn {
            table: table.to_owned(),
            column: column.to_owned(),
            known: listed(known),
        }
    }
}

fn listed(names: impl IntoIterator<Item = &'static str>) -> String {
    names.into_iter().collect::<Vec<_>>().join(", ")
}

impl ColumnData {
    /// How many cells it has.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            ColumnData::Scalar(values) => values.len(),
            ColumnData::Vector(values) => values.len(),
            ColumnData::Quaternion(values) => values.len(),
            ColumnData::Matrix(values) => values.len(),
            ColumnData::Index(values) => values.len(),
        }
    }

    /// Whether it has none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// What its cells are.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self {
            ColumnData::Scalar(_) => Kind::Scalar,
            ColumnData::Vector(_) => Kind::Vector,
            ColumnData::Quaternion(_) => Kind::Quaternion,
            ColumnData::Matrix(_) => Kind::Matrix,
            ColumnData::Index(_) => Kind::Index,
        }
    }

    /// One cell.
    #[must_use]
    pub fn cell(&self, i: usize) -> Option<Cell> {
        Some(match self {
            ColumnData::Scalar(values) => Cell::Scalar(*values.get(i)?),
            ColumnData::Vector(values) => Cell::Vector(*values.get(i)?),
            ColumnData::Quaternion(values) => Cell::Quaternion(*values.get(i)?),
            ColumnData::Matrix(values) => Cell::Matrix(*values.get(i)?),
            ColumnData::Index(values) => Cell::Index(*values.get(i)?),
        })
    }

    /// The cells of some rows, in their order; rows that there aren't give none.
    #[must_use]
    pub fn of_rows(&self, rows: &[usize]) -> Self {
        fn pick<T: Copy>(values: &[T], rows: &[usize]) -> Vec<T> {
            rows.iter()
                .filter_map(|&i| values.get(i).copied())
                .collect()
        }
        match self {
            ColumnData::Scalar(values) => ColumnData::Scalar(pick(values, rows)),
            ColumnData::Vector(values) => ColumnData::Vector(pick(values, rows)),
            ColumnData::Quaternion(values) => ColumnData::Quaternion(pick(values, rows)),
            ColumnData::Matrix(values) => ColumnData::Matrix(pick(values, rows)),
            ColumnData::Index(values) => ColumnData::Index(pick(values, rows)),
        }
    }
}
