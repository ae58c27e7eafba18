//! Exercise 3 of chapter 2: the box that flips (scenario 5, the Dzhanibekov effect). A flip is a
//! change of sign of ω about the middle axis: by the engine, which stores q* in f32, and by the
//! same splitting with L stored in f64.
//!
//! `cargo run --release -p ch02_rigid_bodies --example flips`

use std::error::Error;

use ch00_maths::f64::free_rotation;
use ch00_scenes::{Body, Scene, Settings, Shape, State};
use glam::{DQuat, DVec3};

/// First flip and time between two, s: `05_dzhanibekov` of the reference.
const EXACT: [f64; 2] = [3.013_185_259, 5.110_152_307];
const SECONDS: u32 = 30;
const BOX: Shape = Shape::Box {
    half_extents: DVec3::new(0.3, 0.2, 0.1),
};
const OMEGA: DVec3 = DVec3::new(0.05, 5.0, 0.05);

/// ω about the body's y axis after every step of the engine, rad/s.
fn by_engine(method: &str, rate: u32) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut scene = Scene::new("flips");
    scene.gravity = DVec3::ZERO;
    scene.dt = 1.0 / f64::from(rate);
    scene.bodies.push(Body {
        angular_velocity: OMEGA,
        ..Body::new(BOX, 1.0, DVec3::ZERO)
    });
    let settings = Settings::defaults().with_method(method);
    let mut engine = (ch02_rigid_bodies::ENGINE.load)(&scene, &settings)?;
    let mut state = State::default();
    let step = |_| {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        (state.orientation[0].conjugate() * state.angular_velocity[0]).y
    };
    Ok((0..SECONDS * rate).map(step).collect())
}

/// The same with the angular momentum in store.
fn by_momentum(rate: u32) -> Vec<f64> {
    let moments = BOX.inertia(1.0);
    let momentum = moments * OMEGA;
    let mut q = DQuat::IDENTITY;
    let step = |_| {
        q = free_rotation::attitude_after(q, moments, momentum, 1.0 / f64::from(rate));
        (q.conjugate() * momentum).y / moments.y
    };
    (0..SECONDS * rate).map(step).collect()
}

/// Prints how often the sign changed, when first, and the mean time between two changes.
fn row(name: &str, rate: u32, about_y: &[f64]) {
    let times: Vec<f64> = about_y
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| pair[0] * pair[1] < 0.0)
        .map(|(i, pair)| (1.0 + i as f64 + pair[0] / (pair[0] - pair[1])) / f64::from(rate))
        .collect();
    let count = times.len();
    match times[..] {
        [first, .., last] => {
            let between = (last - first) / (count - 1) as f64;
            println!("{name:<17}  {rate:<7}  {count:<5}  {first:.3} s  {between:.3} s");
        }
        _ => println!("{name:<17}  {rate:<7}  {count:<5}  -        -"),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{SECONDS} s              steps/s  flips  first    between two");
    for rate in [60, 240] {
        row("printed", rate, &by_engine("printed", rate)?);
        row("corrected", rate, &by_engine("corrected", rate)?);
        row("L stored, f64", rate, &by_momentum(rate));
    }
    let [first, between] = EXACT;
    let count = 1 + ((f64::from(SECONDS) - first) / between) as u32;
    println!("exact                       {count:<5}  {first:.3} s  {between:.3} s");
    Ok(())
}
