//! 7: who reads the spin that there is. A turn that is read from two attitudes is right up to half a turn a step.

use std::f64::consts::PI;

use super::{Map, Who, thinned};
use crate::chart::{Axis, Class};
use crate::laboratory::scenario::timed;
use crate::laboratory::scenarios::{fast_spin, spin_kept};

/// As far as a spin may be off, as a share.
const HELD: f64 = 0.01;
/// When it is read, s.
const SECONDS: f64 = 0.1;

pub const MAP: Map = Map {
    number: "7",
    name: "aliasing",
    title: "Who reads the spin that there is",
    value: "error of the spin after 0.1 s, as a share of it",
    axes: || {
        [
            Axis::linear("spin (rad/s)"),
            Axis::log("steps a second (1/s)"),
        ]
    },
    grid: |quick| {
        let spins = (1..=20).map(|k| 20.0 * f64::from(k));
        let rates = [
            20.0, 30.0, 40.0, 60.0, 80.0, 120.0, 160.0, 240.0, 320.0, 480.0, 640.0, 960.0, 1280.0,
            1920.0,
        ];
        [spins.collect(), rates.to_vec()].map(|all| thinned(all, quick))
    },
    bounds: [HELD, 0.5],
    classes: ["within 1 %", "up to half of it is missing", "another spin"],
    better_upwards: true,
    theory: "half a turn a step; of rapier an eighth; of printed and xpbd, 1 % is lost",
    who: || {
        let half = |spin: f64| spin / PI;
        let lossy = |who: Who, of: fn(f64) -> f64| who.law(Class::Held, of);
        let mut all: Vec<Who> = Who::all(["printed"])
            .map(|who| lossy(who, |spin| loss(spin, 6.0, 1.0)).line(half))
            .collect();
        all.extend(Who::all(["corrected"]).map(|who| who.law(Class::Held, half)));
        all.extend(Who::all(["xpbd"]).map(|who| lossy(who, |spin| loss(spin, 4.0, 20.0))));
        let eighth = |spin: f64| (1.0 - HELD) * spin / (0.25 * PI);
        let capped = Who::all(["rapier", "rapier tuned"]);
        all.extend(capped.map(|who| who.law(Class::Held, eighth)));
        all.extend(Who::all([
            "sequential-impulses",
            "soft-step",
            "own-row",
            "coloured",
        ]));
        all
    },
    scene: |spin, rate, _| Ok(timed(spin_kept::spinning(spin), rate as u32, SECONDS)),
    watcher: |scene, _, _| Box::new(fast_spin::spin_read(scene)),
};

/// The rate from which on a turn to first order in so many parts of a step loses 1 % at most. n parts of h s leave
/// 1/√(1 + n (ω h)²/k). Where the spin is read by the sine of half the angle, as in scenario 6, k = 4; where it is
/// read by the angle, a part takes ω to 2 arctan(ω h/2)/h, and k = 6 for small angles.
fn loss(spin: f64, k: f64, parts: f64) -> f64 {
    let room = (1.0 - HELD).powi(-2) - 1.0;
    let h = k * room / (SECONDS * spin * spin);
    (parts * h).recip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_loss_is_that_of_scenario_6() {
        // 60 Hz in one substep for one second leave 8.401680504 of 10 rad/s.
        let n_h = |h: f64, seconds: f64| seconds / h * (10.0 * h / 2.0).powi(2);
        let left = 10.0 / (1.0 + n_h(1.0 / 60.0, 1.0)).sqrt();
        assert!((left - 8.401_680_504).abs() < 1e-9, "{left}");
        let h = (20.0 * loss(10.0, 4.0, 20.0)).recip();
        assert!(((1.0 + n_h(h, SECONDS)).powf(-0.5) - 0.99).abs() < 1e-12);
    }

    #[test]
    fn a_spin_that_is_read_by_the_angle_loses_two_thirds_as_much() {
        let (rate, steps) = (330.0, 33);
        let spin = (0..steps).fold(20.0, |spin: f64, _| 2.0 * rate * (0.5 * spin / rate).atan());
        let left = (1.0 + f64::from(steps) * (20.0 / rate).powi(2) / 6.0).powf(-0.5);
        assert!((spin / 20.0 - left).abs() < 1e-5, "{spin}");
        assert!((loss(20.0, 6.0, 1.0) - 328.3).abs() < 0.1);
    }
}
