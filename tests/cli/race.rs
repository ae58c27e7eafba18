//! `--race`: several engines on one scene, side by side.

use crate::{folder, run, run_in};

#[test]
fn a_race_prints_a_row_a_contender_with_the_same_bits_where_they_should_be() {
    let arguments =
        "--headless --race objects,properties:corrected --scene balls --count 10 --steps 60";
    let ran = run(&arguments.split(' ').collect::<Vec<_>>()).succeeds();
    let lines: Vec<&str> = ran.out.lines().collect();
    assert!(
        lines[0].starts_with("balls: 15 bodies, 0 joints, 60 steps"),
        "{}",
        ran.out
    );
    let columns = [
        "contender",
        "median ms",
        "energy",
        "overlap m",
        "joint m",
        "hash",
    ];
    assert!(
        columns.iter().all(|name| lines[2].contains(name)),
        "{}",
        ran.out
    );
    let [one, two] = [lines[3], lines[4]];
    assert!(one.starts_with("objects · corrected") && two.starts_with("properties · corrected"));
    let hash = |row: &str| row.split_whitespace().last().map(str::to_owned);
    assert_eq!(hash(one), hash(two));
    assert_eq!((lines.len(), ran.err.as_str()), (5, ""));
}

#[test]
fn a_race_of_the_gallery_says_what_to_watch_and_writes_a_picture() {
    let folder = folder();
    let arguments = [
        "--race",
        "bounce",
        "--steps",
        "30",
        "--screenshot",
        "race.png",
    ];
    let ran = run_in(folder.path(), &arguments).succeeds();
    for words in [
        "bounce: ",
        "watch: ",
        "[ch03_impulses]",
        "objects · printed",
        "lanes · ",
    ] {
        assert!(ran.out.contains(words), "`{words}` isn't in: {}", ran.out);
    }
    let bytes = std::fs::read(folder.path().join("race.png")).expect("it was written");
    assert!(bytes.starts_with(b"\x89PNG"));
}

#[test]
fn who_becomes_no_number_is_marked_with_the_time() {
    let folder = folder();
    let text = r#"{"name": "far", "gravity": [0, 0, 0], "dt": 0.5, "steps": 10, "bodies": [
        {"shape": {"sphere": {"radius": 1}}, "mass": 1, "position": [0, 0, 0], "linear_velocity": [3e38, 0, 0]}]}"#;
    std::fs::write(folder.path().join("far.json"), text).expect("the folder is ours");
    let arguments = [
        "--headless",
        "--race",
        "objects,lanes",
        "--scene",
        "far.json",
    ];
    let ran = run_in(folder.path(), &arguments).succeeds();
    assert_eq!(
        ran.out.matches("NaN at t = 1.50 s").count(),
        2,
        "{}",
        ran.out
    );
}

#[test]
fn without_a_display_a_race_says_so_in_one_line_and_runs_headless() {
    let arguments = ["--race", "objects,lanes", "--scene", "pair"];
    let ran = run(&arguments).succeeds();
    let first = ran.err.lines().next().unwrap_or_default();
    assert!(
        first.contains("DISPLAY") && first.contains("without a window"),
        "{first}"
    );
    assert!(ran.out.contains("lanes · own-row"), "{}", ran.out);
    let picture = ran.err.contains("pair-race-after-120-steps.png");
    assert!(picture || ran.err.contains("no pictures"), "{}", ran.err);
}

#[test]
fn help_lists_the_races_of_the_gallery() {
    let ran = run(&["--help"]).succeeds();
    for words in ["--race <ENGINE", "Races of the gallery", "heavy_on_light"] {
        assert!(ran.out.contains(words), "`{words}` isn't in: {}", ran.out);
    }
}
