//! Exercise 2 of the page on impulses: a level rod falls on a peg with one end. Which way does it go
//! on, and how fast does it turn, by the formula and by the engine?
//!
//! `cargo run --release -p ch03_collision --no-default-features --example struck_rod`

use ch00_maths::f64::shape::Shape as Solid;
use ch00_scenes::{Body, Scene, Settings, Shape};
use glam::DVec3;

/// m/s, downwards.
const SPEED: f64 = 2.0;
/// Half of the length between the caps, m, and the rod's radius.
const HALF: f64 = 1.0;
const RADIUS: f64 = 0.05;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("e      v, formula   v, engine   ω, formula   ω, engine");
    for e in [0.0, 0.5, 1.0] {
        let (v, omega) = by_formula(e);
        let (v_run, omega_run) = by_engine(e)?;
        println!("{e:.1}    {v:10.4}   {v_run:9.4}   {omega:10.4}   {omega_run:9.4}");
    }
    Ok(())
}

/// J = (1 + e) u / k with k = 1/m + r²/I: the arm is at a right angle to the normal.
fn by_formula(e: f64) -> (f64, f64) {
    let rod = Solid::Capsule {
        radius: RADIUS,
        half_height: HALF,
    };
    let inertia = rod.inertia(1.0).x;
    let k = 1.0 + HALF * HALF / inertia;
    let impulse = (1.0 + e) * SPEED / k;
    (impulse - SPEED, HALF * impulse / inertia)
}

/// The rod lies along x, a little above a ball under its right end that can't move.
fn by_engine(e: f64) -> Result<(f64, f64), Box<dyn std::error::Error>> {
    let mut scene = Scene::new("struck rod");
    scene.gravity = DVec3::ZERO;
    let rod = Shape::Capsule {
        radius: RADIUS,
        half_height: HALF,
    };
    let peg = Shape::Sphere { radius: 0.1 };
    let mut rod = Body::new(rod, 1.0, DVec3::ZERO);
    rod.orientation = glam::DQuat::from_rotation_z(-std::f64::consts::FRAC_PI_2);
    rod.linear_velocity = DVec3::NEG_Y * SPEED;
    let start = RADIUS + 0.1 + SPEED * scene.dt;
    let peg = Body::new(peg, 0.0, DVec3::new(HALF, -start, 0.0));
    scene.bodies = vec![rod, peg];
    for body in &mut scene.bodies {
        (body.restitution, body.friction) = (e, 0.0);
    }
    let state = ch03_collision::ENGINE.run(&scene, &Settings::defaults(), 2)?;
    Ok((state.linear_velocity[0].y, state.angular_velocity[0].z))
}
