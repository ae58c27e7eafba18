//! How many touches of a heap can be resolved side by side: those of a level share no body that can
//! move. The answer to the page's first exercise.
//!
//! `cargo run --release -p ch05_properties --no-default-features --example levels`

use ch00_scenes::{Engine, Scene, Settings};
use ch05_properties::PropertiesEngine;
use ch05_properties::columns::AnyTable;

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
        let touches = &engine.world().data.touches;
        let levels = touches.level.last().map_or(0, |last| last + 1);
        println!(
            "{name:<9}{:>7}{:>9}{levels:>8}{:>14}{:>17.1}",
            scene.bodies.len(),
            touches.rows(),
            touches.level.partition_point(|&level| level == 0),
            touches.rows() as f64 / f64::from(levels.max(1))
        );
    }
    Ok(())
}
