//! Erratum 6: for body 2 the report prints M(q₂, I₂, t₂) × −D, which takes the cross product after
//! the inertia; it must be M(q₂, I₂, t₂ × −D).
//!
//! Two rods, pinned end to end and pulled apart by 1 cm at an angle: how much of the gap is left after
//! some corrections.

use ch00_maths::f64::impulse::Mass;
use ch00_maths::f64::inertia;
use ch00_maths::f64::pin::{self, Pose};
use glam::{DQuat, DVec3};

use crate::chart::{Axis, Chart, Series, Style};

/// The gap at the start, m.
pub const GAP: f64 = 0.01;

/// Gap after some corrections over the gap before, for a gap at `angle` rad from the rods' axis.
///
/// One correction closes the gap along itself; rods answer differently along and across, so it opens
/// another across, which the next corrections close.
#[must_use]
pub fn gap_left(angle: f64, corrections: u32, printed: bool) -> f64 {
    let half = DVec3::new(0.3, 0.05, 0.05);
    let moments = inertia::ori_box(1.0, half);
    let pose = |p| Pose {
        p,
        q: DQuat::IDENTITY,
    };
    let apart = GAP * DVec3::new(angle.cos(), angle.sin(), 0.0);
    let mut poses = [pose(DVec3::ZERO), pose(DVec3::X * 0.6 + apart)];
    let offsets = [DVec3::X * 0.3, DVec3::X * -0.3];
    let arms = |poses: [Pose; 2]| [poses[0].q * offsets[0], poses[1].q * offsets[1]];
    let gap = |poses: [Pose; 2]| {
        let t = arms(poses);
        (poses[0].p + t[0]) - (poses[1].p + t[1])
    };
    for _ in 0..corrections {
        let masses = poses.map(|pose| Mass::new(1.0, moments.recip(), pose.q));
        let t = arms(poses);
        let d = pin::correction(&masses[0], t[0], &masses[1], t[1], gap(poses));
        let second = if printed {
            pin::printed::applied_to_second(poses[1], &masses[1], t[1], d)
        } else {
            pin::applied(poses[1], &masses[1], t[1], -d)
        };
        poses = [pin::applied(poses[0], &masses[0], t[0], d), second];
    }
    gap(poses).length() / GAP
}

/// Gap left against the number of corrections.
#[must_use]
pub fn chart() -> Chart {
    let corrections: Vec<f64> = (0..=20).map(f64::from).collect();
    let left = |n: f64, printed| gap_left(45f64.to_radians(), n as u32, printed);
    Chart {
        name: "erratum_06",
        title: "Erratum 6: two pinned rods, 1 cm apart at 45° to their axis".to_owned(),
        x: Axis::linear("corrections made"),
        y: Axis::log("gap / gap at the start"),
        series: vec![
            Series::of(
                "printed: M(q₂, I₂, t₂) × −D",
                Style::Printed,
                &corrections,
                |n| left(n, true),
            ),
            Series::of(
                "corrected: M(q₂, I₂, t₂ × −D)",
                Style::Corrected,
                &corrections,
                |n| left(n, false),
            ),
        ],
    }
}
