//! The report's twelve errata, each as an experiment: what the printed formula gives, what the
//! corrected one gives, and what is right. The tests hold the numbers, the charts draw them.
//!
//! All in f64 with the book's own functions, except the twelfth, which is about f32.

pub mod contact_arm;
pub mod drag;
pub mod first_order;
pub mod frame_of_turn;
pub mod gyroscopic;
pub mod pin;
pub mod shares;
pub mod sign;
pub mod spin_alias;
pub mod stall;
pub mod start_up;
pub mod uneven_steps;

use glam::DQuat;

use crate::chart::Chart;

/// One erratum.
#[derive(Clone, Copy)]
pub struct Erratum {
    /// As the book numbers it.
    pub number: u32,
    /// What is wrong, in a few words.
    pub title: &'static str,
    /// Measures it.
    pub chart: fn() -> Chart,
}

/// All of them, in the book's order.
pub const ERRATA: [Erratum; 12] = [
    entry(1, "r₁ where r₂ belongs", contact_arm::chart),
    entry(
        2,
        "s₁ and s₂ scale the impulse once too often",
        shares::chart,
    ),
    entry(3, "no gyroscopic term", gyroscopic::chart),
    entry(
        4,
        "a world vector applied in the body's frame",
        frame_of_turn::chart,
    ),
    entry(5, "a first-order update loses spin", first_order::chart),
    entry(6, "the pin's cross product after the inertia", pin::chart),
    entry(7, "the sign of C for body 2", sign::chart),
    entry(8, "steps of different length", uneven_steps::chart),
    entry(9, "half a step off at the start", start_up::chart),
    entry(10, "fast spin is read as slow", spin_alias::chart),
    entry(11, "drag that depends on the frame rate", drag::chart),
    entry(12, "f32 differences that never fall", stall::chart),
];

const fn entry(number: u32, title: &'static str, chart: fn() -> Chart) -> Erratum {
    Erratum {
        number,
        title,
        chart,
    }
}

/// The angle between two attitudes, rad.
#[must_use]
pub fn angle_between(a: DQuat, b: DQuat) -> f64 {
    let d = a.conjugate() * b;
    2.0 * glam::DVec3::new(d.x, d.y, d.z).length().atan2(d.w.abs())
}

/// 1/30, 1/60 … 1/1920 s.
#[must_use]
pub fn halved_steps() -> Vec<f64> {
    (0..7).map(|k| 1.0 / (30.0 * f64::from(1 << k))).collect()
}
