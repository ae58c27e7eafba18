//! Balls on the device: the same as on the CPU, the same bits each time, and what happens when things go
//! wrong. On a machine without a graphics card they run on the software device.

#[path = "shared/moved.rs"]
mod moved;

use ch00_scenes::measures::Penetration;
use ch00_scenes::{Engine, Scene, Settings, State};
use ch06_compute::compute::{Balls, ComputeEngine};
use ch06_compute::lanes::LanesEngine;
use ch06_compute::rules::Rules;
use ch06_compute::stream::{Gpu, StreamError};
use glam::DVec3;
use moved::{moved, on_the_cpu};

const DT: f32 = 1.0 / 60.0;

fn gpu() -> Gpu {
    Gpu::open().expect("a graphics device, or package mesa-vulkan-drivers")
}

fn pile(count: u64) -> Scene {
    Scene::open("pile", Some(count), None).expect("a built-in scene")
}

fn rules(scene: &Scene) -> Rules {
    Rules::of(scene, &Settings::defaults()).expect("the defaults")
}

fn balls(gpu: &Gpu, scene: &Scene) -> Balls {
    Balls::of(gpu, scene, rules(scene)).expect("it fits")
}

fn read(balls: &mut Balls) -> State {
    let mut state = State::default();
    balls.read(&mut state).expect("the device is there");
    state
}

fn largest_gap(one: &State, other: &State) -> f64 {
    let pairs = one.position.iter().zip(&other.position);
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[test]
fn the_device_makes_the_same_steps_as_the_cpu_within_their_own_spread() {
    let gpu = gpu();
    for (name, count) in [
        ("balls", Some(60)),
        ("bounce", None),
        ("smooth_balls", None),
        ("pair", None),
    ] {
        let scene = Scene::open(name, count, None).expect("a built-in scene");
        let mut on_device = balls(&gpu, &scene);
        on_device.step(DT, 60).expect("it runs");
        let found = read(&mut on_device);
        let here = on_the_cpu(&scene, 60);
        let gaps = (1..20).map(|seed| largest_gap(&here, &on_the_cpu(&moved(&scene, seed), 60)));
        let spread = gaps.fold(0.0, f64::max);
        // Where nothing is chaotic the spread is a few roundings, and a fused multiply-add is one more.
        let allowed = 3.0 * spread + 1e-5;
        let gap = largest_gap(&found, &here);
        assert!(gap <= allowed, "{name}: {gap} m apart, allowed {allowed}");
    }
}

#[test]
fn the_first_step_differs_by_roundings_only() {
    let (gpu, scene) = (gpu(), pile(500));
    let mut on_device = balls(&gpu, &scene);
    on_device.step(DT, 1).expect("it runs");
    let gap = largest_gap(&read(&mut on_device), &on_the_cpu(&scene, 1));
    assert!(gap < 1e-5, "{gap} m apart");
}

#[test]
fn equal_inputs_give_equal_bits() {
    let (gpu, scene) = (gpu(), pile(400));
    let run = || {
        let mut balls = balls(&gpu, &scene);
        balls.step(DT, 150).expect("it runs");
        read(&mut balls).hash()
    };
    assert_eq!(run(), run());
}

#[test]
fn a_pile_comes_to_rest_without_sinking_in() {
    let (gpu, scene) = (gpu(), pile(300));
    let mut balls = balls(&gpu, &scene);
    balls.step(DT, 700).expect("it runs");
    let state = read(&mut balls);
    let depth = Penetration::of(&scene, &state).relative;
    assert_eq!(state.not_finite(), 0);
    assert!(depth.p99 <= 0.01 && depth.deepest <= 0.05, "{depth:?}");
    let lowest = state
        .position
        .iter()
        .map(|p| p.y)
        .fold(f64::INFINITY, f64::min);
    assert!(lowest > -0.6, "a ball fell to {lowest}");
}

#[test]
fn too_little_room_for_neighbours_grows_and_loses_nothing() {
    let (gpu, scene) = (gpu(), pile(300));
    let mut tight = Balls::with_room(&gpu, &scene, rules(&scene), 2).expect("it fits");
    let mut ample = balls(&gpu, &scene);
    tight.step(DT, 120).expect("it runs");
    ample.step(DT, 120).expect("it runs");
    let (tight_state, ample_state) = (read(&mut tight), read(&mut ample));
    assert!(tight.room() > 2, "it grew");
    assert_eq!(tight_state.hash(), ample_state.hash());
}

#[test]
fn more_bodies_than_the_device_has_room_for_is_an_error_before_anything_is_allocated() {
    let (gpu, scene) = (gpu(), pile(1000));
    let room = gpu.most_rows(16) as usize / 1000 + 1;
    let error = Balls::with_room(&gpu, &scene, rules(&scene), room).expect_err("too large");
    assert!(matches!(error, StreamError::TooLarge { .. }), "{error}");
    assert!(error.to_string().contains("at most"), "{error}");
}

#[test]
fn one_ball_that_is_not_finite_is_named_and_the_rest_goes_on() {
    let (gpu, scene) = (gpu(), pile(200));
    let mut balls = balls(&gpu, &scene);
    let mut state = State::start_of(&scene);
    state.position[17] = DVec3::splat(f64::NAN);
    balls.write(&state).expect("the device is there");
    balls.step(DT, 120).expect("it runs");
    let after = read(&mut balls);
    assert_eq!(after.not_finite(), 1);
    assert_eq!(balls.not_finite().map(|(first, _)| first), Some(17));
    assert!(balls.explain().contains("body 17 is not finite"));
}

#[test]
fn all_balls_in_one_cell_of_the_grid_are_pushed_apart() {
    let (gpu, scene) = (gpu(), pile(120));
    let mut balls = balls(&gpu, &scene);
    let mut state = State::start_of(&scene);
    let still = scene.bodies.iter().filter(|body| body.is_static()).count();
    for (i, position) in state.position.iter_mut().skip(still).enumerate() {
        *position = DVec3::new(
            0.01 * (i % 5) as f64,
            0.5 + 0.01 * (i / 25) as f64,
            0.01 * (i / 5 % 5) as f64,
        );
    }
    balls.write(&state).expect("the device is there");
    balls.step(DT, 300).expect("it runs");
    let after = read(&mut balls);
    assert_eq!(after.not_finite(), 0);
    let start = Penetration::of(&scene, &state).relative;
    let depth = Penetration::of(&scene, &after).relative;
    assert!(
        depth.p50 < 0.05 && depth.deepest <= start.deepest,
        "{depth:?} from {start:?}"
    );
}

#[test]
fn a_world_too_wide_for_f32_is_an_error_that_says_how_coarse_it_is() {
    let mut scene = pile(10);
    let last = scene.bodies.len() - 1;
    scene.bodies[last].position.x = 1e6;
    let error = ComputeEngine::load(&scene, &Settings::defaults())
        .err()
        .expect("too wide");
    let text = error.to_string();
    assert!(
        text.contains("0.0625 m apart") && text.contains(&format!("index {last}")),
        "{text}"
    );
}

#[test]
fn a_device_lost_in_mid_run_leaves_the_last_state_and_lanes_go_on_from_it() {
    let scene = pile(100);
    let mut engine = ComputeEngine::load(&scene, &Settings::defaults()).expect("a device");
    for _ in 0..30 {
        engine.step(DT);
    }
    let mut known = State::default();
    engine.read_state(&mut known);
    engine.driver().columns().gpu().device.destroy();
    engine.step(DT);
    let mut after = State::default();
    engine.read_state(&mut after);
    assert!(engine.failure().is_some());
    assert_eq!(after.hash(), known.hash());
    let mut lanes = LanesEngine::load(&scene, &Settings::defaults()).expect("it is supported");
    lanes.write_state(&after, DT);
    lanes.step(DT);
    let mut next = State::default();
    lanes.read_state(&mut next);
    assert!(largest_gap(&next, &after) > 0.0 && next.not_finite() == 0);
}

#[test]
fn no_fast_ball_passes_a_thin_wall() {
    let scene = Scene::open("tunnelling", Some(50), None).expect("a built-in scene");
    let gpu = gpu();
    let mut balls = balls(&gpu, &scene);
    balls.step(DT, 60).expect("it runs");
    let state = read(&mut balls);
    let behind = state.position[1..].iter().filter(|p| p.x > 0.0).count();
    assert_eq!(behind, 0);
}
