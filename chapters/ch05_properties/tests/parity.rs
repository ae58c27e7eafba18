//! The same bits as chapter 4, on every scene; and the same bits with no more than the scene needs.

use ch00_scenes::{Engine, Scene, Settings, State, builtin};
use ch05_properties::PropertiesEngine;
use ch05_properties::plan::Plan;

const STEPS: u32 = 600;

/// The built-in scenes that chapter 4 steps itself.
fn scenes() -> impl Iterator<Item = Scene> {
    builtin::NAMES
        .iter()
        .map(|name| Scene::open(name, None, None).expect("a built-in"))
        .filter(|scene| scene.orbits.is_empty())
}

/// Where every body is after each step.
#[track_caller]
fn same_steps(scene: &Scene, one: &mut dyn Engine, two: &mut dyn Engine) {
    let (mut a, mut b) = (State::default(), State::default());
    for step in 0..=STEPS {
        one.read_state(&mut a);
        two.read_state(&mut b);
        if a.hash() != b.hash() {
            let differs = |i: &usize| {
                a.position[*i].to_array().map(f64::to_bits)
                    != b.position[*i].to_array().map(f64::to_bits)
                    || a.orientation[*i].to_array().map(f64::to_bits)
                        != b.orientation[*i].to_array().map(f64::to_bits)
                    || a.linear_velocity[*i] != b.linear_velocity[*i]
                    || a.angular_velocity[*i] != b.angular_velocity[*i]
            };
            let body = (0..a.len()).find(differs);
            panic!(
                "{}: step {step}, body {body:?}: {:?} {:?}",
                scene.name,
                body.map(|i| (
                    a.position[i],
                    a.orientation[i],
                    a.linear_velocity[i],
                    a.angular_velocity[i]
                )),
                body.map(|i| (
                    b.position[i],
                    b.orientation[i],
                    b.linear_velocity[i],
                    b.angular_velocity[i]
                )),
            );
        }
        one.step(scene.dt as f32);
        two.step(scene.dt as f32);
    }
}

fn against_objects(method: &str) {
    let settings = Settings::defaults().with_method(method);
    for scene in scenes() {
        let mut objects =
            (ch04_ragdolls::ENGINE.load)(&scene, &settings).expect("chapter 4 runs it");
        let full = |_: &Scene, method| Plan::full(method);
        let mut full = PropertiesEngine::load_with(&scene, &settings, full).expect("so do we");
        same_steps(&scene, objects.as_mut(), &mut full);
    }
}

fn planned_against_full(method: &str) {
    let settings = Settings::defaults().with_method(method);
    for scene in scenes() {
        let full = |_: &Scene, method| Plan::full(method);
        let mut full = PropertiesEngine::load_with(&scene, &settings, full).expect("it runs");
        let mut planned = PropertiesEngine::load(&scene, &settings).expect("it runs");
        same_steps(&scene, &mut full, &mut planned);
    }
}

#[test]
fn corrected_has_the_bits_of_chapter_4() {
    against_objects("corrected");
}

#[test]
fn printed_has_the_bits_of_chapter_4() {
    against_objects("printed");
}

#[test]
fn corrected_with_no_more_than_needed_has_the_bits_of_all() {
    planned_against_full("corrected");
}

#[test]
fn printed_with_no_more_than_needed_has_the_bits_of_all() {
    planned_against_full("printed");
}
