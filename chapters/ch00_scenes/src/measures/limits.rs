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
mod tests;
