//! Rigid bodies of the object engine against exact solutions. The numbers are those of
//! `tests/reference`; the engine runs in f32, so each tolerance says what f32 allows.

use ch00_maths::f64::free_rotation;
use ch00_scenes::measures::{Conserved, Reference};
use ch00_scenes::{Body, Engine, Force, Scene, Settings, Shape, State};
use glam::{DQuat, DVec3};

fn load(scene: &Scene, method: &str) -> Box<dyn Engine> {
    let settings = Settings::defaults().with_method(method);
    (ch02_rigid_bodies::ENGINE.load)(scene, &settings).expect("the scene is supported")
}

fn run(scene: &Scene, method: &str, steps: u32) -> State {
    let settings = Settings::defaults().with_method(method);
    ch02_rigid_bodies::ENGINE
        .run(scene, &settings, steps)
        .expect("the scene is supported")
}

fn weightless(name: &str) -> Scene {
    Scene {
        gravity: DVec3::ZERO,
        ..Scene::new(name)
    }
}

fn free_box() -> Scene {
    let mut scene = weightless("free box");
    let half_extents = DVec3::new(0.3, 0.2, 0.1);
    let mut body = Body::new(Shape::Box { half_extents }, 1.0, DVec3::ZERO);
    body.angular_velocity = DVec3::new(1.0, 2.0, 3.0);
    scene.bodies.push(body);
    scene
}

fn angle_between(a: DQuat, b: DQuat) -> f64 {
    let d = a.conjugate() * b;
    2.0 * DVec3::new(d.x, d.y, d.z).length().atan2(d.w.abs())
}

#[track_caller]
fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!(
        (value - wanted).abs() <= tolerance,
        "{value} is not within {tolerance} of {wanted}"
    );
}

#[test]
fn a_thrown_body_follows_its_parabola() {
    let mut scene = Scene::new("thrown");
    let mut body = Body::new(Shape::Sphere { radius: 0.1 }, 1.0, DVec3::Y * 10.0);
    body.linear_velocity = DVec3::new(5.0, 8.0, 0.0);
    scene.bodies.push(body);
    let state = run(&scene, "corrected", 120);
    // Scenario 1 after 2 s. Each step rounds p by up to ½ ulp(10 m), 4.8e-7 m, which stays in p − p*
    // and so is added again at every later step: at the worst ½ · 120² roundings.
    let rounding = 0.5 * 120.0 * 120.0 * 4.8e-7;
    near(
        state.position[0].distance(DVec3::new(10.0, 6.38, 0.0)),
        0.0,
        rounding,
    );
    let velocity = DVec3::new(5.0, 8.0 - 19.62, 0.0);
    near(state.linear_velocity[0].distance(velocity), 0.0, rounding);
    let printed = run(&scene, "printed", 120);
    near(printed.position[0].y - 6.38, -0.1635, rounding);
}

#[test]
fn a_free_box_keeps_to_eulers_equations() {
    let exact = DQuat::from_xyzw(
        -0.106_057_607_8,
        -0.035_904_831_18,
        -0.914_239_544_2,
        0.389_395_278_3,
    );
    let state = run(&free_box(), "corrected", 600);
    // Scenario 4 after 10 s: the splitting alone errs by 3.1e-4 rad; reading the momentum from two
    // f32 attitudes adds about 2⁻²³ rad a step, which wanders to 1e-3.
    near(angle_between(state.orientation[0], exact), 0.0, 3e-3);
    let printed = run(&free_box(), "printed", 600);
    assert!(angle_between(printed.orientation[0], exact) > 1.0);
}

#[test]
fn a_ball_keeps_its_spin_and_printed_loses_it() {
    let mut scene = weightless("spinning ball");
    let mut body = Body::new(Shape::Sphere { radius: 0.5 }, 1.0, DVec3::ZERO);
    body.angular_velocity = DVec3::Z * 10.0;
    scene.bodies.push(body);
    let spin = |method| run(&scene, method, 60).angular_velocity[0].z;
    near(spin("corrected"), 10.0, 1e-4);
    // Each update maps ω to 2 atan(½ω Δt)/Δt; the printed start makes one more of them.
    let h = 1.0 / 60.0;
    let law = (0..61).fold(10.0_f64, |omega, _| 2.0 * (0.5 * omega * h).atan() / h);
    near(spin("printed"), law, 1e-4);
}

#[test]
fn drag_slows_a_body_as_the_exponential_does() {
    let mut scene = weightless("drag");
    scene.drag = 0.25;
    let mut body = Body::new(Shape::Sphere { radius: 0.5 }, 1.0, DVec3::ZERO);
    body.linear_velocity = DVec3::X;
    body.angular_velocity = DVec3::Y;
    scene.bodies.push(body);
    let state = run(&scene, "corrected", 240);
    let left = (-1.0_f64).exp();
    near(state.linear_velocity[0].x, left, 1e-4);
    near(state.angular_velocity[0].y, left, 1e-4);
}

/// The heavy top of scenario 8, held by its tip.
fn heavy_top(dt: f64) -> Scene {
    let mut scene = Scene::new("heavy top");
    scene.dt = dt;
    let tilt = DQuat::from_axis_angle(DVec3::Z, -0.5);
    let axis = tilt * DVec3::Y;
    // Thin enough that its moment about the tip is 0.05 kg m² to 1e-7.
    let shape = Shape::Cylinder {
        radius: 0.2,
        half_height: 1e-4,
    };
    let mut body = Body::new(shape, 1.0, axis * 0.2);
    body.orientation = tilt;
    body.angular_velocity = axis * 60.0;
    scene.bodies.push(body);
    scene.forces.push(Force::FixedPoint {
        body: 0,
        arm: DVec3::Y * 0.2,
    });
    scene
}

/// Largest tilt, times of its minima and the azimuth turned by then, over 5 s.
fn nutation(dt: f64) -> (f64, Vec<f64>, f64) {
    let scene = heavy_top(dt);
    let mut engine = load(&scene, "corrected");
    let mut state = State::default();
    let (mut largest, mut minima, mut azimuths) = (0.0_f64, vec![0.0], vec![0.0]);
    let (mut tilts, mut azimuth, mut azimuth_last) = (vec![0.5_f64], 0.0_f64, 0.0_f64);
    for step in 1..=(5.0 / dt).round() as u32 {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        let axis = state.orientation[0] * DVec3::Y;
        tilts.push(axis.y.acos());
        largest = largest.max(axis.y.acos());
        let raw = (-axis.z).atan2(axis.x);
        let turned = (raw - azimuth_last + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU)
            - std::f64::consts::PI;
        azimuth_last = raw;
        azimuth += turned;
        azimuths.push(azimuth);
        let n = tilts.len();
        if n >= 3 && tilts[n - 2] <= tilts[n - 3] && tilts[n - 2] < tilts[n - 1] {
            let (a, b, c) = (tilts[n - 3], tilts[n - 2], tilts[n - 1]);
            let offset = 0.5 * (a - c) / (a - 2.0 * b + c);
            minima.push((f64::from(step) - 1.0 + offset) * dt);
        }
    }
    let whole = *minima.last().expect("it nutates") / dt;
    let before = azimuths[whole.floor() as usize];
    let turned = before + (azimuths[whole.ceil() as usize] - before) * whole.fract();
    (largest, minima, turned)
}

#[test]
fn a_heavy_top_nods_and_precesses_as_the_elliptic_integral_says() {
    let (largest, minima, azimuth) = nutation(1.0 / 240.0);
    let last = *minima.last().expect("it nutates");
    let period = last / (minima.len() - 1) as f64;
    near(period / 0.298_502_047_2, 1.0, 5e-3);
    near(largest, 0.579_527_312_2, 5e-3);
    near(azimuth / last / 1.740_723_888, 1.0, 1e-2);
}

#[test]
fn a_heavy_top_stays_up_at_60_hz_with_a_radian_a_step() {
    let (largest, minima, _) = nutation(1.0 / 60.0);
    // 16 whole nutations fit into 5 s; explicit Euler blows up within the first second.
    assert_eq!(minima.len() - 1, 16);
    near(largest, 0.58, 0.02);
}

#[test]
fn magnets_push_each_other_equally() {
    let scene = Scene::open("magnets", None, None).expect("a built-in");
    let reference = Reference::of(&scene);
    for (method, bound) in [("corrected", 1e-3), ("printed", 1e-3)] {
        let state = run(&scene, method, 60);
        let now = Conserved::of(&scene, &state);
        let error = reference.momentum_error(&now).expect("nothing else pulls");
        assert!(error < bound, "{method}: {error}");
    }
}

#[test]
fn magnets_keep_their_energy_and_do_not_touch_for_twelve_seconds() {
    let scene = Scene::open("magnets", None, None).expect("a built-in");
    let reference = Reference::of(&scene);
    let mut engine = load(&scene, "corrected");
    let mut state = State::default();
    for step in 1..=720 {
        engine.step(scene.dt as f32);
        if step % 30 == 0 {
            engine.read_state(&mut state);
            let energy = reference.energy_error(&Conserved::of(&scene, &state));
            near(energy.expect("no orbits"), 0.0, 2e-3);
            let touching = ch00_scenes::measures::Penetration::of(&scene, &state);
            assert_eq!(
                (touching.pairs_touching, touching.pairs_not_measured),
                (0, 0)
            );
        }
    }
}

#[test]
fn the_energy_of_the_free_tops_stays() {
    let scene = Scene::open("tops", None, None).expect("a built-in");
    let reference = Reference::of(&scene);
    let state = run(&scene, "corrected", 600);
    let error = reference.energy_error(&Conserved::of(&scene, &state));
    near(error.expect("no orbits"), 0.0, 2e-3);
}

#[test]
fn a_state_that_is_written_is_the_state_that_is_read() {
    let scene = Scene::open("tops", None, None).expect("a built-in");
    let before = run(&scene, "corrected", 37);
    let mut other = load(&scene, "corrected");
    other.write_state(&before, scene.dt as f32);
    let mut after = State::default();
    other.read_state(&mut after);
    for i in 0..before.len() {
        near(before.position[i].distance(after.position[i]), 0.0, 1e-6);
        near(
            angle_between(before.orientation[i], after.orientation[i]),
            0.0,
            1e-6,
        );
        // 60 Hz times the rounding of an attitude, 2⁻²³, and of 60 rad/s itself.
        near(
            before.angular_velocity[i].distance(after.angular_velocity[i]),
            0.0,
            2e-4,
        );
    }
}

#[test]
fn a_spin_too_fast_to_read_is_counted() {
    let mut scene = weightless("fast rod");
    let half_extents = DVec3::new(0.7, 0.07, 0.07);
    let mut body = Body::new(Shape::Box { half_extents }, 1.0, DVec3::ZERO);
    // 178 rad/s: 2.97 rad a step, where π is the end.
    body.angular_velocity = DVec3::new(54.0, 144.0, 90.0);
    scene.bodies.push(body);
    let mut engine = load(&scene, "corrected");
    for _ in 0..60 {
        engine.step(scene.dt as f32);
    }
    assert!(engine.counters().overflow > 0);
    let mut state = State::default();
    engine.read_state(&mut state);
    assert_eq!(state.not_finite(), 0);
}

#[test]
fn the_engine_takes_the_same_turn_as_the_formula() {
    let scene = free_box();
    let state = run(&scene, "corrected", 1);
    let moments = scene.bodies[0].shape.inertia(1.0);
    let momentum = moments * scene.bodies[0].angular_velocity;
    let q = free_rotation::attitude_after(DQuat::IDENTITY, moments, momentum, scene.dt);
    near(angle_between(state.orientation[0], q), 0.0, 1e-6);
}

#[test]
fn an_arm_across_two_axes_is_refused_with_its_index() {
    let mut scene = heavy_top(1.0 / 60.0);
    scene.forces[0] = Force::FixedPoint {
        body: 0,
        arm: DVec3::new(0.1, 0.2, 0.0),
    };
    let error = (ch02_rigid_bodies::ENGINE.load)(&scene, &Settings::defaults());
    let text = error.err().expect("it must be refused").to_string();
    assert!(text.contains("arm") && text.contains("index 0"), "{text}");
}
