//! The device against the CPU.

use std::f64::consts::PI;

use ch00_scenes::{Engine, Joint, Scene, Settings, State};
use ch06_compute::lanes::LanesEngine;
use glam::{DQuat, DVec3};

use super::moved::{moved, on_the_cpu};
use super::{DT, after, ball, built_in, gpu, largest_gap, pairs};

/// Runs whose starts differ by one unit in the last place.
const RUNS: u64 = 20;

/// Where nothing is chaotic the spread is a few roundings, and a fused multiply-add is one more, m.
const ROUNDINGS: f64 = 1e-5;

/// How far a run on the device is from one on the CPU after some steps, in terms of how far runs on the CPU
/// are from each other.
fn agree(name: &str, count: Option<u64>, steps: u32) {
    scenes_agree(&built_in(name, count), steps);
}

fn scenes_agree(scene: &Scene, steps: u32) {
    let name = &scene.name;
    let found = after(&mut pairs(&gpu(), scene), steps);
    let here = on_the_cpu(scene, steps);
    let gaps = (1..=RUNS).map(|seed| largest_gap(&here, &on_the_cpu(&moved(scene, seed), steps)));
    let spread = gaps.fold(0.0, f64::max);
    let gap = largest_gap(&found, &here);
    let allowed = 3.0 * spread + ROUNDINGS;
    assert_eq!(found.not_finite(), 0, "{name}");
    assert!(
        gap <= allowed,
        "{name}: {gap} m apart after {steps} steps, allowed {allowed}"
    );
}

#[test]
fn contacts_agree_with_the_cpu_within_its_own_spread() {
    for name in [
        "pair",
        "bounce_half",
        "slopes",
        "slip_to_roll",
        "oblique",
        "balls",
    ] {
        agree(name, None, 60);
    }
}

#[test]
fn boxes_agree_with_the_cpu_within_its_own_spread() {
    for name in ["stack", "heavy_on_light", "incline", "slide"] {
        agree(name, None, 60);
    }
}

#[test]
fn all_shapes_agree_with_the_cpu_within_its_own_spread() {
    agree("mixed", Some(40), 60);
}

#[test]
fn joints_agree_with_the_cpu_within_its_own_spread() {
    for (name, count) in [
        ("chain", None),
        ("chain_hanging", Some(10)),
        ("cradle", None),
        ("door", None),
    ] {
        agree(name, count, 60);
    }
}

#[test]
fn ragdolls_agree_with_the_cpu_within_its_own_spread() {
    agree("ragdoll_field", Some(3), 60);
}

#[test]
fn ragdolls_that_bounce_agree_with_the_cpu_within_its_own_spread() {
    let mut scene = built_in("ragdoll_field", Some(2));
    for body in &mut scene.bodies {
        body.restitution = 0.5;
    }
    scenes_agree(&scene, 40);
}

#[test]
fn joints_that_close_loops_agree_with_the_cpu_within_its_own_spread() {
    scenes_agree(&ring(), 60);
}

/// A ring of eight balls, each pinned to the next, that hangs on a static one.
fn ring() -> Scene {
    let mut scene = Scene::new("ring");
    let places = (0..8).map(|i| DQuat::from_rotation_z(0.25 * PI * f64::from(i)) * DVec3::Y);
    let places: Vec<DVec3> = places.collect();
    scene.bodies.push(ball(0.1, 0.0, places[0]));
    for &place in &places[1..] {
        scene.bodies.push(ball(0.1, 1.0, place));
    }
    for a in 0..8 {
        let b = (a + 1) % 8;
        let half = 0.5 * (places[b] - places[a]);
        scene.joints.push(pin(a, b, half));
    }
    scene
}

/// A ball joint midway between two bodies.
fn pin(a: usize, b: usize, half: DVec3) -> Joint {
    Joint::Ball {
        a,
        b,
        anchor_a: half,
        anchor_b: -half,
        cone: None,
        twist: None,
        limits: None,
        rest: None,
    }
}

#[test]
fn forces_agree_with_the_cpu_within_its_own_spread() {
    for name in ["tops", "magnets"] {
        agree(name, None, 60);
    }
}

#[test]
fn fast_bodies_agree_with_the_cpu_within_its_own_spread() {
    agree("tunnelling", Some(1), 60);
}

#[test]
fn the_first_steps_differ_by_roundings_only() {
    for (name, count) in [
        ("stack", Some(8)),
        ("slide", None),
        ("ragdoll_field", Some(2)),
    ] {
        let scene = built_in(name, count);
        let found = after(&mut pairs(&gpu(), &scene), 3);
        let gap = largest_gap(&found, &on_the_cpu(&scene, 3));
        assert!(gap < ROUNDINGS, "{name}: {gap} m apart");
    }
}

#[test]
fn no_fast_ball_passes_a_thin_wall() {
    let state = after(&mut pairs(&gpu(), &built_in("tunnelling", Some(50))), 60);
    let behind = state.position[1..].iter().filter(|p| p.x > 0.0).count();
    assert_eq!(behind, 0);
}

#[test]
fn a_wall_is_read_back_where_the_scene_has_it() {
    let scene = built_in("ragdolls", Some(1));
    let state = after(&mut pairs(&gpu(), &scene), 1);
    for (row, body) in scene.bodies[..5].iter().enumerate() {
        assert_eq!(state.position[row], body.position.as_vec3().as_dvec3());
    }
}

#[test]
fn equal_inputs_give_equal_bits() {
    let gpu = gpu();
    for (name, count) in [("ragdoll_field", Some(4)), ("stack", Some(10))] {
        let scene = built_in(name, count);
        let run = || after(&mut pairs(&gpu, &scene), 90).hash();
        assert_eq!(run(), run(), "{name}");
    }
}

#[test]
fn the_engine_of_lanes_makes_the_steps_that_the_device_is_compared_with() {
    let scene = built_in("stack", None);
    let mut engine = LanesEngine::load(&scene, &Settings::defaults()).expect("it is supported");
    for _ in 0..5 {
        engine.step(DT);
    }
    let mut state = State::default();
    engine.read_state(&mut state);
    assert_eq!(state.hash(), on_the_cpu(&scene, 5).hash());
}
