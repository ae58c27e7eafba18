//! The thrown point of scenario 1 in f32, at ever more steps a second: with p* stored and with v
//! stored. Steps are powers of two, so that rounding is the only error.
//!
//! `cargo run --release -p ch02_rigid_bodies --example fall_in_f32`

use ch00_maths::f32::verlet;
use glam::Vec3;

const START: Vec3 = Vec3::new(0.0, 10.0, 0.0);
const VELOCITY: Vec3 = Vec3::new(5.0, 8.0, 0.0);
const GRAVITY: Vec3 = Vec3::new(0.0, -9.81, 0.0);
const SECONDS: u32 = 2;

/// Distance between two numbers from 8 to 16, where most of the path lies, m: 2⁻²⁰.
const ULP: f64 = 8.0 * f32::EPSILON as f64;

// ANCHOR: two_ways
/// Where the point is after 2 s with p and p* in store.
fn by_positions(dt: f32, steps: u32) -> Vec3 {
    let mut p = START;
    let mut p_last = verlet::last_position(p, VELOCITY, GRAVITY, dt);
    for _ in 0..steps {
        let moved = verlet::displacement(p, p_last, GRAVITY, 1.0, dt, dt);
        p_last = p;
        p += moved;
    }
    p
}

/// Where it is with p and v in store.
fn by_velocity(dt: f32, steps: u32) -> Vec3 {
    let (mut p, mut v) = (START, VELOCITY);
    for _ in 0..steps {
        p += (v + 0.5 * dt * GRAVITY) * dt;
        v += GRAVITY * dt;
    }
    p
}
// ANCHOR_END: two_ways

/// Distance from the parabola, m.
fn error(p: Vec3) -> f64 {
    let t = f64::from(SECONDS);
    let [start, v, g] = [START, VELOCITY, GRAVITY].map(Vec3::as_dvec3);
    let exact = start + v * t + 0.5 * g * t * t;
    p.as_dvec3().distance(exact)
}

fn main() {
    println!("steps/s  g Δt²         predicted  p and p*   p and v");
    for rate in [64, 256, 1024, 4096] {
        let (dt, steps) = (1.0 / rate as f32, rate * SECONDS);
        // p + (p − p*) is a number of whole ulps, so g Δt² is rounded to whole ulps, at every step alike.
        let increment = 9.81 / f64::from(rate * rate) / ULP;
        let lost = (increment - increment.round()).abs() * ULP;
        let predicted = 0.5 * f64::from(steps).powi(2) * lost;
        let by_positions = error(by_positions(dt, steps));
        let by_velocity = error(by_velocity(dt, steps));
        println!(
            "{rate:<7}  {increment:>7.2} ulp  {predicted:.1e} m  {by_positions:.1e} m  {by_velocity:.1e} m"
        );
    }
}
