//! Chapter 3's fast balls and a thin wall again: how many of them are behind it a second later, by chapter
//! 5's engine, which looks once a step, and by own rows, which look along the way. From the page on own rows.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example through_the_wall`

use ch00_scenes::{EngineEntry, Scene, Settings, State};

/// Balls of each speed, in all phases of a step.
const BALLS: usize = 50;
/// As the scene has them, m/s.
const SPEEDS: [f64; 7] = [9.0, 12.0, 18.0, 30.0, 60.0, 100.0, 300.0];
/// Twice the radius and the thickness of the wall, m.
const SEEN: f64 = 0.3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Scene::open("tunnelling", Some(BALLS as u64), None)?;
    let engines = [ch05_properties::ENGINE, ch06_compute::LANES];
    let mut through = Vec::new();
    for engine in &engines {
        through.push(behind(engine, &scene)?);
    }
    println!("of {BALLS} balls behind a wall of 0.1 m, at 60 steps a second");
    println!("speed, m/s  not seen in pictures  properties  lanes");
    for (row, speed) in SPEEDS.into_iter().enumerate() {
        let unseen = (1.0 - SEEN / (speed * scene.dt)).max(0.0) * BALLS as f64;
        let [properties, lanes] = [through[0][row], through[1][row]];
        println!("{speed:>10}{unseen:>22.0}{properties:>12}{lanes:>7}");
    }
    Ok(())
}

/// How many balls of each speed are behind the wall in the end.
fn behind(engine: &EngineEntry, scene: &Scene) -> Result<Vec<usize>, Box<dyn std::error::Error>> {
    let mut run = (engine.load)(scene, &Settings::defaults())?;
    for _ in 0..scene.steps {
        run.step(scene.dt as f32);
    }
    let mut state = State::default();
    run.read_state(&mut state);
    // Body 0 is the wall, about x = 0.
    let rows = state.position[1..].chunks(BALLS);
    Ok(rows
        .map(|row| row.iter().filter(|p| p.x > 0.0).count())
        .collect())
}
