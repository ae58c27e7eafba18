//! Joints of the object engine against exact solutions: `tests/reference` has the numbers. Every
//! tolerance says what it comes from.

#[path = "exact/chain.rs"]
mod chain;
#[path = "exact/cradle.rs"]
mod cradle;
#[path = "exact/door.rs"]
mod door;
#[path = "exact/limits.rs"]
mod limits;
#[path = "exact/pendulum.rs"]
mod pendulum;
#[path = "exact/ragdoll.rs"]
mod ragdoll;

use ch00_scenes::measures::{joint_separation, limit_excess};
use ch00_scenes::{Body, Engine, Scene, Settings, Shape, State};
use glam::DVec3;

const G: f64 = 9.81;

fn load(scene: &Scene) -> Box<dyn Engine> {
    (ch04_ragdolls::ENGINE.load)(scene, &Settings::defaults()).expect("the scene is supported")
}

/// Steps a scene and shows every state, the start first, with the number of steps made.
fn watch(scene: &Scene, steps: u32, mut look: impl FnMut(u32, &State)) {
    let mut engine = load(scene);
    let mut state = State::start_of(scene);
    look(0, &state);
    for step in 1..=steps {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        look(step, &state);
    }
    assert_eq!(state.not_finite(), 0);
}

fn built_in(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in")
}

#[track_caller]
fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!(
        (value - wanted).abs() <= tolerance,
        "{value} is not within {tolerance} of {wanted}"
    );
}

fn separation(scene: &Scene, state: &State) -> f64 {
    joint_separation(scene, state).expect("there are joints")
}

fn excess(scene: &Scene, state: &State) -> f64 {
    limit_excess(scene, state).unwrap_or(0.0)
}

/// A body that nothing moves, to hang others on.
fn hook(position: DVec3) -> Body {
    let half_extents = DVec3::splat(0.05);
    Body::new(Shape::Box { half_extents }, 0.0, position)
}

fn rod(length: f64, thickness: f64) -> Shape {
    let half_extents = DVec3::new(thickness, length, thickness) / 2.0;
    Shape::Box { half_extents }
}
