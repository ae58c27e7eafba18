//! Exercise 1 of chapter 2: a spring as a force callback. Its frequency under Verlet obeys
//! sin(½ω′Δt) = ½ω Δt, its amplitude stays; explicit Euler's grows by √(1 + ω²Δt²) a step.
//!
//! `cargo run --release -p ch02_rigid_bodies --example spring_callback`

use std::f32::consts::TAU;

use ch00_maths::f32::impulse::Velocity;
use ch00_maths::f32::shape::Shape;
use ch01_hierarchy::{Level, Transform};
use ch02_rigid_bodies::{Feel, Material, Method, RigidBody};
use glam::{Quat, Vec3};

/// N/m, which with 1 kg makes ω = 2π rad/s: one swing a second.
const STIFFNESS: f32 = TAU * TAU;
/// m, where it is let go.
const AMPLITUDE: f32 = 0.5;
const SECONDS: u32 = 100;

/// Places along x after every step, m.
fn verlet(dt: f32, steps: u32) -> Vec<f32> {
    let mut level = Level::new();
    let node = level.graph.add("weight", None, Transform::IDENTITY);
    let ball = Shape::Sphere { radius: 0.1 };
    let surface = Material {
        restitution: 0.0,
        friction: 0.0,
        static_friction: 0.0,
    };
    let mut body = RigidBody::new(node, Method::Corrected, ball, 1.0, surface);
    body.add_force(Box::new(|feel: &Feel| -STIFFNESS * feel.p));
    let start = Vec3::X * AMPLITUDE;
    body.place(start, Quat::IDENTITY, Velocity::default(), dt);
    let body = level.add(body);
    let advance = |_| {
        level.update(dt);
        body.borrow().position().x
    };
    (0..steps).map(advance).collect()
}

/// Explicit Euler: place and speed both advance with what they were at the start of the step.
fn explicit_euler(dt: f32, steps: u32) -> f32 {
    let (mut x, mut v) = (AMPLITUDE, 0.0);
    for _ in 0..steps {
        (x, v) = (x + v * dt, v - STIFFNESS * x * dt);
    }
    x.hypot(v / TAU)
}

/// Mean time between two passages upwards through 0, s.
fn period(places: &[f32], dt: f32) -> f32 {
    let passages: Vec<f32> = places
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| pair[0] < 0.0 && pair[1] >= 0.0)
        .map(|(i, pair)| i as f32 - pair[0] / (pair[1] - pair[0]))
        .collect();
    let swings = passages.len().saturating_sub(1) as f32;
    (passages.last().unwrap_or(&0.0) - passages.first().unwrap_or(&0.0)) * dt / swings
}

fn main() {
    println!("steps/s  period    predicted  largest swing  explicit Euler, 1 s");
    for rate in [60, 30, 10, 5, 4] {
        let dt = 1.0 / rate as f32;
        let places = verlet(dt, SECONDS * rate);
        let largest = places.iter().fold(0.0, |most: f32, x| most.max(x.abs()));
        let predicted = std::f32::consts::PI * dt / (0.5 * TAU * dt).asin();
        println!(
            "{rate:<7}  {:.4} s  {predicted:.4} s   {largest:.3} m        {:.2} m",
            period(&places, dt),
            explicit_euler(dt, rate)
        );
    }
}
