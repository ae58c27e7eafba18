//! The same scene, the same bits, two layouts: time of a step and of each of its passes.
//!
//! `cargo run --release -p ch05_properties --no-default-features --example against_objects [SCENE COUNT [STEPS [TURN]]]`
//!
//! The engines take turns of TURN steps, 50 unless given, so that a noisy neighbour disturbs all alike.

use std::time::{Duration, Instant};

use ch00_scenes::{Engine, PassTime, Scene, Settings};
use ch05_properties::PropertiesEngine;
use ch05_properties::plan::Plan;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let name = args.next().unwrap_or_else(|| "balls".to_owned());
    let count = args.next().map(|count| count.parse()).transpose()?;
    let steps: u32 = args.next().map_or(Ok(300), |steps| steps.parse())?;
    let turn: u32 = args.next().map_or(Ok(50), |turn| turn.parse())?;
    let scene = Scene::open(&name, count, None)?;
    let settings = Settings::defaults();
    let full = |_: &Scene, method| Plan::full(method);
    let mut engines: [(&str, Box<dyn Engine>); 3] = [
        ("objects", (ch04_ragdolls::ENGINE.load)(&scene, &settings)?),
        (
            "all columns",
            Box::new(PropertiesEngine::load_with(&scene, &settings, full)?),
        ),
        (
            "planned",
            Box::new(PropertiesEngine::load(&scene, &settings)?),
        ),
    ];
    let mut times = vec![Vec::new(); engines.len()];
    let mut passes: Vec<Vec<Vec<PassTime>>> = vec![Vec::new(); engines.len()];
    for _ in 0..steps.div_ceil(turn.max(1)) {
        for (k, (_, engine)) in engines.iter_mut().enumerate() {
            for _ in 0..turn.max(1) {
                let start = Instant::now();
                engine.step(scene.dt as f32);
                times[k].push(start.elapsed());
                passes[k].push(engine.pass_times());
            }
        }
    }
    for (k, (name, engine)) in engines.iter().enumerate() {
        times[k].sort_unstable();
        println!(
            "{name:<12} median step {:>9.3} ms",
            ms(times[k][times[k].len() / 2])
        );
        for (place, pass) in passes[k][0].iter().enumerate() {
            let time = median(passes[k].iter().map(|passes| passes[place].time));
            println!("    {:<22}{:>9.4} ms", pass.name, ms(time));
        }
        let counters = engine.counters();
        println!(
            "    {} pairs, {} contacts",
            counters.pairs, counters.contacts
        );
    }
    Ok(())
}

fn median(times: impl Iterator<Item = Duration>) -> Duration {
    let mut times: Vec<Duration> = times.collect();
    times.sort_unstable();
    times[times.len() / 2]
}

fn ms(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}
