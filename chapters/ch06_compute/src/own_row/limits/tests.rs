//! Single limits, whose answers are known.

use ch00_scenes::{Body, Joint, Scene, Shape};
use glam::{DQuat, DVec3, Quat, Vec3};

use super::{Bounds, FASTEST_TURN, Limit, Side, Symmetric, Turning, limit_of, turns};
use crate::rows::{CONE_TWIST, EULER, FREE_ANGLE, Turned};

/// A body of 1 kg and 1 kg m², or a static one, that turns.
fn side(attitude: Quat, spin: Vec3, is_static: bool) -> Side<f32> {
    let answer = if is_static { 0.0 } else { 1.0 };
    Side {
        attitude: attitude.into(),
        angular_velocity: spin.into(),
        inverse_mass: answer,
        shared_mass: answer,
        shared_inertia: Symmetric::splat(answer),
        ..Side::default()
    }
}

/// A substep of a limit in a lane by itself.
fn solve_limit(limit: &mut Limit, before: &Turned, sides: [Side<f32>; 2], h: f32) -> Turned {
    let mut bounds = Bounds::of(|_| &*limit);
    let before = Turning {
        turning: before.turning.into(),
        push: before.push.into(),
        counts: before.counts,
    };
    let turned = super::solve_limit(&mut bounds, &before, sides, h);
    limit.impulses = bounds.impulses.lane(0);
    Turned {
        turning: turned.turning.lane(0),
        push: turned.push.lane(0),
        counts: turned.counts,
        ..Turned::default()
    }
}

fn with_bounds(low: Vec3, high: Vec3, kind: u32) -> Limit {
    Limit {
        kind,
        low,
        high,
        ..Limit::default()
    }
}

/// A cone of 0.5 rad and a twist of ±0.25 rad.
fn cone_twist() -> Limit {
    let low = Vec3::new(-FREE_ANGLE, -0.25, -FREE_ANGLE);
    with_bounds(low, Vec3::new(0.5, 0.25, FREE_ANGLE), CONE_TWIST)
}

/// A limit that counts solves b, turned so and turning, against a static a.
fn solved(limit: &mut Limit, attitude: Quat, spin: Vec3) -> Turned {
    let before = Turned {
        counts: 1.0,
        ..Turned::default()
    };
    let sides = [
        side(Quat::IDENTITY, Vec3::ZERO, true),
        side(attitude, spin, false),
    ];
    solve_limit(limit, &before, sides, 1e-3)
}

#[track_caller]
fn assert_near(a: Vec3, b: Vec3) {
    // An angle of 1e-7 rad too little may be gone in a substep of 1 ms: 1e-4 rad/s.
    assert!((a - b).length() < 1e-4, "{a} is not {b}");
}

#[test]
fn a_tilt_within_its_cone_turns_freely() {
    let turned = solved(&mut cone_twist(), Quat::from_rotation_x(0.3), Vec3::X);
    assert_eq!(turned, Turned::default());
}

#[test]
fn a_tilt_at_its_bound_is_stopped_and_one_that_turns_back_is_not() {
    let attitude = Quat::from_rotation_x(0.5);
    let turned = solved(&mut cone_twist(), attitude, Vec3::X * 2.0);
    assert_near(turned.turning, Vec3::X * -2.0);
    assert_eq!(turned.counts, 1.0);
    let turned = solved(&mut cone_twist(), attitude, Vec3::X * -2.0);
    assert_near(turned.turning, Vec3::ZERO);
}

#[test]
fn a_tilt_that_would_pass_its_bound_is_slowed_to_arrive_there() {
    let turned = solved(
        &mut cone_twist(),
        Quat::from_rotation_x(0.499),
        Vec3::X * 5.0,
    );
    // 1 mrad in 1 ms is 1 rad/s.
    assert!(
        (turned.turning + Vec3::X * 4.0).length() < 1e-3,
        "{}",
        turned.turning
    );
}

#[test]
fn what_is_beyond_is_pushed_back_by_a_fifth_and_no_faster_than_a_push_is() {
    let turned = solved(&mut cone_twist(), Quat::from_rotation_z(0.502), Vec3::ZERO);
    assert!(
        (turned.push + Vec3::Z * 0.4).length() < 1e-3,
        "{}",
        turned.push
    );
    let turned = solved(&mut cone_twist(), Quat::from_rotation_z(0.6), Vec3::ZERO);
    assert_near(turned.push, Vec3::Z * -FASTEST_TURN);
}

#[test]
fn a_twist_is_held_at_the_nearer_of_its_bounds() {
    for sign in [-1.0, 1.0] {
        let attitude = Quat::from_rotation_y(0.25 * sign);
        let turned = solved(&mut cone_twist(), attitude, Vec3::new(1.0, 3.0 * sign, 1.0));
        assert_near(turned.turning, Vec3::Y * -3.0 * sign);
    }
}

#[test]
fn a_turn_that_is_locked_is_held_both_ways() {
    let low = Vec3::new(-FREE_ANGLE, 0.1, -FREE_ANGLE);
    let high = Vec3::new(FREE_ANGLE, 0.1, FREE_ANGLE);
    for spin in [-2.0, 2.0] {
        let mut limit = with_bounds(low, high, CONE_TWIST);
        let turned = solved(&mut limit, Quat::from_rotation_y(0.1), Vec3::Y * spin);
        assert_near(turned.turning, Vec3::Y * -spin);
    }
}

#[test]
fn pitch_yaw_and_roll_are_held_each_by_itself() {
    let bounds = Vec3::new(0.2, 0.3, 0.4);
    for (axis, bound) in Vec3::AXES.into_iter().zip(bounds.to_array()) {
        let mut limit = with_bounds(-bounds, bounds, EULER);
        let attitude = Quat::from_axis_angle(axis, bound);
        let turned = solved(&mut limit, attitude, axis);
        assert_near(turned.turning, -axis);
        let mut free = with_bounds(-bounds, bounds, EULER);
        let turned = solved(&mut free, Quat::from_axis_angle(axis, 0.1), axis);
        assert_near(turned.turning, Vec3::ZERO);
    }
}

#[test]
fn a_limit_works_only_if_it_counted_and_says_when_it_will() {
    let attitude = Quat::from_rotation_x(0.49);
    let sides = [
        side(Quat::IDENTITY, Vec3::ZERO, true),
        side(attitude, Vec3::X, false),
    ];
    let first = solve_limit(&mut cone_twist(), &Turned::default(), sides, 1e-3);
    assert_eq!((first.turning, first.counts), (Vec3::ZERO, 1.0));
}

#[test]
fn what_held_in_the_last_substep_is_taken_over_along_the_axis_as_it_is_now() {
    // The body rests against its bound: a spin of 0 that 3 N m s have made.
    let mut limit = Limit {
        impulses: Vec3::new(-3.0, 0.0, 0.0),
        ..cone_twist()
    };
    let before = Turned {
        counts: 1.0,
        turning: Vec3::Z * 3.0,
        ..Turned::default()
    };
    let attitude = Quat::from_rotation_x(0.5);
    let spin = Vec3::Z * 3.0;
    let sides = [
        side(Quat::IDENTITY, Vec3::ZERO, true),
        side(attitude, spin, false),
    ];
    let turned = solve_limit(&mut limit, &before, sides, 1e-3);
    // Of what it gave about z nothing is left; about x nothing is needed.
    assert_near(turned.turning, Vec3::ZERO);
}

#[test]
fn a_body_on_a_pin_is_stopped_with_its_moment_about_the_pin() {
    let mut limit = Limit {
        anchor_b: Vec3::Y * -2.0,
        ..cone_twist()
    };
    let turned = solved(&mut limit, Quat::from_rotation_x(0.5), Vec3::X);
    // 1 kg m² about its centre, 1 kg at 2 m.
    assert_near(turned.turning, Vec3::X * -5.0);
}

#[test]
fn a_range_of_a_hinge_is_a_twist_about_its_axis() {
    let ball = Shape::Sphere { radius: 0.1 };
    let mut scene = Scene::new("hinge");
    scene.bodies = [DQuat::from_rotation_x(1.0), DQuat::from_rotation_y(-0.7)]
        .map(|orientation| Body {
            orientation,
            ..Body::new(ball, 1.0, DVec3::ZERO)
        })
        .into();
    let axis = DVec3::new(0.0, 0.6, 0.8);
    scene.joints = vec![Joint::Hinge {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: DVec3::ZERO,
        axis_a: scene.bodies[0].orientation.conjugate() * axis,
        axis_b: scene.bodies[1].orientation.conjugate() * axis,
        range: Some([-0.5, 1.0]),
    }];
    let limit = limit_of(&scene, 0).expect("a range");
    let bounds = Bounds::<f32>::of(|_| &limit);
    let attitude = |body: usize| scene.bodies[body].orientation;
    for (angle, room, side) in [(0.9, 0.1, -1.0), (-0.4, 0.1, 1.0), (1.2, -0.2, -1.0)] {
        let turned = DQuat::from_axis_angle(axis, angle) * attitude(1);
        let turns = turns(
            &bounds,
            attitude(0).as_quat().into(),
            turned.as_quat().into(),
        );
        assert_eq!(turns[1].side, side);
        assert!(
            (turns[1].room - room).abs() < 1e-5,
            "{angle}: {}",
            turns[1].room
        );
        assert_near(turns[1].axis.lane(0), axis.as_vec3());
        assert_eq!((turns[0].side, turns[2].side), (0.0, 0.0));
    }
}

#[test]
fn joints_without_limits_have_none() {
    let mut scene = ch00_scenes::builtin::build("chain", None, None).expect("a scene");
    assert_eq!(limit_of(&scene, 0), None);
    scene = ch00_scenes::builtin::build("cradle", None, None).expect("a scene");
    assert_eq!(limit_of(&scene, 0), None);
}
