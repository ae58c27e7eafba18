//! What was worked out from the engine's tables, kept while nothing in them has changed, so that a
//! paused scene costs nothing to look at.

use ch00_scenes::{BODIES, TableError, TableInfo};

use crate::stage::Stage;
use crate::tables::View;
use crate::tables::filter::Filter;
use crate::tables::rows::Rows;
use crate::tables::sort::Sort;

/// Tables and rows of a revision.
#[derive(Default)]
pub struct Snapshot {
    tables: Option<((u32, u64), Vec<TableInfo>)>,
    rows: Option<(Key, Outcome)>,
}

/// Rows, or why a column can't be read.
pub type Outcome = Result<Rows, TableError>;

/// What rows follow from.
#[derive(PartialEq)]
struct Key {
    revision: (u32, u64),
    table: &'static str,
    sort: Option<Sort>,
    filter: Filter,
    only: Option<usize>,
}

impl Snapshot {
    /// The engine's tables.
    pub fn tables(&mut self, stage: &Stage) -> &[TableInfo] {
        let revision = stage.revision();
        if self
            .tables
            .as_ref()
            .is_none_or(|(known, _)| *known != revision)
        {
            self.tables = Some((revision, stage.session().engine().tables()));
        }
        self.tables.as_ref().map_or(&[], |(_, tables)| tables)
    }

    /// The rows that a view wants of a table.
    pub fn rows(&mut self, stage: &Stage, table: &TableInfo, view: &View) -> Outcome {
        let picked = stage.picked.filter(|_| table.name == BODIES);
        let key = Key {
            revision: stage.revision(),
            table: table.name,
            sort: view.sort,
            filter: view.filter.filter().clone(),
            only: picked.filter(|_| view.only_picked),
        };
        if let Some((known, rows)) = &self.rows
            && *known == key
        {
            return rows.clone();
        }
        let rows = Rows::of(stage.session().engine(), table, view, key.only);
        self.rows = Some((key, rows.clone()));
        rows
    }
}
