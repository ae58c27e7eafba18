//! Exercise 1 of chapter 4: a pin is visited again and again, with the report's one number and with
//! the matrix. How much of the gap does each visit leave?
//!
//! `cargo run --release -p ch04_ragdolls --no-default-features --example scalar_or_matrix`

use ch00_maths::f64::impulse::Mass;
use ch00_maths::f64::inertia;
use ch00_maths::f64::joint::pin_matrix;
use ch00_maths::f64::pin::{Pose, applied, correction};
use glam::{DQuat, DVec3};

/// From the rod's centre to the pin at its end, m. The rod is thin and lies along x.
const ARM: DVec3 = DVec3::X;

/// The gap of a rod of 1 kg that should hang on the origin by its end: 1 mm along it, 1 mm across.
const GAP: DVec3 = DVec3::new(1e-3, 1e-3, 0.0);

/// A body that nothing moves.
const POST: Mass = Mass {
    inverse_mass: 0.0,
    inverse_inertia: glam::DMat3::ZERO,
};

fn mass(q: DQuat) -> Mass {
    let moments = inertia::ori_box(1.0, DVec3::new(1.0, 0.01, 0.01));
    Mass::new(1.0, moments.recip(), q)
}

/// The gaps, m, before each of six visits.
fn gaps(impulse: impl Fn(&Mass, DVec3, DVec3) -> DVec3) -> Vec<DVec3> {
    let mut rod = Pose {
        p: GAP - ARM,
        q: DQuat::IDENTITY,
    };
    (0..6)
        .map(|_| {
            let (mass, t) = (mass(rod.q), rod.q * ARM);
            let gap = rod.p + t;
            rod = applied(rod, &mass, t, impulse(&mass, t, gap));
            gap
        })
        .collect()
}

fn main() {
    let by_number = gaps(|mass, t, gap| correction(mass, t, &POST, DVec3::ZERO, gap));
    let by_matrix = gaps(|mass, t, gap| pin_matrix(mass, t, &POST, DVec3::ZERO).inverse() * -gap);
    println!("visits  one number: along, across  matrix: along, across  (mm)");
    for (visits, (a, b)) in by_number.iter().zip(&by_matrix).enumerate() {
        // In millimetres, to a thousandth; and no −0.
        let [a, b] = [a, b].map(|gap| (1e6 * *gap).round() / 1e3 + DVec3::ZERO);
        println!(
            "{visits:6}  {:17.3}  {:6.3}  {:13.3}  {:6.3}",
            a.x, a.y, b.x, b.y
        );
    }
}
