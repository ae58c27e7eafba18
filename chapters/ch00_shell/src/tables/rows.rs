//! The rows of a table that are shown, in their order. Without filter and order these are all
//! rows, and none of their cells is read.

use ch00_scenes::{Engine, RowId, TableError, TableInfo};

use super::View;
use super::sort::{By, sort_by_cells, sort_by_ids};

/// Rows to show.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rows {
    /// So many, in the engine's order.
    All(usize),
    /// These, in this order.
    Listed(Vec<usize>),
}

impl Rows {
    /// Those that a view wants of a table; `picked` is the row of the picked body.
    ///
    /// # Errors
    /// [`TableError`] where the column to sort by can't be read.
    pub fn of(
        engine: &dyn Engine,
        table: &TableInfo,
        view: &View,
        picked: Option<usize>,
    ) -> Result<Self, TableError> {
        let only = picked.filter(|&row| view.only_picked && row < table.rows);
        let filter = view.filter.filter();
        if only.is_none() && filter.is_empty() && view.sort.is_none() {
            return Ok(Rows::All(table.rows));
        }
        let mut rows = match only {
            Some(row) => vec![row],
            None => (0..table.rows).collect(),
        };
        if !filter.is_empty() {
            let ids = engine.row_ids(table.name, &rows);
            let pairs = rows.iter().zip(ids);
            let fitting = pairs.filter(|(_, id)| filter.lets_through(*id));
            rows = fitting.map(|(&row, _)| row).collect();
        }
        if let Some(sort) = view.sort {
            match sort.by {
                By::Id => {
                    let ids = engine.row_ids(table.name, &rows);
                    sort_by_ids(&mut rows, &ids, sort.is_descending);
                }
                By::Column(column) => {
                    let cells = engine.cells(table.name, column, &rows)?;
                    sort_by_cells(&mut rows, &cells, sort.part, sort.is_descending);
                }
            }
        }
        Ok(Rows::Listed(rows))
    }

    /// How many.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Rows::All(count) => *count,
            Rows::Listed(rows) => rows.len(),
        }
    }

    /// The row at a place.
    #[must_use]
    pub fn at(&self, place: usize) -> Option<usize> {
        match self {
            Rows::All(count) => (place < *count).then_some(place),
            Rows::Listed(rows) => rows.get(place).copied(),
        }
    }

    /// The rows at so many places from one on, as far as there are any.
    #[must_use]
    pub fn block(&self, from: usize, count: usize) -> Vec<usize> {
        (from..from.saturating_add(count))
            .map_while(|place| self.at(place))
            .collect()
    }

    /// The place of a row, if it is shown.
    #[must_use]
    pub fn place_of(&self, row: usize) -> Option<usize> {
        match self {
            Rows::All(count) => (row < *count).then_some(row),
            Rows::Listed(rows) => rows.iter().position(|&known| known == row),
        }
    }
}

/// The ID of one row of a table.
#[must_use]
pub fn id_of(engine: &dyn Engine, table: &str, row: usize) -> Option<RowId> {
    engine.row_ids(table, &[row]).first().copied()
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{BODIES, Cell, Edit, RowId};

    use super::*;
    use crate::Session;
    use crate::tables::sort::{Part, Sort};
    use crate::test_engine::{PAIRS, balls};

    /// Balls at these heights.
    fn at_heights(heights: &[f32]) -> Session {
        let mut session = balls(heights.len());
        for (i, &height) in heights.iter().enumerate() {
            let edit = Edit {
                table: BODIES.to_owned(),
                column: "position".to_owned(),
                row: RowId::first(i as u32),
                value: Cell::Vector([i as f32, height, 0.0]),
            };
            session.edit(&edit).expect("it fits");
        }
        session
    }

    fn rows(session: &Session, table: usize, view: &View, picked: Option<usize>) -> Rows {
        let table = &session.engine().tables()[table];
        Rows::of(session.engine(), table, view, picked).expect("it can be read")
    }

    fn by(column: &'static str, part: Part) -> View {
        View {
            sort: Some(Sort {
                by: By::Column(column),
                part,
                is_descending: false,
            }),
            ..View::default()
        }
    }

    fn filtered(view: View, text: &str) -> View {
        let mut view = view;
        text.clone_into(&mut view.filter.text);
        view.filter.read();
        view
    }

    #[test]
    fn without_filter_and_order_all_rows_are_shown_unread() {
        let session = balls(4);
        assert_eq!(rows(&session, 0, &View::default(), Some(2)), Rows::All(4));
        assert_eq!(rows(&session, 1, &View::default(), None), Rows::All(3));
    }

    #[test]
    fn rows_follow_the_order_of_a_columns_cells() {
        let session = at_heights(&[3.0, 1.0, 2.0]);
        let found = rows(&session, 0, &by("height", Part::Whole), None);
        assert_eq!(found, Rows::Listed(vec![1, 2, 0]));
        let found = rows(&session, 0, &by("position", Part::Number(1)), None);
        assert_eq!(found, Rows::Listed(vec![1, 2, 0]));
        let found = rows(&session, 1, &by("distance", Part::Whole), None);
        assert_eq!(found, Rows::Listed(vec![1, 0]));
    }

    #[test]
    fn a_filter_is_by_id_and_not_by_row() {
        let mut session = at_heights(&[3.0, 1.0, 2.0, 0.0]);
        session.remove_body(0).expect("nothing holds it");
        let view = filtered(by("height", Part::Whole), "1-2");
        assert_eq!(rows(&session, 0, &view, None), Rows::Listed(vec![0, 1]));
        let view = filtered(View::default(), "3, 0");
        assert_eq!(rows(&session, 0, &view, None), Rows::Listed(vec![2]));
    }

    #[test]
    fn only_the_picked_body_is_one_row_and_all_where_none_is_picked() {
        let session = balls(3);
        let view = View {
            only_picked: true,
            ..View::default()
        };
        assert_eq!(rows(&session, 0, &view, Some(1)), Rows::Listed(vec![1]));
        assert_eq!(rows(&session, 0, &view, None), Rows::All(3));
        assert_eq!(rows(&session, 0, &view, Some(7)), Rows::All(3));
    }

    #[test]
    fn a_column_that_was_left_out_is_an_error_to_sort_by() {
        let session = balls(2);
        let table = &session.engine().tables()[0];
        let view = by("spin", Part::Whole);
        let error = Rows::of(session.engine(), table, &view, None).expect_err("left out");
        assert!(matches!(error, TableError::LeftOut { .. }));
    }

    #[test]
    fn a_followed_row_is_found_where_the_order_and_removals_have_moved_it() {
        let mut session = at_heights(&[3.0, 1.0, 2.0]);
        let id = RowId::first(0);
        let place = |session: &Session| {
            let row = session.engine().row_of(BODIES, id)?;
            rows(session, 0, &by("height", Part::Whole), None).place_of(row)
        };
        assert_eq!(place(&session), Some(2));
        session.remove_body(1).expect("nothing holds it");
        assert_eq!(place(&session), Some(1));
        session.remove_body(0).expect("nothing holds it");
        assert_eq!(place(&session), None);
    }

    #[test]
    fn a_block_ends_with_the_rows() {
        let listed = Rows::Listed(vec![5, 3, 4]);
        assert_eq!(listed.block(1, 9), [3, 4]);
        assert_eq!(Rows::All(4).block(2, 1), [2]);
        assert!(Rows::All(4).block(9, usize::MAX).is_empty());
        assert_eq!((listed.at(3), listed.place_of(2)), (None, None));
    }

    #[test]
    fn the_id_of_a_row_that_is_not_there_is_none() {
        let session = balls(1);
        assert_eq!(id_of(session.engine(), BODIES, 0), Some(RowId::first(0)));
        assert_eq!(id_of(session.engine(), BODIES, 1), None);
        assert_eq!(id_of(session.engine(), PAIRS, 0), Some(RowId::first(0)));
    }
}
