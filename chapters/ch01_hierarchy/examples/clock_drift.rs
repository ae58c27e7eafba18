//! What a clock shows that adds up steps of 1/60 s, in f32 and in f64.
//!
//! `cargo run --release -p ch01_hierarchy --example clock_drift`

/// Steps a second.
const RATE: u32 = 60;
const HOUR: u32 = 3600 * RATE;
const DAY: u32 = 24 * HOUR;

fn main() {
    let marks = [
        ("1 minute", 60 * RATE),
        ("1 hour", HOUR),
        ("1 day", DAY),
        ("2 days", 2 * DAY),
        ("4 days", 4 * DAY),
        ("7 days", 7 * DAY),
    ];
    let dt = 1.0 / RATE as f32;
    let (mut single, mut double, mut steps) = (0.0_f32, 0.0_f64, 0);
    println!("after       f32 is off by      f64 is off by   f32 goes on by");
    for (name, mark) in marks {
        while steps < mark {
            single += dt;
            double += f64::from(dt);
            steps += 1;
        }
        // What the steps add up to: they are f32 numbers, and 1/60 is not.
        let time = f64::from(dt) * f64::from(steps);
        let off = f64::from(single) - time;
        let step = single + dt - single;
        println!(
            "{name:<9} {off:>14.3} s {:>16.3} s {step:>12.5} s",
            double - time
        );
    }
}
