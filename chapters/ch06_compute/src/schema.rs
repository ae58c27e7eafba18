//! The rows of this chapter as the overlay's tables: a column a property, by name.

use ch00_scenes::{ColumnData, ColumnInfo, Kind, TableError, TableInfo};

use crate::rows::{FieldSpec, Row};

/// A column of rows, of any kind of row.
#[derive(Clone, Copy)]
pub struct RowColumn<'a> {
    fields: &'static [FieldSpec],
    stride: usize,
    bytes: &'a [u8],
}

impl<'a> RowColumn<'a> {
    /// What lies in a slice of rows.
    #[must_use]
    pub fn of<R: Row>(rows: &'a [R]) -> Self {
        Self {
            fields: R::FIELDS,
            stride: size_of::<R>(),
            bytes: bytemuck::cast_slice(rows),
        }
    }

    /// A property that is a row by itself, such as an attitude.
    #[must_use]
    pub fn alone<T: bytemuck::Pod>(spec: &'static [FieldSpec], values: &'a [T]) -> Self {
        Self {
            fields: spec,
            stride: size_of::<T>(),
            bytes: bytemuck::cast_slice(values),
        }
    }

    /// Rows that came as bytes.
    #[must_use]
    pub fn of_bytes(fields: &'static [FieldSpec], stride: usize, bytes: &'a [u8]) -> Self {
        Self {
            fields,
            stride,
            bytes,
        }
    }

    fn cells(&self, field: &FieldSpec, rows: &[usize]) -> ColumnData {
        let rows = rows
            .iter()
            .filter(|&&row| (row + 1) * self.stride <= self.bytes.len());
        let starts = rows.map(|&row| row * self.stride + field.offset);
        match kind_of(field) {
            Some(Kind::Index) => {
                ColumnData::Index(starts.map(|at| number(self.bytes, at)).collect())
            }
            Some(Kind::Vector) => {
                ColumnData::Vector(starts.map(|at| number(self.bytes, at)).collect())
            }
            Some(Kind::Quaternion) => {
                ColumnData::Quaternion(starts.map(|at| number(self.bytes, at)).collect())
            }
            _ => ColumnData::Scalar(starts.map(|at| number(self.bytes, at)).collect()),
        }
    }
}

/// Numbers of a type, wherever they lie.
fn number<T: bytemuck::Pod>(bytes: &[u8], at: usize) -> T {
    bytemuck::pod_read_unaligned(&bytes[at..at + size_of::<T>()])
}

/// What a cell of a field is; None for what isn't shown: fillers, and lists of points.
fn kind_of(field: &FieldSpec) -> Option<Kind> {
    match field.wgsl {
        _ if field.about.starts_with("Unused") => None,
        "f32" => Some(Kind::Scalar),
        "u32" => Some(Kind::Index),
        "vec3f" => Some(Kind::Vector),
        "vec4f" => Some(Kind::Quaternion),
        _ => None,
    }
}

/// A table of columns of rows.
#[derive(Clone)]
pub struct RowTable<'a> {
    /// Its name.
    pub name: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// How many rows it has.
    pub rows: usize,
    /// Its columns of rows.
    pub columns: Vec<RowColumn<'a>>,
}

impl RowTable<'_> {
    fn fields(&self) -> impl Iterator<Item = (&RowColumn<'_>, &'static FieldSpec, Kind)> {
        self.columns.iter().flat_map(|column| {
            let shown = column.fields.iter();
            shown.filter_map(move |field| kind_of(field).map(|kind| (column, field, kind)))
        })
    }

    /// What the overlay shows of it.
    #[must_use]
    pub fn info(&self) -> TableInfo {
        let columns = self.fields().map(|(_, field, kind)| ColumnInfo {
            name: field.name,
            symbol: field.symbol,
            unit: field.unit,
            about: field.about,
            kind,
            editable: false,
            left_out: None,
        });
        TableInfo {
            name: self.name,
            about: self.about,
            rows: self.rows,
            columns: columns.collect(),
        }
    }

    /// Cells of some rows of a property.
    ///
    /// # Errors
    /// [`TableError`] where there is no such property.
    pub fn cells(&self, name: &str, rows: &[usize]) -> Result<ColumnData, TableError> {
        let found = self.fields().find(|(_, field, _)| field.name == name);
        found
            .map(|(column, field, _)| column.cells(field, rows))
            .ok_or_else(|| {
                let known = self.fields().map(|(_, field, _)| field.name);
                TableError::unknown_column(self.name, name, known)
            })
    }
}
