//! A column: one property of all rows of a table, one value after the other.

use std::ops::{Deref, DerefMut};

use bytemuck::Pod;
use ch00_scenes::{Cell, ColumnData, Kind};
use glam::{Mat3, Quat, Vec3};

// ANCHOR: column
/// One property of all rows. It reads and writes as a slice.
///
/// A column that the plan left out has no values, however many rows its table has.
#[derive(Clone, Debug)]
pub struct Column<T> {
    values: Vec<T>,
    kept: bool,
}

impl<T> Deref for Column<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.values
    }
}

impl<T> DerefMut for Column<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.values
    }
}
// ANCHOR_END: column

impl<T> Default for Column<T> {
    fn default() -> Self {
        Self {
            values: Vec::new(),
            kept: true,
        }
    }
}

impl<T: Value> Column<T> {
    /// Adds a row's value, if the plan kept the column.
    #[inline]
    pub fn push(&mut self, value: T) {
        if self.kept {
            self.values.push(value);
        }
    }

    /// Makes all values this one, a value a row, if the plan kept the column.
    pub fn fill_rows(&mut self, rows: usize, value: T) {
        if self.kept {
            self.values.clear();
            self.values.resize(rows, value);
        }
    }

    /// Trades all values with another column.
    pub fn trade(&mut self, other: &mut Self) {
        std::mem::swap(&mut self.values, &mut other.values);
    }

    // ANCHOR: bytes
    /// Its memory, ready for upload: nothing is gathered, nothing is converted.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.values)
    }
    // ANCHOR_END: bytes
}

// ANCHOR: value
/// What a column can hold: numbers that lie in memory as a GPU wants them.
pub trait Value: Copy + Default + Pod {
    /// What a cell of it is.
    const KIND: Kind;

    /// As the overlay shows it.
    fn cell(self) -> Cell;

    /// As the overlay hands it back; None if that is something else.
    fn of_cell(cell: Cell) -> Option<Self>;
}
// ANCHOR_END: value

impl Value for f32 {
    const KIND: Kind = Kind::Scalar;

    fn cell(self) -> Cell {
        Cell::Scalar(self)
    }

    fn of_cell(cell: Cell) -> Option<Self> {
        match cell {
            Cell::Scalar(value) => Some(value),
            _ => None,
        }
    }
}

impl Value for u32 {
    const KIND: Kind = Kind::Index;

    fn cell(self) -> Cell {
        Cell::Index(self)
    }

    fn of_cell(cell: Cell) -> Option<Self> {
        match cell {
            Cell::Index(value) => Some(value),
            _ => None,
        }
    }
}

impl Value for Vec3 {
    const KIND: Kind = Kind::Vector;

    fn cell(self) -> Cell {
        Cell::Vector(self.to_array())
    }

    fn of_cell(cell: Cell) -> Option<Self> {
        match cell {
            Cell::Vector(value) => Some(value.into()),
            _ => None,
        }
    }
}

impl Value for Quat {
    const KIND: Kind = Kind::Quaternion;

    fn cell(self) -> Cell {
        Cell::Quaternion(self.to_array())
    }

    fn of_cell(cell: Cell) -> Option<Self> {
        match cell {
            Cell::Quaternion(value) => Some(Self::from_array(value)),
            _ => None,
        }
    }
}

impl Value for Mat3 {
    const KIND: Kind = Kind::Matrix;

    fn cell(self) -> Cell {
        Cell::Matrix(self.to_cols_array())
    }

    fn of_cell(cell: Cell) -> Option<Self> {
        match cell {
            Cell::Matrix(value) => Some(Self::from_cols_array(&value)),
            _ => None,
        }
    }
}

/// A column of any type: what the schema's users know of it.
pub trait AnyColumn {
    /// How many values it has: a value a row, or none if the plan left it out.
    fn count(&self) -> usize;

    /// Whether the plan kept it.
    fn is_kept(&self) -> bool;

    /// Leaves it out from now on, or takes it in, with the type's zero for all `rows`.
    fn set_kept(&mut self, kept: bool, rows: usize);

    /// Its memory.
    fn memory(&self) -> &[u8];

    /// The same, to be changed.
    fn memory_mut(&mut self) -> &mut [u8];

    /// A value; None where there is none.
    fn cell(&self, row: usize) -> Option<Cell>;

    /// The values of some rows; rows that there aren't give none.
    fn cells(&self, rows: &[usize]) -> ColumnData;

    /// Sets a value. Says whether it could: the row must be there and the kind be the column's.
    fn set_cell(&mut self, row: usize, cell: Cell) -> bool;

    /// Takes over the values of a column of the same type.
    fn copy_from(&mut self, other: &dyn AnyColumn);

    /// Keeps the rows that are marked, in their order.
    fn retain_rows(&mut self, keep: &[bool]);

    /// Forgets all values and keeps the memory.
    fn clear(&mut self);
}

impl<T: Value> AnyColumn for Column<T> {
    fn count(&self) -> usize {
        self.values.len()
    }

    fn is_kept(&self) -> bool {
        self.kept
    }

    fn set_kept(&mut self, kept: bool, rows: usize) {
        if kept && !self.kept {
            self.values.resize(rows, T::default());
        } else if !kept {
            self.values = Vec::new();
        }
        self.kept = kept;
    }

    fn memory(&self) -> &[u8] {
        self.bytes()
    }

    fn memory_mut(&mut self) -> &mut [u8] {
        bytemuck::cast_slice_mut(&mut self.values)
    }

    fn cell(&self, row: usize) -> Option<Cell> {
        self.values.get(row).map(|value| value.cell())
    }

    fn cells(&self, rows: &[usize]) -> ColumnData {
        let found = rows.iter().filter_map(|&row| self.cell(row));
        let mut data = match T::KIND {
            Kind::Scalar => ColumnData::Scalar(Vec::new()),
            Kind::Vector => ColumnData::Vector(Vec::new()),
            Kind::Quaternion => ColumnData::Quaternion(Vec::new()),
            Kind::Matrix => ColumnData::Matrix(Vec::new()),
            Kind::Index => ColumnData::Index(Vec::new()),
        };
        for cell in found {
            match (&mut data, cell) {
                (ColumnData::Scalar(values), Cell::Scalar(value)) => values.push(value),
                (ColumnData::Vector(values), Cell::Vector(value)) => values.push(value),
                (ColumnData::Quaternion(values), Cell::Quaternion(value)) => values.push(value),
                (ColumnData::Matrix(values), Cell::Matrix(value)) => values.push(value),
                (ColumnData::Index(values), Cell::Index(value)) => values.push(value),
                _ => unreachable!("a column's cells are of its kind"),
            }
        }
        data
    }

    fn set_cell(&mut self, row: usize, cell: Cell) -> bool {
        match (self.values.get_mut(row), T::of_cell(cell)) {
            (Some(place), Some(value)) => {
                *place = value;
                true
            }
            _ => false,
        }
    }

    fn copy_from(&mut self, other: &dyn AnyColumn) {
        self.values.clear();
        self.values
            .extend_from_slice(bytemuck::cast_slice(other.memory()));
    }

    fn retain_rows(&mut self, keep: &[bool]) {
        let mut keep = keep.iter();
        self.values.retain(|_| keep.next().copied().unwrap_or(true));
    }

    fn clear(&mut self) {
        self.values.clear();
    }
}
