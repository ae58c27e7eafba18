//! The same scene on different engines: equal bits where they promise equal bits, and a state
//! that one hands over to another in mid-run goes on as if nothing had happened.

use ch00_scenes::{Engine, EngineEntry, Scene, Settings, State};

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
    let mut engines = [load(one, &scene, method), load(two, &scene, method)];
    for step in 1..=600 {
        let [a, b] = engines
            .each_mut()
            .map(|engine| state_after(engine.as_mut(), &scene, 1));
        assert_eq!(a.hash(), b.hash(), "{} differs in step {step}", scene.name);
    }
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
