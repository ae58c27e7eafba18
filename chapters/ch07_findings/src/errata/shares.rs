//! Erratum 2: J already accounts for both masses, so each body gets the whole C/m; the shares
//! s₁ = m₂/(m₁ + m₂) and s₂ scale it once too often.
//!
//! Two balls meet head-on. With the shares, momentum is lost unless the masses are equal, and even
//! then only half of the impulse arrives.

use ch00_maths::f64::impulse::{self, Mass, Velocity};
use ch00_maths::f64::inertia;
use glam::{DQuat, DVec3};

use crate::chart::{Axis, Chart, Series, Style};

/// What a head-on impact leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// |ΔP| over Σ|m v| before.
    pub momentum_error: f64,
    /// Speed after over speed before: e if all is right.
    pub restitution: f64,
    /// Velocities after, m/s.
    pub velocities: [f64; 2],
}

/// Balls of m₁ and m₂ kg with v₁ and v₂ m/s along n̂, which points from 2 to 1.
#[must_use]
pub fn head_on(masses: [f64; 2], speeds: [f64; 2], e: f64, printed: bool) -> Outcome {
    let n = DVec3::NEG_X;
    let body = masses.map(|m| Mass::new(1.0 / m, inertia::sphere(m, 0.1).recip(), DQuat::IDENTITY));
    let before = speeds.map(|v| Velocity {
        v: DVec3::X * v,
        omega: DVec3::ZERO,
    });
    let arm = [-0.1 * n, 0.1 * n];
    let approach = impulse::relative_velocity(before[0], arm[0], before[1], arm[1]).dot(n);
    let response = impulse::response(&body[0], arm[0], &body[1], arm[1], n);
    let c = impulse::magnitude(approach, e, response) * n;
    let (s1, s2) = if printed {
        impulse::printed::shares(&body[0], &body[1])
    } else {
        (1.0, 1.0)
    };
    let after = [
        impulse::applied(before[0], &body[0], arm[0], s1 * c),
        impulse::applied(before[1], &body[1], arm[1], -s2 * c),
    ];
    let momentum = |v: [f64; 2]| masses[0] * v[0] + masses[1] * v[1];
    let velocities = after.map(|velocity| velocity.v.x);
    let size = masses[0] * speeds[0].abs() + masses[1] * speeds[1].abs();
    Outcome {
        momentum_error: (momentum(velocities) - momentum(speeds)).abs() / size,
        restitution: (velocities[0] - velocities[1]) / (speeds[1] - speeds[0]),
        velocities,
    }
}

/// Momentum lost against the ratio of the masses.
#[must_use]
pub fn chart() -> Chart {
    let ratios: Vec<f64> = (-16..=16).map(|k| 2f64.powf(0.25 * f64::from(k))).collect();
    let error = |ratio, printed| head_on([1.0, ratio], [1.0, -1.0], 0.8, printed).momentum_error;
    Chart {
        name: "erratum_02",
        title: "Erratum 2: momentum lost in one head-on impact".to_owned(),
        x: Axis::log("m₂ / m₁"),
        y: Axis::log("|ΔP| / Σ|m v|"),
        series: vec![
            Series::of(
                "printed: C shared by s₁ and s₂",
                Style::Printed,
                &ratios,
                |r| error(r, true),
            ),
            Series::of("corrected", Style::Corrected, &ratios, |r| error(r, false)),
        ],
    }
}
