//! The device's columns as the overlay's tables. A table's rows come down late, with the state of the same
//! step, and only while somebody looks at it.

use std::cell::Cell;

use ch00_scenes::{ColumnData, TableError, TableInfo};

use crate::rows::{
    Ball, Before, Bound, Contact, Drawn, FieldSpec, Held, Holding, Limit, Memory, Mover, Node,
    Partner, Pivot, Place, Pole, Pressed, Rigid, Row, Seen, Total, Turned, Wall, WgslType,
};
use crate::schema::{RowColumn, RowTable};
use crate::stream::{self, Columns, Passes, Readback, StreamError};

/// At most so many bytes of a column come down: the first rows of one that is longer.
const MOST_BYTES: usize = 1 << 26;

/// So many requests still bring a table that nobody has read since.
const KEEP: u8 = 3;

/// What is told of a column.
#[derive(Debug)]
struct Told {
    name: &'static str,
    about: &'static str,
    fields: &'static [FieldSpec],
    row_bytes: usize,
}

const fn told<R: Row>(name: &'static str) -> Told {
    Told {
        name,
        about: R::ABOUT,
        fields: R::FIELDS,
        row_bytes: size_of::<R>(),
    }
}

/// Of a column of whole numbers.
const fn number(name: &'static str, about: &'static str) -> Told {
    Told {
        name,
        about,
        fields: NUMBER,
        row_bytes: 4,
    }
}

const NUMBER: &[FieldSpec] = &[FieldSpec {
    name: "value",
    symbol: "",
    unit: "",
    about: "The number.",
    wgsl: <u32 as WgslType>::WGSL,
    offset: 0,
}];

/// The columns that can be looked at, of balls and of pairs. Of two columns between which a state goes back and
/// forth, `_a` and `_b`, one has what is true now.
const TOLD: &[Told] = &[
    told::<Rigid>("rigids"),
    told::<Holding>("holdings"),
    told::<Before>("befores"),
    told::<Bound>("bounds"),
    told::<Bound>("sorted"),
    told::<Partner>("partners_a"),
    told::<Partner>("partners_b"),
    told::<Contact>("touches"),
    told::<Memory>("memories_a"),
    told::<Memory>("memories_b"),
    told::<Pressed>("presses"),
    told::<Total>("totals"),
    told::<Node>("nodes"),
    told::<Held>("joined"),
    told::<Limit>("limits"),
    told::<Turned>("turned"),
    told::<Node>("loops"),
    told::<Pivot>("pivots"),
    told::<Pole>("poles"),
    told::<Place>("places_a"),
    told::<Place>("places_b"),
    told::<Mover>("movers_a"),
    told::<Mover>("movers_b"),
    told::<Ball>("balls_a"),
    told::<Ball>("balls_b"),
    told::<Held>("helds_a"),
    told::<Held>("helds_b"),
    number("neighbour_counts_a", "How many neighbours a ball has."),
    number("neighbour_counts_b", "How many neighbours a ball has."),
    told::<Wall>("walls"),
    number("slots", "In which slot of the grid's table a row is."),
    number("order", "Rows in the order of the grid."),
    number("counts", "How many rows a slot of the grid has."),
    number("starts", "Where the rows of a slot begin."),
    number("status", "What the kernels say of how it goes."),
    told::<Drawn>("drawn"),
    told::<Seen>("seen"),
];

/// The tables of a run.
#[derive(Debug, Default)]
pub struct Tables {
    all: Vec<Table>,
}

#[derive(Debug)]
struct Table {
    told: &'static Told,
    /// How many requests will still bring it, unless somebody reads it again.
    wanted: Cell<u8>,
    readback: Readback,
    is_asked: bool,
    coming: Option<Vec<u8>>,
    /// The rows that are here, and the step after which they were so.
    here: Option<(u32, Vec<u8>)>,
}

impl Table {
    fn of(told: &'static Told) -> Self {
        Self {
            told,
            wanted: Cell::new(0),
            readback: Readback::default(),
            is_asked: false,
            coming: None,
            here: None,
        }
    }

    /// How many rows come down: those in use, or where only the device knows how many these are, those for
    /// which there is memory.
    fn rows(&self, columns: &Columns) -> usize {
        let most = MOST_BYTES / self.told.row_bytes;
        columns.info(self.told.name).map_or(0, |info| {
            let rows = if info.rows > 0 {
                info.rows
            } else {
                info.capacity
            };
            rows.min(most)
        })
    }

    fn show<'a>(&self, rows: usize, bytes: &'a [u8]) -> RowTable<'a> {
        RowTable {
            name: self.told.name,
            about: self.told.about,
            rows,
            columns: vec![RowColumn::of_bytes(
                self.told.fields,
                self.told.row_bytes,
                bytes,
            )],
        }
    }

    fn is_of(&self, step: Option<u32>) -> bool {
        self.here.as_ref().map(|(of, _)| *of) == step
    }
}

impl Tables {
    /// Those of the columns that there are.
    #[must_use]
    pub fn of(columns: &Columns) -> Self {
        let all = TOLD.iter().filter(|told| columns.has(told.name));
        Self {
            all: all.map(Table::of).collect(),
        }
    }

    /// What the overlay shows of them.
    #[must_use]
    pub fn info(&self, columns: &Columns) -> Vec<TableInfo> {
        let info = |table: &Table| table.show(table.rows(columns), &[]).info();
        self.all.iter().map(info).collect()
    }

    /// Their names.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.all.iter().map(|table| table.told.name)
    }

    /// Cells of some rows as they were after a step, if that is the step whose rows are here; they are asked
    /// for then and otherwise.
    ///
    /// # Errors
    /// [`TableError`] where there is no such table or column, or its rows are still on their way.
    pub fn cells(
        &self,
        table: &str,
        column: &str,
        rows: &[usize],
        step: Option<u32>,
    ) -> Result<ColumnData, TableError> {
        let found = self.all.iter().find(|known| known.told.name == table);
        let found = found.ok_or_else(|| {
            let known = [ch00_scenes::BODIES].into_iter().chain(self.names());
            TableError::unknown_table(table, known)
        })?;
        found.wanted.set(KEEP);
        match &found.here {
            Some((_, bytes)) if found.is_of(step) => {
                let rows_here = bytes.len() / found.told.row_bytes;
                found.show(rows_here, bytes).cells(column, rows)
            }
            _ => Err(TableError::OnTheWay {
                table: table.to_owned(),
            }),
        }
    }

    /// Whether somebody wants rows as they were after this step, and they aren't here.
    #[must_use]
    pub fn lacks(&self, step: Option<u32>) -> bool {
        let lacks = |table: &Table| table.wanted.get() > 0 && !table.is_of(step);
        self.all.iter().any(lacks)
    }

    /// Asks for the rows that somebody wants.
    ///
    /// # Errors
    /// A lost device.
    pub fn ask(
        &mut self,
        columns: &Columns,
        passes: &mut Passes<'_>,
        label: u64,
    ) -> Result<(), StreamError> {
        for table in &mut self.all {
            let left = table.wanted.get();
            table.wanted.set(left.saturating_sub(1));
            table.coming = None;
            table.is_asked = false;
            if left > 0 {
                let rows = table.rows(columns);
                table.is_asked =
                    passes.read_back(&mut table.readback, table.told.name, 0..rows, label)?;
            }
        }
        Ok(())
    }

    /// Takes what has come of the request with this label; whether all has.
    pub fn take(&mut self, label: impl Fn(u64) -> bool) -> bool {
        for table in self.all.iter_mut().filter(|table| table.is_asked) {
            let late: Option<stream::Late<u8>> = table.readback.latest();
            if let Some(late) = late.filter(|late| label(late.frame)) {
                table.coming = Some(late.rows);
            }
        }
        let has_come = |table: &Table| !table.is_asked || table.coming.is_some();
        self.all.iter().all(has_come)
    }

    /// What has come is of this step.
    pub fn keep(&mut self, step: u32) {
        for table in &mut self.all {
            table.is_asked = false;
            if let Some(bytes) = table.coming.take() {
                table.here = Some((step, bytes));
            }
        }
    }

    /// What is here or on its way is no longer true.
    pub fn forget(&mut self) {
        for table in &mut self.all {
            table.is_asked = false;
            table.coming = None;
            table.here = None;
        }
    }
}
