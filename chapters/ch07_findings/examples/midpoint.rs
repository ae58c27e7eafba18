//! The answer to an exercise of the page on findings: the explicit midpoint rule for a body that is alone,
//! in attitude and angular momentum, on the top of scenario 4. What was measured elsewhere is 5.12e-3 rad after
//! 10 s at 60 Hz, and it is of second order.
//!
//! `cargo run --release -p ch07_findings --example midpoint`

use ch00_maths::f64::rotation::{moment, turned};
use glam::{DQuat, DVec3};

const INERTIA: DVec3 = DVec3::new(1.0 / 60.0, 1.0 / 30.0, 13.0 / 300.0);
/// After 10 s, by the elliptic functions.
const EXACT: DQuat = DQuat::from_xyzw(
    -0.106_057_607_8,
    -0.035_904_831_18,
    -0.914_239_544_2,
    0.389_395_278_3,
);

fn main() {
    let momentum = INERTIA * DVec3::new(1.0, 2.0, 3.0);
    println!("steps a second   error after 10 s, rad");
    for rate in [30, 60, 120, 240] {
        let h = 1.0 / f64::from(rate);
        let mut q = DQuat::IDENTITY;
        for _ in 0..10 * rate {
            // Half a step with the spin at its start, a whole one with the spin half-way.
            let half = turned(q, spin(q, momentum) * (0.5 * h));
            q = turned(q, spin(half, momentum) * h);
        }
        let off = q * EXACT.conjugate();
        let error = 2.0 * off.xyz().length().atan2(off.w.abs());
        println!("{rate:>14}   {error:.2e}");
    }
}

/// The spin, rad/s, of a body with this angular momentum in the world.
fn spin(q: DQuat, momentum: DVec3) -> DVec3 {
    moment(q, INERTIA.recip(), momentum)
}
