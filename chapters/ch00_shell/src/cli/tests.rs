use super::*;
use crate::test_engine::CHAPTER;

pub(super) fn parse(arguments: &[&str]) -> Result<Args, clap::Error> {
    let words = std::iter::once("ch00_shell").chain(arguments.iter().copied());
    let matches = command(&CHAPTER).try_get_matches_from(words)?;
    Args::from_arg_matches(&matches)
}

pub(super) fn args(arguments: &[&str]) -> Args {
    parse(arguments).expect("these flags are right")
}

/// What a chapter's program answers to flags that parse.
fn refusal(arguments: &[&str]) -> String {
    let error = args(arguments).session(&CHAPTER).err();
    error.expect("it is refused").to_string()
}

#[test]
fn the_command_line_is_consistent() {
    command(&CHAPTER).debug_assert();
}

#[test]
fn no_flags_are_the_chapters_scene_and_engine_in_a_window() {
    let args = args(&[]);
    let session = args.session(&CHAPTER).expect("the defaults load");
    assert_eq!(
        (session.scene().name.as_str(), session.entry().name),
        ("pair", "falling")
    );
    assert!(!args.is_headless());
}

#[test]
fn flags_that_end_a_run_open_no_window() {
    for flags in [
        &["--headless"][..],
        &["--json"],
        &["--steps", "3"],
        &["--dump", "a.rbd"],
        &["--screenshot", "a.png"],
    ] {
        assert!(args(flags).is_headless(), "{flags:?}");
    }
}

#[test]
fn flags_change_the_scene_and_the_settings() {
    let flags = [
        "--scene", "bounce", "--dt", "0.5", "--steps", "7", "--method", "heavy",
    ];
    let session = args(&flags).session(&CHAPTER).expect("they are right");
    assert_eq!((session.dt(), session.scene().steps), (0.5, 7));
    assert_eq!(session.engine().info().method, "heavy");
}

#[test]
fn an_engine_of_another_chapter_is_answered_with_that_chapter() {
    let message = refusal(&["--engine", "objects"]);
    assert!(message.contains("ch04_ragdolls"), "{message}");
    assert!(message.contains("falling"), "{message}");
}

#[test]
fn an_engine_that_the_book_does_not_have_is_answered_with_the_known_ones() {
    let message = refusal(&["--engine", "gears"]);
    let expected = "engine `gears` is not in this chapter's list (ch00_shell has: falling)";
    assert_eq!(message, expected);
}

#[test]
fn an_unknown_method_is_answered_with_the_known_ones() {
    let message = refusal(&["--method", "magic"]);
    assert!(message.contains("light, heavy"), "{message}");
}

#[test]
fn an_engine_that_draws_nothing_says_so_before_the_run() {
    let error_of = |arguments: &[&str]| {
        let args = args(arguments);
        let session = args.session(&CHAPTER).expect("the defaults load");
        let error = args.wish().check(&session).expect_err("it can't");
        error.to_string()
    };
    let message = error_of(&["--layers", "contacts"]);
    assert!(
        message.contains("--layers contacts") && message.contains("falling"),
        "{message}"
    );
    let message = error_of(&["--dissect", "0,1"]);
    assert!(message.contains("no narrow phase"), "{message}");
    let message = error_of(&["--dissect", "0,7"]);
    assert!(message.contains("bodies 0 to 1"), "{message}");
    let message = error_of(&["--dissect", "1,1"]);
    assert!(message.contains("itself"), "{message}");
}

#[test]
fn a_dump_interval_needs_a_dump() {
    assert!(parse(&["--dump-every", "2"]).is_err());
    let args = args(&["--dump", "a.rbd", "--dump-every", "2"]);
    let dump = args.headless_options(Picture::None).dump;
    assert_eq!(dump.map(|dump| dump.every), Some(2));
}

#[test]
fn explaining_names_engine_method_and_threshold() {
    let session = args(&[]).session(&CHAPTER).expect("the defaults load");
    let text = explain(&session);
    for word in ["falling", "light", "threshold", "Each point falls"] {
        assert!(text.contains(word), "`{word}` isn't in:\n{text}");
    }
}

#[test]
fn help_lists_scenes_engines_methods_and_examples() {
    let help = command(&CHAPTER).render_help().to_string();
    for word in [
        "pair ",
        "bounce ",
        "falling",
        "heavy",
        "Examples:",
        "-p ch00_shell --",
    ] {
        assert!(help.contains(word), "`{word}` isn't in:\n{help}");
    }
}
