//! Prints a hash of every bit of the state after a run, for a scene of each kind: the same lines as
//! chapter 4's example of this name.
//!
//! `cargo run -p ch05_properties --no-default-features --example column_hash`

use ch00_scenes::{Scene, Settings};
use ch05_properties::ENGINE;

const RUNS: [(&str, Option<u64>, u32); 6] = [
    ("balls", Some(200), 600),
    ("mixed", Some(200), 300),
    ("ragdolls", Some(5), 600),
    ("magnets_on_a_table", None, 600),
    ("door", None, 600),
    ("chain", None, 300),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (name, count, steps) in RUNS {
        let scene = Scene::open(name, count, None)?;
        let state = ENGINE.run(&scene, &Settings::defaults(), steps)?;
        let count = count.map_or(String::new(), |count| count.to_string());
        println!("{name} {count} {steps} {:016x}", state.hash());
    }
    Ok(())
}
