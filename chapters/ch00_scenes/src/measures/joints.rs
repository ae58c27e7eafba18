//! How far joints have come apart.

use glam::DVec3;

use crate::{Joint, Scene, State};

/// The largest error of any joint, m: the distance between the two anchors, or for a
/// distance joint how far that is from its length. `None` in a scene without joints.
/// Joints of bodies that are not finite are passed over.
#[must_use]
pub fn joint_separation(scene: &Scene, state: &State) -> Option<f64> {
    joint_separations(scene, state).reduce(f64::max)
}

/// The error of every joint, m, in the scene's order; no number where a body is not finite.
pub fn joint_separations(scene: &Scene, state: &State) -> impl Iterator<Item = f64> {
    scene.joints.iter().map(|joint| separation(joint, state))
}

fn separation(joint: &Joint, state: &State) -> f64 {
    let (a, b) = joint.bodies();
    let (anchor_a, anchor_b) = joint.anchors();
    let world =
        |body: usize, anchor: DVec3| state.position[body] + state.orientation[body] * anchor;
    let distance = world(a, anchor_a).distance(world(b, anchor_b));
    match joint {
        Joint::Distance { length, .. } => (distance - length).abs(),
        Joint::Ball { .. } | Joint::Hinge { .. } => distance,
    }
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;
    use crate::{Body, Shape};

    fn two_bodies(joint: Joint) -> (Scene, State) {
        let ball = Shape::Sphere { radius: 0.1 };
        let mut scene = Scene::new("joint");
        scene.bodies = vec![
            Body::new(ball, 1.0, DVec3::ZERO),
            Body::new(ball, 1.0, DVec3::X * 2.0),
        ];
        scene.joints = vec![joint];
        let state = State::start_of(&scene);
        (scene, state)
    }

    fn ball_joint() -> Joint {
        Joint::pin(0, 1, DVec3::X, -DVec3::X)
    }

    #[test]
    fn anchors_that_meet_are_not_apart() {
        let (scene, state) = two_bodies(ball_joint());
        assert_eq!(joint_separation(&scene, &state), Some(0.0));
    }

    #[test]
    fn anchors_turn_with_their_bodies() {
        let (scene, mut state) = two_bodies(ball_joint());
        // Half a turn about y puts b's anchor on its far side.
        state.orientation[1] = DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0);
        let apart = joint_separation(&scene, &state).unwrap();
        assert!((apart - 2.0).abs() < 1e-12, "{apart}");
    }

    #[test]
    fn a_distance_joint_is_off_by_its_stretch_or_its_squeeze() {
        for length in [1.9, 2.1] {
            let (scene, state) = two_bodies(Joint::Distance {
                a: 0,
                b: 1,
                anchor_a: DVec3::ZERO,
                anchor_b: DVec3::ZERO,
                length,
            });
            let off = joint_separation(&scene, &state).unwrap();
            assert!((off - 0.1).abs() < 1e-12, "{off}");
        }
    }

    #[test]
    fn a_scene_without_joints_has_no_separation() {
        let (mut scene, state) = two_bodies(ball_joint());
        scene.joints.clear();
        assert_eq!(joint_separation(&scene, &state), None);
    }
}
