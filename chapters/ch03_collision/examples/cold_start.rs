//! Exercise of the page on limits: sweeps over the supports of a tower, by hand, without an engine. What
//! does one sweep leave of the error, for a tower of equal bodies and for a heavy one on a light one?
//!
//! `cargo run --release -p ch03_collision --no-default-features --example cold_start`

use std::f64::consts::FRAC_PI_2;

/// Momentum that gravity gives to 1 kg in a step, N s.
const KICK: f64 = 9.81 / 60.0;

fn main() {
    println!("tower of            a sweep leaves   theory     sweeps to 1 %");
    for n in [2, 5, 10, 15, 30] {
        let theory = (FRAC_PI_2 / f64::from(n)).cos().powi(2);
        tell(&format!("{n} equal"), &vec![1.0; n as usize], theory);
    }
    for ratio in [10.0, 100.0, 1000.0] {
        tell(
            &format!("1 under {ratio}"),
            &[1.0, ratio],
            ratio / (ratio + 1.0),
        );
    }
}

fn tell(name: &str, masses: &[f64], theory: f64) {
    let (share, sweeps) = measure(masses);
    println!("{name:<19} {share:.8}       {theory:.8} {sweeps:8}");
}

/// What a late sweep leaves of the error, and how many sweeps leave 1 % of what there was at first.
fn measure(masses: &[f64]) -> (f64, u32) {
    let exact = |k: usize| masses[k..].iter().sum::<f64>() * KICK;
    let mut velocities: Vec<f64> = masses.iter().map(|_| -KICK).collect();
    let mut supports = vec![0.0; masses.len()];
    let error = |supports: &[f64]| {
        let off = |(k, support): (usize, &f64)| (support / exact(k) - 1.0).abs();
        supports.iter().enumerate().map(off).fold(0.0, f64::max)
    };
    let (mut share, mut last) = (0.0, 1.0);
    let mut sweeps_to_a_percent = None;
    for sweep in 1..=20_000 {
        sweep_once(masses, &mut velocities, &mut supports);
        let now = error(&supports);
        if now < 1e-9 {
            break;
        }
        (share, last) = (now / last, now);
        if now <= 0.01 && sweeps_to_a_percent.is_none() {
            sweeps_to_a_percent = Some(sweep);
        }
    }
    (share, sweeps_to_a_percent.unwrap_or(0))
}

// ANCHOR: sweep_once
/// Support k is between body k − 1 (the ground for 0) and body k: it stops what still approaches.
fn sweep_once(masses: &[f64], velocities: &mut [f64], supports: &mut [f64]) {
    for k in 0..masses.len() {
        let (below, weight_below) = if k == 0 {
            (0.0, 0.0)
        } else {
            (velocities[k - 1], 1.0 / masses[k - 1])
        };
        let weight = 1.0 / masses[k];
        let approach = velocities[k] - below;
        let support = (supports[k] - approach / (weight + weight_below)).max(0.0);
        let change = support - supports[k];
        supports[k] = support;
        velocities[k] += change * weight;
        if k > 0 {
            velocities[k - 1] -= change * weight_below;
        }
    }
}
// ANCHOR_END: sweep_once
