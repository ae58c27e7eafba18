//! The same scene on different engines: equal bits where they promise equal bits, and a state
//! that one hands over to another in mid-run goes on as if nothing had happened.

use ch00_scenes::{Body, Engine, EngineEntry, Force, Scene, Settings, Shape, State};
use ch05_properties::PropertiesEngine;
use ch05_properties::plan::Plan;
use glam::DVec3;

fn load(entry: EngineEntry, scene: &Scene, method: &str) -> Box<dyn Engine> {
    (entry.load)(scene, &Settings::defaults().with_method(method)).expect("the scene is supported")
}

fn state_after(engine: &mut dyn Engine, scene: &Scene, steps: u32) -> State {
    for _ in 0..steps {
        engine.step(scene.dt as f32);
    }
    let mut state = State::default();
    engine.read_state(&mut state);
    state
}

#[track_caller]
fn same_bits(scene: &str, method: &str, one: EngineEntry, two: EngineEntry) {
    let scene = Scene::open(scene, None, None).expect("a built-in");
    let (mut one, mut two) = (load(one, &scene, method), load(two, &scene, method));
    same_steps(&scene, method, 600, [one.as_mut(), two.as_mut()]);
}

/// Steps both engines and compares all bits after each step.
#[track_caller]
fn same_steps(scene: &Scene, method: &str, steps: u32, engines: [&mut dyn Engine; 2]) {
    let [one, two] = engines;
    for step in 1..=steps {
        let (a, b) = (state_after(one, scene, 1), state_after(two, scene, 1));
        let name = &scene.name;
        assert_eq!(a.hash(), b.hash(), "{name}, {method}: step {step} differs");
    }
}

/// The scenes that come as files.
fn reference_scenes() -> Vec<Scene> {
    let files = tests::files_below(&tests::root().join("tests/reference/scenes"));
    let scenes = files.iter().map(|file| Scene::load(file).expect("a scene"));
    scenes.collect()
}

/// Chapter 5 with all columns and systems that the method has.
fn with_all(scene: &Scene, method: &str) -> PropertiesEngine {
    let settings = Settings::defaults().with_method(method);
    PropertiesEngine::load_with(scene, &settings, |_, method| Plan::full(method))
        .expect("the scene is supported")
}

#[test]
fn where_nothing_touches_chapter_3_is_chapter_2() {
    for method in ["corrected", "printed"] {
        same_bits(
            "tops",
            method,
            ch02_rigid_bodies::ENGINE,
            ch03_collision::ENGINE,
        );
    }
}

#[test]
fn where_nothing_is_joined_chapter_4_is_chapter_3() {
    for scene in ["balls", "pair", "stack", "magnets_on_a_table", "slopes"] {
        for method in ["corrected", "printed"] {
            same_bits(scene, method, ch03_collision::ENGINE, ch04_ragdolls::ENGINE);
        }
    }
}

#[test]
fn in_columns_chapter_5_is_chapter_4() {
    let scenes = reference_scenes();
    assert_eq!(scenes.len(), 3);
    for scene in &scenes {
        for method in ["corrected", "printed"] {
            let mut objects = load(ch04_ragdolls::ENGINE, scene, method);
            let mut all = with_all(scene, method);
            same_steps(scene, method, 600, [objects.as_mut(), &mut all]);
        }
    }
}

#[test]
fn with_no_more_than_the_scene_needs_chapter_5_is_chapter_4() {
    for scene in &reference_scenes() {
        for method in ["corrected", "printed"] {
            let mut objects = load(ch04_ragdolls::ENGINE, scene, method);
            let mut planned = load(ch05_properties::ENGINE, scene, method);
            same_steps(scene, method, 600, [objects.as_mut(), planned.as_mut()]);
        }
    }
}

/// A box that tumbles and is pushed, without gravity.
fn pushed_box() -> Scene {
    let mut scene = Scene::new("pushed");
    scene.gravity = DVec3::ZERO;
    let half_extents = DVec3::new(0.3, 0.2, 0.1);
    scene.bodies.push(Body {
        angular_velocity: DVec3::new(1.0, 2.0, 3.0),
        ..Body::new(Shape::Box { half_extents }, 2.0, DVec3::ZERO)
    });
    let force = DVec3::new(3.0, -1.0, 0.5);
    scene.forces.push(Force::Constant { body: 0, force });
    scene
}

#[test]
fn a_force_that_stays_gives_the_same_bits_in_objects_and_in_columns() {
    let scene = pushed_box();
    for method in ["corrected", "printed"] {
        let mut objects = load(ch04_ragdolls::ENGINE, &scene, method);
        let mut columns = load(ch05_properties::ENGINE, &scene, method);
        same_steps(&scene, method, 120, [objects.as_mut(), columns.as_mut()]);
    }
}

#[test]
fn a_force_that_stays_accelerates_by_the_mass_on_every_engine() {
    let scene = pushed_box();
    let Force::Constant { force, .. } = scene.forces[0] else {
        panic!("made above");
    };
    for (entry, method) in [
        (ch02_rigid_bodies::ENGINE, "corrected"),
        (ch03_collision::ENGINE, "corrected"),
        (ch04_ragdolls::ENGINE, "corrected"),
        (ch05_properties::ENGINE, "corrected"),
        (ch06_compute::LANES, "own-row"),
        (ch06_compute::LANES, "coloured"),
    ] {
        let mut engine = load(entry, &scene, method);
        let state = state_after(engine.as_mut(), &scene, 60);
        // a = F/m for a second: v = a, x = ½ a. Lanes know of gravity alone that it makes ½ g h² of way in a
        // substep h; with other pulls they go by the speed at its end, and are half a substep ahead. Then
        // rounding, of 60 steps or 600 substeps.
        let (a, substeps) = (force / 2.0, f64::from(engine.info().substeps));
        let is_lanes = entry.name == ch06_compute::LANES.name;
        let ahead = if is_lanes {
            0.5 * a * scene.dt / substeps
        } else {
            DVec3::ZERO
        };
        let off = state.linear_velocity[0].distance(a);
        assert!(off < 1e-4, "{} {method}: {off} m/s", entry.name);
        let off = state.position[0].distance(0.5 * a + ahead);
        assert!(off < 1e-4, "{} {method}: {off} m", entry.name);
    }
}

#[test]
fn an_orrery_is_the_same_in_every_chapter() {
    let scene = Scene::open("orrery", None, None).expect("a built-in");
    let run = |entry: EngineEntry| {
        let mut engine = (entry.load)(&scene, &Settings::defaults()).expect("it has orbits only");
        state_after(engine.as_mut(), &scene, 600).hash()
    };
    let first = run(ch01_hierarchy::ENGINE);
    assert_eq!(first, run(ch02_rigid_bodies::ENGINE));
    assert_eq!(first, run(ch03_collision::ENGINE));
    assert_eq!(first, run(ch04_ragdolls::ENGINE));
    assert_eq!(first, run(ch05_properties::ENGINE));
}

#[test]
fn a_state_handed_over_goes_on_along_the_same_path() {
    let scene = Scene::open("tops", None, None).expect("a built-in");
    let mut first = load(ch02_rigid_bodies::ENGINE, &scene, "corrected");
    let half_way = state_after(first.as_mut(), &scene, 100);
    let mut second = load(ch03_collision::ENGINE, &scene, "corrected");
    second.write_state(&half_way, scene.dt as f32);
    let a = state_after(first.as_mut(), &scene, 100);
    let b = state_after(second.as_mut(), &scene, 100);
    for i in 0..a.len() {
        // Writing q* and reading it back rounds ω by about 60 Hz · 2⁻²³, and the tops amplify that.
        let apart = a.position[i].distance(b.position[i]);
        let turned = a.orientation[i].angle_between(b.orientation[i]);
        assert!(
            apart < 2e-3 && turned < 1e-2,
            "body {i}: {apart} m, {turned} rad"
        );
    }
}

/// Puts both engines where `state` says, and compares the path from there on.
#[track_caller]
fn same_path_from(
    state: &State,
    scene: &Scene,
    method: &str,
    [one, two]: [&mut dyn Engine; 2],
) -> State {
    one.write_state(state, scene.dt as f32);
    two.write_state(state, scene.dt as f32);
    same_steps(scene, method, 100, [&mut *one, &mut *two]);
    state_after(two, scene, 0)
}

#[test]
fn objects_that_become_columns_and_objects_again_keep_their_path() {
    let built_in = ["smooth_balls", "mixed", "door", "chain", "magnets", "tops"]
        .map(|name| Scene::open(name, None, None).expect("a built-in"));
    for scene in reference_scenes().iter().chain(&built_in) {
        for method in ["corrected", "printed"] {
            let mut stays = load(ch04_ragdolls::ENGINE, scene, method);
            let mut columns = load(ch05_properties::ENGINE, scene, method);
            let mut again = load(ch04_ragdolls::ENGINE, scene, method);
            let state = state_after(stays.as_mut(), scene, 100);
            let engines: [&mut dyn Engine; 2] = [stays.as_mut(), columns.as_mut()];
            let state = same_path_from(&state, scene, method, engines);
            let engines: [&mut dyn Engine; 2] = [stays.as_mut(), again.as_mut()];
            same_path_from(&state, scene, method, engines);
        }
    }
}

#[test]
fn balls_handed_over_from_printed_to_corrected_stop_gaining_energy() {
    use ch00_scenes::measures::Conserved;
    let scene = Scene::open("balls", Some(60), None).expect("a built-in");
    let mut printed = load(ch03_collision::ENGINE, &scene, "printed");
    let state = state_after(printed.as_mut(), &scene, 60);
    let energy = |state: &State| Conserved::of(&scene, state).energy();
    let before = energy(&state);
    let mut corrected = load(ch03_collision::ENGINE, &scene, "corrected");
    corrected.write_state(&state, scene.dt as f32);
    for _ in 0..600 {
        let now = energy(&state_after(corrected.as_mut(), &scene, 1));
        assert!(now <= before * 1.001, "{now} J of {before} J");
    }
}

#[test]
fn balls_handed_from_engine_to_engine_stay_where_they_are_and_gain_no_energy() {
    use ch00_scenes::measures::{Conserved, escaped};
    let scene = Scene::open("balls", Some(60), None).expect("a built-in");
    let settings = Settings::defaults();
    let mut state = State::start_of(&scene);
    let before = Conserved::of(&scene, &state).energy();
    for entry in [
        ch04_ragdolls::ENGINE,
        ch06_compute::LANES,
        ch06_compute::COMPUTE,
        ch05_properties::ENGINE,
        ch06_compute::COMPUTE,
        ch06_compute::LANES,
        ch04_ragdolls::ENGINE,
    ] {
        let mut engine = (entry.load)(&scene, &settings).expect("the scene is supported");
        engine.write_state(&state, scene.dt as f32);
        let taken = state_after(engine.as_mut(), &scene, 0);
        for i in 0..state.len() {
            let apart = taken.position[i].distance(state.position[i]);
            let faster = taken.linear_velocity[i].distance(state.linear_velocity[i]);
            // Coordinates of some metres in f32; v is stored as p* by the first two engines, at 60 Hz.
            assert!(
                apart < 1e-6 && faster < 1e-4,
                "{}, body {i}: {apart} m, {faster} m/s",
                entry.name
            );
        }
        state = state_after(engine.as_mut(), &scene, 100);
        let now = Conserved::of(&scene, &state).energy();
        assert!(
            now <= before * 1.001,
            "{}: {now} J of {before} J",
            entry.name
        );
        assert_eq!(escaped(&scene, &state), Some(0), "{}", entry.name);
    }
}
