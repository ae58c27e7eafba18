//! The heavy top of scenario 8 at four step sizes: period of its nodding, largest tilt and mean
//! precession, by the engine, by the same method with L stored in f64, and exactly.
//!
//! `cargo run --release -p ch02_rigid_bodies --example heavy_top`

use std::error::Error;
use std::f64::consts::{PI, TAU};

use ch00_maths::f64::free_rotation;
use ch00_scenes::{Body, Force, Scene, Settings, Shape, State};
use glam::{DQuat, DVec3};

/// Period, s, largest tilt, rad, and mean precession, rad/s: `08_heavy_top`.
const EXACT: [f64; 3] = [0.298_502_047_2, 0.579_527_312_2, 1.740_723_888];

/// How long it is watched, s.
const WATCHED: f64 = 5.0;

/// A disc so thin that its moments about the foot are 0.05 and 0.02 kg m² to 1e-7.
fn scene(rate: u32) -> Scene {
    let mut scene = Scene::new("heavy top");
    scene.dt = 1.0 / f64::from(rate);
    let disc = Shape::Cylinder {
        radius: 0.2,
        half_height: 1e-4,
    };
    let orientation = DQuat::from_rotation_z(-0.5);
    let axis = orientation * DVec3::Y;
    scene.bodies.push(Body {
        orientation,
        angular_velocity: 60.0 * axis,
        ..Body::new(disc, 1.0, 0.2 * axis)
    });
    scene.forces.push(Force::FixedPoint {
        body: 0,
        arm: DVec3::Y * 0.2,
    });
    scene
}

/// Where a parabola through three values, a step apart, has its extremum: steps after the middle
/// one, and its value there.
fn vertex([a, b, c]: [f64; 3]) -> (f64, f64) {
    let offset = 0.5 * (a - c) / (a - 2.0 * b + c);
    (offset, b - 0.25 * (a - c) * offset)
}

/// What [`EXACT`] holds, of the attitudes that `next` gives, one a step.
fn measured(rate: u32, mut next: impl FnMut() -> DQuat) -> [f64; 3] {
    let (mut tilts, mut azimuths) = (vec![0.5], vec![0.0]);
    let (mut azimuth, mut azimuth_last) = (0.0, 0.0_f64);
    let (mut uppermost, mut largest) = (0.0, 0.0_f64);
    let mut nods = 0;
    for step in 0..(WATCHED * f64::from(rate)) as usize {
        let axis = next() * DVec3::Y;
        tilts.push(axis.y.acos());
        let raw = (-axis.z).atan2(axis.x);
        azimuth += (raw - azimuth_last + PI).rem_euclid(TAU) - PI;
        azimuth_last = raw;
        azimuths.push(azimuth);
        if step == 0 {
            continue;
        }
        let last = [tilts[step - 1], tilts[step], tilts[step + 1]];
        let (offset, tilt) = vertex(last);
        if last[1] > last[0] && last[1] >= last[2] {
            largest = largest.max(tilt);
        } else if last[1] < last[0] && last[1] <= last[2] {
            nods += 1;
            uppermost = step as f64 + offset;
        }
    }
    let before = azimuths[uppermost as usize];
    let next = azimuths[uppermost as usize + 1];
    let turned = before + (next - before) * uppermost.fract();
    let seconds = uppermost / f64::from(rate);
    [seconds / f64::from(nods), largest, turned / seconds]
}

/// By the engine: q and q* in store, f32.
fn by_engine(rate: u32) -> Result<[f64; 3], Box<dyn Error>> {
    let scene = scene(rate);
    let mut engine = (ch02_rigid_bodies::ENGINE.load)(&scene, &Settings::defaults())?;
    let mut state = State::default();
    Ok(measured(rate, || {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        state.orientation[0]
    }))
}

/// By the same method with q and the angular momentum half a step ago in store, f64.
fn by_momentum(rate: u32) -> [f64; 3] {
    let scene = scene(rate);
    let moments = DVec3::new(0.05, 0.02, 0.05);
    let mut q = scene.bodies[0].orientation;
    let torque = |q: DQuat| (q * (0.2 * DVec3::Y)).cross(scene.gravity);
    let spin = DVec3::new(0.0, 60.0, 0.0);
    let mut momentum = q * (moments * spin) - torque(q) * (0.5 * scene.dt);
    measured(rate, || {
        momentum += torque(q) * scene.dt;
        q = free_rotation::attitude_after(q, moments, momentum, scene.dt);
        q
    })
}

fn row(name: &str, [period, tilt, precession]: [f64; 3]) {
    println!("{name:<20}  {period:.4} s  {tilt:.4} rad      {precession:.4} rad/s");
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("5 s, steps/s          period    largest tilt    precession");
    for rate in [60, 120, 240, 480] {
        row(&format!("engine, {rate}"), by_engine(rate)?);
        row(&format!("L stored, f64, {rate}"), by_momentum(rate));
    }
    row("exact", EXACT);
    Ok(())
}
