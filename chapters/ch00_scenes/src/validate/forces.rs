//! The checks of one force.

use super::Place;
use crate::{Force, Pole, Scene, SceneError};

const PUSHED_AND_HELD: &str = "only gravity acts on a body that turns about a fixed point";

pub(super) fn check(scene: &Scene, index: usize, at: &Place) -> Result<(), SceneError> {
    match &scene.forces[index] {
        Force::Magnets { poles, softening } => {
            at.positive("magnets.softening", *softening)?;
            poles
                .iter()
                .enumerate()
                .try_for_each(|(i, pole)| check_pole(pole, i, at))
        }
        Force::FixedPoint { body, arm } => {
            at.body("fixed_point.body", *body)?;
            at.finite_vector("fixed_point.arm", *arm)?;
            at.demand(
                !scene.bodies[*body].is_static(),
                "fixed_point.body",
                || body.to_string(),
                "a static body has no use for a fixed point",
            )?;
            at.demand(
                !has_fixed_point(&scene.forces[..index], *body),
                "fixed_point.body",
                || body.to_string(),
                "a body turns about one fixed point at most",
            )?;
            at.demand(
                !is_pushed(&scene.forces[..index], *body),
                "fixed_point.body",
                || body.to_string(),
                PUSHED_AND_HELD,
            )
        }
        Force::Constant { body, force } => {
            at.body("constant.body", *body)?;
            at.finite_vector("constant.force", *force)?;
            at.demand(
                !has_fixed_point(&scene.forces[..index], *body),
                "constant.body",
                || body.to_string(),
                PUSHED_AND_HELD,
            )
        }
    }
}

fn check_pole(pole: &Pole, index: usize, at: &Place) -> Result<(), SceneError> {
    let field = |name: &str| format!("magnets.poles[{index}].{name}");
    at.body(&field("body"), pole.body)?;
    at.finite_vector(&field("position"), pole.position)?;
    at.finite(&field("strength"), pole.strength)
}

fn has_fixed_point(forces: &[Force], of: usize) -> bool {
    forces
        .iter()
        .any(|force| matches!(force, Force::FixedPoint { body, .. } if *body == of))
}

fn is_pushed(forces: &[Force], body: usize) -> bool {
    forces
        .iter()
        .any(|force| matches!(force, Force::Constant { body: pushed, .. } if *pushed == body))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::assert_refused;
    use crate::{Force, Pole};

    fn fixed_point(body: usize) -> Force {
        Force::FixedPoint {
            body,
            arm: DVec3::ZERO,
        }
    }

    #[test]
    fn magnets_without_softening_are_refused() {
        let magnets = Force::Magnets {
            poles: Vec::new(),
            softening: 0.0,
        };
        assert_refused(
            |scene| scene.forces.push(magnets),
            "file.json: forces[0].magnets.softening = 0: ",
        );
    }

    #[test]
    fn a_pole_in_no_body_is_named() {
        let pole = |body| Pole {
            body,
            position: DVec3::ZERO,
            strength: 1.0,
        };
        let magnets = Force::Magnets {
            poles: vec![pole(0), pole(7)],
            softening: 0.1,
        };
        assert_refused(
            |scene| scene.forces.push(magnets),
            "file.json: forces[0].magnets.poles[1].body = 7 (of 2 bodies): ",
        );
    }

    #[test]
    fn a_fixed_point_on_a_static_body_is_refused() {
        assert_refused(
            |scene| {
                scene.bodies[1].mass = 0.0;
                scene.forces.push(fixed_point(1));
            },
            "file.json: forces[0].fixed_point.body = 1: a static body",
        );
    }

    #[test]
    fn a_constant_force_on_no_body_and_one_that_is_no_number_are_refused() {
        let push = |body, x| Force::Constant {
            body,
            force: DVec3::X * x,
        };
        assert_refused(
            |scene| scene.forces.push(push(7, 1.0)),
            "file.json: forces[0].constant.body = 7 (of 2 bodies): ",
        );
        assert_refused(
            |scene| scene.forces.push(push(1, f64::NAN)),
            "file.json: forces[0].constant.force",
        );
        assert_refused(
            |scene| scene.forces.extend([push(1, 1.0), fixed_point(1)]),
            "file.json: forces[1].fixed_point.body = 1: only gravity acts",
        );
        assert_refused(
            |scene| scene.forces.extend([fixed_point(1), push(1, 1.0)]),
            "file.json: forces[1].constant.body = 1: only gravity acts",
        );
    }

    #[test]
    fn a_second_fixed_point_on_a_body_is_refused() {
        assert_refused(
            |scene| scene.forces.extend([fixed_point(1), fixed_point(1)]),
            "file.json: forces[1].fixed_point.body = 1: a body turns about one",
        );
    }
}
