//! Erratum 11: f = 1 − ΔtF makes the drag depend on the frame rate; F is a rate, so f = exp(−FΔt).
//!
//! What is left of a velocity after 1 s at the report's F = 0.25/s, and at F = 5/s, where a slow frame
//! turns the printed factor negative.

use ch00_maths::f64::drag;

use super::gyroscopic::steps;
use crate::chart::{Axis, Chart, Series, Style};

/// Share of a velocity that is left after 1 s at `rate` per second, with this many frames a second.
#[must_use]
pub fn left_after_a_second(rate: f64, frames: f64, printed: bool) -> f64 {
    let dt = 1.0 / frames;
    let kept = if printed {
        drag::printed::kept(rate, dt)
    } else {
        drag::kept(rate, dt)
    };
    (0..steps(1.0, dt)).fold(1.0, |left, _| left * kept)
}

/// Error of what is left against the frame rate.
#[must_use]
pub fn chart() -> Chart {
    let frames: Vec<f64> = [4, 5, 8, 10, 15, 20, 30, 60, 120, 240]
        .map(f64::from)
        .to_vec();
    let error = |rate: f64, n: f64, printed: bool| {
        (left_after_a_second(rate, n, printed) / (-rate).exp() - 1.0).abs()
    };
    Chart {
        name: "erratum_11",
        title: "Erratum 11: error of the speed left after 1 s of drag".to_owned(),
        x: Axis::log("frames per second"),
        y: Axis::log("relative error"),
        series: vec![
            Series::of("printed, F = 0.25/s", Style::Printed, &frames, |n| {
                error(0.25, n, true)
            }),
            Series::of("printed, F = 5/s", Style::Other(0), &frames, |n| {
                error(5.0, n, true)
            }),
            Series::of("corrected, F = 5/s", Style::Corrected, &frames, |n| {
                error(5.0, n, false)
            }),
        ],
    }
}
