//! A session without a window: what a step, a reset and another engine do.

use ch00_scenes::builtin;

use super::*;
use crate::test_engine::{FALLING, balls};

/// One ball, 10 m up, at rest; steps of ¼ s.
fn one_ball() -> Session {
    balls(1)
}

fn height(session: &Session) -> f64 {
    session.state_now().position[0].y
}

#[test]
fn before_the_first_step_both_states_are_the_start() {
    let session = one_ball();
    assert_eq!(session.state_before(), session.state_now());
    assert_eq!((session.steps(), session.time()), (0, 0.0));
}

#[test]
fn a_step_moves_the_state_and_keeps_the_one_before() {
    let mut session = one_ball();
    session.step();
    assert_eq!(session.state_before().position[0].y, 10.0);
    assert_eq!(height(&session), 9.75);
    assert_eq!((session.steps(), session.time()), (1, 0.25));
}

#[test]
fn halfway_between_two_states_a_ball_is_drawn_halfway() {
    let mut session = one_ball();
    session.step();
    assert_eq!(session.pose(0, 0.5).0.y, 9.875);
    assert_eq!(session.pose(0, 1.0).0.y, 9.75);
}

#[test]
fn a_reset_starts_again_with_the_step_size_as_set() {
    let mut session = one_ball();
    session.step();
    session.set_dt(0.5);
    session.reset().expect("it was loaded before");
    assert_eq!((session.steps(), height(&session)), (0, 10.0));
    assert_eq!(session.dt(), 0.5);
    assert_eq!(session.history().samples().len(), 1);
}

#[test]
fn another_method_goes_on_from_the_same_state() {
    let mut session = one_ball();
    session.step();
    let heavy = Settings::defaults().with_method("heavy");
    session.change_engine(FALLING, heavy).expect("it has that");
    assert_eq!((session.steps(), height(&session)), (1, 9.75));
    session.step(); // 9.75 − 2 · ¼ − ½ · 16 · ¼²
    assert_eq!(height(&session), 8.75);
    assert_eq!(session.settings().method.as_deref(), Some("heavy"));
}

#[test]
fn a_method_that_is_not_there_leaves_the_session_as_it_was() {
    let mut session = one_ball();
    let magic = Settings::defaults().with_method("magic");
    assert!(session.change_engine(FALLING, magic).is_err());
    assert_eq!(session.settings(), &Settings::defaults());
    session.step();
    assert_eq!(height(&session), 9.75);
}

#[test]
fn a_wrong_engine_shows_in_the_history() {
    let mut session = one_ball();
    let heavy = Settings::defaults().with_method("heavy");
    session.change_engine(FALLING, heavy).expect("it has that");
    session.step(); // falls ½ m for 16 · ¼ = 4 m/s: gains ½ · 16 − 8 · ½ = 4 J of 80
    let last = session.history().samples().back().expect("measured");
    assert!(
        last.energy_error
            .is_some_and(|error| (error - 0.05).abs() < 1e-6)
    );
}

#[test]
fn built_in_scenes_load() {
    let pair = builtin::build("pair", None, None).expect("`pair` is built in");
    assert!(Session::new(pair, FALLING, Settings::defaults()).is_ok());
}
