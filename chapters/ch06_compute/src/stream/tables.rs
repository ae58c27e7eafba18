//! Chapter 5's tables, up and down by name. What WGSL calls a column and how its rows lie follows from the
//! schema: a `Vec3` has 12 bytes here, where an `array<vec3f>` would have 16, so it goes up as numbers,
//! and generated functions put them together.

use ch00_scenes::{Kind, TableError};
use ch05_properties::columns::{AnyTable, ColumnSpec};
use ch05_properties::data::Data;

use super::{Columns, StreamError};

/// The bindings of generated columns start here; a kernel's own are below.
const FIRST_BINDING: usize = 100;

// ANCHOR: upload
impl Columns {
    /// Takes columns of a table up. They are added the first time, under [`column_name`].
    ///
    /// # Errors
    /// [`StreamError::Table`] for a column that isn't there or that the plan left out;
    /// [`StreamError::TooLarge`], [`StreamError::OutOfMemory`].
    pub fn upload(&mut self, table: &dyn AnyTable, columns: &[&str]) -> Result<(), StreamError> {
        for column in columns {
            let place = place_of(table, column)?;
            let name = column_name(table.name(), column);
            if !self.has(&name) {
                let kind = table.specs()[place].kind;
                let uses = wgpu::BufferUsages::STORAGE;
                self.add_bytes(&name, row_name(kind), kind.size(), table.rows(), uses)?;
            }
            self.write_bytes(&name, table.column(place).memory())?;
        }
        Ok(())
    }

    /// Brings columns of a table down again, together, and waits for them.
    ///
    /// # Errors
    /// As for [`Self::upload`]; [`StreamError::NoRow`] if the table has more rows than went up;
    /// [`StreamError::Failed`].
    pub fn download(&self, table: &mut dyn AnyTable, columns: &[&str]) -> Result<(), StreamError> {
        let mut places = Vec::new();
        let mut parts = Vec::new();
        for column in columns {
            places.push(place_of(table, column)?);
            let name = column_name(table.name(), column);
            parts.push(self.part(&name, 0..table.rows())?);
        }
        self.fetch_parts(&parts, |index, bytes| {
            let column = table.column_mut(places[index]);
            column.memory_mut().copy_from_slice(bytes);
        })
    }
}
// ANCHOR_END: upload

/// What kernels call a table's column: `bodies_position`.
#[must_use]
pub fn column_name(table: &str, column: &str) -> String {
    format!("{table}_{column}")
}

// ANCHOR: wgsl
/// The WGSL of a table: for each column its binding, a function that gives a row's value, and one that
/// sets it. A kernel binds those that it uses.
///
/// # Errors
/// [`TableError::UnknownTable`].
pub fn table_wgsl(data: &Data, table: &str) -> Result<String, TableError> {
    let wanted = data.table(table)?;
    let before = data.tables().into_iter();
    let before = before.take_while(|other| other.name() != table);
    let first = FIRST_BINDING + before.map(|other| other.specs().len()).sum::<usize>();
    let columns = wanted.specs().iter().enumerate();
    let columns = columns.map(|(place, spec)| {
        let name = column_name(table, spec.name);
        column_wgsl(&name, spec, first + place)
    });
    let columns: String = columns.collect();
    Ok(format!("// {}\n{columns}", wanted.about()))
}

// ANCHOR: column_wgsl
/// A column's binding and its two functions.
fn column_wgsl(name: &str, spec: &ColumnSpec, binding: usize) -> String {
    let (element, value) = wgsl_of(spec.kind);
    let count = spec.kind.numbers();
    let is_whole = element == value;
    let number = |n| format!("{name}[{count}u * row + {n}u]");
    let numbers: Vec<_> = (0..count).map(number).collect();
    let get = if is_whole {
        format!("{name}[row]")
    } else {
        format!("{value}({})", numbers.join(", "))
    };
    let set = if is_whole {
        vec![format!("    {name}[row] = value;\n")]
    } else {
        let parts = numbers.iter().enumerate();
        parts
            .map(|(n, number)| format!("    {number} = value{};\n", part_of(spec.kind, n)))
            .collect()
    };
    let unit = if spec.unit.is_empty() { "" } else { ", " };
    format!(
        "\n// {about}{unit}{}\n\
         @group(0) @binding({binding}) var<storage, read_write> {name}: array<{element}>;\n\
         fn get_{name}(row: u32) -> {value} {{\n    return {get};\n}}\n\
         fn set_{name}(row: u32, value: {value}) {{\n{}}}\n",
        spec.unit,
        set.concat(),
        about = spec.about,
    )
}
// ANCHOR_END: column_wgsl
// ANCHOR_END: wgsl

/// What WGSL has an array of, and what a row is.
fn wgsl_of(kind: Kind) -> (&'static str, &'static str) {
    match kind {
        Kind::Scalar => ("f32", "f32"),
        Kind::Index => ("u32", "u32"),
        Kind::Vector => ("f32", "vec3f"),
        Kind::Quaternion => ("vec4f", "vec4f"),
        Kind::Matrix => ("f32", "mat3x3f"),
    }
}

/// A number of a row: a matrix is three columns.
fn part_of(kind: Kind, n: usize) -> String {
    match kind {
        Kind::Matrix => format!("[{}][{}]", n / 3, n % 3),
        _ => format!("[{n}]"),
    }
}

/// What Rust calls a row.
fn row_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Scalar => "f32",
        Kind::Index => "u32",
        Kind::Vector => "Vec3",
        Kind::Quaternion => "Quat",
        Kind::Matrix => "Mat3",
    }
}

/// Where a table has a column with values.
fn place_of(table: &dyn AnyTable, column: &str) -> Result<usize, TableError> {
    let known = || table.specs().iter().map(|spec| spec.name);
    let place = table
        .place_of(column)
        .ok_or_else(|| TableError::unknown_column(table.name(), column, known()))?;
    if table.column(place).is_kept() {
        return Ok(place);
    }
    Err(TableError::LeftOut {
        table: table.name().to_owned(),
        column: column.to_owned(),
        why: "it has no values to take up".to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_is_valid_wgsl_with_bindings_of_its_own() {
        let data = Data::default();
        let names = data.tables().map(AnyTable::name);
        let texts = names.map(|name| table_wgsl(&data, name).expect("a table"));
        let module = naga::front::wgsl::parse_str(&texts.concat()).expect("valid WGSL");
        let variables = module.global_variables.iter();
        let mut bindings: Vec<_> = variables
            .map(|(_, variable)| variable.binding.as_ref().expect("bound").binding)
            .collect();
        let columns = data.tables().map(|table| table.specs().len());
        assert_eq!(bindings.len(), columns.iter().sum::<usize>());
        bindings.sort_unstable();
        bindings.dedup();
        assert_eq!(bindings.len(), columns.iter().sum::<usize>());
    }

    #[test]
    fn a_vector_is_read_and_set_by_its_three_numbers() {
        let text = table_wgsl(&Data::default(), "bodies").expect("a table");
        let set = "fn set_bodies_position(row: u32, value: vec3f) {\n    \
                   bodies_position[3u * row + 0u] = value[0];";
        assert!(text.contains(set), "{text}");
    }
}
