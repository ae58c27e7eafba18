//! Orbits as nested nodes against their closed form, and the engine around them.

use ch00_scenes::{
    Body, Column, ColumnData, Drawing, Engine, Layer, LoadError, Orbit, Scene, Settings, Shape,
    State, orbits, palette,
};
use ch01_hierarchy::ENGINE;
use glam::{DQuat, DVec3};

const STEPS: u32 = 600;

/// A sun off the origin, a planet with a tilted path, a moon, and the moon's moon, listed
/// from the leaf to the root; and a mast that stands still and is circled too.
fn nested() -> Scene {
    let mut scene = Scene::new("nested");
    scene.bodies = vec![Body::new(Shape::Sphere { radius: 0.1 }, 0.0, DVec3::ZERO); 6];
    scene.bodies[4].position = DVec3::new(-3.0, 1.0, 0.5);
    scene.bodies[4].orientation = DQuat::from_rotation_z(0.3);
    let orbit = |body, parent, radius, tilt, rate, spin| Orbit {
        body,
        parent,
        radius,
        tilt,
        phase: 0.7 * body as f64,
        rate,
        spin,
    };
    scene.orbits = vec![
        orbit(3, Some(2), 0.2, 0.4, 5.0, -1.0),
        orbit(2, Some(1), 0.5, -0.2, 2.0, 3.0),
        orbit(1, Some(0), 2.0, 0.3, -0.7, 6.0),
        orbit(0, None, 0.5, 0.1, 0.1, 0.5),
        orbit(5, Some(4), 1.0, 0.0, 1.0, 0.0),
    ];
    scene
}

fn load(scene: &Scene) -> Box<dyn Engine> {
    scene.validate("test").unwrap();
    (ENGINE.load)(scene, &Settings::defaults()).unwrap()
}

fn state_of(engine: &dyn Engine) -> State {
    let mut state = State::default();
    engine.read_state(&mut state);
    state
}

/// The largest differences: position, orientation (as rotation angle), velocities.
fn differences(left: &State, right: &State) -> [f64; 4] {
    let mut most = [0.0_f64; 4];
    for i in 0..left.len() {
        let turn = left.orientation[i].angle_between(right.orientation[i]);
        let differences = [
            left.position[i].distance(right.position[i]),
            turn,
            left.linear_velocity[i].distance(right.linear_velocity[i]),
            left.angular_velocity[i].distance(right.angular_velocity[i]),
        ];
        for (most, difference) in most.iter_mut().zip(differences) {
            *most = most.max(difference);
        }
    }
    most
}

fn run(engine: &mut dyn Engine, steps: u32, dt: f32) {
    for _ in 0..steps {
        engine.step(dt);
    }
}

#[test]
fn nested_nodes_follow_the_closed_form() {
    let scene = nested();
    let mut engine = load(&scene);
    let dt = scene.dt as f32;
    for steps in [0, 1, STEPS - 1] {
        run(engine.as_mut(), steps, dt);
    }
    let exact = orbits::state_at(&scene, f64::from(STEPS) * f64::from(dt));
    let [position, turn, linear, angular] = differences(&state_of(engine.as_ref()), &exact);
    assert!(position < 1e-5, "{position} m");
    // The angle between two nearly equal f32 quaternions has an error of √ε ≈ 3.5e-4.
    assert!(turn < 1e-3, "{turn} rad");
    // Speeds here are up to 7 m/s and rates up to 10 rad/s, so the bound is relative 1e-5.
    assert!(linear < 7e-5, "{linear} m/s");
    assert!(angular < 1e-4, "{angular} rad/s");
}

#[test]
fn the_start_is_the_closed_form_at_time_zero() {
    let scene = nested();
    let start = state_of(load(&scene).as_ref());
    let [position, ..] = differences(&start, &orbits::state_at(&scene, 0.0));
    assert!(position < 1e-6, "{position} m");
}

#[test]
fn an_orbit_is_as_exact_at_a_long_step_as_at_a_short_one() {
    let scene = nested();
    for (steps, dt) in [(64, 0.125), (8, 1.0), (1, 8.0)] {
        let mut engine = load(&scene);
        run(engine.as_mut(), steps, dt);
        let [position, ..] =
            differences(&state_of(engine.as_ref()), &orbits::state_at(&scene, 8.0));
        assert!(position < 1e-5, "{position} m in {steps} steps");
    }
}

#[test]
fn velocities_are_what_positions_do() {
    let scene = nested();
    let mut engine = load(&scene);
    run(engine.as_mut(), 100, 1.0 / 64.0);
    let before = state_of(engine.as_ref());
    engine.step(1.0 / 64.0);
    let middle = state_of(engine.as_ref());
    engine.step(1.0 / 64.0);
    let after = state_of(engine.as_ref());
    for i in 0..before.len() {
        let difference = (after.position[i] - before.position[i]) * 32.0;
        // A central difference is off by dt²/6 of the third derivative, here up to 60 m/s³.
        let error = difference.distance(middle.linear_velocity[i]);
        assert!(error < 4e-3, "body {i}: {error} m/s");
    }
}

#[test]
fn after_an_hour_of_frames_the_planet_is_still_on_time() {
    let scene = nested();
    let mut engine = load(&scene);
    let (steps, dt) = (216_000, 1.0_f32 / 60.0);
    run(engine.as_mut(), steps, dt);
    let exact = orbits::state_at(&scene, f64::from(steps) * f64::from(dt));
    let [position, ..] = differences(&state_of(engine.as_ref()), &exact);
    assert!(position < 1e-5, "{position} m");
}

#[test]
fn a_state_handed_over_in_mid_run_goes_on() {
    let scene = nested();
    let (mut first, mut second) = (load(&scene), load(&scene));
    run(first.as_mut(), 123, 1.0 / 60.0);
    second.write_state(&state_of(first.as_ref()), 1.0 / 60.0);
    for steps in [0, 200] {
        run(first.as_mut(), steps, 1.0 / 60.0);
        run(second.as_mut(), steps, 1.0 / 60.0);
        let (one, other) = (state_of(first.as_ref()), state_of(second.as_ref()));
        let [position, turn, ..] = differences(&one, &other);
        assert!(position < 1e-5 && turn < 1e-3, "{position} m, {turn} rad");
    }
}

#[test]
fn columns_have_a_row_for_every_body() {
    let engine = load(&nested());
    for Column { name, data, .. } in engine.columns() {
        assert_eq!(data.len(), 6, "{name}");
    }
    let depth = engine.columns().pop().unwrap().data;
    // Sun 1, planet 2, moon 3, moon's moon 4 carriers; the mast is a root.
    assert_eq!(
        depth,
        ColumnData::Scalar(vec![1.0, 2.0, 3.0, 4.0, 0.0, 2.0])
    );
}

#[test]
fn frames_are_three_axes_a_body_and_a_link_to_what_it_circles() {
    let engine = load(&nested());
    let lines = engine.layer(Layer::Frames).lines;
    assert_eq!(lines.len(), 6 * 3 + 4);
    assert_eq!(engine.layer(Layer::Aabbs), Drawing::default());
    // The planet's link ends at the carrier of the sun, which is where the sun is.
    let state = state_of(engine.as_ref());
    let link = lines
        .iter()
        .filter(|line| line.color == palette::GREY)
        .nth(1);
    let from = state.position[2].as_vec3().to_array();
    let to = state.position[1].as_vec3().to_array();
    assert_eq!(link.map(|line| (line.from, line.to)), Some((from, to)));
}

#[test]
fn the_tree_is_explained() {
    let text = load(&nested()).explain();
    assert!(
        text.contains("\n  orbit of body 0\n    body 0\n    orbit of body 1\n"),
        "{text}"
    );
}

#[test]
fn what_chapter_1_does_not_model_is_named_with_its_chapter() {
    let mut scene = nested();
    scene
        .bodies
        .push(Body::new(Shape::Sphere { radius: 0.1 }, 1.0, DVec3::ZERO));
    let error = (ENGINE.load)(&scene, &Settings::defaults()).err().unwrap();
    assert_eq!(
        error.to_string(),
        "engine `objects` (ch01_hierarchy) can't run scene `nested`: a body that no orbit moves \
         needs chapter 2 (ch02_rigid_bodies) (index 6)"
    );
}

#[test]
fn settings_that_mean_nothing_here_are_refused() {
    let scene = nested();
    let refused = |settings: Settings| (ENGINE.load)(&scene, &settings).err();
    let sweeps = refused(Settings::defaults().with_sweeps(4));
    assert!(matches!(
        sweeps,
        Some(LoadError::Setting {
            setting: "sweeps",
            ..
        })
    ));
    let method = refused(Settings::defaults().with_method("printed"));
    assert!(matches!(method, Some(LoadError::UnknownMethod { .. })));
    assert!(refused(Settings::defaults().with_method("hierarchy")).is_none());
}

#[test]
fn a_static_body_can_be_added_and_a_free_one_can_not() {
    let mut engine = load(&nested());
    let mast = Body::new(Shape::Sphere { radius: 0.1 }, 0.0, DVec3::Y);
    assert_eq!(engine.add_body(&mast, 1.0 / 60.0), Ok(6));
    engine.step(1.0 / 60.0);
    assert_eq!(state_of(engine.as_ref()).position[6], DVec3::Y);
    let ball = Body { mass: 1.0, ..mast };
    assert!(engine.add_body(&ball, 1.0 / 60.0).is_err());
}

#[test]
fn the_built_in_orrery_runs() {
    let scene = Scene::open("orrery", None, None).unwrap();
    assert!(!scene.orbits.is_empty());
    let mut engine = load(&scene);
    run(engine.as_mut(), scene.steps, scene.dt as f32);
    let time = f64::from(scene.steps) * f64::from(scene.dt as f32);
    let [position, ..] = differences(&state_of(engine.as_ref()), &orbits::state_at(&scene, time));
    assert!(position < 1e-5, "{position} m");
    assert_eq!(engine.pass_times().len(), 3);
}
