//! The checks of one joint.

use std::f64::consts::PI;

use super::Place;
use crate::{Joint, SceneError};

pub(super) fn check(joint: &Joint, at: &Place) -> Result<(), SceneError> {
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
            range.map_or(Ok(()), |range| at.range("hinge.range", range))
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
        at.range("ball.twist", twist)?;
    }
    if let Some(limits) = limits {
        at.demand(
            cone.is_none() && twist.is_none(),
            "ball.limits",
            || "given".to_owned(),
            "pitch, yaw and roll limits exclude a cone and a twist",
        )?;
        at.range("ball.limits.pitch", limits.pitch)?;
        at.range("ball.limits.yaw", limits.yaw)?;
        at.range("ball.limits.roll", limits.roll)?;
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
}
