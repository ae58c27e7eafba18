//! From a scene's joints to limits.

use ch00_scenes::{EulerLimits, Joint, Scene};
use glam::{DQuat, DVec3};

use crate::rows::{CONE_TWIST, EULER, FREE_ANGLE, Limit};

// ANCHOR: limit_of
/// The limit of a joint of the scene, if it has one.
///
/// A hinge's range is a twist about its axis: the frame in b turns y onto that.
#[must_use]
pub fn limit_of(scene: &Scene, index: usize) -> Option<Limit> {
    let joint = &scene.joints[index];
    let (a, b) = joint.bodies();
    let (anchor_a, anchor_b) = joint.anchors();
    let attitude = |body: usize| scene.bodies[body].orientation;
    let as_loaded = (attitude(a).conjugate() * attitude(b)).normalize();
    let free = f64::from(FREE_ANGLE);
    let (low, high, kind, rest, frame_b) = match *joint {
        Joint::Ball {
            limits: Some(limits),
            rest,
            ..
        } => {
            let [low, high] = euler_bounds(limits);
            (low, high, EULER, rest, DQuat::IDENTITY)
        }
        Joint::Ball {
            cone, twist, rest, ..
        } if cone.is_some() || twist.is_some() => {
            let [low, high] = twist.unwrap_or([-free, free]);
            let (low, high) = (
                DVec3::new(-free, low, -free),
                DVec3::new(cone.unwrap_or(free), high, free),
            );
            (low, high, CONE_TWIST, rest, DQuat::IDENTITY)
        }
        Joint::Hinge {
            axis_b,
            range: Some([low, high]),
            ..
        } => {
            let frame_b = DQuat::from_rotation_arc(DVec3::Y, axis_b.normalize());
            let (low, high) = (DVec3::new(-free, low, -free), DVec3::new(free, high, free));
            (low, high, CONE_TWIST, None, frame_b)
        }
        Joint::Ball { .. } | Joint::Hinge { .. } | Joint::Distance { .. } => return None,
    };
    Some(Limit {
        a: a as u32,
        b: b as u32,
        joint: index as u32,
        kind,
        frame_a: (rest.unwrap_or(as_loaded) * frame_b).normalize().as_quat(),
        frame_b: frame_b.as_quat(),
        low: low.as_vec3(),
        high: high.as_vec3(),
        anchor_a: anchor_a.as_vec3(),
        anchor_b: anchor_b.as_vec3(),
        ..Limit::default()
    })
}

fn euler_bounds(limits: EulerLimits) -> [DVec3; 2] {
    [0, 1].map(|end| DVec3::new(limits.pitch[end], limits.yaw[end], limits.roll[end]))
}
// ANCHOR_END: limit_of
