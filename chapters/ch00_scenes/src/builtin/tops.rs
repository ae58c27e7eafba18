//! Spinning tops. One is heavy: a disc on a massless axle whose foot stays in place, so
//! that its weight turns it over, and it precesses and nods instead of falling (scenario
//! 8). The others hang in gimbals, each held at its own centre, so that no torque acts
//! and each shows free rotation: the box of scenario 4, the box that flips over every 5.1 s
//! (scenario 5, the Dzhanibekov effect), a plate that wobbles and a rod that tumbles.
//!
//! The disc has radius 0.2 m, mass 1 kg and half-height 0.005 m, its centre 0.2 m from
//! the foot. About the foot this makes I₁ = m (r²/4 + h²/3 + d²) = 0.050 008 kg m², which
//! is 1.7 · 10⁻⁴ above the 0.05 of the infinitely thin disc of scenario 8; I₃ is 0.02.

use glam::{DQuat, DVec3};

use crate::{Body, Force, Scene, Shape};

/// Height of the gimbals' centres, m.
const GIMBAL_HEIGHT: f64 = 0.9;

/// The scene: the heavy top is body 0, the boxes of scenarios 4 and 5 are bodies 1 and 2,
/// plate and rod 3 and 4; a floor under them, for their shadows, is last.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("tops");
    let foot = DVec3::new(0.0, 0.5, 0.0);
    add(&mut scene, heavy_top(), foot, DVec3::new(0.0, 0.2, 0.0));

    let (radius, half_height) = (0.28, 0.02);
    let plate = Shape::Cylinder {
        radius,
        half_height,
    };
    let (radius, half_height) = (0.07, 0.25);
    let rod = Shape::Capsule {
        radius,
        half_height,
    };
    let brick = Shape::Box {
        half_extents: DVec3::new(0.3, 0.2, 0.1),
    };
    let free = [
        (brick, -1.0, DVec3::new(1.0, 2.0, 3.0)),
        (brick, 1.0, DVec3::new(0.05, 5.0, 0.05)),
        (plate, -2.0, DVec3::new(1.5, 6.0, 0.0)),
        (rod, 2.0, DVec3::new(3.0, 9.0, 0.0)),
    ];
    for (shape, x, angular_velocity) in free {
        let body = Body {
            angular_velocity,
            ..Body::new(shape, 1.0, DVec3::ZERO)
        };
        let gimbal = DVec3::new(x, GIMBAL_HEIGHT, 0.0);
        add(&mut scene, body, gimbal, DVec3::ZERO);
    }
    scene.bodies.push(floor());
    scene
}

/// The disc, its axis 0.5 rad from the vertical, with 60 rad/s about that axis and no
/// other motion.
fn heavy_top() -> Body {
    let (radius, half_height) = (0.2, 0.005);
    let disc = Shape::Cylinder {
        radius,
        half_height,
    };
    let orientation = DQuat::from_rotation_z(-0.5);
    Body {
        orientation,
        angular_velocity: orientation * DVec3::new(0.0, 60.0, 0.0),
        ..Body::new(disc, 1.0, DVec3::ZERO)
    }
}

fn floor() -> Body {
    let half_extents = DVec3::new(3.0, 0.5, 1.5);
    Body::new(Shape::Box { half_extents }, 0.0, DVec3::new(0.0, -0.5, 0.0))
}

/// Adds a body that turns about `point`, with its centre at `arm` (in its own
/// coordinates) from there.
fn add(scene: &mut Scene, mut body: Body, point: DVec3, arm: DVec3) {
    body.position = point + body.orientation * arm;
    scene.forces.push(Force::FixedPoint {
        body: scene.bodies.len(),
        arm,
    });
    scene.bodies.push(body);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::Penetration;

    #[test]
    fn the_heavy_top_has_the_moments_of_scenario_8() {
        let scene = build();
        let body = &scene.bodies[0];
        let Force::FixedPoint { arm, .. } = &scene.forces[0] else {
            panic!("the heavy top is held first");
        };
        let centre = body.shape.inertia(body.mass);
        let about_foot = centre.x + body.mass * arm.length_squared();
        assert!((about_foot / 0.05 - 1.0).abs() < 2e-4, "{about_foot}");
        assert!((centre.y - 0.02).abs() < 1e-15, "{centre}");
    }

    #[test]
    fn the_heavy_tops_axis_leans_by_half_a_radian_and_its_foot_is_in_place() {
        let body = &build().bodies[0];
        let axis = body.orientation * DVec3::Y;
        assert!((axis.angle_between(DVec3::Y) - 0.5).abs() < 1e-12);
        let foot = body.position - 0.2 * axis;
        assert!(foot.distance(DVec3::new(0.0, 0.5, 0.0)) < 1e-15);
        assert!((body.angular_velocity - 60.0 * axis).length() < 1e-12);
    }

    #[test]
    fn every_top_is_held_and_none_can_reach_another_or_the_floor() {
        let scene = build();
        assert_eq!(scene.forces.len(), scene.dynamic_count());
        // Whatever way they turn: each top as the ball about its fixed point.
        let mut balls = scene.clone();
        for force in &scene.forces {
            if let Force::FixedPoint { body, arm } = force {
                let top = &mut balls.bodies[*body];
                let radius = top.shape.bounding_radius() + arm.length();
                top.position -= top.orientation * *arm;
                top.shape = Shape::Sphere { radius };
            }
        }
        let found = Penetration::of(&balls, &State::start_of(&balls));
        assert_eq!(found.pairs_touching, 0, "{found:?}");
    }
}
