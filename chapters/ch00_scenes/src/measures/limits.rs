//! By how much joints are turned beyond their limits.
//!
//! Where a joint's bodies rest, b is turned by `rest` in a. What matters is the turn since
//! then, seen from b's rest frame: r = rest⁻¹ q_a⁻¹ q_b. It is split into a twist about the
//! bone's axis y, which comes first, and a swing which tilts that axis, r = swing · twist: the
//! twist has the part of r along y, (0, r_y, 0, r_w) made a unit, and the swing the rest. At a
//! swing of half a turn r_y = r_w = 0, and the twist is not defined; it is taken as 0.
//!
//! - *cone*: the angle between b's y axis and where that rests in a, which is the swing's;
//! - *twist*, *yaw*: the angle of the twist, 2 atan2(r_y, r_w);
//! - *pitch*, *roll*: the x and z parts of the swing's rotation vector, whose y part is 0;
//! - *hinge range*: the angle of the turn of b in a since loading, about a's axis.
//!
//! Written from the definitions, in f64; no engine shares it.

use std::f64::consts::PI;

use glam::{DQuat, DVec3};

use crate::{EulerLimits, Joint, Scene, State};

/// The largest angle by which any joint is beyond any of its limits, rad; 0 if all are kept.
/// `None` in a scene without limits. Joints of bodies that are not finite are passed over.
///
/// An angle that is outside [low, high] is beyond by the shorter way round to either end.
#[must_use]
pub fn limit_excess(scene: &Scene, state: &State) -> Option<f64> {
    worst(limit_excesses(scene, state))
}

/// The largest angle by which each joint that has limits is beyond any of them, rad, in the scene's
/// order; 0 if it keeps them. What is no number counts as 0.
pub fn limit_excesses(scene: &Scene, state: &State) -> impl Iterator<Item = f64> {
    let excess = |joint| excess_of(scene, state, joint);
    scene.joints.iter().filter_map(excess)
}

fn excess_of(scene: &Scene, state: &State, joint: &Joint) -> Option<f64> {
    match joint {
        Joint::Ball {
            cone,
            twist,
            limits,
            rest,
            ..
        } => {
            let turn = turn_since_rest(scene, state, joint, *rest);
            let from_cone = cone.map(|cone| (swing_angle(turn) - cone).max(0.0));
            let from_twist = twist.map(|range| beyond(twist_angle(turn), range));
            let from_euler = limits.map(|limits| beyond_euler(turn, limits));
            [from_cone, from_twist, from_euler]
                .into_iter()
                .flatten()
                .reduce(f64::max)
        }
        Joint::Hinge { axis_a, range, .. } => {
            let turn = turn_since_loading(scene, state, joint);
            range.map(|range| beyond(angle_about(turn, *axis_a), range))
        }
        Joint::Distance { .. } => None,
    }
}

/// The largest angle between the two axes of any hinge, rad. `None` in a scene without
/// hinges. Hinges of bodies that are not finite are passed over.
#[must_use]
pub fn hinge_misalignment(scene: &Scene, state: &State) -> Option<f64> {
    worst(scene.joints.iter().filter_map(|joint| match *joint {
        Joint::Hinge {
            a,
            b,
            axis_a,
            axis_b,
            ..
        } => Some(angle_between(
            state.orientation[a] * axis_a,
            state.orientation[b] * axis_b,
        )),
        Joint::Ball { .. } | Joint::Distance { .. } => None,
    }))
}

/// The largest of some angles, none of them below 0; `None` of none. What is no number
/// counts as 0.
fn worst(angles: impl Iterator<Item = f64>) -> Option<f64> {
    angles.fold(None, |worst, angle| Some(worst.unwrap_or(0.0).max(angle)))
}

/// The orientation of b in a.
fn relative(orientation: &[DQuat], joint: &Joint) -> DQuat {
    let (a, b) = joint.bodies();
    orientation[a].conjugate() * orientation[b]
}

fn as_loaded(scene: &Scene, joint: &Joint) -> DQuat {
    let (a, b) = joint.bodies();
    scene.bodies[a].orientation.conjugate() * scene.bodies[b].orientation
}

/// rest⁻¹ q_a⁻¹ q_b: the turn from where b rests, seen from b's rest frame.
fn turn_since_rest(scene: &Scene, state: &State, joint: &Joint, rest: Option<DQuat>) -> DQuat {
    let rest = rest.unwrap_or_else(|| as_loaded(scene, joint));
    rest.conjugate() * relative(&state.orientation, joint)
}

/// The turn of b from where it was loaded, seen from a.
fn turn_since_loading(scene: &Scene, state: &State, joint: &Joint) -> DQuat {
    relative(&state.orientation, joint) * as_loaded(scene, joint).conjugate()
}

/// The angle between y and where the turn takes it, 0 … π.
fn swing_angle(turn: DQuat) -> f64 {
    angle_between(DVec3::Y, turn * DVec3::Y)
}

fn twist_angle(turn: DQuat) -> f64 {
    angle_about(turn, DVec3::Y)
}

/// The angle of a turn's part about a direction, −π … π.
fn angle_about(turn: DQuat, axis: DVec3) -> f64 {
    let along = turn.xyz().dot(axis.normalize());
    to_half_turn(2.0 * libm::atan2(along, turn.w))
}

/// How far a turn is beyond the report's limits.
fn beyond_euler(turn: DQuat, limits: EulerLimits) -> f64 {
    let yaw = twist_angle(turn);
    let swing = turn * DQuat::from_rotation_y(-yaw);
    let vector = rotation_vector(swing);
    beyond(vector.x, limits.pitch)
        .max(beyond(yaw, limits.yaw))
        .max(beyond(vector.z, limits.roll))
}

/// Axis times angle of a rotation, the angle 0 … π.
fn rotation_vector(q: DQuat) -> DVec3 {
    // q and −q are the same rotation: this one turns by less.
    let v = if q.w < 0.0 { -q.xyz() } else { q.xyz() };
    let angle = 2.0 * libm::atan2(v.length(), q.w.abs());
    v.normalize_or_zero() * angle
}

/// The angle from `angle` to the nearer end of a range that it is not in, else 0.
fn beyond(angle: f64, [low, high]: [f64; 2]) -> f64 {
    if angle < low || angle > high {
        let to = |end: f64| to_half_turn(angle - end).abs();
        to(low).min(to(high))
    } else {
        0.0
    }
}

/// The same angle between −π and π.
fn to_half_turn(angle: f64) -> f64 {
    angle - 2.0 * PI * (angle / (2.0 * PI)).round()
}

/// The angle between two directions, 0 … π. Exact for small angles too, as an arc cosine
/// is not.
fn angle_between(u: DVec3, v: DVec3) -> f64 {
    libm::atan2(u.cross(v).length(), u.dot(v))
}

#[cfg(test)]
mod tests {
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
}
