//! A row that is followed: the table stays with it, and with a body's row the camera.

use ch00_scenes::{BODIES, RowId};

use super::Stage;
use crate::tables::rows::id_of;

/// A row, by an ID that stays its own wherever it moves to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Followed {
    /// Name of the table.
    pub table: &'static str,
    /// The row's ID.
    pub row: RowId,
}

impl Stage {
    /// The row that is followed.
    #[must_use]
    pub fn followed(&self) -> Option<Followed> {
        self.followed
    }

    /// Follows a row from now on, or none.
    pub fn follow(&mut self, row: Option<Followed>) {
        self.followed = row;
        self.keep_following();
    }

    /// Follows a body from now on, or none.
    pub fn follow_body(&mut self, body: Option<usize>) {
        let row = body.and_then(|body| id_of(self.session.engine(), BODIES, body));
        self.followed = row.map(|row| Followed { table: BODIES, row });
    }

    /// The body that is followed, if it is a body.
    #[must_use]
    pub fn followed_body(&self) -> Option<usize> {
        let Followed { row, .. } = self.followed.filter(|followed| followed.table == BODIES)?;
        self.session.engine().row_of(BODIES, row)
    }

    /// Lets go of a row that is gone, and moves the camera to a body that isn't.
    pub(super) fn keep_following(&mut self) {
        let Some(Followed { table, row }) = self.followed else {
            return;
        };
        let Some(place) = self.session.engine().row_of(table, row) else {
            self.followed = None;
            self.notice = Some(format!("row {row} is gone from the table `{table}`"));
            return;
        };
        if table == BODIES && place < self.session.scene().bodies.len() {
            let position = self.session.pose(place, self.alpha()).0.as_vec3();
            if position.is_finite() {
                self.camera_to_move().target = position;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::Settings;

    use super::*;
    use crate::clock::Pace;
    use crate::show::Show;
    use crate::test_engine::{CHAPTER, FALLING, PAIRS, balls};

    fn stage() -> Stage {
        Stage::new(CHAPTER, balls(3), Pace::Fixed, Show::default())
    }

    #[test]
    fn the_camera_stays_with_a_followed_body_as_it_falls() {
        let mut stage = stage();
        stage.follow_body(Some(2));
        stage.advance(0.0);
        assert_eq!(stage.camera.target.to_array(), [2.0, 10.0, 0.0]);
        stage.step_once();
        stage.advance(0.0);
        assert_eq!(stage.camera.target.to_array(), [2.0, 9.75, 0.0]);
    }

    #[test]
    fn a_body_is_followed_while_those_before_it_go_and_on_another_engine() {
        let mut stage = stage();
        stage.follow_body(Some(2));
        stage.picked = Some(0);
        stage.remove_picked();
        assert_eq!(stage.followed_body(), Some(1));
        stage.change_engine(FALLING, Settings::defaults());
        assert_eq!(stage.followed_body(), Some(1));
        stage.reset();
        assert_eq!(stage.followed_body(), Some(2));
        assert_eq!(stage.notice, None);
    }

    #[test]
    fn a_row_that_is_gone_is_let_go_and_said() {
        let mut stage = stage();
        stage.follow_body(Some(1));
        stage.picked = Some(1);
        stage.remove_picked();
        stage.is_paused = true;
        stage.advance(0.0);
        assert_eq!(stage.followed(), None);
        let notice = stage.notice.as_deref().unwrap_or_default();
        assert!(notice.contains("row 1 is gone"), "{notice}");
    }

    #[test]
    fn a_row_of_another_table_moves_no_camera_and_is_let_go_on_another_engine() {
        let mut stage = stage();
        let before = stage.camera.clone();
        let row = RowId::first(1);
        stage.follow(Some(Followed { table: PAIRS, row }));
        stage.advance(0.0);
        assert!(stage.followed().is_some());
        assert_eq!(stage.camera, before);
        stage.change_engine(FALLING, Settings::defaults());
        assert_eq!((stage.followed(), &stage.notice), (None, &None));
    }

    #[test]
    fn another_scene_has_no_row_to_follow() {
        let mut stage = stage();
        stage.follow_body(Some(0));
        stage.change_scene("bounce", None);
        assert_eq!(stage.followed(), None);
    }
}
