//! Bad input: each ends in one paragraph that says what to mend, with exit status 1, or 2
//! where a flag itself is wrong; never in a panic.

use std::fmt::Write as _;
use std::path::Path;

use crate::{folder, run, run_in};

/// The program refuses `arguments` with exit status 1 and one paragraph that has `words`.
#[track_caller]
fn refuses(arguments: &[&str], words: &[&str]) {
    refuses_in(folder().path(), arguments, words);
}

#[track_caller]
fn refuses_in(folder: &Path, arguments: &[&str], words: &[&str]) {
    let ran = run_in(folder, arguments);
    assert_eq!(ran.status, Some(1), "{}: {}", ran.command, ran.err);
    assert_eq!(ran.out, "", "{}", ran.command);
    assert_eq!(ran.err.lines().count(), 1, "one paragraph: {}", ran.err);
    says(&ran.err, words);
}

/// A wrong flag: exit status 2, and as clap does, one paragraph and where to find help.
#[track_caller]
fn is_a_usage_error(arguments: &[&str], words: &[&str]) {
    let ran = run(arguments);
    assert_eq!(ran.status, Some(2), "{}: {}", ran.command, ran.err);
    assert_eq!(ran.out, "", "{}", ran.command);
    says(&ran.err, words);
}

#[track_caller]
fn says(message: &str, words: &[&str]) {
    assert!(message.starts_with("error: "), "{message}");
    assert!(!message.contains("panicked"), "{message}");
    for word in words {
        assert!(message.contains(word), "`{word}` isn't in: {message}");
    }
}

/// A scene file with one ball whose fields are `body`.
#[track_caller]
fn scene_is_refused(body: &str, words: &[&str]) {
    let folder = folder();
    let mut text = String::from(r#"{"name": "bad", "gravity": [0, -9.81, 0], "bodies": ["#);
    write!(text, "{{{body}}}]}}").expect("text always takes text");
    std::fs::write(folder.path().join("bad.json"), text).expect("the folder is ours");
    refuses_in(folder.path(), &["--headless", "--scene", "bad.json"], words);
}

#[test]
fn an_unknown_scene_is_answered_with_the_known_ones() {
    refuses(
        &["--headless", "--scene", "bals"],
        &["`bals`", "balls", "pair", ".json"],
    );
}

#[test]
fn an_unknown_engine_is_answered_with_the_known_ones() {
    refuses(
        &["--headless", "--engine", "gears"],
        &["`gears`", "objects", "properties", "lanes", "compute"],
    );
}

#[test]
fn an_unknown_method_is_answered_with_the_known_ones() {
    refuses(
        &["--headless", "--method", "magic"],
        &["`magic`", "printed", "corrected"],
    );
}

#[test]
fn a_missing_scene_file_is_named() {
    refuses(
        &["--headless", "--scene", "no/such.json"],
        &["no/such.json"],
    );
}

#[test]
fn malformed_json_is_located() {
    let folder = folder();
    let text = "{\"name\": \"bad\",\n \"gravity\": [0, -9.81 0]}";
    std::fs::write(folder.path().join("bad.json"), text).expect("the folder is ours");
    refuses_in(
        folder.path(),
        &["--headless", "--scene", "bad.json"],
        &["bad.json", "line 2"],
    );
}

#[test]
fn a_number_that_is_no_number_is_refused() {
    let body = r#""shape": {"sphere": {"radius": 0.2}}, "mass": NaN, "position": [0, 1, 0]"#;
    scene_is_refused(body, &["bad.json", "line 1"]);
}

#[test]
fn a_number_too_large_is_refused() {
    let body = r#""shape": {"sphere": {"radius": 0.2}}, "mass": 1e999, "position": [0, 1, 0]"#;
    scene_is_refused(body, &["bad.json"]);
}

#[test]
fn a_negative_mass_is_named_with_its_body() {
    let body = r#""shape": {"sphere": {"radius": 0.2}}, "mass": -1, "position": [0, 1, 0]"#;
    scene_is_refused(body, &["bad.json", "bodies[0].mass", "-1"]);
}

#[test]
fn a_radius_of_zero_is_named_with_its_body() {
    let body = r#""shape": {"sphere": {"radius": 0}}, "mass": 1, "position": [0, 1, 0]"#;
    scene_is_refused(body, &["bad.json", "bodies[0]", "radius"]);
}

#[test]
fn a_quaternion_of_length_zero_is_named_with_its_body() {
    let body = r#""shape": {"sphere": {"radius": 1}}, "mass": 1, "position": [0, 1, 0],
                  "orientation": [0, 0, 0, 0]"#;
    scene_is_refused(body, &["bad.json", "bodies[0].orientation"]);
}

#[test]
fn an_unknown_field_is_named() {
    let body = r#""shape": {"sphere": {"radius": 1}}, "mass": 1, "position": [0, 1, 0],
                  "colour": "red""#;
    scene_is_refused(body, &["bad.json", "colour"]);
}

#[test]
fn a_count_below_zero_is_a_usage_error() {
    let words = ["'-1'", "--count", "0 or more"];
    is_a_usage_error(&["--headless", "--count", "-1"], &words);
}

#[test]
fn a_count_of_a_thousand_million_is_answered_with_the_range() {
    refuses(
        &["--headless", "--scene", "balls", "--count", "1000000000"],
        &["balls", "--count 1000000000", "100000"],
    );
}

#[test]
fn a_step_that_is_not_a_positive_time_is_a_usage_error() {
    for dt in ["0", "-1", "nan", "inf", "soon"] {
        let words = ["--dt", "number of seconds"];
        is_a_usage_error(&["--headless", "--dt", dt], &words);
    }
}

#[test]
fn zero_sweeps_substeps_or_threads_are_a_usage_error() {
    for flag in ["--sweeps", "--substeps", "--threads"] {
        is_a_usage_error(&["--headless", flag, "0"], &[flag, "from 1"]);
    }
}

#[test]
fn an_unknown_flag_is_a_usage_error() {
    is_a_usage_error(&["--fast"], &["--fast"]);
}

#[test]
fn a_dump_interval_needs_a_dump() {
    is_a_usage_error(&["--headless", "--dump-every", "2"], &["--dump <FILE>"]);
}

#[test]
fn a_dump_that_cannot_be_written_is_named_before_the_run() {
    // So many steps that the test would not end if the run came first.
    refuses(
        &[
            "--steps",
            "4000000000",
            "--dump",
            "no/such/folder/states.rbd",
        ],
        &["no/such/folder/states.rbd"],
    );
}

#[test]
fn a_picture_that_cannot_be_written_is_named_before_the_run() {
    refuses(
        &["--steps", "4000000000", "--screenshot", "no/such/ball.png"],
        &["no/such/ball.png"],
    );
}

#[test]
fn contenders_of_a_race_that_are_none_are_answered_with_what_there_is() {
    for (contenders, words) in [
        ("lanes", &["2 to 4", "names 1", "cradle"][..]),
        ("lanes,lanes,lanes,lanes,lanes", &["2 to 4", "names 5"]),
        ("lanes,gears", &["`gears`", "objects", "compute"]),
        ("lanes,objects:magic", &["`magic`", "corrected", "printed"]),
        ("lanes,lanes@-1", &["`lanes@-1`", "from 1"]),
        ("lanes,objects@4", &["`objects:corrected@4`", "whole steps"]),
    ] {
        refuses(&["--headless", "--race", contenders], words);
    }
}

#[test]
fn a_race_in_a_scene_that_cannot_be_is_refused() {
    refuses(
        &["--headless", "--race", "lanes,objects", "--scene", "bals"],
        &["`bals`", "balls"],
    );
    refuses(
        &["--headless", "--race", "cradle", "--scene", "balls"],
        &["cradle", "--scene balls"],
    );
    let picture = ["--race", "lanes,objects", "--screenshot", "no/such.png"];
    refuses(&picture, &["no/such.png"]);
}

#[test]
fn flags_that_a_race_has_no_use_for_are_usage_errors() {
    for flags in [
        ["--engine", "lanes"],
        ["--substeps", "4"],
        ["--dump", "a.rbd"],
    ] {
        let race = ["--race", "lanes,objects"];
        is_a_usage_error(&[&race[..], &flags[..]].concat(), &["--race", flags[0]]);
    }
}
