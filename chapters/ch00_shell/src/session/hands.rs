//! What hands may do to a run from outside: throw a body in, take one out, pull one, give a cell
//! another value. None of it is an error of the engine, so the history forgives what it does to
//! the sums.

use ch00_scenes::measures::Conserved;
use ch00_scenes::{Body, Cell, Edit, LoadError, Pull, RemoveError, TableError};

use super::Session;

impl Session {
    /// Adds a body in mid-run, to the scene too, until the next reset; gives its index.
    ///
    /// # Errors
    /// [`LoadError`] where the engine can't; the session then goes on without it.
    pub fn add_body(&mut self, body: Body) -> Result<usize, LoadError> {
        self.catch_up();
        let index = self.engine.add_body(&body, self.scene.dt as f32)?;
        let before = self.sums();
        self.scene.bodies.push(body);
        self.accept(&before);
        Ok(index)
    }

    /// Removes a body in mid-run, from the scene too, until the next reset; those after it move up
    /// by one. A body that is pulled has to be let go before.
    ///
    /// # Errors
    /// [`RemoveError`] where something holds the body or the engine can't; nothing has changed then.
    pub fn remove_body(&mut self, body: usize) -> Result<(), RemoveError> {
        self.scene.check_removal(body)?;
        self.catch_up();
        let before = self.sums();
        self.engine.remove_body(body)?;
        self.scene.remove_body(body)?;
        self.accept(&before);
        Ok(())
    }

    /// Gives a cell of the engine's tables another value; gives the value that it had.
    ///
    /// # Errors
    /// [`TableError`] where there is no such cell, or it can't take the value; nothing has changed
    /// then.
    pub fn edit(&mut self, edit: &Edit) -> Result<Cell, TableError> {
        if let Some(odd) = edit.value.numbers().iter().find(|part| !part.is_finite()) {
            return Err(TableError::BadValue {
                table: edit.table.clone(),
                column: edit.column.clone(),
                what: format!("{odd} is no finite number"),
            });
        }
        self.catch_up();
        let before = self.sums();
        let old = self.engine.edit(edit)?;
        self.accept(&before);
        Ok(old)
    }

    /// Pulls a body from now on, or lets go.
    pub fn pull(&mut self, pull: Option<Pull>) {
        self.pulled_until = match pull {
            Some(_) => u64::MAX,
            None => self.pulled_until.min(self.steps),
        };
        self.engine.pull(pull);
    }

    /// Takes what was done from outside as it is: reads the state and forgives the change of the
    /// sums from `before`.
    fn accept(&mut self, before: &Conserved) {
        self.reread();
        self.history.forgive(before, &self.sums());
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{Joint, RowId, Scene, Settings};
    use glam::DVec3;

    use super::*;
    use crate::test_engine::{FALLING, MOST_BODIES, ball, balls, scene_of_balls};

    fn heights(session: &Session) -> Vec<f64> {
        session.state_now().position.iter().map(|p| p.y).collect()
    }

    fn last_energy_error(session: &Session) -> f64 {
        let last = session.history().samples().back().expect("measured");
        last.energy_error.expect("falling keeps energy")
    }

    fn position_of(row: RowId, value: [f32; 3]) -> Edit {
        Edit {
            table: "bodies".to_owned(),
            column: "position".to_owned(),
            row,
            value: Cell::Vector(value),
        }
    }

    #[test]
    fn a_ball_thrown_in_falls_too_and_is_gone_after_a_reset() {
        let mut session = balls(1);
        session.step();
        assert_eq!(session.add_body(ball(0.0)), Ok(1));
        session.step();
        assert_eq!(heights(&session)[1], 9.75);
        assert_eq!(session.pose(1, 0.0).0.y, 10.0);
        session.reset().expect("it was loaded before");
        assert_eq!(
            (session.scene().bodies.len(), session.state_now().len()),
            (1, 1)
        );
    }

    #[test]
    fn a_ball_thrown_in_is_no_energy_error() {
        let mut session = balls(1);
        session.step();
        session.add_body(ball(0.0)).expect("there is room");
        session.step();
        assert!(last_energy_error(&session).abs() < 1e-6);
    }

    #[test]
    fn a_ball_that_the_engine_refuses_leaves_the_session_as_it_was() {
        let scene = scene_of_balls(MOST_BODIES);
        let mut session = Session::new(scene, FALLING, Settings::defaults()).expect("it fits");
        assert!(session.add_body(ball(0.0)).is_err());
        assert_eq!(session.scene().bodies.len(), MOST_BODIES);
        session.step();
    }

    #[test]
    fn a_removed_ball_is_gone_from_scene_and_state_until_the_next_reset() {
        let mut session = balls(3);
        session.step();
        session.remove_body(1).expect("nothing holds it");
        let across: Vec<f64> = session
            .scene()
            .bodies
            .iter()
            .map(|b| b.position.x)
            .collect();
        assert_eq!(across, [0.0, 2.0]);
        assert_eq!(session.state_before().len(), 2);
        assert_eq!(session.pose(1, 0.5).0, DVec3::new(2.0, 9.75, 0.0));
        session.step();
        assert!(last_energy_error(&session).abs() < 1e-6);
        session.reset().expect("it was loaded before");
        assert_eq!(heights(&session), [10.0; 3]);
    }

    #[test]
    fn balls_thrown_in_and_removed_stay_so_on_another_engine() {
        let mut session = balls(3);
        session.add_body(ball(7.0)).expect("there is room");
        session.remove_body(0).expect("nothing holds it");
        session.step();
        let before = session.state_now().clone();
        let heavy = Settings::defaults().with_method("heavy");
        session.change_engine(FALLING, heavy).expect("it has that");
        assert_eq!(session.state_now(), &before);
        assert_eq!(before.position[2].x, 7.0);
    }

    #[test]
    fn a_ball_that_is_held_or_not_there_stays_and_the_error_says_why() {
        let mut scene = scene_of_balls(2);
        scene.joints.push(Joint::Distance {
            a: 0,
            b: 1,
            anchor_a: DVec3::ZERO,
            anchor_b: DVec3::ZERO,
            length: 1.0,
        });
        let mut session = Session::new(scene, FALLING, Settings::defaults()).expect("it fits");
        let held = RemoveError::HeldByJoint { body: 1, joint: 0 };
        assert_eq!(session.remove_body(1), Err(held));
        let missing = RemoveError::NoSuchBody { body: 2, bodies: 2 };
        assert_eq!(session.remove_body(2), Err(missing));
        assert_eq!(session.state_now().len(), 2);
    }

    #[test]
    fn an_engine_that_removes_nothing_leaves_the_scene_whole() {
        let mut session = balls(2);
        let heavy = Settings::defaults().with_method("heavy");
        session.change_engine(FALLING, heavy).expect("it has that");
        let refusal = RemoveError::Unsupported { engine: "falling" };
        assert_eq!(session.remove_body(0), Err(refusal));
        assert_eq!(session.scene().bodies.len(), 2);
    }

    #[test]
    fn an_edited_ball_is_where_it_was_put_without_an_energy_error() {
        let mut session = balls(2);
        session.step();
        let old = session.edit(&position_of(RowId::first(1), [1.0, 40.0, 0.0]));
        assert_eq!(old, Ok(Cell::Vector([1.0, 9.75, 0.0])));
        assert_eq!(heights(&session), [9.75, 40.0]);
        assert_eq!(session.pose(1, 0.0).0.y, 40.0);
        session.step();
        assert!(last_energy_error(&session).abs() < 1e-6);
    }

    #[test]
    fn a_value_that_is_no_number_is_refused_before_the_engine_sees_it() {
        let mut session = balls(1);
        let revision = session.revision();
        for bad in [f32::NAN, f32::INFINITY] {
            let error = session.edit(&position_of(RowId::first(0), [0.0, bad, 0.0]));
            assert!(matches!(error, Err(TableError::BadValue { .. })));
        }
        assert_eq!(
            (heights(&session), session.revision()),
            (vec![10.0], revision)
        );
    }

    #[test]
    fn an_id_names_the_same_ball_after_others_were_removed_and_thrown_in() {
        let mut session = balls(3);
        session.remove_body(0).expect("nothing holds it");
        session.add_body(ball(9.0)).expect("there is room");
        let ids = session.engine().row_ids("bodies", &[0, 1, 2]);
        let second_of_its_name = RowId {
            slot: 0,
            generation: 1,
        };
        assert_eq!(ids, [RowId::first(1), RowId::first(2), second_of_its_name]);
        let gone = session.edit(&position_of(RowId::first(0), [0.0; 3]));
        assert!(matches!(gone, Err(TableError::Stale { .. })));
        session
            .edit(&position_of(RowId::first(2), [2.0, 1.0, 0.0]))
            .expect("it is there");
        assert_eq!(heights(&session), [10.0, 1.0, 10.0]);
    }

    #[test]
    fn whatever_changes_the_rows_changes_the_revision() {
        let mut session = balls(2);
        let mut last = session.revision();
        let mut has_grown = |session: &Session| {
            let grown = session.revision() > last;
            last = session.revision();
            grown
        };
        session.step();
        assert!(has_grown(&session));
        session.add_body(ball(0.0)).expect("there is room");
        assert!(has_grown(&session));
        session.remove_body(0).expect("nothing holds it");
        assert!(has_grown(&session));
        session
            .edit(&position_of(RowId::first(1), [0.0; 3]))
            .expect("it is there");
        assert!(has_grown(&session));
        session
            .change_engine(FALLING, Settings::defaults())
            .expect("it has that");
        assert!(has_grown(&session));
        session.reset().expect("it was loaded before");
        assert!(has_grown(&session));
    }

    #[test]
    fn an_engine_change_keeps_the_balls_thrown_in() {
        let mut session = balls(1);
        session.add_body(ball(0.0)).expect("there is room");
        session.step();
        let heavy = Settings::defaults().with_method("heavy");
        session.change_engine(FALLING, heavy).expect("it has that");
        assert_eq!(heights(&session)[1], 9.75);
    }

    #[test]
    fn what_happens_while_a_body_is_dragged_is_no_error() {
        let mut session = balls(1);
        let heavy = Settings::defaults().with_method("heavy");
        session.change_engine(FALLING, heavy).expect("it has that");
        session.pull(Some(Pull {
            body: 0,
            anchor: DVec3::ZERO,
            target: DVec3::ZERO,
        }));
        session.step();
        assert!(last_energy_error(&session).abs() < 1e-12);
    }

    #[test]
    fn a_scene_without_bodies_has_nothing_to_remove() {
        let scene = Scene::new("empty");
        let mut session = Session::new(scene, FALLING, Settings::defaults()).expect("it fits");
        let error = RemoveError::NoSuchBody { body: 0, bodies: 0 };
        assert_eq!(session.remove_body(0), Err(error));
    }
}
