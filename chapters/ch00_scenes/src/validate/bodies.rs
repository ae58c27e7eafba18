//! The checks of one body.

use super::{Place, is_normal};
use crate::{Body, SceneError, Shape};

pub(super) fn check(body: &Body, at: &Place) -> Result<(), SceneError> {
    check_shape(body.shape, at)?;
    if body.mass != 0.0 {
        at.demand(
            body.mass > 0.0,
            "mass",
            || body.mass.to_string(),
            "a mass is above 0 kg, or 0 for a static body",
        )?;
        at.positive("mass", body.mass)?;
        let inertia = body.shape.inertia(body.mass);
        at.demand(
            inertia.to_array().into_iter().all(is_normal),
            "mass",
            || {
                format!(
                    "{} (moments of inertia {:?})",
                    body.mass,
                    inertia.to_array()
                )
            },
            "the moments of inertia must be above 0 and finite, in single precision too",
        )?;
    }
    at.finite_vector("position", body.position)?;
    at.unit_quaternion("orientation", body.orientation)?;
    at.finite_vector("linear_velocity", body.linear_velocity)?;
    at.finite_vector("angular_velocity", body.angular_velocity)?;
    at.demand(
        (0.0..=1.0).contains(&body.restitution),
        "restitution",
        || body.restitution.to_string(),
        "a coefficient of restitution lies in 0 … 1",
    )?;
    at.at_least_zero("friction", body.friction)?;
    let Some(static_friction) = body.static_friction else {
        return Ok(());
    };
    at.finite("static_friction", static_friction)?;
    at.demand(
        static_friction >= body.friction,
        "static_friction",
        || format!("{static_friction} (friction is {})", body.friction),
        "static friction is at least the kinetic one",
    )
}

fn check_shape(shape: Shape, at: &Place) -> Result<(), SceneError> {
    match shape {
        Shape::Sphere { radius } => at.positive("shape.sphere.radius", radius),
        Shape::Box { half_extents } => {
            at.finite_vector("shape.box.half_extents", half_extents)?;
            for (axis, half) in half_extents.to_array().into_iter().enumerate() {
                at.positive(&format!("shape.box.half_extents[{axis}]"), half)?;
            }
            Ok(())
        }
        Shape::Capsule {
            radius,
            half_height,
        } => {
            at.positive("shape.capsule.radius", radius)?;
            at.at_least_zero("shape.capsule.half_height", half_height)
        }
        Shape::Cylinder {
            radius,
            half_height,
        } => {
            at.positive("shape.cylinder.radius", radius)?;
            at.positive("shape.cylinder.half_height", half_height)
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::super::assert_refused;
    use crate::Shape;

    #[test]
    fn a_negative_mass_is_named_with_its_index() {
        assert_refused(
            |scene| scene.bodies[1].mass = -2.0,
            "file.json: bodies[1].mass = -2: a mass is above 0 kg",
        );
    }

    #[test]
    fn a_mass_that_single_precision_rounds_to_zero_is_refused() {
        assert_refused(
            |scene| scene.bodies[0].mass = 1e-50,
            "file.json: bodies[0].mass = 0.0000",
        );
    }

    #[test]
    fn a_mass_that_is_not_a_number_is_refused() {
        assert_refused(
            |scene| scene.bodies[0].mass = f64::NAN,
            "file.json: bodies[0].mass = NaN: ",
        );
    }

    #[test]
    fn a_radius_of_zero_is_named() {
        assert_refused(
            |scene| scene.bodies[1].shape = Shape::Sphere { radius: 0.0 },
            "file.json: bodies[1].shape.sphere.radius = 0: must be above 0",
        );
    }

    #[test]
    fn a_flat_box_is_refused_at_its_axis() {
        let half_extents = DVec3::new(1.0, 0.0, 1.0);
        assert_refused(
            |scene| scene.bodies[0].shape = Shape::Box { half_extents },
            "file.json: bodies[0].shape.box.half_extents[1] = 0: ",
        );
    }

    #[test]
    fn a_capsule_may_be_a_ball_but_a_cylinder_may_not_be_flat() {
        let (radius, half_height) = (0.1, 0.0);
        let mut scene = crate::builtin::build("pair", None, None).unwrap();
        scene.bodies[0].shape = Shape::Capsule {
            radius,
            half_height,
        };
        scene.validate("file.json").unwrap();
        assert_refused(
            |scene| {
                scene.bodies[0].shape = Shape::Cylinder {
                    radius,
                    half_height,
                };
            },
            "file.json: bodies[0].shape.cylinder.half_height = 0: ",
        );
    }

    #[test]
    fn a_needle_of_a_thousand_to_one_is_a_box() {
        let mut scene = crate::builtin::build("pair", None, None).unwrap();
        let half_extents = DVec3::new(0.001, 1.0, 0.001);
        scene.bodies[0].shape = Shape::Box { half_extents };
        scene.validate("file.json").unwrap();
    }

    #[test]
    fn a_milligram_on_a_thousand_tons_at_the_same_place_is_a_scene() {
        let mut scene = crate::builtin::build("pair", None, None).unwrap();
        scene.bodies[0].mass = 1e-6;
        scene.bodies[1].mass = 1e6;
        scene.bodies[1].position = scene.bodies[0].position;
        scene.validate("file.json").unwrap();
    }

    #[test]
    fn a_body_too_light_and_small_to_have_a_moment_of_inertia_is_refused() {
        assert_refused(
            |scene| {
                scene.bodies[0].shape = Shape::Sphere { radius: 1e-5 };
                scene.bodies[0].mass = 1e-30;
            },
            "file.json: bodies[0].mass = 0.000000000000000000000000000001 (moments of inertia [4",
        );
    }

    #[test]
    fn a_quaternion_of_length_zero_is_refused() {
        assert_refused(
            |scene| scene.bodies[0].orientation = DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0),
            "file.json: bodies[0].orientation = [0.0, 0.0, 0.0, 0.0]: ",
        );
    }

    #[test]
    fn a_quaternion_that_is_off_unit_length_by_two_thousandths_is_refused() {
        assert_refused(
            |scene| scene.bodies[0].orientation = DQuat::from_xyzw(0.0, 0.0, 0.0, 1.002),
            "file.json: bodies[0].orientation = ",
        );
    }

    #[test]
    fn an_infinite_velocity_is_named() {
        assert_refused(
            |scene| scene.bodies[1].linear_velocity.z = f64::INFINITY,
            "file.json: bodies[1].linear_velocity = [-1.0, 0.2, inf]: must be finite",
        );
    }

    #[test]
    fn a_position_beyond_single_precision_is_refused() {
        assert_refused(
            |scene| scene.bodies[1].position.y = 1e39,
            "file.json: bodies[1].position = ",
        );
    }

    #[test]
    fn a_restitution_above_one_is_refused() {
        assert_refused(
            |scene| scene.bodies[0].restitution = 1.1,
            "file.json: bodies[0].restitution = 1.1: ",
        );
    }

    #[test]
    fn static_friction_below_the_kinetic_one_is_refused() {
        assert_refused(
            |scene| scene.bodies[0].static_friction = Some(0.1),
            "file.json: bodies[0].static_friction = 0.1 (friction is 0.3): ",
        );
    }
}
