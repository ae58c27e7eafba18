//! A door, 0.9 × 2.0 × 0.04 m and 20 kg, that swings on a post: on a true hinge, or on two
//! pins, which are ball joints on the hinge's line. Two points of a line that stay in place
//! leave a body one turn, the one about that line, so both move the same.
//!
//! Both have stops, 0 (closed, as it starts) and 2 rad: the hinge by its range, and the
//! pins by the twist of the upper one, since the line is the door's y axis. The door opens
//! at 0.8 rad/s, a ball hits its front and opens it further, and one that rolls in from the
//! left closes it again.

use glam::DVec3;

use super::parts::{floor, static_box};
use crate::{Body, Joint, Scene, Shape};

/// Half-extents of the door's panel and of its post, m.
const PANEL: DVec3 = DVec3::new(0.45, 1.0, 0.02);
const POST: DVec3 = DVec3::new(0.05, 1.05, 0.05);
/// From the hinge's line, which is the world's y axis, to the panel's and the post's edge, m.
const CLEARANCE: f64 = 0.01;
/// The turn at which the door is stopped, open to the other side of z, rad.
const WIDE_OPEN: f64 = 2.0;
/// Of the door about the line at the start, rad/s.
const OPENING: f64 = 0.8;
/// Heights of the pins from the door's middle, m.
const PINS: [f64; 2] = [-0.8, 0.8];

/// What holds the door.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Hung {
    /// One hinge.
    OnHinge,
    /// Two ball joints.
    OnPins,
}

/// The scene: body 0 is the post, 1 the door, 2 the ball that flies, 3 the ball that rolls;
/// the floor is last.
pub(super) fn build(name: &str, hung: Hung) -> Scene {
    let mut scene = Scene::new(name);
    scene.steps = 300;
    let to_post = DVec3::X * (POST.x + CLEARANCE);
    let to_panel = DVec3::X * (PANEL.x + CLEARANCE);
    let middle = DVec3::Y * POST.y;
    let panel = Shape::Box {
        half_extents: PANEL,
    };
    let turn = DVec3::Y * OPENING;
    let door = Body {
        linear_velocity: turn.cross(to_panel),
        angular_velocity: turn,
        ..Body::new(panel, 20.0, middle + to_panel)
    };
    scene.bodies = vec![
        static_box(POST, middle - to_post),
        door,
        flying_ball(),
        rolling_ball(),
        floor(5.0, 3.0),
    ];
    for body in &mut scene.bodies {
        body.restitution = 0.3;
    }
    scene.joints = joints(hung, to_post, -to_panel);
    scene
}

/// What holds the door, whose line is at `anchor_a` of the post and `anchor_b` of the door.
fn joints(hung: Hung, anchor_a: DVec3, anchor_b: DVec3) -> Vec<Joint> {
    let stops = Some([0.0, WIDE_OPEN]);
    match hung {
        Hung::OnHinge => vec![Joint::Hinge {
            a: 0,
            b: 1,
            anchor_a,
            anchor_b,
            axis_a: DVec3::Y,
            axis_b: DVec3::Y,
            range: stops,
        }],
        Hung::OnPins => PINS
            .map(|height| Joint::Ball {
                a: 0,
                b: 1,
                anchor_a: anchor_a + DVec3::Y * height,
                anchor_b: anchor_b + DVec3::Y * height,
                cone: None,
                twist: stops.filter(|_| height > 0.0),
                limits: None,
                rest: None,
            })
            .into(),
    }
}

/// Comes from the front at 4 m/s, and is back at the height of its start when it arrives, after
/// about 0.53 s.
fn flying_ball() -> Body {
    let ball = Shape::Sphere { radius: 0.12 };
    Body {
        linear_velocity: DVec3::new(0.0, 2.6, -4.0),
        ..Body::new(ball, 3.0, DVec3::new(0.6, 1.2, 2.0))
    }
}

/// Rolls along x towards the open door, where it arrives after about 1.6 s.
fn rolling_ball() -> Body {
    let radius = 0.15;
    let speed = 2.2;
    Body {
        linear_velocity: DVec3::X * speed,
        angular_velocity: DVec3::NEG_Z * speed / radius,
        ..Body::new(
            Shape::Sphere { radius },
            5.0,
            DVec3::new(-4.0, radius, -0.6),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Penetration, joint_separation, limit_excess};

    const BOTH: [Hung; 2] = [Hung::OnHinge, Hung::OnPins];

    #[test]
    fn the_door_hangs_free_and_its_joints_meet_within_their_limits() {
        for hung in BOTH {
            let scene = build("door", hung);
            let state = State::start_of(&scene);
            assert!(joint_separation(&scene, &state).unwrap() < 1e-15);
            assert_eq!(limit_excess(&scene, &state), Some(0.0));
            // The ball that rolls touches the floor, and post and floor are both static.
            let found = Penetration::of(&scene, &state);
            assert_eq!(found.deepest, 0.0, "{found:?}");
        }
    }

    #[test]
    fn the_doors_edge_at_the_hinge_moves_with_its_turn_alone() {
        let door = &build("door", Hung::OnHinge).bodies[1];
        let line = DVec3::new(0.0, door.position.y, 0.0);
        let there = door.linear_velocity + door.angular_velocity.cross(line - door.position);
        assert!(there.length() < 1e-16, "{there}");
    }

    #[test]
    fn the_turn_of_the_hinge_and_the_twist_of_the_pin_are_measured_alike() {
        for hung in BOTH {
            let scene = build("door", hung);
            let mut state = State::start_of(&scene);
            for (angle, expected) in [(2.3, 0.3), (-0.2, 0.2), (1.0, 0.0)] {
                state.orientation[1] = glam::DQuat::from_rotation_y(angle);
                let excess = limit_excess(&scene, &state).unwrap();
                assert!((excess - expected).abs() < 1e-15, "{angle}: {excess}");
            }
        }
    }
}
