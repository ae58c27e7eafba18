//! Collisions of the object engine against exact solutions: `tests/reference` has the numbers.

use ch00_scenes::measures::{Conserved, Measures};
use ch00_scenes::{Body, Engine, Scene, Settings, Shape, State};
use glam::{DQuat, DVec3};

fn load(scene: &Scene, method: &str) -> Box<dyn Engine> {
    let settings = Settings::defaults().with_method(method);
    (ch03_collision::ENGINE.load)(scene, &settings).expect("the scene is supported")
}

fn run(scene: &Scene, method: &str, steps: u32) -> State {
    let settings = Settings::defaults().with_method(method);
    ch03_collision::ENGINE
        .run(scene, &settings, steps)
        .expect("the scene is supported")
}

#[track_caller]
fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!(
        (value - wanted).abs() <= tolerance,
        "{value} is not within {tolerance} of {wanted}"
    );
}

fn ball(radius: f64, mass: f64, position: DVec3) -> Body {
    Body::new(Shape::Sphere { radius }, mass, position)
}

/// A floor whose upper face passes through the origin, tilted about z.
fn floor(tilt: f64) -> Body {
    let turn = DQuat::from_axis_angle(DVec3::Z, tilt);
    let half_extents = DVec3::new(20.0, 0.5, 20.0);
    let mut body = Body::new(Shape::Box { half_extents }, 0.0, turn * DVec3::Y * -0.5);
    body.orientation = turn;
    body
}

/// Heights of the apexes within `seconds`, from the state now: y + v²/2g, exact in flight.
fn apexes(scene: &Scene, method: &str, seconds: f64) -> Vec<f64> {
    let mut engine = load(scene, method);
    let mut state = State::default();
    let (mut out, mut rising) = (Vec::new(), false);
    for _ in 0..(seconds / scene.dt).round() as u32 {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        let (y, v) = (state.position[1].y, state.linear_velocity[1].y);
        if rising && v <= 0.0 {
            out.push(y + v * v / (2.0 * 9.81));
        }
        rising = v > 0.0;
    }
    out
}

#[test]
fn an_elastic_ball_comes_back_to_its_height() {
    for steps_per_second in [60.0, 240.0] {
        let mut scene = Scene::open("bounce", None, None).expect("a built-in");
        scene.dt = 1.0 / steps_per_second;
        let heights = apexes(&scene, "corrected", 10.0);
        assert_eq!(heights.len(), 5);
        for height in heights {
            near(height, 5.0, 0.01 * 5.0);
        }
    }
}

#[test]
fn a_ball_with_e_of_a_half_comes_back_to_a_quarter_each_time() {
    let mut scene = Scene::open("bounce_half", None, None).expect("a built-in");
    scene.dt = 1.0 / 240.0;
    let heights = apexes(&scene, "corrected", 2.9);
    for (height, exact) in heights.iter().zip([1.325, 0.406_25, 0.176_562_5]) {
        near(height - 0.1, exact - 0.1, 0.01 * (exact - 0.1));
    }
}

#[test]
fn a_ball_that_slips_ends_rolling_at_five_sevenths() {
    let mut scene = Scene::new("slip to roll");
    scene.bodies = vec![floor(0.0), ball(0.5, 1.0, DVec3::Y * 0.5)];
    for body in &mut scene.bodies {
        body.friction = 0.3;
    }
    scene.bodies[1].linear_velocity = DVec3::X * 4.0;
    let state = run(&scene, "corrected", 60);
    // Scenario 13 after 1 s.
    near(state.linear_velocity[1].x, 20.0 / 7.0, 0.01 * 20.0 / 7.0);
    near(state.angular_velocity[1].z, -40.0 / 7.0, 0.01 * 40.0 / 7.0);
    near(state.position[1].x, 3.079_046_093, 0.01 * 3.079);
}

/// A ball of 0.5 m at rest on a slope; how far it came down in a second, and its spin.
fn down_the_slope(degrees: f64, mu: f64) -> (f64, f64) {
    let tilt = degrees.to_radians();
    let turn = DQuat::from_axis_angle(DVec3::Z, tilt);
    let mut scene = Scene::new("slope");
    scene.bodies = vec![floor(tilt), ball(0.5, 1.0, turn * DVec3::Y * 0.5)];
    for body in &mut scene.bodies {
        body.friction = mu;
    }
    let start = scene.bodies[1].position;
    let state = run(&scene, "corrected", 60);
    let along = turn * DVec3::NEG_X;
    (
        (state.position[1] - start).dot(along),
        state.angular_velocity[1].z,
    )
}

#[test]
fn a_ball_rolls_down_a_slope_of_twenty_degrees() {
    let (distance, spin) = down_the_slope(20.0, 0.5);
    near(distance, 1.198_292_002, 0.012);
    near(spin, 4.793_168_009, 0.048);
}

#[test]
fn a_ball_slips_down_a_slope_of_sixty_degrees() {
    let (distance, spin) = down_the_slope(60.0, 0.3);
    near(distance, 3.512_104_606, 0.035);
    near(spin, 7.3575, 0.074);
}

/// Scenario 16: the two balls, touching exactly, right before they collide.
fn oblique(v1: DVec3, omega_1: DVec3, mu: f64) -> State {
    let mut scene = Scene::new("oblique impact");
    scene.gravity = DVec3::ZERO;
    scene.dt = 1e-4;
    scene.restitution_threshold = Some(0.0);
    // A hair apart, so that the first step makes them touch.
    let apart = 0.3 + 2e-4;
    scene.bodies = vec![
        ball(0.1, 1.0, DVec3::ZERO),
        ball(0.2, 2.0, DVec3::X * apart),
    ];
    scene.bodies[0].linear_velocity = v1;
    scene.bodies[0].angular_velocity = omega_1;
    scene.bodies[1].linear_velocity = DVec3::NEG_X;
    for body in &mut scene.bodies {
        body.restitution = 0.8;
        body.friction = mu;
    }
    run(&scene, "corrected", 3)
}

#[test]
fn an_oblique_impact_that_sticks_is_the_closed_form() {
    let state = oblique(DVec3::new(3.0, 1.0, 0.0), DVec3::Z * 5.0, 0.5);
    near(
        state.linear_velocity[0].distance(DVec3::new(-1.8, 0.714_285_714_3, 0.0)),
        0.0,
        0.01,
    );
    near(
        state.linear_velocity[1].distance(DVec3::new(1.4, 0.142_857_142_9, 0.0)),
        0.0,
        0.01,
    );
    near(state.angular_velocity[0].z, -2.142_857_143, 0.03);
    near(state.angular_velocity[1].z, -1.785_714_286, 0.03);
}

#[test]
fn an_oblique_impact_that_slips_is_the_closed_form() {
    let state = oblique(DVec3::new(3.0, 4.0, 1.0), DVec3::new(0.0, 10.0, 5.0), 0.1);
    near(
        state.linear_velocity[0].distance(DVec3::new(-1.8, 3.52, 1.0)),
        0.0,
        0.01,
    );
    near(
        state.linear_velocity[1].distance(DVec3::new(1.4, 0.24, 0.0)),
        0.0,
        0.01,
    );
    near(
        state.angular_velocity[0].distance(DVec3::new(0.0, 10.0, -7.0)),
        0.0,
        0.05,
    );
    near(
        state.angular_velocity[1].distance(DVec3::new(0.0, 0.0, -3.0)),
        0.0,
        0.05,
    );
}

fn momentum_error(scene: &Scene, method: &str) -> f64 {
    let start = Conserved::of(scene, &State::start_of(scene));
    let end = Conserved::of(scene, &run(scene, method, 60));
    (end.momentum - start.momentum).length() / start.momentum_sum
}

#[test]
fn a_pair_of_unequal_masses_keeps_its_momentum() {
    let scene = Scene::open("pair", None, None).expect("a built-in");
    assert!(momentum_error(&scene, "corrected") <= 1e-5);
    assert!(momentum_error(&scene, "printed") > 0.1);
}

#[test]
fn a_cradle_hands_the_speed_to_the_last_ball() {
    let mut scene = Scene::new("cradle");
    scene.gravity = DVec3::ZERO;
    scene.restitution_threshold = Some(0.0);
    let place = |i: u32| if i == 0 { -0.3 } else { 0.2001 * f64::from(i) };
    scene.bodies = (0..5)
        .map(|i| ball(0.1, 1.0, DVec3::X * place(i)))
        .collect();
    scene.bodies[0].linear_velocity = DVec3::X;
    for body in &mut scene.bodies {
        body.restitution = 1.0;
        body.friction = 0.0;
    }
    let state = run(&scene, "corrected", 60);
    // Scenario 17 with gaps of 1e-4 m: all of it, and the others rest.
    for (i, velocity) in state.linear_velocity.iter().enumerate() {
        near(velocity.x, if i == 4 { 1.0 } else { 0.0 }, 1e-3);
    }
}

/// Largest energy over its start, and largest number of escaped balls, over 600 steps.
fn watch(scene: &Scene) -> (f64, usize) {
    watch_with(scene, &Settings::defaults())
}

fn watch_with(scene: &Scene, settings: &Settings) -> (f64, usize) {
    let mut engine =
        (ch03_collision::ENGINE.load)(scene, settings).expect("the scene is supported");
    let mut state = State::start_of(scene);
    let start = Conserved::of(scene, &state).energy();
    let (mut most, mut escaped) = (0.0_f64, 0);
    for _ in 0..600 {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        most = most.max(Conserved::of(scene, &state).energy() / start - 1.0);
        let out = ch00_scenes::measures::escaped(scene, &state).expect("the box is known");
        escaped = escaped.max(out);
    }
    assert_eq!(state.not_finite(), 0);
    (most, escaped)
}

#[test]
fn no_ball_escapes_and_no_energy_is_made() {
    for (count, seed) in [
        (10, 1),
        (10, 2),
        (10, 3),
        (60, 1),
        (60, 2),
        (60, 3),
        (1000, 1),
    ] {
        let scene = Scene::open("balls", Some(count), Some(seed)).expect("a built-in");
        let (most, escaped) = watch(&scene);
        assert!(most <= 1e-3, "{count} balls, seed {seed}: {most}");
        assert_eq!(escaped, 0, "{count} balls, seed {seed}");
    }
}

#[test]
fn no_ball_is_lost_in_a_corner_even_if_the_sweeps_are_few() {
    // With two or four sweeps a fast ball may pass the foot of a wall and the floor in one step.
    for (sweeps, seed) in [(2, 1), (4, 1), (4, 2), (4, 3)] {
        let scene = Scene::open("balls", Some(1000), Some(seed)).expect("a built-in");
        let (most, escaped) = watch_with(&scene, &Settings::defaults().with_sweeps(sweeps));
        assert!(
            most <= 1e-3 && escaped == 0,
            "{sweeps} sweeps, seed {seed}: {most}, {escaped}"
        );
    }
}

#[test]
fn elastic_balls_make_no_energy_either() {
    let cases = [
        (10, 1, 0.0),
        (60, 1, 0.0),
        (60, 2, 0.0),
        (60, 3, 0.0),
        (60, 1, 0.5),
        (300, 1, 0.0),
    ];
    for (count, seed, mu) in cases {
        let mut scene = Scene::open("balls", Some(count), Some(seed)).expect("a built-in");
        for body in &mut scene.bodies {
            body.restitution = 1.0;
            body.friction = mu;
        }
        let (most, _) = watch(&scene);
        assert!(most <= 1e-3, "{count} balls, seed {seed}, μ = {mu}: {most}");
    }
}

#[test]
fn a_settled_pile_overlaps_by_less_than_a_centimetre() {
    let scene = Scene::open("balls", Some(1000), Some(1)).expect("a built-in");
    let state = run(&scene, "corrected", 600);
    let penetration = Measures::of(&scene, &state).penetration;
    assert!(penetration.p99 <= 0.01, "{}", penetration.p99);
}

#[test]
fn the_files_that_other_engines_ran_run_here() {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/reference/scenes/balls_60.json"
    );
    let scene = Scene::open(file, None, None).expect("part of the repository");
    let (most, escaped) = watch(&scene);
    assert!(most <= 1e-3 && escaped == 0, "{most}, {escaped}");
}

#[test]
fn joints_are_refused_by_name() {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/reference/scenes/ragdolls_5.json"
    );
    let scene = Scene::open(file, None, None).expect("part of the repository");
    let error = (ch03_collision::ENGINE.load)(&scene, &Settings::defaults());
    let text = error.err().expect("it must be refused").to_string();
    assert!(text.contains("joints"), "{text}");
}

#[test]
fn bodies_at_one_place_part_and_stay_finite() {
    let mut scene = Scene::new("one place");
    scene.bodies = vec![
        floor(0.0),
        ball(0.2, 1.0, DVec3::Y * 0.5),
        ball(0.2, 1.0, DVec3::Y * 0.5),
        ball(0.2, 50.0, DVec3::Y * 0.5),
    ];
    let state = run(&scene, "corrected", 300);
    assert_eq!(state.not_finite(), 0);
    let penetration = Measures::of(&scene, &state).penetration;
    assert!(penetration.deepest < 0.005, "{}", penetration.deepest);
}
