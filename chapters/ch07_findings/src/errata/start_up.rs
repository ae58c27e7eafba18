//! Erratum 9: p* = p − vΔt is half a step of acceleration short; p* = p − vΔt + ½aΔt² is right.
//!
//! Scenario 1: a point thrown from (0, 10, 0) with (5, 8, 0) m/s. After t seconds the printed start
//! is ½ a Δt t off, for ever of first order, though the rule is of second.

use ch00_maths::f64::verlet;
use glam::DVec3;

use super::gyroscopic::steps;
use super::halved_steps;
use crate::chart::{Axis, Chart, Series, Style};

const START: DVec3 = DVec3::new(0.0, 10.0, 0.0);
const VELOCITY: DVec3 = DVec3::new(5.0, 8.0, 0.0);
const GRAVITY: DVec3 = DVec3::new(0.0, -9.81, 0.0);

/// Distance from the exact place after 2 s, m.
#[must_use]
pub fn error_after_two_seconds(dt: f64, printed: bool) -> f64 {
    let mut p = START;
    let mut p_last = if printed {
        verlet::printed::last_position(p, VELOCITY, dt)
    } else {
        verlet::last_position(p, VELOCITY, GRAVITY, dt)
    };
    for _ in 0..steps(2.0, dt) {
        let moved = verlet::displacement(p, p_last, GRAVITY, 1.0, dt, dt);
        p_last = p;
        p += moved;
    }
    (p - (START + VELOCITY * 2.0 + 0.5 * GRAVITY * 4.0)).length()
}

/// Error after 2 s against the step.
#[must_use]
pub fn chart() -> Chart {
    let places = halved_steps();
    Chart {
        name: "erratum_09",
        title: "Erratum 9: a thrown point after 2 s (scenario 1)".to_owned(),
        x: Axis::log("time step (s)"),
        y: Axis::log("distance from the exact place (m)"),
        series: vec![
            Series::of("printed start", Style::Printed, &places, |dt| {
                error_after_two_seconds(dt, true)
            }),
            Series::of("corrected start", Style::Corrected, &places, |dt| {
                error_after_two_seconds(dt, false)
            }),
            Series::of("½ g Δt t", Style::Theory, &places, |dt| {
                0.5 * 9.81 * dt * 2.0
            }),
        ],
    }
}
