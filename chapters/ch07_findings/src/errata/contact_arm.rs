//! Erratum 1: v_c2 = v₂ + ω₂ × r₁ must be v₂ + ω₂ × r₂.
//!
//! A rod at rest is struck from below at one end by a ball that comes with 1 m/s, while the rod
//! turns. The report reads the speed of the wrong point, so the impulse is off, and the bodies
//! don't part with e times the speed of their approach.

use ch00_maths::f64::impulse::{self, Mass, Velocity};
use ch00_maths::f64::inertia;
use glam::{DQuat, DVec3};

use crate::chart::{Axis, Chart, Series, Style};

/// Restitution of the pair.
pub const RESTITUTION: f64 = 0.5;

/// The ratio of the speeds after and before an impact `arm` metres from the rod's centre, for a rod
/// that turns with 3 rad/s; e if all is right.
#[must_use]
pub fn restitution_reached(arm: f64, printed: bool) -> f64 {
    let ball = Mass::new(1.0, inertia::sphere(1.0, 0.1).recip(), DQuat::IDENTITY);
    let half = DVec3::new(0.6, 0.05, 0.05);
    let rod = Mass::new(0.5, inertia::ori_box(2.0, half).recip(), DQuat::IDENTITY);
    // n̂ points from body 2, the rod, down to body 1, the ball.
    let n = DVec3::NEG_Y;
    let r1 = DVec3::new(0.0, 0.1, 0.0);
    let r2 = DVec3::new(arm, -0.05, 0.0);
    let before_1 = Velocity {
        v: DVec3::new(0.0, 1.0, 0.0),
        omega: DVec3::ZERO,
    };
    let before_2 = Velocity {
        v: DVec3::ZERO,
        omega: DVec3::new(0.0, 0.0, -3.0),
    };
    let seen = if printed {
        impulse::printed::relative_velocity(before_1, r1, before_2)
    } else {
        impulse::relative_velocity(before_1, r1, before_2, r2)
    };
    let response = impulse::response(&ball, r1, &rod, r2, n);
    let c = impulse::magnitude(seen.dot(n), RESTITUTION, response) * n;
    let after_1 = impulse::applied(before_1, &ball, r1, c);
    let after_2 = impulse::applied(before_2, &rod, r2, -c);
    let speed = |one, two| impulse::relative_velocity(one, r1, two, r2).dot(n);
    -speed(after_1, after_2) / speed(before_1, before_2)
}

/// Restitution reached against where the rod is struck.
#[must_use]
pub fn chart() -> Chart {
    let arms: Vec<f64> = (0..=24).map(|k| 0.025 * f64::from(k)).collect();
    Chart {
        name: "erratum_01",
        title: "Erratum 1: restitution that an impact reaches, e = 0.5 asked for".to_owned(),
        x: Axis::linear("distance of the contact from the rod's centre (m)"),
        y: Axis::linear("speed after / speed before"),
        series: vec![
            Series::of("printed: r₁ twice", Style::Printed, &arms, |arm| {
                restitution_reached(arm, true)
            }),
            Series::of("corrected", Style::Corrected, &arms, |arm| {
                restitution_reached(arm, false)
            }),
            Series::of("e", Style::Theory, &arms, |_| RESTITUTION),
        ],
    }
}
