//! Scenes, runs and comparisons that the scenarios share.

use ch00_scenes::measures::joint_separation;
use ch00_scenes::{Body, Engine, EngineEntry, Scene, Settings, Shape, State};
use glam::{DQuat, DVec3};
use serde_json::Value;

/// The engine that is tested.
pub const ENGINE: EngineEntry = ch06_compute::LANES;

/// The engine's substeps unless a test says otherwise.
pub const SUBSTEPS: u32 = super::SUBSTEPS_OF_THE_METHOD;

pub const G: f64 = 9.81;

pub fn load(scene: &Scene, substeps: u32) -> Box<dyn Engine> {
    let settings = Settings {
        substeps: Some(substeps),
        ..Settings::defaults().with_method(super::METHOD)
    };
    (ENGINE.load)(scene, &settings).expect("the scene is supported")
}

/// Steps a scene and shows every state, the start first, with the number of steps made.
pub fn watch_with(scene: &Scene, substeps: u32, steps: u32, mut look: impl FnMut(u32, &State)) {
    let mut engine = load(scene, substeps);
    let mut state = State::start_of(scene);
    look(0, &state);
    for step in 1..=steps {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        look(step, &state);
    }
    assert_eq!(state.not_finite(), 0);
}

pub fn watch(scene: &Scene, steps: u32, look: impl FnMut(u32, &State)) {
    watch_with(scene, SUBSTEPS, steps, look);
}

/// The state after so many seconds.
pub fn after(scene: &Scene, seconds: f64) -> State {
    let mut end = State::default();
    watch(scene, steps(scene, seconds), |_, state| {
        end.clone_from(state);
    });
    end
}

/// How many steps of the scene make so many seconds.
pub fn steps(scene: &Scene, seconds: f64) -> u32 {
    (seconds / scene.dt).round() as u32
}

pub fn built_in(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in")
}

/// A scene in which nothing falls.
pub fn weightless(name: &str) -> Scene {
    Scene {
        gravity: DVec3::ZERO,
        ..Scene::new(name)
    }
}

pub fn ball(radius: f64, mass: f64, position: DVec3) -> Body {
    Body::new(Shape::Sphere { radius }, mass, position)
}

/// A static box whose upper face passes through the origin, tilted about z.
pub fn floor(tilt: f64) -> Body {
    let turn = DQuat::from_rotation_z(tilt);
    let half_extents = DVec3::new(20.0, 0.5, 20.0);
    Body {
        orientation: turn,
        ..Body::new(Shape::Box { half_extents }, 0.0, turn * DVec3::Y * -0.5)
    }
}

/// Gives every body these coefficients.
pub fn of_one_stuff(scene: &mut Scene, restitution: f64, friction: f64) {
    for body in &mut scene.bodies {
        body.restitution = restitution;
        body.friction = friction;
        body.static_friction = None;
    }
}

pub fn separation(scene: &Scene, state: &State) -> f64 {
    joint_separation(scene, state).expect("there are joints")
}

/// The angle between two attitudes, rad.
pub fn angle_between(a: DQuat, b: DQuat) -> f64 {
    let d = a.conjugate() * b;
    2.0 * d.xyz().length().atan2(d.w.abs())
}

#[track_caller]
pub fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!(
        (value - wanted).abs() <= tolerance,
        "{value} is not within {tolerance} of {wanted}"
    );
}

#[track_caller]
pub fn at_most(value: f64, most: f64, what: &str) {
    assert!(value <= most, "{what}: {value}, at most {most}");
}

/// The exact values of a scenario of the reference.
pub fn exact(scenario: &str) -> Value {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/reference/exact.json"
    );
    let text = std::fs::read_to_string(path).expect("the reference is part of the repository");
    let all: Value = serde_json::from_str(&text).expect("the reference is JSON");
    all[scenario]["exact"].clone()
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub fn vector(value: &Value) -> DVec3 {
    DVec3::new(number(&value[0]), number(&value[1]), number(&value[2]))
}
