//! Erratum 12, a limit rather than a slip: in f32 a position can't change by less than half the
//! distance to the next number. High enough, and g h² is lost whole (scenario 3).
//!
//! fl(y − g h²) = y when g h² < 2^(⌊log₂ y⌋ − 24), with h = (1/60 s)/substeps.

use ch00_maths::f32::verlet;
use glam::Vec3;

use crate::chart::{Axis, Chart, Series, Style};

/// How far a body at rest at the height `y` falls in 1 s, over ½ g t².
#[must_use]
pub fn fall(y: f32, substeps: u32) -> f64 {
    let h = 1.0 / (60.0 * substeps as f32);
    let g = Vec3::new(0.0, -9.81, 0.0);
    let (mut p, mut p_last) = (Vec3::Y * y, Vec3::Y * y);
    for _ in 0..60 * substeps {
        let moved = verlet::printed::displacement(p, p_last, g, 1.0, h);
        p_last = p;
        p += moved;
    }
    f64::from(y - p.y) / (0.5 * 9.81)
}

/// The height above which a body at rest never falls, m.
#[must_use]
pub fn stalls_above(substeps: u32) -> f64 {
    let h = 1.0 / (60.0 * f64::from(substeps));
    2f64.powf((9.81 * h * h).log2().floor() + 25.0)
}

/// Fall against height for several numbers of substeps.
#[must_use]
pub fn chart() -> Chart {
    let heights: Vec<f64> = (2..=36)
        .map(|k| 1.1 * 2f64.powf(0.5 * f64::from(k)))
        .collect();
    let curve = |substeps: u32, style| {
        let stall = stalls_above(substeps);
        let name = format!("{substeps} substeps; theory: stalls above {stall} m");
        Series::of(&name, style, &heights, |y| fall(y as f32, substeps))
    };
    Chart {
        name: "erratum_12",
        title: "Erratum 12: fall in 1 s from rest, f32 positions".to_owned(),
        x: Axis::log("height (m)"),
        y: Axis::linear("fall / (½ g t²)"),
        series: vec![
            curve(1, Style::Corrected),
            curve(4, Style::Other(0)),
            curve(20, Style::Printed),
            Series::of("exact", Style::Theory, &heights, |_| 1.0),
        ],
    }
}
