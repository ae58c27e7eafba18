//! The overlay draws of columns what it draws of objects: every line, face and key.

use ch00_scenes::{Engine, Layer, Scene, Settings};
use ch04_ragdolls::RagdollEngine;
use ch05_properties::PropertiesEngine;

const SCENES: [(&str, Option<u64>); 9] = [
    ("balls", Some(30)),
    ("smooth_balls", Some(30)),
    ("mixed", Some(30)),
    ("stack", None),
    ("magnets_on_a_table", None),
    ("ragdolls", Some(2)),
    ("door", None),
    ("door_pins", None),
    ("cradle", None),
];

/// Both engines with a scene in them after 30 steps, in which some bodies have met.
fn both(name: &str, count: Option<u64>, method: &str) -> (RagdollEngine, PropertiesEngine) {
    let scene = Scene::open(name, count, None).expect("a built-in");
    let settings = Settings::defaults().with_method(method);
    let mut objects = RagdollEngine::load(&scene, &settings).expect("it runs");
    let mut properties = PropertiesEngine::load(&scene, &settings).expect("it runs");
    for _ in 0..30 {
        objects.step(scene.dt as f32);
        properties.step(scene.dt as f32);
    }
    (objects, properties)
}

#[test]
fn every_layer_is_drawn_as_that_of_the_objects() {
    for (name, count) in SCENES {
        for method in ["corrected", "printed"] {
            let (objects, properties) = both(name, count, method);
            assert_eq!(properties.layers(), objects.layers(), "{name}");
            for layer in Layer::ALL {
                let what = format!("{}, {name}, {method}", layer.name());
                assert!(properties.layer(layer) == objects.layer(layer), "{what}");
            }
        }
    }
}

#[test]
fn the_narrow_phase_is_taken_apart_as_that_of_the_objects() {
    let (objects, properties) = both("mixed", Some(30), "corrected");
    assert!(properties.pairs().len() > 30);
    for &(a, b) in properties.pairs() {
        for step in 0..5 {
            let dissection = properties.dissect(a, b, step);
            assert!(dissection.is_some());
            assert_eq!(dissection, objects.dissect(a, b, step), "{a}, {b}, {step}");
        }
    }
    assert_eq!(properties.dissect(0, 35, 0), None);
}

#[test]
fn a_world_without_collisions_has_no_layers_of_them() {
    let mut scene = Scene::open("bounce", None, None).expect("a built-in");
    scene.bodies.retain(|body| !body.is_static());
    let engine = PropertiesEngine::load(&scene, &Settings::defaults()).expect("it runs");
    assert_eq!(engine.layers(), [Layer::Frames]);
    assert!(!engine.layer(Layer::Frames).lines.is_empty());
}
