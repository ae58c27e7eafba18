//! Prints a hash of every bit of the state after a run, to be compared between builds.
//!
//! `cargo run -p ch03_collision --no-default-features --example bit_hash -- [SCENE] [COUNT] [STEPS]`

use ch00_scenes::{Scene, Settings};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let name = args.next().unwrap_or_else(|| "balls".to_owned());
    let count = args.next().map_or(Ok(200), |text| text.parse())?;
    let steps: u32 = args.next().map_or(Ok(600), |text| text.parse())?;
    let scene = Scene::open(&name, Some(count), None)?;
    let state = ch03_collision::ENGINE.run(&scene, &Settings::defaults(), steps)?;
    println!("{name} {count} {steps} {:016x}", state.hash());
    Ok(())
}
