//! Swing and twist, tested against finite differences and against rotations put together by hand.

use ch00_maths::f64::rotation::{exp, turned};
use ch00_maths::f64::swing_twist::{SwingTwist, compose, cone, decompose, swing_axes, twist_axis};
use glam::{DQuat, DVec3};

/// Some rest frame, swing, twist and relative angular velocity that are nowhere special.
fn somewhere() -> (DQuat, SwingTwist, DVec3) {
    let rest = exp(DVec3::new(0.4, -1.1, 0.3));
    let parts = SwingTwist {
        swing: DVec3::new(0.9, 0.0, -1.3),
        twist: 0.7,
    };
    (rest, parts, DVec3::new(0.3, -0.8, 0.5))
}

/// How the parts change in a second if the child turns with ω in the world.
fn rates(rest: DQuat, parts: SwingTwist, omega: DVec3) -> (DVec3, f64) {
    let h = 1e-6;
    let child = rest * compose(parts);
    let after = |h: f64| decompose(rest.conjugate() * turned(child, omega * h));
    let (ahead, behind) = (after(h), after(-h));
    (
        (ahead.swing - behind.swing) / (2.0 * h),
        (ahead.twist - behind.twist) / (2.0 * h),
    )
}

#[test]
fn a_rotation_is_its_swing_after_its_twist() {
    for swing in [DVec3::ZERO, DVec3::X * 3.1, DVec3::new(-0.2, 0.0, 2.0)] {
        for twist in [-3.0, -0.5, 0.0, 0.5, 3.0] {
            let parts = SwingTwist { swing, twist };
            let back = decompose(compose(parts));
            assert!((back.swing - swing).length() < 1e-9, "{parts:?} {back:?}");
            assert!((back.twist - twist).abs() < 1e-9, "{parts:?} {back:?}");
        }
    }
}

#[test]
fn q_and_minus_q_split_alike() {
    let (_, parts, _) = somewhere();
    let q = compose(parts);
    assert_eq!(decompose(q), decompose(-q));
}

#[test]
fn the_twist_is_finite_and_continuous_up_to_a_cone_just_under_pi() {
    let tilted = std::f64::consts::PI - 1e-4;
    for twist in [-1.0, 0.0, 1.0] {
        let swing = DVec3::new(tilted * 0.6, 0.0, tilted * 0.8);
        let back = decompose(compose(SwingTwist { swing, twist }));
        assert!((back.twist - twist).abs() < 1e-6, "{back:?}");
    }
}

#[test]
fn at_the_singular_direction_the_swing_is_pi_and_the_twist_nothing() {
    let back = decompose(DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0));
    assert!((back.swing - DVec3::X * std::f64::consts::PI).length() < 1e-12);
    assert_eq!(back.twist, 0.0);
}

#[test]
fn the_axes_give_the_rates_of_twist_cone_pitch_and_roll() {
    let (rest, parts, omega) = somewhere();
    let (swing_rate, twist_rate) = rates(rest, parts, omega);
    let (y_rest, y) = (rest * DVec3::Y, rest * compose(parts) * DVec3::Y);
    assert!((twist_axis(y_rest, y).dot(omega) - twist_rate).abs() < 1e-8);

    let (angle, axis) = cone(y_rest, y);
    let angle_rate = swing_rate.dot(parts.swing.normalize());
    assert!((angle - parts.swing.length()).abs() < 1e-12);
    assert!((axis.unwrap().dot(omega) - angle_rate).abs() < 1e-8);

    let (pitch, roll) = swing_axes(rest, parts.swing, y);
    assert!((pitch.dot(omega) - swing_rate.x).abs() < 1e-8);
    assert!((roll.dot(omega) - swing_rate.z).abs() < 1e-8);
}

#[test]
fn at_rest_the_axes_are_those_of_the_rest_frame() {
    let (rest, _, _) = somewhere();
    let (pitch, roll) = swing_axes(rest, DVec3::ZERO, rest * DVec3::Y);
    assert_eq!((pitch, roll), (rest * DVec3::X, rest * DVec3::Z));
    assert_eq!(cone(DVec3::Y, DVec3::Y), (0.0, None));
}

#[test]
fn opposite_axes_are_a_cone_of_pi_with_some_axis_across() {
    let (angle, axis) = cone(DVec3::Y, -DVec3::Y);
    assert_eq!(angle, std::f64::consts::PI);
    assert!(axis.unwrap().dot(DVec3::Y).abs() < 1e-12);
}
