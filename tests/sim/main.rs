//! Snapshots of the simulations: where every body is after 0, 1, 10 and 60 steps, and a hash of
//! all bits after long runs.
//!
//! A snapshot says that something changed, not that it is right: what is right is tested against
//! exact solutions in the chapters. A change here needs its reason in the commit.
//! `tests/snapshots/sim__<scene>@<engine>.snap`.
//!
//! Chapter 5 promises the bits of chapter 4, so it has no snapshots of its own: what is written down of
//! `objects` is asked of `properties` too.

use std::fmt::Write as _;

use ch00_scenes::{Engine, EngineEntry, Scene, Settings, State};

/// The steps that are written down.
const STEPS: [u32; 4] = [0, 1, 10, 60];

/// Number with a fixed width; −0 is written as 0.
fn fixed(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = if text == "-0.000000" {
        "0.000000"
    } else {
        &text
    };
    format!("{text:>12}")
}

fn fixed_row(values: &[f64]) -> String {
    values.iter().map(|&value| fixed(value)).collect()
}

/// A table of all bodies: position, orientation x y z w, velocity, angular velocity.
fn table(state: &State) -> String {
    let mut out = String::new();
    for i in 0..state.len() {
        let _ = writeln!(
            out,
            "{i:>4} p{} q{} v{} w{}",
            fixed_row(&state.position[i].to_array()),
            fixed_row(&state.orientation[i].to_array()),
            fixed_row(&state.linear_velocity[i].to_array()),
            fixed_row(&state.angular_velocity[i].to_array()),
        );
    }
    out
}

fn load(entry: EngineEntry, scene: &Scene, method: &str) -> Box<dyn Engine> {
    (entry.load)(scene, &Settings::defaults().with_method(method)).expect("the scene is supported")
}

fn story(entry: EngineEntry, scene: &Scene, method: &str) -> String {
    let mut engine = load(entry, scene, method);
    let mut state = State::default();
    let mut out = String::new();
    for step in 0..=STEPS[STEPS.len() - 1] {
        if step > 0 {
            engine.step(scene.dt as f32);
        }
        if STEPS.contains(&step) {
            engine.read_state(&mut state);
            let _ = write!(out, "step {step}\n{}", table(&state));
        }
    }
    out
}

fn check(name: &str, content: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(format!("sim__{name}"), content));
}

fn check_scene(entry: EngineEntry, scene: &str, count: Option<u64>, method: &str) {
    let data = Scene::open(scene, count, None).expect("a built-in");
    let default = entry.methods[0].name;
    let name = if method == default {
        format!("{scene}@{}", entry.name)
    } else {
        format!("{scene}-{method}@{}", entry.name)
    };
    let story_of_objects = story(entry, &data, method);
    check(&name, &story_of_objects);
    let story_of_properties = story(ch05_properties::ENGINE, &data, method);
    assert!(
        story_of_properties == story_of_objects,
        "chapter 5 tells another story of {name}:\n{story_of_properties}"
    );
}

#[test]
fn orrery() {
    check_scene(
        ch01_hierarchy::ENGINE,
        "orrery",
        None,
        ch01_hierarchy::ENGINE.methods[0].name,
    );
}

#[test]
fn tops() {
    check_scene(ch02_rigid_bodies::ENGINE, "tops", None, "corrected");
    check_scene(ch02_rigid_bodies::ENGINE, "tops", None, "printed");
}

#[test]
fn magnets() {
    check_scene(ch02_rigid_bodies::ENGINE, "magnets", None, "corrected");
}

#[test]
fn pair() {
    check_scene(ch03_collision::ENGINE, "pair", None, "corrected");
    check_scene(ch03_collision::ENGINE, "pair", None, "printed");
}

#[test]
fn bounce() {
    check_scene(ch03_collision::ENGINE, "bounce", None, "corrected");
}

#[test]
fn balls() {
    check_scene(ch03_collision::ENGINE, "balls", Some(20), "corrected");
    check_scene(ch03_collision::ENGINE, "balls", Some(20), "printed");
    check_scene(
        ch03_collision::ENGINE,
        "smooth_balls",
        Some(20),
        "corrected",
    );
    check_scene(ch03_collision::ENGINE, "pile", Some(20), "corrected");
}

#[test]
fn solids_of_every_shape() {
    check_scene(ch03_collision::ENGINE, "mixed", Some(12), "corrected");
    check_scene(ch03_collision::ENGINE, "stack", None, "corrected");
    check_scene(
        ch03_collision::ENGINE,
        "magnets_on_a_table",
        None,
        "corrected",
    );
}

#[test]
fn friction() {
    for scene in ["slip_to_roll", "slopes", "incline", "slide", "oblique"] {
        check_scene(ch03_collision::ENGINE, scene, None, "corrected");
    }
}

#[test]
fn ragdolls() {
    check_scene(ch04_ragdolls::ENGINE, "ragdolls", Some(2), "corrected");
    check_scene(ch04_ragdolls::ENGINE, "ragdolls", Some(2), "printed");
    check_scene(ch04_ragdolls::ENGINE, "ragdoll_field", Some(3), "corrected");
}

#[test]
fn joints() {
    for scene in ["door", "door_pins", "cradle"] {
        check_scene(ch04_ragdolls::ENGINE, scene, None, "corrected");
    }
    check_scene(ch04_ragdolls::ENGINE, "chain", Some(10), "corrected");
}

/// All bits after a run, as a number.
fn bits(entry: EngineEntry, scene: &str, count: Option<u64>, steps: u32) -> u64 {
    let data = Scene::open(scene, count, None).expect("a built-in");
    let state = entry.run(&data, &Settings::defaults(), steps);
    state.expect("the scene is supported").hash()
}

/// The same as a line.
fn hash(entry: EngineEntry, scene: &str, count: Option<u64>, steps: u32) -> String {
    let bits = bits(entry, scene, count, steps);
    let count = count.map_or(String::new(), |count| format!(" {count}"));
    format!("{} {scene}{count} {steps} {bits:016x}\n", entry.chapter)
}

#[test]
fn long_runs_end_in_the_same_bits() {
    let all: String = [
        hash(ch01_hierarchy::ENGINE, "orrery", None, 600),
        hash(ch02_rigid_bodies::ENGINE, "tops", None, 600),
        hash(ch02_rigid_bodies::ENGINE, "magnets", None, 600),
        hash(ch03_collision::ENGINE, "pair", None, 600),
        hash(ch03_collision::ENGINE, "balls", Some(200), 600),
        hash(ch03_collision::ENGINE, "mixed", Some(200), 600),
        hash(ch03_collision::ENGINE, "stack", Some(10), 600),
        hash(ch03_collision::ENGINE, "magnets_on_a_table", None, 600),
        hash(ch04_ragdolls::ENGINE, "ragdolls", Some(5), 600),
        hash(ch04_ragdolls::ENGINE, "door", None, 600),
        hash(ch04_ragdolls::ENGINE, "chain", None, 600),
        hash(ch04_ragdolls::ENGINE, "cradle", None, 600),
    ]
    .concat();
    check("hashes@objects", &all);
}

#[test]
fn long_runs_in_columns_end_in_the_bits_of_objects() {
    for (scene, count) in [
        ("orrery", None),
        ("tops", None),
        ("magnets", None),
        ("pair", None),
        ("balls", Some(200)),
        ("smooth_balls", Some(200)),
        ("pile", Some(200)),
        ("mixed", Some(200)),
        ("stack", Some(10)),
        ("magnets_on_a_table", None),
        ("ragdolls", Some(5)),
        ("ragdoll_field", Some(6)),
        ("door", None),
        ("chain", None),
        ("cradle", None),
    ] {
        let objects = bits(ch04_ragdolls::ENGINE, scene, count, 600);
        let properties = bits(ch05_properties::ENGINE, scene, count, 600);
        assert_eq!(properties, objects, "{scene}");
    }
}

#[test]
fn a_second_run_ends_in_the_same_bits() {
    let run = || hash(ch03_collision::ENGINE, "balls", Some(100), 300);
    assert_eq!(run(), run());
}

#[test]
fn fixed_numbers_have_no_negative_zero() {
    assert_eq!(fixed(-0.0), "    0.000000");
    assert_eq!(fixed(-1e-9), "    0.000000");
    assert_eq!(fixed(-1.5), "   -1.500000");
}
