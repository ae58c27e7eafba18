//! Engine `lanes` with bodies that may sleep: who falls asleep, what wakes him, and that nothing else changes.

use ch00_scenes::{Body, Engine, LoadError, Scene, Settings, Shape, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::threads::Threads;
use ch06_compute::rules::Rules;
use ch06_compute::simd::{Eight, Four, Real};
use glam::{DQuat, DVec3};

const METHODS: [&str; 2] = ["own-row", "coloured"];

fn sleepy(method: &str) -> Settings {
    Settings {
        sleeping: true,
        ..Settings::defaults().with_method(method)
    }
}

fn lanes_of<R: Real>(scene: &Scene, settings: &Settings) -> Lanes<R> {
    let rules = Rules::of(scene, settings).expect("the settings are right");
    Lanes::<R>::of(scene, rules).expect("it is supported")
}

fn engine_of(scene: &Scene, method: &str) -> Box<dyn Engine> {
    (ch06_compute::LANES.load)(scene, &sleepy(method)).expect("the scene is supported")
}

fn open(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in scene")
}

fn step(engine: &mut dyn Engine, steps: u32) {
    for _ in 0..steps {
        engine.step(1.0 / 60.0);
    }
}

fn state_of(engine: &dyn Engine) -> State {
    let mut state = State::default();
    engine.read_state(&mut state);
    state
}

fn asleep(engine: &dyn Engine) -> usize {
    engine.counters().asleep
}

/// Steps until so many sleep.
#[track_caller]
fn until_asleep(engine: &mut dyn Engine, wanted: usize, most: u32) {
    for _ in 0..most {
        engine.step(1.0 / 60.0);
        if asleep(engine) == wanted {
            return;
        }
    }
    panic!("{} sleep after {most} steps, not {wanted}", asleep(engine));
}

/// A floor, and boxes on it: at each x so many, one on the other.
fn stacks(places: &[f64], high: usize) -> Scene {
    let mut scene = Scene::new("stacks");
    scene.bodies.push(floor());
    for &x in places {
        for level in 0..high {
            let half_extents = DVec3::splat(0.2);
            let at = DVec3::new(x, 0.2 + 0.4 * level as f64, 0.0);
            scene
                .bodies
                .push(Body::new(Shape::Box { half_extents }, 64.0, at));
        }
    }
    scene
}

fn floor() -> Body {
    let half_extents = DVec3::new(20.0, 0.5, 20.0);
    Body::new(Shape::Box { half_extents }, 0.0, DVec3::Y * -0.5)
}

fn ball(radius: f64, at: DVec3) -> Body {
    Body::new(Shape::Sphere { radius }, 1000.0 * radius.powi(3), at)
}

#[test]
fn a_pile_a_mixture_and_ragdolls_fall_asleep() {
    for (name, count, most) in [
        ("pile", 60, 1800),
        ("mixed", 30, 1800),
        ("ragdolls", 2, 2400),
    ] {
        for method in METHODS {
            let scene = open(name, Some(count));
            let mut engine = engine_of(&scene, method);
            until_asleep(engine.as_mut(), scene.dynamic_count(), most);
        }
    }
}

#[test]
fn who_sleeps_keeps_all_bits() {
    let scene = open("mixed", Some(30));
    let mut engine = engine_of(&scene, "own-row");
    until_asleep(engine.as_mut(), scene.dynamic_count(), 1800);
    let (before, contacts) = (state_of(engine.as_ref()), engine.contacts());
    assert!(!contacts.is_empty(), "contacts are kept");
    step(engine.as_mut(), 300);
    assert_eq!(before, state_of(engine.as_ref()));
    assert_eq!(contacts, engine.contacts());
    assert_eq!(engine.counters().pairs, 0);
}

#[test]
fn who_is_awake_moves_with_the_same_bits_where_nobody_sleeps_yet() {
    for method in METHODS {
        let scene = open("balls", Some(200));
        let mut may = lanes_of::<Eight>(&scene, &sleepy(method));
        let mut may_not = lanes_of::<Eight>(&scene, &Settings::defaults().with_method(method));
        let (mut one, mut other) = (State::default(), State::default());
        let mut steps = 0;
        while may.sleep.asleep() == 0 {
            may.bodies.read(&mut one);
            may_not.bodies.read(&mut other);
            assert_eq!(one, other, "{method}, after {steps} steps");
            may.step(1.0 / 60.0, |_| {});
            may_not.step(1.0 / 60.0, |_| {});
            steps += 1;
        }
        assert!(steps > 30, "somebody sleeps after {steps} steps");
    }
}

/// A run of so many steps in which islands sleep and are woken: at its half a ball falls on what has come to
/// rest. How many slept after each step, and the end.
fn disturbed<R: Real>(
    scene: &Scene,
    method: &str,
    steps: u32,
    threads: usize,
) -> (Vec<usize>, State) {
    let mut lanes = lanes_of::<R>(scene, &sleepy(method));
    lanes.threads = Threads::of(threads).expect("the system has so many");
    let mut slept = Vec::new();
    for step in 0..steps {
        if 2 * step == steps {
            lanes.add_body(&ball(0.2, DVec3::new(0.1, 8.0, 0.05)));
        }
        lanes.step(1.0 / 60.0, |_| {});
        slept.push(lanes.sleep.asleep());
    }
    let mut state = State::default();
    lanes.bodies.read(&mut state);
    (slept, state)
}

#[test]
fn sleepers_have_the_same_bits_in_any_number_of_lanes_and_threads() {
    for (name, count, steps) in [
        ("mixed", 40, 2000),
        ("ragdolls", 2, 4000),
        ("pile", 300, 2000),
    ] {
        let scene = open(name, Some(count));
        for method in METHODS {
            let one = disturbed::<f32>(&scene, method, steps, 1);
            assert_eq!(one.1.not_finite(), 0);
            let wakes = |two: &[usize]| two[1] < two[0];
            assert!(
                one.0.windows(2).any(wakes),
                "{name}, {method}: nobody ever wakes"
            );
            let four = disturbed::<Four>(&scene, method, steps, 2);
            assert!(one == four, "{name}, {method} in lanes of four");
            let eight = disturbed::<Eight>(&scene, method, steps, 3);
            assert!(one == eight, "{name}, {method} in lanes of eight");
        }
    }
}

#[test]
fn a_ball_that_falls_on_a_stack_wakes_it_and_no_other() {
    for method in METHODS {
        let scene = stacks(&[-2.0, 2.0], 3);
        let mut engine = engine_of(&scene, method);
        until_asleep(engine.as_mut(), 6, 120);
        engine
            .add_body(&ball(0.2, DVec3::new(2.0, 2.5, 0.0)), 1.0 / 60.0)
            .expect("bodies can be added");
        step(engine.as_mut(), 12);
        assert_eq!(asleep(engine.as_ref()), 6, "it has not come down");
        let before = state_of(engine.as_ref());
        while asleep(engine.as_ref()) == 6 {
            step(engine.as_mut(), 1);
        }
        assert_eq!(asleep(engine.as_ref()), 3);
        step(engine.as_mut(), 5);
        let after = state_of(engine.as_ref());
        assert_eq!(before.position[1..4], after.position[1..4]);
        let ball = after.position.len() - 1;
        assert!(after.linear_velocity[ball].y > -6.0, "it was stopped");
        until_asleep(engine.as_mut(), 7, 1800);
    }
}

#[test]
fn an_elastic_ball_hands_a_sleeping_one_all_that_it_has() {
    let mut scene = Scene::new("billiards");
    scene.bodies.push(floor());
    scene.bodies.push(ball(0.2, DVec3::new(0.0, 0.2, 0.0)));
    for body in &mut scene.bodies {
        (body.restitution, body.friction) = (1.0, 0.0);
    }
    let mut engine = engine_of(&scene, "own-row");
    until_asleep(engine.as_mut(), 1, 120);
    let mut other = scene.bodies[1].clone();
    other.position.x = -2.0;
    other.linear_velocity.x = 3.0;
    engine
        .add_body(&other, 1.0 / 60.0)
        .expect("it can be added");
    step(engine.as_mut(), 60);
    let state = state_of(engine.as_ref());
    assert!((state.linear_velocity[1].x - 3.0).abs() < 1e-3);
    assert!(state.linear_velocity[2].x.abs() < 1e-3);
}

#[test]
fn who_loses_his_support_wakes_and_falls_and_no_other() {
    for method in METHODS {
        let mut scene = stacks(&[-2.0, 2.0], 3);
        // A shelf under a stack of its own, fixed; and the lowest box of a stack, which isn't.
        let half_extents = DVec3::new(0.5, 0.1, 0.5);
        let shelf = Body::new(Shape::Box { half_extents }, 0.0, DVec3::new(8.0, 2.0, 0.0));
        scene.bodies.push(shelf);
        scene.bodies.push(ball(0.2, DVec3::new(8.0, 2.3, 0.0)));
        let mut engine = engine_of(&scene, method);
        until_asleep(engine.as_mut(), 7, 120);
        engine.remove_body(7).expect("nothing holds the shelf");
        assert_eq!(asleep(engine.as_ref()), 6);
        step(engine.as_mut(), 20);
        let height = state_of(engine.as_ref()).position[7].y;
        assert!((2.3 - height - 0.5 * 9.81 / 9.0).abs() < 0.02, "{height}");
        engine.remove_body(1).expect("nothing holds the box");
        assert_eq!(asleep(engine.as_ref()), 3);
        step(engine.as_mut(), 120);
        let state = state_of(engine.as_ref());
        assert!((state.position[1].y - 0.2).abs() < 0.01, "it lies lower");
    }
}

#[test]
fn who_is_moved_by_hand_is_awake_and_so_are_all() {
    let scene = stacks(&[-2.0, 2.0], 2);
    let mut engine = engine_of(&scene, "own-row");
    until_asleep(engine.as_mut(), 4, 120);
    let mut state = state_of(engine.as_ref());
    state.position[2].y += 1.0;
    engine.write_state(&state, 1.0 / 60.0);
    assert_eq!(asleep(engine.as_ref()), 0);
    step(engine.as_mut(), 10);
    let fallen = state_of(engine.as_ref()).position[2].y;
    assert!(fallen < state.position[2].y - 0.1, "{fallen}");
}

#[test]
fn whom_the_mouse_pulls_wakes_and_takes_the_others_along() {
    let scene = stacks(&[-2.0, 2.0], 2);
    let mut engine = engine_of(&scene, "own-row");
    until_asleep(engine.as_mut(), 4, 120);
    engine.pull(Some(ch00_scenes::Pull {
        body: 1,
        anchor: DVec3::ZERO,
        target: DVec3::new(-2.0, 1.5, 0.0),
    }));
    assert_eq!(asleep(engine.as_ref()), 2);
    step(engine.as_mut(), 300);
    assert_eq!(asleep(engine.as_ref()), 2, "who is pulled doesn't sleep");
    assert!(state_of(engine.as_ref()).position[1].y > 0.5);
    engine.pull(None);
    until_asleep(engine.as_mut(), 4, 600);
}

#[test]
fn a_wall_that_comes_wakes_those_into_whom_it_comes() {
    let scene = stacks(&[-2.0, 2.0], 2);
    let mut engine = engine_of(&scene, "own-row");
    until_asleep(engine.as_mut(), 4, 120);
    let half_extents = DVec3::new(0.1, 1.0, 1.0);
    let wall = Body::new(Shape::Box { half_extents }, 0.0, DVec3::new(2.25, 1.0, 0.0));
    engine.add_body(&wall, 1.0 / 60.0).expect("it can be added");
    assert_eq!(asleep(engine.as_ref()), 2);
    step(engine.as_mut(), 60);
    let pushed = state_of(engine.as_ref()).position[3].x;
    assert!(pushed < 1.96, "{pushed}");
}

#[test]
fn a_sleeper_that_is_nowhere_is_counted_and_the_others_go_on() {
    for method in METHODS {
        let scene = stacks(&[-2.0, 2.0], 3);
        let mut engine = engine_of(&scene, method);
        until_asleep(engine.as_mut(), 6, 120);
        let mut state = state_of(engine.as_ref());
        state.position[1].x = f64::NAN;
        engine.write_state(&state, 1.0 / 60.0);
        step(engine.as_mut(), 120);
        let after = state_of(engine.as_ref());
        assert_eq!(after.not_finite(), 1);
        assert!(!after.position[1].is_finite(), "it is the one");
        assert!((after.position[2].y - 0.2).abs() < 0.01, "it fell");
        assert!((after.position[4].y - 0.2).abs() < 0.01);
        until_asleep(engine.as_mut(), 5, 600);
    }
}

#[test]
fn nobody_sleeps_in_the_air_or_where_nothing_holds_him() {
    // At the top of its way a ball is slow.
    let mut scene = Scene::new("throw");
    let mut thrown = ball(0.2, DVec3::Y);
    thrown.linear_velocity.y = 5.0;
    scene.bodies.push(thrown);
    let mut engine = engine_of(&scene, "own-row");
    for _ in 0..120 {
        step(engine.as_mut(), 1);
        assert_eq!(asleep(engine.as_ref()), 0);
    }
    // And without weight two that touch may float.
    let mut scene = Scene::new("floating");
    scene.gravity = DVec3::ZERO;
    scene.bodies.push(ball(0.2, DVec3::ZERO));
    scene.bodies.push(ball(0.2, DVec3::X * 0.4));
    for body in &mut scene.bodies {
        body.linear_velocity.z = 0.01;
    }
    let mut engine = engine_of(&scene, "own-row");
    step(engine.as_mut(), 600);
    let state = state_of(engine.as_ref());
    assert!((state.position[1].z - 0.1).abs() < 1e-4);
    assert_eq!(asleep(engine.as_ref()), 0);
}

#[test]
fn magnets_and_tops_never_sleep() {
    for name in ["magnets", "tops"] {
        let scene = open(name, None);
        let mut engine = engine_of(&scene, "own-row");
        step(engine.as_mut(), 300);
        assert_eq!(asleep(engine.as_ref()), 0, "{name}");
    }
}

#[test]
fn a_ball_that_spins_in_place_does_not_keep_its_heap_awake() {
    let mut scene = Scene::new("spin");
    scene.bodies.push(floor());
    let mut spinning = ball(0.2, DVec3::Y * 0.2);
    spinning.angular_velocity.y = 3.0;
    scene.bodies.push(spinning.clone());
    let mut engine = engine_of(&scene, "own-row");
    until_asleep(engine.as_mut(), 1, 120);
    // But a fast one is none that rests.
    scene.bodies[1].angular_velocity.y = 30.0;
    let mut engine = engine_of(&scene, "own-row");
    step(engine.as_mut(), 120);
    assert_eq!(asleep(engine.as_ref()), 0);
}

#[test]
fn a_joint_wakes_the_other_end() {
    let scene = open("ragdolls", Some(1));
    let mut engine = engine_of(&scene, "own-row");
    let moving = scene.dynamic_count();
    until_asleep(engine.as_mut(), moving, 2400);
    let body = scene.bodies.iter().position(|body| !body.is_static());
    let body = body.expect("it has limbs");
    let at = state_of(engine.as_ref()).position[body];
    engine.pull(Some(ch00_scenes::Pull {
        body,
        anchor: DVec3::ZERO,
        target: at + DVec3::Y,
    }));
    assert_eq!(asleep(engine.as_ref()), 0);
    step(engine.as_mut(), 120);
    let state = state_of(engine.as_ref());
    assert_eq!(state.not_finite(), 0);
    let gap = ch00_scenes::measures::joint_separation(&scene, &state).expect("joints");
    assert!(gap < 1e-3, "{gap}");
}

#[test]
fn the_other_engines_say_that_nobody_sleeps_there() {
    let scene = open("pair", None);
    for engine in [
        ch06_compute::COMPUTE,
        ch05_properties::ENGINE,
        ch04_ragdolls::ENGINE,
    ] {
        let settings = Settings {
            sleeping: true,
            ..Settings::defaults()
        };
        let Err(error) = (engine.load)(&scene, &settings) else {
            panic!("{} lets bodies sleep", engine.name);
        };
        let is_it = matches!(
            error,
            LoadError::Setting {
                setting: "sleeping",
                ..
            }
        );
        assert!(is_it, "{error}");
        assert!(error.to_string().contains("`--sleeping`: "), "{error}");
    }
}

#[test]
fn a_turned_box_that_is_removed_wakes_those_that_leaned_on_it() {
    let mut scene = stacks(&[], 0);
    scene.bodies[0].orientation = DQuat::from_rotation_z(-0.2);
    let half_extents = DVec3::splat(0.2);
    let down = DQuat::from_rotation_z(-0.2);
    let stop = Body::new(
        Shape::Box { half_extents },
        0.0,
        down * DVec3::new(0.42, 0.2, 0.0),
    );
    let mut leaning = ball(0.2, down * DVec3::new(0.0, 0.2, 0.0));
    leaning.friction = 0.0;
    for body in [stop, leaning] {
        scene.bodies.push(Body {
            orientation: down,
            ..body
        });
    }
    scene.bodies[0].position = down * DVec3::Y * -0.5;
    let mut engine = engine_of(&scene, "own-row");
    until_asleep(engine.as_mut(), 1, 600);
    engine.remove_body(1).expect("nothing holds the stop");
    assert_eq!(asleep(engine.as_ref()), 0);
    step(engine.as_mut(), 60);
    assert!(state_of(engine.as_ref()).position[1].x > 0.5);
}
