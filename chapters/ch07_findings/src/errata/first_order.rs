//! Erratum 5: norm(q + ½ quat[0, Δq] q) turns by 2 atan(½|Δq|), not by |Δq|. The next step reads
//! the smaller angle, so spin fades without any drag.
//!
//! A ball at 10 rad/s for 1 s. With the report's logarithm a step maps ω to 2 atan(½ω Δt)/Δt; with the
//! reading of XPBD, 2 vec(q q̄*)/Δt, it maps it to ω/√(1 + (½ω Δt)²) (scenario 6).

use ch00_maths::f64::rotation;
use glam::{DQuat, DVec3};

use super::gyroscopic::steps;
use super::halved_steps;
use crate::chart::{Axis, Chart, Series, Style};

/// rad/s at the start.
pub const OMEGA: f64 = 10.0;

/// How a spin is kept and read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    /// First-order update, logarithm.
    FirstOrderLog,
    /// First-order update, chord: XPBD.
    FirstOrderChord,
    /// Exponential, logarithm.
    Exponential,
}

/// The spin after 1 s, rad/s.
#[must_use]
pub fn spin_after_a_second(update: Update, dt: f64) -> f64 {
    let mut q = DQuat::IDENTITY;
    let mut omega = DVec3::Z * OMEGA;
    for _ in 0..steps(1.0, dt) {
        let q_last = q;
        q = match update {
            Update::Exponential => rotation::turned(q, omega * dt),
            _ => rotation::turned_first_order(q, omega * dt),
        };
        let turn = (q * q_last.conjugate()).normalize();
        omega = match update {
            Update::FirstOrderChord => 2.0 * DVec3::new(turn.x, turn.y, turn.z) / dt,
            _ => rotation::log(turn) / dt,
        };
    }
    omega.z
}

/// Spin lost against the step.
#[must_use]
pub fn chart() -> Chart {
    let places = halved_steps();
    let lost = |update, dt| (1.0 - spin_after_a_second(update, dt) / OMEGA).max(0.0);
    Chart {
        name: "erratum_05",
        title: "Erratum 5: spin lost in 1 s, 10 rad/s, nothing slows it".to_owned(),
        x: Axis::log("time step (s)"),
        y: Axis::log("share of the spin lost"),
        series: vec![
            Series::of("printed update, logarithm", Style::Printed, &places, |dt| {
                lost(Update::FirstOrderLog, dt)
            }),
            Series::of(
                "printed update, chord (XPBD)",
                Style::Other(0),
                &places,
                |dt| lost(Update::FirstOrderChord, dt),
            ),
            Series::of("corrected: exponential", Style::Corrected, &places, |dt| {
                lost(Update::Exponential, dt)
            }),
            Series::of("law for the chord", Style::Theory, &places, |dt| {
                let x = 0.5 * OMEGA * dt;
                1.0 - 1.0 / (1.0 + x * x / dt).sqrt()
            }),
        ],
    }
}
