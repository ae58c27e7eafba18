//! How many of a thousand turns can't be read back, by shape and by size of the turn: momenta in
//! all directions, each turned forward by a step and read from the two attitudes.
//!
//! `cargo run --release -p ch02_rigid_bodies --example unread_turns`

use ch00_maths::f32::{free_rotation, inertia, rotation};
use glam::{Vec3, Vec3Swizzles};

const DT: f32 = 1.0 / 60.0;
const DIRECTIONS: u32 = 1000;

/// Directions spread evenly over the sphere: a Fibonacci lattice.
fn direction(k: u32) -> Vec3 {
    let z = (2.0 * k as f32 + 1.0) / DIRECTIONS as f32 - 1.0;
    let round = rotation::exp(Vec3::Z * (2.399_963 * k as f32));
    round * Vec3::new((1.0 - z * z).sqrt(), 0.0, z)
}

// ANCHOR: count
/// Turns that are not read, and turns that are read as another momentum, off by over 1 %.
fn unread(moments: Vec3, radians: f32) -> (u32, u32) {
    let (mut unread, mut wrong) = (0, 0);
    for k in 0..DIRECTIONS {
        let q_last = rotation::exp(3.0 * direction(k).zxy());
        let omega = direction(k) * (radians / DT);
        let momentum = q_last * (moments * omega);
        let q = free_rotation::attitude_after(q_last, moments, momentum, DT);
        match free_rotation::momentum_of_turn(q_last, q, moments, DT) {
            None => unread += 1,
            Some(read) if read.distance(momentum) > 0.01 * momentum.length() => wrong += 1,
            Some(_) => {}
        }
    }
    (unread, wrong)
}
// ANCHOR_END: count

fn main() {
    let shapes = [
        inertia::ori_box(1.0, Vec3::new(0.3, 0.2, 0.1)),
        inertia::cylinder(1.0, 0.28, 0.02),
        inertia::capsule(1.0, 0.07, 0.25),
        inertia::ori_box(1.0, Vec3::new(0.7, 0.07, 0.07)),
    ];
    println!("of {DIRECTIONS} turns: not read + misread");
    println!("turn     brick      plate      rod        long rod");
    for radians in [0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0] {
        let counts = shapes.map(|moments| {
            let (unread, wrong) = unread(moments, radians);
            format!("{unread:>3} + {wrong:<3}  ")
        });
        println!("{radians:.2} rad {}", counts.concat().trim_end());
    }
}
