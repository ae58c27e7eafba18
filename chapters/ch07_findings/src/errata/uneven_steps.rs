//! Erratum 8: p − p* is a displacement over the last step. If this step is longer or shorter, it
//! must be scaled by Δt/Δt*, and the acceleration counts with ½(Δt + Δt*)Δt.
//!
//! Scenario 2: a point thrown from (0, 10, 0) with (5, 8, 0) m/s, 2 s in uneven steps.

use ch00_maths::f64::verlet;
use glam::DVec3;

use crate::chart::{Axis, Chart, Series, Style};

const START: DVec3 = DVec3::new(0.0, 10.0, 0.0);
const VELOCITY: DVec3 = DVec3::new(5.0, 8.0, 0.0);
const GRAVITY: DVec3 = DVec3::new(0.0, -9.81, 0.0);

/// Which rule makes the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Δp = (p − p*) + a Δt².
    Printed,
    /// Δp = (p − p*) Δt/Δt* + a Δt²: the widely copied half of the correction.
    RatioOnly,
    /// Δp = (p − p*) Δt/Δt* + ½ a (Δt + Δt*) Δt.
    Corrected,
}

/// Set-up A: 1/60 and 1/30 s in turn, forty times.
#[must_use]
pub fn alternating() -> Vec<f64> {
    (0..80)
        .map(|k| if k % 2 == 0 { 1.0 / 60.0 } else { 1.0 / 30.0 })
        .collect()
}

/// Set-up B: 1/60 s throughout, but for one hitch of 0.1 s after one second.
#[must_use]
pub fn hitch() -> Vec<f64> {
    let mut steps = vec![1.0 / 60.0; 60];
    steps.push(0.1);
    steps.extend([1.0 / 60.0; 54]);
    steps
}

/// The error p − p(t), m, after each of `steps`, with the time, s.
#[must_use]
pub fn errors(rule: Rule, steps: &[f64]) -> Vec<(f64, DVec3)> {
    let mut p = START;
    let mut p_last = verlet::last_position(p, VELOCITY, GRAVITY, steps[0]);
    let (mut dt_last, mut t) = (steps[0], 0.0);
    let mut out = Vec::with_capacity(steps.len());
    for &dt in steps {
        let moved = match rule {
            Rule::Printed => verlet::printed::displacement(p, p_last, GRAVITY, 1.0, dt),
            Rule::RatioOnly => (p - p_last) * (dt / dt_last) + GRAVITY * dt * dt,
            Rule::Corrected => verlet::displacement(p, p_last, GRAVITY, 1.0, dt, dt_last),
        };
        p_last = p;
        p += moved;
        dt_last = dt;
        t += dt;
        let exact = START + VELOCITY * t + 0.5 * GRAVITY * t * t;
        out.push((t, p - exact));
    }
    out
}

/// Distance from the exact path against time, with one hitch.
#[must_use]
pub fn chart() -> Chart {
    let curve = |name: &str, style, rule| {
        let errors = errors(rule, &hitch());
        let some = errors.iter().step_by(3);
        Series::new(name, style, some.map(|(t, error)| (*t, error.length())))
    };
    Chart {
        name: "erratum_08",
        title: "Erratum 8: a thrown point, one hitch of 0.1 s after 1 s".to_owned(),
        x: Axis::linear("time (s)"),
        y: Axis::log("distance from the exact path (m)"),
        series: vec![
            curve("printed", Style::Printed, Rule::Printed),
            curve("scaled by Δt/Δt* only", Style::Other(0), Rule::RatioOnly),
            curve("corrected", Style::Corrected, Rule::Corrected),
        ],
    }
}
