//! Erratum 4: Δq comes from q q̄*, so it is a world vector and belongs on the left of q; the
//! report multiplies it from the right, where body vectors belong.
//!
//! A ball whose axes are tilted about x turns about the world's y. Printed, it turns about its own
//! y instead, so the axis is off by the whole tilt.

use ch00_maths::f64::rotation;
use glam::{DQuat, DVec3};

use super::angle_between;
use crate::chart::{Axis, Chart, Series, Style};

/// The angle, rad, between the attitude after turning by 1 rad about the world's y in 60 steps and the
/// exact one, for a body tilted by `tilt` rad about x.
#[must_use]
pub fn error(tilt: f64, printed: bool) -> f64 {
    let start = rotation::exp(DVec3::X * tilt);
    let delta = DVec3::Y / 60.0;
    let mut q = start;
    for _ in 0..60 {
        q = if printed {
            rotation::printed::turned(q, delta)
        } else {
            rotation::turned(q, delta)
        };
    }
    angle_between(q, rotation::exp(DVec3::Y) * start)
}

/// What theory says of the printed formula: the angle between a turn by 1 rad about y and one about
/// the tilted y.
#[must_use]
pub fn predicted(tilt: f64) -> f64 {
    let tilted = DQuat::from_axis_angle(DVec3::X, tilt) * DVec3::Y;
    angle_between(rotation::exp(tilted), rotation::exp(DVec3::Y))
}

/// Error against tilt.
#[must_use]
pub fn chart() -> Chart {
    let tilts: Vec<f64> = (0..=36).map(|k| 5.0 * f64::from(k)).collect();
    Chart {
        name: "erratum_04",
        title: "Erratum 4: attitude after turning by 1 rad about the world's y".to_owned(),
        x: Axis::linear("tilt of the body before it turns (degrees)"),
        y: Axis::linear("rotation error (rad)"),
        series: vec![
            Series::of(
                "printed: q + q quat[0, ½Δq]",
                Style::Printed,
                &tilts,
                |d| error(d.to_radians(), true),
            ),
            Series::of("corrected: exp(Δq) q", Style::Corrected, &tilts, |d| {
                error(d.to_radians(), false)
            }),
            Series::of("theory", Style::Theory, &tilts, |d| {
                predicted(d.to_radians())
            }),
        ],
    }
}
