//! Exercise 2 of chapter 2: the free box of scenario 4 by splitting, with the axes in each of the
//! six orders. The error after 10 s, and its order in the step.
//!
//! `cargo run --release -p ch02_rigid_bodies --example axis_order`

use ch00_maths::f64::inertia;
use glam::{DQuat, DVec3};

const HALF_EXTENTS: DVec3 = DVec3::new(0.3, 0.2, 0.1);
const OMEGA: DVec3 = DVec3::new(1.0, 2.0, 3.0);
/// `04_free_top` of the reference after 10 s.
const EXACT: DQuat = DQuat::from_xyzw(
    -0.106_057_607_8,
    -0.035_904_831_18,
    -0.914_239_544_2,
    0.389_395_278_3,
);
const AXES: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];

/// One step of `dt`: half, half, whole, half, half.
fn step(q: DQuat, moments: DVec3, momentum: DVec3, order: [usize; 3], dt: f64) -> DQuat {
    let [first, second, third] = order;
    let mut q = q;
    for (axis, part) in [
        (first, 0.5),
        (second, 0.5),
        (third, 1.0),
        (second, 0.5),
        (first, 0.5),
    ] {
        let pi = q.conjugate() * momentum;
        q *= DQuat::from_axis_angle(AXES[axis], part * dt * pi[axis] / moments[axis]);
    }
    q.normalize()
}

/// Angle from the exact attitude after 10 s, rad.
fn error(order: [usize; 3], rate: u32) -> f64 {
    let moments = inertia::ori_box(1.0, HALF_EXTENTS);
    let dt = 1.0 / f64::from(rate);
    let q = (0..10 * rate).fold(DQuat::IDENTITY, |q, _| {
        step(q, moments, moments * OMEGA, order, dt)
    });
    2.0 * (q.conjugate() * EXACT).xyz().length().asin()
}

fn main() {
    println!("order  at 60 Hz     at 120 Hz    ratio");
    for order in [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ] {
        let name: String = order.map(|axis| ['x', 'y', 'z'][axis]).iter().collect();
        let (coarse, fine) = (error(order, 60), error(order, 120));
        println!(
            "{name}    {coarse:.1e} rad  {fine:.1e} rad  {:.2}",
            coarse / fine
        );
    }
}
