//! What every table is made of: columns of plain values, IDs for rows, and the macro that states a
//! table once and gives the struct, the row and the schema.

mod column;
mod ids;
mod table;

pub use column::{AnyColumn, Column, Value};
pub use ids::Ids;
pub use table::{AnyTable, ColumnSpec, Table};

pub use ch00_scenes::RowId;
