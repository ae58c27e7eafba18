use super::*;
use crate::random::SplitMix64;
use crate::{Body, Shape};

/// A joint without limits.
fn free() -> Joint {
    Joint::pin(0, 1, DVec3::ZERO, DVec3::ZERO)
}

fn with_cone(angle: f64) -> Joint {
    let mut joint = free();
    if let Joint::Ball { cone, .. } = &mut joint {
        *cone = Some(angle);
    }
    joint
}

fn with_twist(range: [f64; 2]) -> Joint {
    let mut joint = free();
    if let Joint::Ball { twist, .. } = &mut joint {
        *twist = Some(range);
    }
    joint
}

/// Limits that stop nothing but a pitch, a yaw or a roll of more than these.
fn with_euler(pitch: f64, yaw: f64, roll: f64) -> Joint {
    let mut joint = free();
    if let Joint::Ball { limits, .. } = &mut joint {
        *limits = Some(EulerLimits {
            pitch: [-pitch, pitch],
            yaw: [-yaw, yaw],
            roll: [-roll, roll],
        });
    }
    joint
}

fn hinge(axis_a: DVec3, axis_b: DVec3, range: Option<[f64; 2]>) -> Joint {
    Joint::Hinge {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: DVec3::ZERO,
        axis_a,
        axis_b,
        range,
    }
}

/// Two bodies as loaded, and the joint between them.
fn loaded(orientations: [DQuat; 2], joint: Joint) -> Scene {
    let ball = Shape::Sphere { radius: 0.1 };
    let mut scene = Scene::new("joint");
    scene.bodies = orientations
        .map(|orientation| Body {
            orientation,
            ..Body::new(ball, 1.0, DVec3::ZERO)
        })
        .into();
    scene.joints = vec![joint];
    scene
}

/// The excess after b, loaded as a, is turned so.
fn excess(joint: Joint, turn: DQuat) -> f64 {
    let scene = loaded([DQuat::IDENTITY; 2], joint);
    let mut state = State::start_of(&scene);
    state.orientation[1] = turn;
    limit_excess(&scene, &state).unwrap()
}

fn assert_near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-14, "{a} is not {b}");
}

#[test]
fn a_swing_beyond_the_cone_is_beyond_by_the_difference() {
    assert_near(excess(with_cone(0.3), DQuat::from_rotation_x(0.5)), 0.2);
    assert_eq!(excess(with_cone(0.6), DQuat::from_rotation_z(-0.5)), 0.0);
}

#[test]
fn a_twist_is_no_swing_and_a_swing_no_twist() {
    assert_eq!(excess(with_cone(0.1), DQuat::from_rotation_y(2.0)), 0.0);
    let range = [-0.1, 0.1];
    assert_eq!(excess(with_twist(range), DQuat::from_rotation_z(2.0)), 0.0);
}

#[test]
fn a_twist_is_measured_to_the_nearer_end_of_its_range() {
    let joint = || with_twist([-0.2, 0.5]);
    assert_near(excess(joint(), DQuat::from_rotation_y(0.8)), 0.3);
    assert_near(excess(joint(), DQuat::from_rotation_y(-0.3)), 0.1);
    // −3 is 2.8 from −0.2, and by way of π 2.78 from 0.5.
    assert_near(
        excess(joint(), DQuat::from_rotation_y(-3.0)),
        2.0 * PI - 3.5,
    );
}

#[test]
fn the_other_quaternion_of_the_same_rotation_is_measured_alike() {
    for turn in [0.8, -3.0, 3.1].map(DQuat::from_rotation_y) {
        let joint = || with_twist([-0.2, 0.5]);
        assert_near(excess(joint(), turn), excess(joint(), -turn));
        let joint = || with_euler(0.2, 0.2, 0.2);
        assert_near(excess(joint(), turn), excess(joint(), -turn));
    }
}

#[test]
fn the_swing_comes_after_the_twist() {
    let turn = DQuat::from_rotation_x(0.7) * DQuat::from_rotation_y(0.4);
    assert_near(excess(with_cone(0.5), turn), 0.2);
    assert_near(excess(with_twist([-0.3, 0.3]), turn), 0.1);
}

#[test]
fn pitch_yaw_and_roll_are_the_turns_about_x_y_and_z() {
    let open = 3.0;
    for (joint, turn) in [
        (with_euler(0.5, open, open), DQuat::from_rotation_x(0.7)),
        (with_euler(open, 0.5, open), DQuat::from_rotation_y(-0.7)),
        (with_euler(open, open, 0.5), DQuat::from_rotation_z(0.7)),
    ] {
        assert_near(excess(joint, turn), 0.2);
    }
    let turn = DQuat::from_rotation_x(2.9);
    assert_eq!(excess(with_euler(open, 0.0, 0.0), turn), 0.0);
}

#[test]
fn pitch_and_roll_share_the_swing_as_the_parts_of_its_rotation_vector() {
    let vector = DVec3::new(0.6, 0.0, -0.8);
    let swing = DQuat::from_axis_angle(vector, 1.5);
    let turn = swing * DQuat::from_rotation_y(1.2);
    assert_near(excess(with_euler(0.8, 3.0, 3.0), turn), 0.1);
    assert_near(excess(with_euler(3.0, 3.0, 1.0), turn), 0.2);
    assert_near(excess(with_euler(3.0, 1.0, 3.0), turn), 0.2);
}

#[test]
fn limits_move_with_a_and_count_from_how_b_was_loaded() {
    let mut random = SplitMix64::new(8);
    for _ in 0..100 {
        let [a, b, later] = [(); 3].map(|()| random.rotation());
        let scene = loaded([a, b], with_cone(0.3));
        let mut state = State::start_of(&scene);
        // All turned together: no excess.
        state.orientation = vec![later * a, later * b];
        assert_near(limit_excess(&scene, &state).unwrap(), 0.0);
        // And b tilted by half a radian about an axis across its bone.
        state.orientation[1] *= DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 0.5);
        assert_near(limit_excess(&scene, &state).unwrap(), 0.2);
    }
}

#[test]
fn a_rest_that_is_given_replaces_how_b_was_loaded() {
    let mut joint = with_cone(0.3);
    if let Joint::Ball { rest, .. } = &mut joint {
        *rest = Some(DQuat::from_rotation_x(1.0));
    }
    assert_near(excess(joint.clone(), DQuat::IDENTITY), 0.7);
    assert_near(excess(joint, DQuat::from_rotation_x(1.2)), 0.0);
}

#[test]
fn a_cone_is_about_where_the_bone_rests_in_a() {
    let mut joint = with_cone(0.3);
    if let Joint::Ball { rest, .. } = &mut joint {
        // The bone rests along a's x.
        *rest = Some(DQuat::from_rotation_z(-PI / 2.0));
    }
    let tilted = DQuat::from_rotation_y(0.5) * DQuat::from_rotation_z(-PI / 2.0);
    assert_near(excess(joint, tilted), 0.2);
}

#[test]
fn half_a_turn_of_swing_has_no_twist_and_is_measured() {
    let turn = DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0);
    assert_eq!(excess(with_twist([-0.1, 0.1]), turn), 0.0);
    assert_near(excess(with_cone(3.0), turn), PI - 3.0);
    assert_near(excess(with_euler(3.0, 0.1, 0.1), turn), PI - 3.0);
}

#[test]
fn a_hinge_counts_right_handed_from_how_it_was_loaded() {
    let axis = DVec3::new(0.0, 0.6, 0.8);
    let mut random = SplitMix64::new(9);
    for _ in 0..100 {
        let [a, b, later] = [(); 3].map(|()| random.rotation());
        let in_b = b.conjugate() * (a * axis);
        let scene = loaded([a, b], hinge(axis, in_b, Some([-0.5, 1.0])));
        let mut state = State::start_of(&scene);
        for (angle, expected) in [(0.9, 0.0), (1.3, 0.3), (-0.7, 0.2), (3.5, 2.0 * PI - 4.0)] {
            let turn = DQuat::from_axis_angle(a * axis, angle);
            state.orientation = vec![later * a, later * turn * b];
            assert_near(limit_excess(&scene, &state).unwrap(), expected);
            assert_near(hinge_misalignment(&scene, &state).unwrap(), 0.0);
        }
    }
}

#[test]
fn the_angle_between_a_hinges_axes_is_measured_however_small() {
    for angle in [1e-9, 0.1, 3.0] {
        let scene = loaded([DQuat::IDENTITY; 2], hinge(DVec3::Y, DVec3::Y, None));
        let mut state = State::start_of(&scene);
        state.orientation[1] = DQuat::from_rotation_z(angle);
        let found = hinge_misalignment(&scene, &state).unwrap();
        assert!((found / angle - 1.0).abs() < 1e-7, "{found}");
        assert_eq!(limit_excess(&scene, &state), None);
    }
}

#[test]
fn the_worst_of_several_joints_counts_and_bodies_that_are_no_numbers_don_t() {
    let mut scene = loaded([DQuat::IDENTITY; 2], with_cone(0.3));
    scene.bodies.push(scene.bodies[0].clone());
    let mut other = with_cone(0.1);
    if let Joint::Ball { b, .. } = &mut other {
        *b = 2;
    }
    scene.joints.push(other);
    let mut state = State::start_of(&scene);
    state.orientation[1] = DQuat::from_rotation_x(0.5);
    state.orientation[2] = DQuat::from_rotation_x(0.5);
    assert_near(limit_excess(&scene, &state).unwrap(), 0.4);
    state.orientation[2] = DQuat::NAN;
    assert_near(limit_excess(&scene, &state).unwrap(), 0.2);
}

#[test]
fn a_scene_without_limits_or_hinges_has_nothing_to_measure() {
    let scene = loaded([DQuat::IDENTITY; 2], free());
    let state = State::start_of(&scene);
    assert_eq!(limit_excess(&scene, &state), None);
    assert_eq!(hinge_misalignment(&scene, &state), None);
}

#[test]
fn locked_limits_are_exceeded_by_any_turn() {
    let turn = DQuat::from_rotation_y(0.01);
    assert_near(excess(with_twist([0.0, 0.0]), turn), 0.01);
    assert_near(excess(with_euler(0.0, 0.0, 0.0), turn), 0.01);
}
