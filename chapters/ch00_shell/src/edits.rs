//! What someone changed by hand in the engine's tables, so that it can be undone and redone.
//!
//! An entry names its row by ID, so that it finds the row wherever it has moved to. Undoing puts
//! the old value back into the cell through the same door as the edit; steps that were made since
//! are not taken back.

use ch00_scenes::{BODIES, Cell, Edit, RowId, TableError};

use crate::Session;

/// Changes by hand that are kept at most.
const MOST: usize = 1000;

/// One cell that was changed.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    /// What it was changed to.
    edit: Edit,
    /// What it was before.
    old: Cell,
}

/// The changes that can be undone, and those that can be redone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Edits {
    done: Vec<Change>,
    undone: Vec<Change>,
}

impl Edits {
    /// Changes a cell; what was undone before can't be redone any more.
    ///
    /// # Errors
    /// [`TableError`] where the cell can't be changed so; nothing has changed then.
    pub fn apply(&mut self, session: &mut Session, edit: Edit) -> Result<(), TableError> {
        let old = session.edit(&edit)?;
        self.undone.clear();
        if self.done.len() == MOST {
            self.done.remove(0);
        }
        self.done.push(Change { edit, old });
        Ok(())
    }

    /// Puts back what the last edit changed; nothing where there is none.
    ///
    /// # Errors
    /// [`TableError`] where the row is gone or the value can't stand there any more; the edit is
    /// forgotten then.
    pub fn undo(&mut self, session: &mut Session) -> Result<(), TableError> {
        let Some(change) = self.done.pop() else {
            return Ok(());
        };
        session.edit(&change.undoing())?;
        self.undone.push(change);
        Ok(())
    }

    /// Makes the edit again that was undone last; nothing where there is none.
    ///
    /// # Errors
    /// As [`Self::undo`].
    pub fn redo(&mut self, session: &mut Session) -> Result<(), TableError> {
        let Some(change) = self.undone.pop() else {
            return Ok(());
        };
        session.edit(&change.edit)?;
        self.done.push(change);
        Ok(())
    }

    /// What [`Self::undo`] would put back, as [`cell_name`] says it.
    #[must_use]
    pub fn next_undo(&self) -> Option<String> {
        self.done.last().map(Change::name)
    }

    /// What [`Self::redo`] would change, as [`cell_name`] says it.
    #[must_use]
    pub fn next_redo(&self) -> Option<String> {
        self.undone.last().map(Change::name)
    }

    /// Forgets everything: the rows are others now.
    pub fn clear(&mut self) {
        self.done.clear();
        self.undone.clear();
    }
}

impl Change {
    fn undoing(&self) -> Edit {
        Edit {
            value: self.old,
            ..self.edit.clone()
        }
    }

    fn name(&self) -> String {
        cell_name(&self.edit.table, &self.edit.column, self.edit.row)
    }
}

/// A cell for a reader: `position of 12`; of another table than the bodies', `joints.length of 3`.
#[must_use]
pub fn cell_name(table: &str, column: &str, row: RowId) -> String {
    if table == BODIES {
        format!("{column} of {row}")
    } else {
        format!("{table}.{column} of {row}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_engine::{FARTHEST, balls};

    fn raised_to(row: u32, height: f32) -> Edit {
        Edit {
            table: BODIES.to_owned(),
            column: "position".to_owned(),
            row: RowId::first(row),
            value: Cell::Vector([0.0, height, 0.0]),
        }
    }

    fn heights(session: &Session) -> Vec<f64> {
        session.state_now().position.iter().map(|p| p.y).collect()
    }

    #[test]
    fn edits_are_undone_from_the_last_to_the_first_and_redone_the_other_way() {
        let (mut session, mut edits) = (balls(2), Edits::default());
        edits.apply(&mut session, raised_to(0, 20.0)).expect("fits");
        edits.apply(&mut session, raised_to(1, 30.0)).expect("fits");
        assert_eq!(edits.next_undo().as_deref(), Some("position of 1"));
        edits.undo(&mut session).expect("it is there");
        assert_eq!(heights(&session), [20.0, 10.0]);
        assert_eq!(edits.next_redo().as_deref(), Some("position of 1"));
        edits.undo(&mut session).expect("it is there");
        assert_eq!(
            (heights(&session), edits.next_undo()),
            (vec![10.0; 2], None)
        );
        edits.redo(&mut session).expect("it is there");
        edits.redo(&mut session).expect("it is there");
        assert_eq!(heights(&session), [20.0, 30.0]);
        assert_eq!(edits.next_redo(), None);
    }

    #[test]
    fn with_nothing_to_undo_or_redo_nothing_happens() {
        let (mut session, mut edits) = (balls(1), Edits::default());
        assert_eq!(edits.undo(&mut session), Ok(()));
        assert_eq!(edits.redo(&mut session), Ok(()));
        assert_eq!(edits, Edits::default());
    }

    #[test]
    fn a_new_edit_ends_what_could_be_redone() {
        let (mut session, mut edits) = (balls(1), Edits::default());
        edits.apply(&mut session, raised_to(0, 20.0)).expect("fits");
        edits.undo(&mut session).expect("it is there");
        edits.apply(&mut session, raised_to(0, 30.0)).expect("fits");
        assert_eq!(edits.next_redo(), None);
    }

    #[test]
    fn an_edit_that_is_refused_is_not_there_to_undo() {
        let (mut session, mut edits) = (balls(1), Edits::default());
        for height in [f32::NAN, 2.0 * FARTHEST] {
            let outcome = edits.apply(&mut session, raised_to(0, height));
            assert!(matches!(outcome, Err(TableError::BadValue { .. })));
        }
        assert_eq!((heights(&session), edits.next_undo()), (vec![10.0], None));
    }

    #[test]
    fn after_steps_the_cell_is_put_back_and_the_steps_stay() {
        let (mut session, mut edits) = (balls(2), Edits::default());
        edits.apply(&mut session, raised_to(0, 20.0)).expect("fits");
        session.step();
        edits.undo(&mut session).expect("it is there");
        assert_eq!((heights(&session), session.steps()), (vec![10.0, 9.75], 1));
    }

    #[test]
    fn an_edit_is_undone_where_its_row_has_moved_to() {
        let (mut session, mut edits) = (balls(3), Edits::default());
        edits.apply(&mut session, raised_to(2, 20.0)).expect("fits");
        session.remove_body(0).expect("nothing holds it");
        assert_eq!(heights(&session), [10.0, 20.0]);
        edits.undo(&mut session).expect("it is there");
        assert_eq!(heights(&session), [10.0, 10.0]);
    }

    #[test]
    fn an_edit_of_a_row_that_is_gone_is_an_error_once() {
        let (mut session, mut edits) = (balls(2), Edits::default());
        edits.apply(&mut session, raised_to(0, 20.0)).expect("fits");
        edits.apply(&mut session, raised_to(1, 20.0)).expect("fits");
        session.remove_body(1).expect("nothing holds it");
        let gone = TableError::Stale {
            table: BODIES.to_owned(),
            row: RowId::first(1),
        };
        assert_eq!(edits.undo(&mut session), Err(gone));
        assert_eq!(edits.next_redo(), None);
        assert_eq!(edits.undo(&mut session), Ok(()));
        assert_eq!(heights(&session), [10.0]);
    }

    #[test]
    fn the_oldest_edits_are_forgotten_first() {
        let (mut session, mut edits) = (balls(1), Edits::default());
        for i in 0..=MOST {
            let height = i as f32 / 2.0;
            edits
                .apply(&mut session, raised_to(0, height))
                .expect("fits");
        }
        for _ in 0..MOST {
            edits.undo(&mut session).expect("it is there");
        }
        assert_eq!((heights(&session), edits.next_undo()), (vec![0.0], None));
    }

    #[test]
    fn a_cell_of_another_table_is_named_with_its_table() {
        let name = cell_name(
            "joints",
            "length",
            RowId {
                slot: 3,
                generation: 2,
            },
        );
        assert_eq!(name, "joints.length of 3.2");
    }
}
