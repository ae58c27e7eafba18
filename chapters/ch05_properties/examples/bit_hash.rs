//! Prints a hash of every bit of the state after a run, for a scene of each kind, to be compared between
//! builds and machines. Objects and columns must have the same.
//!
//! `cargo run -p ch05_properties --no-default-features --example bit_hash`

use ch00_scenes::{Scene, Settings};

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
        let [objects, columns] = [ch04_ragdolls::ENGINE, ch05_properties::ENGINE]
            .map(|engine| engine.run(&scene, &Settings::defaults(), steps));
        let (objects, columns) = (objects?.hash(), columns?.hash());
        if objects != columns {
            return Err(
                format!("{name}: {objects:016x} of objects, {columns:016x} of columns").into(),
            );
        }
        let count = count.map_or(String::new(), |count| count.to_string());
        println!("{name} {count} {steps} {objects:016x}");
    }
    Ok(())
}
