//! Runs that end well: what they print and write.

use std::path::Path;

use crate::{folder, run, run_in};

/// The keys of the JSON line, in their order.
const KEYS: &str = "scene engine method threads device n joints steps dt substeps median_ms \
    p99_ms total_s max_fps min_fps max_penetration_final_m p99_penetration_final_m \
    max_penetration_run_m max_joint_separation_final_m max_joint_separation_run_m escaped nan \
    overflow kinetic_energy_final momentum_error max_limit_excess_final_rad";

const TEN_BALLS: [&str; 7] = [
    "--headless",
    "--scene",
    "balls",
    "--count",
    "10",
    "--steps",
    "30",
];

#[test]
fn json_is_one_line_with_the_fixed_keys_in_order() {
    let ran = run(&[&TEN_BALLS[..], &["--json"]].concat()).succeeds();
    assert_eq!(ran.out.lines().count(), 1);
    assert_eq!(ran.err, "");
    let line: serde_json::Map<String, serde_json::Value> =
        serde_json::from_str(&ran.out).expect("one JSON object");
    let mut keys: Vec<_> = line.keys().collect();
    keys.sort_by_key(|key| ran.out.find(&format!("\"{key}\":")));
    assert_eq!(keys, KEYS.split_whitespace().collect::<Vec<_>>());
}

#[test]
fn json_says_what_ran() {
    let ran = run(&[&TEN_BALLS[..], &["--json"]].concat()).succeeds();
    let line: serde_json::Value = serde_json::from_str(&ran.out).expect("one JSON object");
    assert_eq!(line["scene"], "balls");
    assert_eq!(line["n"], 15, "ten balls, a floor and four walls");
    assert_eq!(line["steps"], 30);
    assert_eq!(line["joints"], 0);
    assert!(line["max_joint_separation_run_m"].is_null());
    assert_eq!(line["nan"], 0);
    assert!(line["median_ms"].as_f64() > Some(0.0));
    assert!(line["max_fps"].as_f64() >= line["min_fps"].as_f64());
}

#[test]
fn the_table_names_scene_engine_and_times() {
    let ran = run(&TEN_BALLS).succeeds();
    for word in ["balls", "objects", "median step", "deepest overlap"] {
        assert!(ran.out.contains(word), "`{word}` isn't in:\n{}", ran.out);
    }
}

#[test]
fn a_dump_has_a_header_and_every_state() {
    let folder = folder();
    let bytes = dump(folder.path(), &["--steps", "3"]);
    let n = u32_at(&bytes, 4) as usize;
    let frame = 8 + n * 13 * 4;
    assert_eq!(&bytes[..4], b"RBD1");
    assert_eq!((n, u32_at(&bytes, 8), u32_at(&bytes, 12)), (2, 4, 0));
    assert_eq!(bytes.len(), 16 + 4 * frame);
    let steps: Vec<_> = (0..4).map(|i| u32_at(&bytes, 16 + i * frame)).collect();
    assert_eq!(steps, [0, 1, 2, 3]);
    assert_eq!(
        f32_at(&bytes, 24),
        -0.8,
        "where the first ball of `pair` starts"
    );
}

#[test]
fn a_dump_of_every_fourth_state_has_the_first_and_the_last_too() {
    let folder = folder();
    let bytes = dump(folder.path(), &["--steps", "10", "--dump-every", "4"]);
    let frame = 8 + 2 * 13 * 4;
    assert_eq!(bytes.len(), 16 + 4 * frame);
    let steps: Vec<_> = (0..4).map(|i| u32_at(&bytes, 16 + i * frame)).collect();
    assert_eq!(steps, [0, 4, 8, 10]);
}

#[test]
fn two_runs_write_the_same_bytes() {
    let folder = folder();
    let arguments = [&TEN_BALLS[3..5], &["--scene", "balls", "--steps", "120"]].concat();
    let first = dump(folder.path(), &arguments);
    let second = dump(folder.path(), &arguments);
    assert!(first == second, "the two dumps differ");
}

#[test]
fn another_seed_gives_another_run() {
    let folder = folder();
    let balls = [
        "--scene", "balls", "--count", "10", "--steps", "1", "--seed",
    ];
    let first = dump(folder.path(), &[&balls[..], &["1"]].concat());
    let second = dump(folder.path(), &[&balls[..], &["2"]].concat());
    assert!(first != second, "the two dumps are the same");
}

#[test]
fn no_steps_are_a_run_too() {
    let ran = run(&["--scene", "pair", "--steps", "0", "--json"]).succeeds();
    let line: serde_json::Value = serde_json::from_str(&ran.out).expect("one JSON object");
    assert!(line["median_ms"].is_null());
    assert_eq!(line["max_penetration_final_m"], 0.0);
}

#[test]
fn a_variable_step_has_no_step_size() {
    let ran = run(&[
        "--scene",
        "pair",
        "--steps",
        "5",
        "--json",
        "--variable-step",
    ])
    .succeeds();
    assert!(ran.out.contains("\"dt\":null"), "{}", ran.out);
}

#[test]
fn explain_tells_the_engine_and_runs_nothing() {
    let ran = run(&["--scene", "pair", "--explain", "--steps", "4000000000"]).succeeds();
    for word in ["objects", "corrected", "sweeps", "threshold"] {
        assert!(ran.out.contains(word), "`{word}` isn't in:\n{}", ran.out);
    }
}

#[test]
fn help_shows_scenes_engines_and_examples() {
    let ran = run(&["--help"]).succeeds();
    for word in ["Examples:", "balls", "objects", "corrected", "--dump-every"] {
        assert!(ran.out.contains(word), "`{word}` isn't in:\n{}", ran.out);
    }
}

#[test]
fn without_a_display_it_says_so_in_one_line_and_runs_headless() {
    let ran = run(&["--scene", "pair"]).succeeds();
    let first = ran.err.lines().next().unwrap_or_default();
    assert!(first.contains("without a window"), "{first}");
    assert!(first.contains("DISPLAY"), "{first}");
    assert!(ran.out.contains("median step"), "{}", ran.out);
    let picture = ran.err.contains("pair-after-120-steps.png");
    assert!(picture || ran.err.contains("no pictures"), "{}", ran.err);
}

/// Runs `pair` unless `arguments` say otherwise, and gives the bytes of its dump.
fn dump(folder: &Path, arguments: &[&str]) -> Vec<u8> {
    let mut all = vec!["--headless", "--dump", "states.rbd"];
    all.extend(arguments);
    if !arguments.contains(&"--scene") {
        all.extend(["--scene", "pair"]);
    }
    run_in(folder, &all).succeeds();
    std::fs::read(folder.join("states.rbd")).expect("the run wrote it")
}

fn u32_at(bytes: &[u8], offset: usize) -> u32 {
    u32::from_le_bytes(four_at(bytes, offset))
}

fn f32_at(bytes: &[u8], offset: usize) -> f32 {
    f32::from_le_bytes(four_at(bytes, offset))
}

fn four_at(bytes: &[u8], offset: usize) -> [u8; 4] {
    let four = bytes
        .get(offset..offset + 4)
        .expect("the file is that long");
    four.try_into().expect("four bytes are four bytes")
}
