//! The checks of one joint.

use std::f64::consts::PI;

use super::Place;
use crate::{Joint, Scene, SceneError};

pub(super) fn check(scene: &Scene, joint: &Joint, at: &Place) -> Result<(), SceneError> {
    let kind = match joint {
        Joint::Ball { .. } => "ball",
        Joint::Distance { .. } => "distance",
        Joint::Hinge { .. } => "hinge",
    };
    let field = |name: &str| format!("{kind}.{name}");
    let (a, b) = joint.bodies();
    let (anchor_a, anchor_b) = joint.anchors();
    at.body(&field("a"), a)?;
    at.body(&field("b"), b)?;
    at.demand(
        a != b,
        &field("b"),
        || b.to_string(),
        "a joint connects two different bodies",
    )?;
    at.demand(
        !(scene.bodies[a].is_static() && scene.bodies[b].is_static()),
        &field("b"),
        || format!("{b} (a is {a})"),
        "both bodies are static; a joint needs one that can move",
    )?;
    at.finite_vector(&field("anchor_a"), anchor_a)?;
    at.finite_vector(&field("anchor_b"), anchor_b)?;
    match joint {
        Joint::Ball { .. } => check_ball(joint, at),
        Joint::Distance { length, .. } => at.at_least_zero("distance.length", *length),
        Joint::Hinge {
            axis_a,
            axis_b,
            range,
            ..
        } => {
            at.direction("hinge.axis_a", *axis_a)?;
            at.direction("hinge.axis_b", *axis_b)?;
            range.map_or(Ok(()), |range| at.angles("hinge.range", range))
        }
    }
}

/// The angle limits of a ball joint.
fn check_ball(joint: &Joint, at: &Place) -> Result<(), SceneError> {
    let Joint::Ball {
        cone,
        twist,
        limits,
        rest,
        ..
    } = joint
    else {
        return Ok(());
    };
    if let Some(cone) = *cone {
        at.demand(
            cone > 0.0 && cone < PI,
            "ball.cone",
            || cone.to_string(),
            "a cone's angle lies between 0 and π rad",
        )?;
    }
    if let Some(twist) = *twist {
        at.angles("ball.twist", twist)?;
    }
    if let Some(limits) = limits {
        at.demand(
            cone.is_none() && twist.is_none(),
            "ball.limits",
            || "given".to_owned(),
            "pitch, yaw and roll limits exclude a cone and a twist",
        )?;
        at.angles("ball.limits.pitch", limits.pitch)?;
        at.angles("ball.limits.yaw", limits.yaw)?;
        at.angles("ball.limits.roll", limits.roll)?;
    }
    rest.map_or(Ok(()), |rest| at.unit_quaternion("ball.rest", rest))
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::super::assert_refused;
    use crate::{EulerLimits, Joint};

    /// What a ball joint of the tests may have.
    #[derive(Default)]
    struct Limits {
        cone: Option<f64>,
        twist: Option<[f64; 2]>,
        euler: Option<EulerLimits>,
        rest: Option<DQuat>,
    }

    fn ball(a: usize, b: usize, limits: &Limits) -> Joint {
        Joint::Ball {
            a,
            b,
            anchor_a: DVec3::ZERO,
            anchor_b: DVec3::ZERO,
            cone: limits.cone,
            twist: limits.twist,
            limits: limits.euler,
            rest: limits.rest,
        }
    }

    fn assert_joint_refused(joint: Joint, expected: &str) {
        assert_refused(
            |scene| scene.joints.push(joint),
            format!("file.json: joints[0].{expected}"),
        );
    }

    #[test]
    fn an_index_out_of_range_is_named_with_the_number_of_bodies() {
        assert_joint_refused(
            ball(0, 2, &Limits::default()),
            "ball.b = 2 (of 2 bodies): no body has this index",
        );
    }

    #[test]
    fn a_joint_to_itself_is_refused() {
        assert_joint_refused(
            ball(1, 1, &Limits::default()),
            "ball.b = 1: a joint connects two different bodies",
        );
    }

    #[test]
    fn limits_the_wrong_way_round_are_refused() {
        let limits = Limits {
            twist: Some([0.3, -0.3]),
            ..Limits::default()
        };
        assert_joint_refused(ball(0, 1, &limits), "ball.twist = [0.3, -0.3]: ");
    }

    #[test]
    fn a_cone_beside_euler_limits_is_refused() {
        let limits = Limits {
            cone: Some(1.0),
            euler: Some(EulerLimits {
                pitch: [-1.0, 1.0],
                yaw: [-1.0, 1.0],
                roll: [-1.0, 1.0],
            }),
            ..Limits::default()
        };
        assert_joint_refused(ball(0, 1, &limits), "ball.limits = given: ");
    }

    #[test]
    fn a_cone_of_half_a_turn_is_refused() {
        let limits = Limits {
            cone: Some(std::f64::consts::PI),
            ..Limits::default()
        };
        assert_joint_refused(ball(0, 1, &limits), "ball.cone = 3.14159");
    }

    #[test]
    fn a_rest_quaternion_off_unit_length_is_refused() {
        let limits = Limits {
            rest: Some(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.5)),
            ..Limits::default()
        };
        assert_joint_refused(ball(0, 1, &limits), "ball.rest = [0.0, 0.0, 0.0, 0.5]: ");
    }

    #[test]
    fn a_negative_length_is_refused() {
        let joint = Joint::Distance {
            a: 0,
            b: 1,
            anchor_a: DVec3::ZERO,
            anchor_b: DVec3::ZERO,
            length: -1.0,
        };
        assert_joint_refused(joint, "distance.length = -1: ");
    }

    #[test]
    fn a_hinge_axis_of_length_zero_is_refused() {
        let joint = Joint::Hinge {
            a: 0,
            b: 1,
            anchor_a: DVec3::ZERO,
            anchor_b: DVec3::ZERO,
            axis_a: DVec3::Y,
            axis_b: DVec3::ZERO,
            range: None,
        };
        assert_joint_refused(joint, "hinge.axis_b = [0.0, 0.0, 0.0]: ");
    }

    fn euler(pitch: [f64; 2], yaw: [f64; 2], roll: [f64; 2]) -> Limits {
        Limits {
            euler: Some(EulerLimits { pitch, yaw, roll }),
            ..Limits::default()
        }
    }

    fn hinge(range: [f64; 2]) -> Joint {
        Joint::Hinge {
            a: 0,
            b: 1,
            anchor_a: DVec3::ZERO,
            anchor_b: DVec3::ZERO,
            axis_a: DVec3::Y,
            axis_b: DVec3::Y,
            range: Some(range),
        }
    }

    fn assert_joint_accepted(joint: Joint) {
        let mut scene = crate::builtin::build("pair", None, None).unwrap();
        scene.joints.push(joint);
        scene.validate("file.json").unwrap();
    }

    #[test]
    fn every_range_the_wrong_way_round_is_named() {
        let (fine, wrong) = ([-1.0, 1.0], [0.5, 0.25]);
        for (limits, expected) in [
            (
                euler(wrong, fine, fine),
                "ball.limits.pitch = [0.5, 0.25]: ",
            ),
            (euler(fine, wrong, fine), "ball.limits.yaw = [0.5, 0.25]: "),
            (euler(fine, fine, wrong), "ball.limits.roll = [0.5, 0.25]: "),
        ] {
            assert_joint_refused(ball(0, 1, &limits), expected);
        }
        assert_joint_refused(hinge(wrong), "hinge.range = [0.5, 0.25]: ");
    }

    #[test]
    fn a_range_of_one_angle_locks_and_is_legal() {
        let locked = [0.25, 0.25];
        assert_joint_accepted(ball(0, 1, &euler(locked, locked, locked)));
        assert_joint_accepted(hinge(locked));
        let limits = Limits {
            twist: Some(locked),
            ..Limits::default()
        };
        assert_joint_accepted(ball(0, 1, &limits));
    }

    #[test]
    fn half_a_turn_either_way_is_legal_and_more_can_t_be_told_from_less() {
        // As f32 has it, which is a little above π.
        let pi = f64::from(std::f32::consts::PI);
        assert_joint_accepted(hinge([-pi, pi]));
        for range in [[-4.0, 1.0], [0.0, 3.15]] {
            let expected = format!("hinge.range = {range:?}: limits lie between −π and π");
            assert_joint_refused(hinge(range), &expected);
        }
    }

    #[test]
    fn a_range_that_is_not_finite_is_refused() {
        assert_joint_refused(
            hinge([f64::NEG_INFINITY, 1.0]),
            "hinge.range = [-inf, 1.0]: limits are finite",
        );
        assert_joint_refused(hinge([0.0, f64::NAN]), "hinge.range = [0.0, NaN]: ");
    }

    #[test]
    fn a_joint_between_two_static_bodies_is_refused() {
        assert_refused(
            |scene| {
                scene.bodies[0].mass = 0.0;
                scene.bodies[1].mass = 0.0;
                scene.joints.push(hinge([0.0, 1.0]));
            },
            "file.json: joints[0].hinge.b = 1 (a is 0): both bodies are static",
        );
    }

    #[test]
    fn a_joint_to_one_static_body_and_two_joints_between_the_same_bodies_are_legal() {
        let mut scene = crate::builtin::build("pair", None, None).unwrap();
        scene.bodies[0].mass = 0.0;
        scene.joints = vec![ball(0, 1, &Limits::default()); 2];
        scene.joints.push(ball(1, 0, &Limits::default()));
        scene.validate("file.json").unwrap();
    }

    #[test]
    fn an_anchor_that_is_not_finite_is_named() {
        let mut joint = ball(0, 1, &Limits::default());
        if let Joint::Ball { anchor_b, .. } = &mut joint {
            anchor_b.y = f64::NAN;
        }
        assert_joint_refused(joint, "ball.anchor_b = [0.0, NaN, 0.0]: ");
    }
}
