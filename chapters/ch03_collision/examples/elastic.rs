//! Exercise 1 of chapter 3: how much energy elastic, frictionless balls keep in ten seconds.
//!
//! `cargo run --release -p ch03_collision --no-default-features --example elastic`

use ch00_scenes::measures::Conserved;
use ch00_scenes::{Scene, Settings, State};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("threshold (m/s)   energy left after 10 s   most above the start");
    for threshold in [0.0, 0.1, 0.5, 1.0] {
        let mut scene = Scene::open("balls", Some(60), None)?;
        scene.restitution_threshold = Some(threshold);
        for body in &mut scene.bodies {
            body.restitution = 1.0;
            body.friction = 0.0;
        }
        let (left, most) = energy_over(&scene, 600)?;
        println!("{threshold:15.1}   {left:22.4}   {most:20.1e}");
    }
    Ok(())
}

/// Energy at the end over the start, and the most that it ever was above the start.
fn energy_over(scene: &Scene, steps: u32) -> Result<(f64, f64), Box<dyn std::error::Error>> {
    let mut engine = (ch03_collision::ENGINE.load)(scene, &Settings::defaults())?;
    let mut state = State::start_of(scene);
    let start = Conserved::of(scene, &state).energy();
    let (mut left, mut most) = (1.0, 0.0_f64);
    for _ in 0..steps {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        left = Conserved::of(scene, &state).energy() / start;
        most = most.max(left - 1.0);
    }
    Ok((left, most))
}
