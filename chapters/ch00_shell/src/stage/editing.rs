//! Changing cells of the engine's tables by hand while time stands still, and taking that back.

use ch00_scenes::{Edit, TableError};

use super::Stage;
use crate::ShellError;
use crate::edits::Edits;

/// What someone is told who wants to edit while time goes on.
pub const PAUSE_FIRST: &str = "pause to edit";

impl Stage {
    /// The edits that can be undone and redone.
    #[must_use]
    pub fn edits(&self) -> &Edits {
        &self.edits
    }

    /// Changes a cell.
    ///
    /// # Errors
    /// [`TableError`] where the cell can't be changed so, or time goes on.
    pub fn edit(&mut self, edit: Edit) -> Result<(), TableError> {
        if !self.is_paused {
            return Err(TableError::NotEditable {
                table: edit.table,
                column: edit.column,
                why: PAUSE_FIRST.to_owned(),
            });
        }
        self.edits.apply(&mut self.session, edit)
    }

    /// Puts back what the last edit changed, also after steps.
    pub fn undo(&mut self) {
        let outcome = self.edits.undo(&mut self.session);
        self.report(outcome.map_err(ShellError::from));
    }

    /// Makes the edit again that was undone last.
    pub fn redo(&mut self) {
        let outcome = self.edits.redo(&mut self.session);
        self.report(outcome.map_err(ShellError::from));
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{BODIES, Cell, RowId, Settings};

    use super::*;
    use crate::clock::Pace;
    use crate::show::Show;
    use crate::test_engine::{CHAPTER, FALLING, balls};

    /// Paused, with the first of two balls raised to 20 m.
    fn edited() -> Stage {
        let mut stage = Stage::new(CHAPTER, balls(2), Pace::Fixed, Show::default());
        stage.toggle_pause();
        stage.edit(raised()).expect("it is paused");
        stage
    }

    fn raised() -> Edit {
        Edit {
            table: BODIES.to_owned(),
            column: "position".to_owned(),
            row: RowId::first(0),
            value: Cell::Vector([0.0, 20.0, 0.0]),
        }
    }

    fn height(stage: &Stage) -> f64 {
        stage.session().state_now().position[0].y
    }

    #[test]
    fn an_edit_is_undone_and_redone() {
        let mut stage = edited();
        assert_eq!(height(&stage), 20.0);
        stage.undo();
        assert_eq!(height(&stage), 10.0);
        stage.redo();
        assert_eq!((height(&stage), &stage.notice), (20.0, &None));
    }

    #[test]
    fn nothing_is_edited_while_time_goes_on() {
        let mut stage = edited();
        stage.toggle_pause();
        let error = stage.edit(raised()).expect_err("time goes on");
        assert!(error.to_string().ends_with(PAUSE_FIRST), "{error}");
    }

    #[test]
    fn reset_another_scene_and_another_engine_have_nothing_to_undo() {
        let changes: [fn(&mut Stage); 3] = [
            Stage::reset,
            |stage| stage.change_scene("bounce", None),
            |stage| stage.change_engine(FALLING, Settings::defaults()),
        ];
        for change in changes {
            let mut stage = edited();
            change(&mut stage);
            assert_eq!(stage.edits().next_undo(), None);
        }
    }

    #[test]
    fn a_change_that_fails_leaves_the_edits_to_undo() {
        let mut stage = edited();
        stage.change_engine(FALLING, Settings::defaults().with_method("magic"));
        stage.change_scene("nothing", None);
        stage.undo();
        assert_eq!(height(&stage), 10.0);
    }

    #[test]
    fn undoing_an_edit_of_a_body_that_is_gone_says_so() {
        let mut stage = edited();
        stage.picked = Some(0);
        stage.remove_picked();
        stage.undo();
        let notice = stage.notice.as_deref().unwrap_or_default();
        assert!(notice.contains("no row 0 any more"), "{notice}");
        assert_eq!(stage.edits().next_undo(), None);
    }
}
