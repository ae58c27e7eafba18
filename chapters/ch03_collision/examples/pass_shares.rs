//! What a step's time goes into: the share of each part over ten seconds of a crowd.
//!
//! `cargo run --release -p ch03_collision --example pass_shares`

use std::time::Duration;

use ch00_scenes::{Engine, PassTime, Scene, Settings};
use ch03_collision::ENGINE;

const CROWDS: [(&str, u64); 2] = [("balls", 1000), ("mixed", 1000)];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (name, count) in CROWDS {
        let scene = Scene::open(name, Some(count), None)?;
        let mut engine = (ENGINE.load)(&scene, &Settings::defaults())?;
        let sums = sum_of_passes(engine.as_mut(), scene.dt as f32);
        let whole: Duration = sums.iter().map(|pass| pass.time).sum();
        println!("{count} {name}");
        for pass in sums {
            let share = 100.0 * pass.time.as_secs_f64() / whole.as_secs_f64();
            println!("  {:<16} {share:>5.1} %", pass.name);
        }
    }
    Ok(())
}

/// How long each part took in 600 steps.
fn sum_of_passes(engine: &mut dyn Engine, dt: f32) -> Vec<PassTime> {
    let mut sums: Vec<PassTime> = Vec::new();
    for _ in 0..600 {
        engine.step(dt);
        for (i, pass) in engine.pass_times().into_iter().enumerate() {
            match sums.get_mut(i) {
                Some(sum) => sum.time += pass.time,
                None => sums.push(pass),
            }
        }
    }
    sums
}
