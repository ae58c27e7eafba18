//! The checks that a scene passes before any engine sees it. Each error names the file,
//! the table, the index, the field, what stands there and what should.

mod bodies;
mod forces;
mod joints;
mod orbits;

use glam::{DQuat, DVec3};

use crate::{Scene, SceneError};

/// How far a quaternion's length may be from 1; within it, it is normalised on load.
const UNIT_TOLERANCE: f64 = 1e-3;

impl Scene {
    /// Checks every number; `origin` is the file, or whatever errors shall call the scene.
    ///
    /// # Errors
    /// [`SceneError::SceneValue`] for a field of the scene itself, [`SceneError::Value`]
    /// for one of its bodies, joints, forces or orbits: the first that is wrong.
    pub fn validate(&self, origin: &str) -> Result<(), SceneError> {
        check_settings(self, origin)?;
        let place = |table, index| Place {
            origin,
            table,
            index,
            bodies: self.bodies.len(),
        };
        for (i, body) in self.bodies.iter().enumerate() {
            bodies::check(body, &place("bodies", i))?;
        }
        for (i, joint) in self.joints.iter().enumerate() {
            joints::check(self, joint, &place("joints", i))?;
        }
        for i in 0..self.forces.len() {
            forces::check(self, i, &place("forces", i))?;
        }
        for i in 0..self.orbits.len() {
            orbits::check(&self.orbits, i, &place("orbits", i))?;
        }
        Ok(())
    }
}

/// Checks the fields of the scene itself.
fn check_settings(scene: &Scene, origin: &str) -> Result<(), SceneError> {
    let demand = |holds: bool, field, value: String, why| {
        if holds {
            return Ok(());
        }
        Err(SceneError::SceneValue {
            origin: origin.to_owned(),
            field,
            value,
            why,
        })
    };
    let (dt, drag) = (scene.dt, scene.drag);
    demand(
        fits(scene.gravity.abs().max_element()) && scene.gravity.is_finite(),
        "gravity",
        vector(scene.gravity),
        FINITE,
    )?;
    demand(
        dt > 0.0 && dt <= 1.0 && is_normal(dt),
        "dt",
        dt.to_string(),
        "a time step is above 0 and at most 1 s",
    )?;
    demand(
        scene.steps >= 1,
        "steps",
        scene.steps.to_string(),
        "a run has at least one step",
    )?;
    demand(
        drag >= 0.0 && fits(drag),
        "drag",
        drag.to_string(),
        "drag is a finite rate of at least 0",
    )?;
    let threshold = scene.restitution_threshold.unwrap_or(0.0);
    demand(
        threshold >= 0.0 && fits(threshold),
        "restitution_threshold",
        threshold.to_string(),
        "a threshold is a finite speed of at least 0",
    )
}

const FINITE: &str = "must be finite, in single precision too";
const POSITIVE: &str = "must be above 0 and finite, in single precision too";
const NOT_NEGATIVE: &str = "must be at least 0 and finite, in single precision too";

/// Where a value stands, for errors; and how many bodies an index can mean.
struct Place<'a> {
    origin: &'a str,
    table: &'static str,
    index: usize,
    bodies: usize,
}

impl Place<'_> {
    /// An error about `field` unless `holds`.
    fn demand(
        &self,
        holds: bool,
        field: &str,
        value: impl FnOnce() -> String,
        why: &'static str,
    ) -> Result<(), SceneError> {
        if holds {
            return Ok(());
        }
        Err(SceneError::Value {
            origin: self.origin.to_owned(),
            table: self.table,
            index: self.index,
            field: field.to_owned(),
            value: value(),
            why,
        })
    }

    fn finite(&self, field: &str, value: f64) -> Result<(), SceneError> {
        self.demand(fits(value), field, || value.to_string(), FINITE)
    }

    fn positive(&self, field: &str, value: f64) -> Result<(), SceneError> {
        let holds = value > 0.0 && is_normal(value);
        self.demand(holds, field, || value.to_string(), POSITIVE)
    }

    fn at_least_zero(&self, field: &str, value: f64) -> Result<(), SceneError> {
        let holds = value >= 0.0 && fits(value);
        self.demand(holds, field, || value.to_string(), NOT_NEGATIVE)
    }

    fn finite_vector(&self, field: &str, value: DVec3) -> Result<(), SceneError> {
        let holds = value.to_array().into_iter().all(fits);
        self.demand(holds, field, || vector(value), FINITE)
    }

    /// A direction that can be given unit length.
    fn direction(&self, field: &str, value: DVec3) -> Result<(), SceneError> {
        let holds = value.to_array().into_iter().all(fits) && value.length() > 1e-6;
        self.demand(
            holds,
            field,
            || vector(value),
            "an axis is finite and not zero",
        )
    }

    fn unit_quaternion(&self, field: &str, value: DQuat) -> Result<(), SceneError> {
        let holds = (value.length() - 1.0).abs() <= UNIT_TOLERANCE;
        self.demand(
            holds,
            field,
            || format!("{:?}", value.to_array()),
            "a quaternion [x, y, z, w] has length 1 to within 0.001",
        )
    }

    /// An index of a body.
    fn body(&self, field: &str, value: usize) -> Result<(), SceneError> {
        self.demand(
            value < self.bodies,
            field,
            || format!("{value} (of {} bodies)", self.bodies),
            "no body has this index; the first is 0",
        )
    }

    /// Limits of an angle, the lower first or both the same. A turn is known only up to
    /// whole turns, so angles are measured from −π to π, and a limit beyond that could not
    /// be told from one within.
    fn angles(&self, field: &str, value: [f64; 2]) -> Result<(), SceneError> {
        let [low, high] = value;
        self.demand(
            fits(low) && fits(high) && low <= high,
            field,
            || format!("{value:?}"),
            "limits are finite and stand as [low, high]",
        )?;
        self.demand(
            value.iter().all(|limit| limit.abs() <= HALF_TURN),
            field,
            || format!("{value:?}"),
            "limits lie between −π and π rad: a turn is known only up to whole turns",
        )
    }
}

/// π rad, and what rounding to seven digits may add to it.
const HALF_TURN: f64 = std::f64::consts::PI + 1e-6;

/// Whether a number is finite in f32, in which engines run.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the loss is what is looked for"
)]
fn fits(value: f64) -> bool {
    (value as f32).is_finite()
}

/// Whether a number is neither 0, nor so small that its inverse overflows, nor infinite
/// in f32.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the loss is what is looked for"
)]
fn is_normal(value: f64) -> bool {
    (value as f32).is_normal()
}

fn vector(value: DVec3) -> String {
    format!("{:?}", value.to_array())
}

/// How a test breaks a scene, and what the error must say.
#[cfg(test)]
fn assert_refused(spoil: impl FnOnce(&mut Scene), expected: impl AsRef<str>) {
    let mut scene = crate::builtin::build("pair", None, None).unwrap();
    spoil(&mut scene);
    let message = scene.validate("file.json").unwrap_err().to_string();
    let expected = expected.as_ref();
    assert!(
        message.starts_with(expected),
        "expected {expected}, got {message}"
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_step_of_zero_is_named() {
        assert_refused(|scene| scene.dt = 0.0, "file.json: dt = 0: ");
    }

    #[test]
    fn a_negative_time_step_and_one_above_a_second_are_named() {
        assert_refused(|scene| scene.dt = -1.0, "file.json: dt = -1: ");
        assert_refused(|scene| scene.dt = 1.5, "file.json: dt = 1.5: ");
    }

    #[test]
    fn a_run_without_steps_is_named() {
        assert_refused(|scene| scene.steps = 0, "file.json: steps = 0: ");
    }

    #[test]
    fn gravity_that_is_not_a_number_is_named() {
        assert_refused(
            |scene| scene.gravity.x = f64::NAN,
            "file.json: gravity = [NaN, 0.0, 0.0]: ",
        );
    }

    #[test]
    fn a_negative_drag_and_a_negative_threshold_are_named() {
        assert_refused(|scene| scene.drag = -0.25, "file.json: drag = -0.25: ");
        assert_refused(
            |scene| scene.restitution_threshold = Some(-1.0),
            "file.json: restitution_threshold = -1: ",
        );
    }
}
