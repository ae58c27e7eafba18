//! What happens when things go wrong, or nearly.

use ch00_scenes::measures::Penetration;
use ch00_scenes::{Body, Force, Joint, Scene, Settings, Shape, State};
use ch06_compute::compute::pairs::Room;
use ch06_compute::compute::{ComputeError, Pairs};
use ch06_compute::stream::StreamError;
use glam::DVec3;

use super::{after, ball, built_in, cube, floor, gpu, pairs, read, rules, tight};

#[test]
fn too_little_room_grows_and_loses_nothing() {
    let gpu = gpu();
    for (name, count) in [
        ("ragdoll_field", Some(3)),
        ("stack", Some(6)),
        ("door", None),
    ] {
        let scene = built_in(name, count);
        let mut tight = tight(&gpu, &scene);
        let ample = after(&mut pairs(&gpu, &scene), 60).hash();
        assert_eq!(after(&mut tight, 60).hash(), ample, "{name}");
        assert!(tight.room().pairs > 1, "{name}: it grew");
    }
}

#[test]
fn steps_of_different_lengths_that_had_no_room_are_made_again_as_they_were() {
    let gpu = gpu();
    let scene = built_in("stack", Some(4));
    let run = |mut pairs: Pairs| {
        for dt in [0.01, 0.01, 0.02, 0.015, 0.015, 0.01] {
            pairs.step(dt, 2).expect("it runs");
        }
        read(&mut pairs).hash()
    };
    assert_eq!(run(tight(&gpu, &scene)), run(pairs(&gpu, &scene)));
}

#[test]
fn more_bodies_than_the_device_has_room_for_is_an_error_before_anything_is_allocated() {
    let (gpu, scene) = (gpu(), built_in("stack", Some(50)));
    let room = Room {
        partners: gpu.most_rows(8) as usize / 50 + 1,
        ..Room::for_bodies(50)
    };
    let error = Pairs::with_room(&gpu, &scene, rules(&scene), room).expect_err("too large");
    let ComputeError::Stream(StreamError::TooLarge { asked, most, .. }) = &error else {
        panic!("{error}");
    };
    assert!(*asked == 51 && *most < 51, "{error}");
    assert!(error.to_string().contains("at most"), "{error}");
}

#[test]
fn a_tree_that_no_workgroup_holds_is_named() {
    let (gpu, scene) = (gpu(), built_in("chain", Some(100)));
    let error = Pairs::of(&gpu, &scene, rules(&scene)).expect_err("too long");
    assert!(matches!(error, ComputeError::Tree(_)), "{error}");
    assert!(error.to_string().contains("joints[64]"), "{error}");
}

#[test]
fn one_body_that_is_not_finite_is_named_and_the_rest_goes_on() {
    let (gpu, scene) = (gpu(), built_in("slide", None));
    let mut pairs = pairs(&gpu, &scene);
    let mut state = State::start_of(&scene);
    state.position[5] = DVec3::splat(f64::NAN);
    pairs.write(&state).expect("the device is there");
    let state = after(&mut pairs, 60);
    assert_eq!(state.not_finite(), 1);
    assert_eq!(pairs.not_finite().map(|(first, _)| first), Some(5));
    assert!(pairs.explain().contains("body 5 is not finite"));
    let moved = state.position[6].distance(scene.bodies[6].position);
    assert!(moved > 0.1, "the others slide: {moved} m");
}

#[test]
fn all_bodies_in_one_cell_of_the_grid_are_pushed_apart() {
    let mut scene = Scene::new("crowd");
    scene.bodies.push(floor());
    for i in 0..60 {
        let place = DVec3::new(f64::from(i % 4), f64::from(i / 16), f64::from(i / 4 % 4));
        scene
            .bodies
            .push(ball(0.1, 1.0, 0.02 * place + DVec3::Y * 0.3));
    }
    let mut pairs = pairs(&gpu(), &scene);
    let state = after(&mut pairs, 300);
    let depth = Penetration::of(&scene, &state).relative;
    assert_eq!(state.not_finite(), 0);
    assert!(
        pairs.room().partners >= 60,
        "all touched all: {:?}",
        pairs.room()
    );
    assert!(depth.p99 < 0.05, "{depth:?}");
}

/// Cubes on the floor, and a slab of 3 m that falls on them.
fn huge_over_small() -> Scene {
    let mut scene = Scene::new("one huge body over small ones");
    scene.bodies.push(floor());
    for i in 0..49 {
        let place = DVec3::new(f64::from(i % 7) - 3.0, 0.0, f64::from(i / 7) - 3.0);
        scene.bodies.push(cube(0.4 * place + DVec3::Y * 0.1));
    }
    let half_extents = DVec3::new(1.5, 0.2, 1.5);
    let slab = Body::new(Shape::Box { half_extents }, 100.0, DVec3::Y * 0.5);
    scene.bodies.push(slab);
    scene
}

#[test]
fn one_huge_body_comes_to_rest_on_small_ones() {
    let (gpu, scene) = (gpu(), huge_over_small());
    let mut huge = tight(&gpu, &scene);
    assert_eq!(huge.plan().larges, [50]);
    let state = after(&mut huge, 120);
    let depth = Penetration::of(&scene, &state);
    assert_eq!(state.not_finite(), 0);
    assert!(
        huge.room().large_pairs >= 49,
        "it lies on all: {:?}",
        huge.room()
    );
    let height = state.position[50].y;
    assert!((height - 0.4).abs() < 0.01, "it lies on them: {height}");
    assert!(depth.p99 < 0.01, "{depth:?}");
    assert_eq!(after(&mut pairs(&gpu, &scene), 120).hash(), state.hash());
}

#[test]
fn a_joint_between_static_bodies_holds_nothing_and_breaks_nothing() {
    let mut scene = built_in("stack", Some(2));
    let joint = built_in("chain", Some(2)).joints.remove(0);
    scene.bodies.push(floor());
    scene.joints.push(between(joint, 0, scene.bodies.len() - 1));
    let state = after(&mut pairs(&gpu(), &scene), 10);
    assert_eq!(state.not_finite(), 0);
}

#[test]
fn a_force_that_stays_is_refused_by_the_kernels_with_its_index() {
    let mut scene = Scene::new("a ball that is pushed");
    scene.bodies.push(ball(0.1, 1.0, DVec3::Y));
    let force = DVec3::X;
    scene.forces.push(Force::Constant { body: 0, force });
    let Err(error) = (ch06_compute::COMPUTE.load)(&scene, &Settings::defaults()) else {
        panic!("the kernels take it");
    };
    let text = error.to_string();
    assert!(
        text.contains("forces[0]") && text.contains("(index 0)"),
        "{text}"
    );
}

#[test]
fn a_joint_of_a_body_on_a_fixed_point_is_refused_by_both_engines_with_its_index() {
    let mut scene = Scene::new("a ball that hangs on a top");
    scene.bodies.push(ball(0.1, 1.0, DVec3::Y));
    scene.bodies.push(ball(0.1, 1.0, DVec3::ZERO));
    let half = DVec3::Y * 0.5;
    scene.joints.push(Joint::pin(0, 1, -half, half));
    let arm = DVec3::Y * 0.1;
    scene.forces.push(Force::FixedPoint { body: 0, arm });
    for engine in [ch06_compute::LANES, ch06_compute::COMPUTE] {
        let Err(error) = (engine.load)(&scene, &Settings::defaults()) else {
            panic!("{} takes it", engine.name);
        };
        let text = error.to_string();
        assert!(
            text.contains("joints[0]") && text.contains("(index 0)"),
            "{text}"
        );
    }
    let error = Pairs::of(&gpu(), &scene, rules(&scene)).expect_err("no kernel does");
    let is_known = matches!(error, ComputeError::Unsupported { body: 0, .. });
    assert!(is_known, "{error}");
}

/// The same joint between other bodies.
fn between(mut joint: Joint, one: usize, other: usize) -> Joint {
    if let Joint::Ball { a, b, .. } = &mut joint {
        (*a, *b) = (one, other);
    }
    joint
}
