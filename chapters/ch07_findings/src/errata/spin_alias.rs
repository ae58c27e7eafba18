//! Erratum 10, a limit rather than a slip: two attitudes don't tell how often the body went round
//! between them. Beyond |ω|Δt = π the reading is ω − 2πk/Δt (scenario 7).

use ch00_maths::f64::rotation;
use glam::{DQuat, DVec3};

use crate::chart::{Axis, Chart, Series, Style};

/// The step, s.
pub const DT: f64 = 1.0 / 60.0;

/// ω(q, q*) of a body that turns with `omega` rad/s, rad/s.
#[must_use]
pub fn reading(omega: f64) -> f64 {
    let q = rotation::exp(DVec3::Z * omega * DT);
    rotation::angular_velocity(q, DQuat::IDENTITY, DT).z
}

/// Reading against spin.
#[must_use]
pub fn chart() -> Chart {
    let spins: Vec<f64> = (0..=100).map(|k| 4.0 * f64::from(k)).collect();
    let wrap = std::f64::consts::TAU / DT;
    Chart {
        name: "erratum_10",
        title: "Erratum 10: spin read from two attitudes 1/60 s apart".to_owned(),
        x: Axis::linear("spin (rad/s)"),
        y: Axis::linear("reading (rad/s)"),
        series: vec![
            Series::of("ω(q, q*)", Style::Printed, &spins, reading),
            Series::of("ω − 2πk/Δt", Style::Theory, &spins, |w| {
                w - wrap * (w / wrap).round()
            }),
            Series::of("stored ω (chapter 6)", Style::Corrected, &spins, |w| w),
        ],
    }
}
