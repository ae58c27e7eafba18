//! Erratum 3: constant ω between impulses is right for balls only. Euler's equations turn ω as the
//! body turns; leaving that out solves another problem, which no smaller step mends.
//!
//! Scenario 4 of the reference: a free box of 0.6 × 0.4 × 0.2 m, 1 kg, ω = (1, 2, 3) rad/s.

use ch00_maths::f64::{free_rotation, inertia, rotation};
use glam::{DQuat, DVec3};

use super::{angle_between, halved_steps};
use crate::chart::{Axis, Chart, Series, Style};

/// Half-extents of the box, m.
pub const HALF: DVec3 = DVec3::new(0.3, 0.2, 0.1);
/// Its angular velocity at the start, rad/s.
pub const OMEGA: DVec3 = DVec3::new(1.0, 2.0, 3.0);
/// Its exact attitude after 10 s (scenario 4, `04_free_top` of the reference).
pub const AFTER_10_S: DQuat = DQuat::from_xyzw(
    -0.106_057_607_8,
    -0.035_904_831_18,
    -0.914_239_544_2,
    0.389_395_278_3,
);

/// The attitude after `seconds` with ω held constant, the best that its idea can do.
#[must_use]
pub fn constant_omega(seconds: f64) -> DQuat {
    rotation::turned(DQuat::IDENTITY, OMEGA * seconds)
}

/// The attitude after `seconds` by the report's printed step, without drag.
#[must_use]
pub fn printed(seconds: f64, dt: f64) -> DQuat {
    let mut q = DQuat::IDENTITY;
    let mut q_last = rotation::printed::turned(q, -OMEGA * dt);
    for _ in 0..steps(seconds, dt) {
        let delta = rotation::log((q * q_last.conjugate()).normalize());
        q_last = q;
        q = rotation::printed::turned(q, delta);
    }
    q
}

/// The attitude after `seconds` by the splitting, from the angular momentum.
#[must_use]
pub fn splitting(seconds: f64, dt: f64) -> DQuat {
    let inertia = inertia::ori_box(1.0, HALF);
    let momentum = inertia * OMEGA;
    (0..steps(seconds, dt)).fold(DQuat::IDENTITY, |q, _| {
        free_rotation::attitude_after(q, inertia, momentum, dt)
    })
}

/// The same with nothing stored but q and q*: the momentum is read from them at each step.
#[must_use]
pub fn splitting_without_velocity(seconds: f64, dt: f64) -> Option<DQuat> {
    let inertia = inertia::ori_box(1.0, HALF);
    let mut q = DQuat::IDENTITY;
    let mut q_last = free_rotation::attitude_after(q, inertia, inertia * OMEGA, -dt);
    for _ in 0..steps(seconds, dt) {
        let momentum = free_rotation::momentum_of_turn(q_last, q, inertia, dt)?;
        q_last = q;
        q = free_rotation::attitude_after(q, inertia, momentum, dt);
    }
    Some(q)
}

/// How many steps fit into `seconds`.
#[must_use]
pub fn steps(seconds: f64, dt: f64) -> u32 {
    (seconds / dt).round() as u32
}

/// Rotation error after 10 s against the step.
#[must_use]
pub fn chart() -> Chart {
    let places = halved_steps();
    let error = |q| angle_between(q, AFTER_10_S);
    Chart {
        name: "erratum_03",
        title: "Erratum 3: a free box after 10 s (scenario 4)".to_owned(),
        x: Axis::log("time step (s)"),
        y: Axis::log("rotation error (rad)"),
        series: vec![
            Series::of("printed step", Style::Printed, &places, |dt| {
                error(printed(10.0, dt))
            }),
            Series::of(
                "constant ω, exact exponential",
                Style::Other(0),
                &places,
                |_| error(constant_omega(10.0)),
            ),
            Series::of("corrected: splitting", Style::Corrected, &places, |dt| {
                error(splitting(10.0, dt))
            }),
            Series::of("order 2", Style::Theory, &places, |dt| {
                3.145e-4 * (dt * 60.0) * (dt * 60.0)
            }),
        ],
    }
}
