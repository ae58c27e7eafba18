//! How many touches of a heap can be resolved side by side: those of a level share no body that can
//! move, and each comes after those before it that do. The answer to the page's second exercise.
//!
//! `cargo run --release -p ch05_properties --no-default-features --example levels`

use ch00_scenes::{Engine, Scene, Settings};
use ch05_properties::PropertiesEngine;
use ch05_properties::data::Data;

/// Scenes, what they count, and how long they take to come to rest.
const HEAPS: [(&str, Option<u64>, u32); 4] = [
    ("balls", Some(100), 400),
    ("balls", Some(1000), 400),
    ("stack", Some(15), 60),
    ("ragdolls", Some(5), 200),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("scene     bodies  touches  levels  in the first  touches a level");
    for (name, count, steps) in HEAPS {
        let scene = Scene::open(name, count, None)?;
        let mut engine = PropertiesEngine::load(&scene, &Settings::defaults())?;
        for _ in 0..steps {
            engine.step(scene.dt as f32);
        }
        let level = levels_of(&engine.world().data);
        let levels = level.iter().max().map_or(0, |last| last + 1);
        println!(
            "{name:<9}{:>7}{:>9}{levels:>8}{:>14}{:>17.1}",
            scene.bodies.len(),
            level.len(),
            level.iter().filter(|&&level| level == 0).count(),
            level.len() as f64 / f64::from(levels.max(1))
        );
    }
    Ok(())
}

/// The level of each touch: one more than the highest of those before it that share a body with it.
fn levels_of(data: &Data) -> Vec<u32> {
    let mut free_at = vec![0; data.bodies.position.len()];
    let ends = data.touches.a.iter().zip(data.touches.b.iter());
    let level = |(&a, &b): (&u32, &u32)| {
        let pair = [a as usize, b as usize];
        let movers = pair
            .into_iter()
            .filter(|&row| data.bodies.inverse_mass[row] != 0.0);
        let level = movers.map(|row| free_at[row]).max().unwrap_or(0);
        for row in pair {
            free_at[row] = level + 1;
        }
        level
    };
    ends.map(level).collect()
}
