//! What a step's time goes into: the share of each part over ten seconds of a crowd, and how long it
//! takes in the last of them, when the crowd has become a pile.
//!
//! `cargo run --release -p ch03_collision --example pass_shares`

use std::time::Duration;

use ch00_scenes::{Engine, PassTime, Scene, Settings};
use ch03_collision::ENGINE;

const CROWDS: [(&str, u64); 2] = [("balls", 1000), ("mixed", 1000)];

/// Steps of the last second.
const LAST: u32 = 60;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (name, count) in CROWDS {
        let scene = Scene::open(name, Some(count), None)?;
        let mut engine = (ENGINE.load)(&scene, &Settings::defaults())?;
        let falling = sum_of_passes(engine.as_mut(), scene.dt as f32, 540);
        let resting = sum_of_passes(engine.as_mut(), scene.dt as f32, LAST);
        let both = |i: usize| falling[i].time + resting[i].time;
        let whole: Duration = (0..falling.len()).map(both).sum();
        println!(
            "{:<18} share   ms a step at the end",
            format!("{count} {name}")
        );
        for (i, pass) in resting.iter().enumerate() {
            let share = 100.0 * both(i).as_secs_f64() / whole.as_secs_f64();
            let each = 1000.0 * pass.time.as_secs_f64() / f64::from(LAST);
            println!("  {:<16} {share:>4.1} %  {each:.3}", pass.name);
        }
    }
    Ok(())
}

/// How long each part took in so many steps.
fn sum_of_passes(engine: &mut dyn Engine, dt: f32, steps: u32) -> Vec<PassTime> {
    let mut sums: Vec<PassTime> = Vec::new();
    for _ in 0..steps {
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
