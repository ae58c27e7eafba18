//! Exercise 3 of chapter 4: an arm is raised, and two ways of saying by which angles say it: Euler's
//! and swing and twist. Why limits on the first misbehave.
//!
//! `cargo run --release -p ch04_ragdolls --no-default-features --example euler_limits`

use ch00_maths::f64::rotation::exp;
use ch00_maths::f64::swing_twist::{decompose, twist_axis};
use glam::{DQuat, DVec3, EulerRot};

/// What the joint allows, degrees: pitch, yaw, roll.
const LIMITS: [[f64; 2]; 3] = [[-30.0, 150.0], [-60.0, 60.0], [-60.0, 60.0]];

/// Pitch, yaw and roll, degrees, of a turn that is a yaw about y, then a pitch about the new x, then
/// a roll about the z of both.
fn euler(turn: DQuat) -> [f64; 3] {
    let (yaw, pitch, roll) = turn.to_euler(EulerRot::YXZ);
    [pitch, yaw, roll].map(f64::to_degrees)
}

/// The same three as swing and twist: the swing's x, the twist, the swing's z.
fn swing_twist(turn: DQuat) -> [f64; 3] {
    let parts = decompose(turn);
    [parts.swing.x, parts.twist, parts.swing.z].map(f64::to_degrees)
}

fn verdict(angles: [f64; 3]) -> &'static str {
    let mut all = angles.iter().zip(LIMITS);
    if all.all(|(angle, [low, high])| (low..=high).contains(angle)) {
        "may"
    } else {
        "stop"
    }
}

/// The arm is raised forwards, in a plane 3° beside the one straight ahead.
fn raised(degrees: f64) -> DQuat {
    let across = exp(DVec3::Y * 3_f64.to_radians()) * DVec3::X;
    exp(across * degrees.to_radians())
}

fn raise_the_arm() {
    println!("        Euler                    swing and twist");
    println!("raised  pitch   yaw  roll        pitch   yaw  roll");
    for degrees in [
        0.0, 45.0, 80.0, 87.0, 90.0, 93.0, 100.0, 120.0, 149.0, 155.0,
    ] {
        let columns = |angles: [f64; 3]| {
            let [pitch, yaw, roll] = angles.map(|angle| angle.round() + 0.0);
            let verdict = verdict(angles);
            format!("{pitch:5} {yaw:5} {roll:5}  {verdict:4}")
        };
        let turn = raised(degrees);
        let (by_euler, by_swing) = (columns(euler(turn)), columns(swing_twist(turn)));
        println!("{degrees:4}°   {by_euler}  {}", by_swing.trim_end());
    }
}

/// Of the attitudes whose three angles, in this order of the axes, are within 60°, the share that has
/// one beyond 60° in the other order.
fn decided_by_the_order(here: EulerRot, there: EulerRot) -> f64 {
    let steps = || (-12..=12).map(|k| f64::from(5 * k).to_radians());
    let (mut all, mut beyond) = (0, 0);
    for a in steps() {
        for b in steps() {
            for c in steps() {
                let (x, y, z) = DQuat::from_euler(here, a, b, c).to_euler(there);
                let widest = x.abs().max(y.abs()).max(z.abs()).to_degrees();
                all += 1;
                beyond += i32::from(widest > 60.0 + 1e-9);
            }
        }
    }
    f64::from(beyond) / f64::from(all)
}

/// By how much each angle may change while the bone turns by one degree.
fn fastest() {
    println!("tilted  Euler's yaw  twist  swing");
    for degrees in [0.0_f64, 45.0, 80.0, 89.0, 90.0, 120.0, 170.0, 179.0] {
        let tilt = degrees.to_radians();
        let of_yaw = 1.0 / tilt.cos().abs();
        let of_twist = twist_axis(DVec3::Y, exp(DVec3::X * tilt) * DVec3::Y).length();
        let of_swing = if tilt == 0.0 { 1.0 } else { tilt / tilt.sin() };
        let cell = |rate: f64| {
            if rate < 1e6 {
                format!("{rate:.1}°")
            } else {
                "any".to_owned()
            }
        };
        let (yaw, twist, swing) = (cell(of_yaw), cell(of_twist), cell(of_swing));
        println!("{degrees:4}°   {yaw:>11} {twist:>6} {swing:>6}");
    }
}

fn main() {
    raise_the_arm();
    let share = decided_by_the_order(EulerRot::YXZ, EulerRot::XYZ);
    println!(
        "within 60° in one order and beyond in another: {:.0} %",
        100.0 * share
    );
    fastest();
}
