//! Solids of every shape at rest, sliding and on slopes, against closed forms: scenarios 13 to 16
//! and 20 of the reference.

use ch00_scenes::measures::Measures;
use ch00_scenes::{Engine, Scene, Settings, State};
use ch03_collision::ENGINE;

fn load(scene: &Scene) -> Box<dyn Engine> {
    (ENGINE.load)(scene, &Settings::defaults()).expect("the scene is supported")
}

/// The state after so many seconds.
fn after(scene: &Scene, seconds: f64) -> State {
    let steps = (seconds / scene.dt).round() as u32;
    ENGINE.run(scene, &Settings::defaults(), steps).unwrap()
}

fn open(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in")
}

fn at_rate(name: &str, rate: f64) -> Scene {
    Scene {
        dt: 1.0 / rate,
        ..open(name, None)
    }
}

#[test]
fn boxes_stop_after_the_same_distance_in_every_direction() {
    // v²/(2 μ g) = 1.630988787 m. A friction pyramid stops at 45° after 71 % of that.
    for rate in [30.0, 60.0, 240.0] {
        let scene = at_rate("slide", rate);
        let end = after(&scene, 1.5);
        for (i, body) in scene.bodies.iter().enumerate().skip(1) {
            let slid = end.position[i] - body.position;
            let off = slid.length() / 1.630_988_787 - 1.0;
            assert!(off.abs() < 0.005, "box {i} at {rate} Hz: {off}");
            let aside = slid.normalize().dot(body.linear_velocity.normalize());
            assert!(aside > 1.0 - 1e-6, "box {i} at {rate} Hz: {aside}");
        }
    }
}

#[test]
fn a_box_slips_exactly_above_its_angle_of_friction() {
    // Two degrees and half a degree below atan μ, then as much above; the distances in 2 s are
    // ½ (g sin θ − μ g cos θ) t².
    let scene = open("incline", None);
    let end = after(&scene, 2.0);
    let slid = |i: usize| (end.position[i] - scene.bodies[i].position).length();
    assert!(
        slid(1) < 0.002 && slid(3) < 0.002,
        "{} {}",
        slid(1),
        slid(3)
    );
    for (i, exact) in [(5, 0.191_424), (7, 0.765_549)] {
        // A box slides on for a part of a step that friction has not yet seen.
        assert!((slid(i) / exact - 1.0).abs() < 0.015, "{}", slid(i));
    }
}

#[test]
fn a_ball_that_slips_comes_as_far_as_the_closed_form_says() {
    let end = after(&open("slip_to_roll", None), 1.0);
    let speed = end.linear_velocity[1].length();
    assert!((speed / (20.0 / 7.0) - 1.0).abs() < 1e-3, "{speed}");
    assert!((end.position[1].x / 3.079_046_093 - 1.0).abs() < 1e-3);
}

#[test]
fn oblique_impacts_stick_and_slip_as_the_closed_form_says() {
    let end = after(&open("oblique", None), 0.5);
    let expected = [
        (0, [-1.8, 0.714_285_714, 0.0]),
        (1, [1.4, 0.142_857_143, 0.0]),
        (2, [-1.8, 3.52, 1.0]),
        (3, [1.4, 0.24, 0.0]),
        (4, [-1.8, 0.0, 0.0]),
        (5, [1.4, 0.0, 0.0]),
    ];
    for (i, velocity) in expected {
        let off = end.linear_velocity[i] - glam::DVec3::from(velocity);
        assert!(off.length() < 1e-4, "ball {i}: {off}");
    }
    assert!((end.angular_velocity[0].z + 2.142_857_143).abs() < 1e-4);
    assert!((end.angular_velocity[2].z + 7.0).abs() < 1e-3);
}

#[test]
fn a_stack_of_five_boxes_stands_for_ten_seconds() {
    let scene = open("stack", Some(5));
    let end = after(&scene, 10.0);
    let top = end.position[5] - scene.bodies[5].position;
    // A millimetre is left alone at each of five contacts.
    assert!(top.y.abs() < 0.006, "{top}");
    assert!(top.x.hypot(top.z) < 0.02, "{top}");
}

#[test]
fn a_pile_of_every_shape_comes_to_rest_without_sinking_in() {
    let scene = open("mixed", Some(100));
    let mut engine = load(&scene);
    let mut state = State::default();
    for _ in 0..600 {
        engine.step(scene.dt as f32);
    }
    engine.read_state(&mut state);
    let measures = Measures::of(&scene, &state);
    assert_eq!((measures.escaped, measures.not_finite), (Some(0), 0));
    assert!(
        measures.penetration.p99 < 0.002,
        "{:?}",
        measures.penetration
    );
    let each = measures.conserved.kinetic_energy / 100.0;
    assert!(each < 1e-2, "{each} J a body");
}

#[test]
fn magnets_that_meet_hold_on_to_each_other_and_lie_still() {
    let scene = open("magnets_on_a_table", None);
    let (then, now) = (after(&scene, 10.0), after(&scene, 15.0));
    for (i, body) in scene.bodies.iter().enumerate().skip(1) {
        let crept = now.position[i].distance(then.position[i]);
        assert!(crept < 0.005, "bar {i} crept {crept} m in five seconds");
        // Poles nearly touch, so that nobody is alone any more.
        let nearest = (1..scene.bodies.len())
            .filter(|&j| j != i)
            .map(|j| now.position[i].distance(now.position[j]))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 0.75, "bar {i} of {:?} is alone", body.shape);
    }
    assert!(Measures::of(&scene, &now).penetration.deepest < 0.002);
}

#[test]
fn a_stack_of_five_boxes_stands_through_a_hitch_every_second() {
    let scene = open("stack", Some(5));
    let mut engine = load(&scene);
    let mut state = State::default();
    // Ten hitches, and half a second to come to rest after the last.
    for step in 1..=630 {
        engine.step(if step % 60 == 0 { 0.1 } else { 1.0 / 60.0 });
    }
    engine.read_state(&mut state);
    for (i, body) in scene.bodies.iter().enumerate().skip(1) {
        let sunk = body.position.y - state.position[i].y;
        assert!(sunk.abs() < 0.01, "box {i} sank {sunk} m");
    }
}
