//! What someone wants to see of an engine's tables: which columns, which rows, in which order.
//! Plain code over the engine's tables; the overlay shows what comes out of it.

pub mod filter;
pub mod rows;
pub mod sort;
pub mod value;

use ch00_scenes::{ColumnInfo, RowId, TableInfo};

use filter::FilterField;
use sort::Sort;

/// How one table is looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct View {
    /// Names of the columns that are ticked.
    pub columns: Vec<&'static str>,
    /// What the rows are sorted by; none for the engine's order.
    pub sort: Option<Sort>,
    /// Which IDs are let through.
    pub filter: FilterField,
    /// Whether only the picked body's row is shown.
    pub only_picked: bool,
    /// The row that was clicked last.
    pub selected: Option<RowId>,
}

impl View {
    /// The ticked columns that the table has and the engine's plan hasn't left out, in the table's
    /// order.
    #[must_use]
    pub fn shown_columns<'a>(&self, table: &'a TableInfo) -> Vec<&'a ColumnInfo> {
        let is_shown =
            |column: &&ColumnInfo| column.left_out.is_none() && self.columns.contains(&column.name);
        table.columns.iter().filter(is_shown).collect()
    }

    /// Ticks a column or takes it away.
    pub fn toggle(&mut self, column: &'static str) {
        let count = self.columns.len();
        self.columns.retain(|&name| name != column);
        if self.columns.len() == count {
            self.columns.push(column);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_engine::balls;

    #[test]
    fn columns_are_shown_in_the_tables_order_but_for_those_left_out() {
        let session = balls(1);
        let tables = session.engine().tables();
        let mut view = View::default();
        for name in ["height", "spin", "position", "velocity", "velocity"] {
            view.toggle(name);
        }
        let shown = view.shown_columns(&tables[0]);
        let names: Vec<_> = shown.iter().map(|column| column.name).collect();
        assert_eq!(names, ["position", "height"]);
        assert!(view.shown_columns(&tables[1]).is_empty());
    }
}
