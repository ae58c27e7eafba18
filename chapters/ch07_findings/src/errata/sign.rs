//! Erratum 7: the second set of formulas in 8.4.2 gives body 2 the impulse +s₂C; the first set, and
//! Newton's third law, give it −s₂C.
//!
//! Two balls meet head-on, with the sign as listed and everything else right.

use ch00_maths::f64::impulse::{self, Mass, Velocity};
use ch00_maths::f64::inertia;
use glam::{DQuat, DVec3};

use crate::chart::{Axis, Chart, Series, Style};

/// Speeds of approach after an impact with e = 0.8 of balls of m₁ = 1 and m₂ = `ratio` kg at ±1 m/s:
/// negative where they part, as they must.
#[must_use]
pub fn approach_after(ratio: f64, printed: bool) -> f64 {
    let n = DVec3::NEG_X;
    let masses =
        [1.0, ratio].map(|m| Mass::new(1.0 / m, inertia::sphere(m, 0.1).recip(), DQuat::IDENTITY));
    let moving = [1.0, -1.0].map(|v| Velocity {
        v: DVec3::X * v,
        omega: DVec3::ZERO,
    });
    let arm = [-0.1 * n, 0.1 * n];
    let speed = |m: [Velocity; 2]| impulse::relative_velocity(m[0], arm[0], m[1], arm[1]).dot(n);
    let response = impulse::response(&masses[0], arm[0], &masses[1], arm[1], n);
    let c = impulse::magnitude(speed(moving), 0.8, response) * n;
    let first = impulse::applied(moving[0], &masses[0], arm[0], c);
    let second = if printed {
        impulse::printed::applied(moving[1], &masses[1], arm[1], 1.0, c)
    } else {
        impulse::applied(moving[1], &masses[1], arm[1], -c)
    };
    -speed([first, second])
}

/// Approach after the impact against the ratio of masses.
#[must_use]
pub fn chart() -> Chart {
    let ratios: Vec<f64> = (-16..=16).map(|k| 2f64.powf(0.25 * f64::from(k))).collect();
    Chart {
        name: "erratum_07",
        title: "Erratum 7: speed of approach after an impact, 2 m/s before, e = 0.8".to_owned(),
        x: Axis::log("m₂ / m₁"),
        y: Axis::linear("speed of approach after (m/s)"),
        series: vec![
            Series::of("printed: +C for body 2", Style::Printed, &ratios, |r| {
                approach_after(r, true)
            }),
            Series::of("corrected: −C", Style::Corrected, &ratios, |r| {
                approach_after(r, false)
            }),
            Series::of("−e times 2 m/s", Style::Theory, &ratios, |_| -1.6),
        ],
    }
}
