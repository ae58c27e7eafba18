use ch00_scenes::dump::DumpReader;
use ch00_scenes::measures::Conserved;
use ch00_scenes::{Scene, Settings, builtin};

use super::*;
use crate::clock::SHORTEST_VARIABLE_STEP;
use crate::test_engine::FALLING;

fn session_of(scene: Scene) -> Session {
    Session::new(scene, FALLING, Settings::defaults()).expect("it can fall")
}

fn pair(steps: u32) -> Session {
    let mut scene = builtin::build("pair", None, None).expect("`pair` is built in");
    scene.steps = steps;
    session_of(scene)
}

fn quiet() -> Options {
    Options {
        json: true,
        ..Options::default()
    }
}

fn simulated(mut session: Session, options: &Options) -> Summary {
    simulate(&mut session, options).expect("nothing is written")
}

/// The steps of the frames that a run of ten steps dumps.
fn dumped(name: &str, every: u32) -> Vec<u32> {
    let file = std::env::temp_dir().join(format!("{name}-{}.rbd", std::process::id()));
    let options = Options {
        dump: Some(Dump {
            file: file.clone(),
            every,
        }),
        ..quiet()
    };
    simulate(&mut pair(10), &options).expect("the folder is writable");
    let reader = DumpReader::open(&file).expect("it was written");
    let frames = reader.frames().expect("it is whole");
    remove_file(&file).expect("it was ours");
    frames.iter().map(|frame| frame.step).collect()
}

#[test]
fn the_summary_says_what_ran() {
    let summary = simulated(pair(20), &quiet());
    assert_eq!((summary.scene.as_str(), summary.method), ("pair", "light"));
    assert_eq!((summary.n, summary.joints, summary.steps), (2, 0, 20));
    assert_eq!((summary.nan, summary.overflow), (0, 0));
}

#[test]
fn the_first_step_is_not_timed() {
    assert_eq!(simulated(pair(1), &quiet()).timing, Timing::default());
    assert!(simulated(pair(2), &quiet()).timing.median_ms.is_some());
    assert!(simulated(pair(10), &quiet()).timing.max_fps.is_none());
    assert!(simulated(pair(11), &quiet()).timing.max_fps.is_some());
}

#[test]
fn what_does_not_apply_to_a_scene_is_absent() {
    let summary = simulated(pair(2), &quiet());
    assert_eq!(summary.max_joint_separation_run_m, None);
    assert_eq!(summary.escaped, None);
    // Velocities are f32 in the engine: 2⁻²⁴ = 6e-8 of each.
    assert!(summary.momentum_error.is_some_and(|error| error < 6e-8));
    let bounce = builtin::build("bounce", None, None).expect("it is built in");
    assert_eq!(simulated(session_of(bounce), &quiet()).momentum_error, None);
}

#[test]
fn two_balls_that_fly_through_each_other_overlap_in_the_run_but_not_at_its_end() {
    let summary = simulated(pair(120), &quiet());
    assert!(summary.max_penetration_run_m > Some(0.1));
    assert_eq!(summary.max_penetration_final_m, Some(0.0));
}

#[test]
fn the_last_step_is_measured_even_when_it_is_not_its_turn() {
    let mut scene = builtin::build("balls", Some(6000), None).expect("it is built in");
    scene.steps = 3; // and every second step is measured
    let mut session = session_of(scene);
    let summary = simulate(&mut session, &quiet()).expect("nothing is written");
    let last = Conserved::of(session.scene(), session.state_now());
    assert_eq!(summary.kinetic_energy_final, Some(last.kinetic_energy));
}

#[test]
fn a_variable_step_has_no_size_and_is_never_zero() {
    let options = Options {
        variable_step: true,
        ..quiet()
    };
    let mut session = pair(50);
    let summary = simulate(&mut session, &options).expect("nothing is written");
    assert_eq!(summary.dt, None);
    let shortest = session.dt() + 49.0 * SHORTEST_VARIABLE_STEP;
    assert!(session.time() > shortest - 1e-9);
}

#[test]
fn every_state_is_dumped_or_every_fourth_with_the_first_and_the_last() {
    assert_eq!(dumped("every", 1), (0..=10).collect::<Vec<_>>());
    assert_eq!(dumped("fourth", 4), [0, 4, 8, 10]);
    assert_eq!(dumped("rarely", 1000), [0, 10]);
}

#[test]
fn a_dump_into_a_folder_that_is_not_there_stops_before_the_first_step() {
    let mut session = pair(10);
    let options = Options {
        dump: Some(Dump {
            file: PathBuf::from("no/such/folder.rbd"),
            every: 1,
        }),
        ..quiet()
    };
    let error = simulate(&mut session, &options).expect_err("it can't be written");
    assert!(error.to_string().contains("no/such/folder.rbd"), "{error}");
    assert_eq!(session.steps(), 0);
}

#[test]
fn looking_whether_a_file_can_be_written_leaves_none() {
    let file = std::env::temp_dir().join(format!("check-{}.png", std::process::id()));
    check_writable(&file).expect("the folder is writable");
    assert!(!file.exists());
    assert!(check_writable(Path::new("no/such/folder.png")).is_err());
}

#[test]
fn a_picture_without_a_wish_is_named_after_scene_and_steps() {
    assert_eq!(
        picture_name("balls", 600),
        Path::new("balls-after-600-steps.png")
    );
    assert_eq!(
        picture_name("../a b", 1),
        Path::new("___a_b-after-1-steps.png")
    );
}

#[test]
fn the_progress_bar_has_a_valid_template() {
    progress_bar(&pair(3), true).finish_and_clear();
}
