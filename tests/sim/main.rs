//! Snapshots of the simulations: where every body is after 0, 1, 10 and 60 steps, and a hash of
//! all bits after long runs.
//!
//! A snapshot says that something changed, not that it is right: what is right is tested against
//! exact solutions in the chapters. A change here needs its reason in the commit.
//! `tests/snapshots/sim__<scene>@<engine>.snap`.

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
    check(&name, &story(entry, &data, method));
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
}

#[test]
fn joints() {
    for scene in ["door", "door_pins", "cradle"] {
        check_scene(ch04_ragdolls::ENGINE, scene, None, "corrected");
    }
    check_scene(ch04_ragdolls::ENGINE, "chain", Some(10), "corrected");
}

/// The hash of all bits after a run.
fn hash(entry: EngineEntry, scene: &str, count: Option<u64>, steps: u32) -> String {
    let data = Scene::open(scene, count, None).expect("a built-in");
    let state = entry
        .run(&data, &Settings::defaults(), steps)
        .expect("the scene is supported");
    let count = count.map_or(String::new(), |count| format!(" {count}"));
    format!(
        "{} {scene}{count} {steps} {:016x}\n",
        entry.chapter,
        state.hash()
    )
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
