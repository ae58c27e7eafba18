//! Own rows and colours: how large an error is left for how much work? A line of CSV for each scene, method and
//! number of substeps, for the chart of the page on lanes.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example rows_and_colours -- [SCENE COUNT]`
//!
//! A scene settles for ten seconds and is then looked at every twenty steps for two hundred more. Work is told
//! in visits a step, of which each is a pair solved once, and in ms a step on one thread, the median of the ten.
//! Depths are means of the ten, in parts of the smaller radius.

use std::time::Instant;

use ch00_scenes::measures::Measures;
use ch00_scenes::{Scene, Settings, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::rules::{Method, Rules};

type Problem = Box<dyn std::error::Error>;

/// Ten seconds.
const SETTLE: u32 = 600;

/// How often it is looked at.
const LOOKS: u32 = 10;

/// Steps from one look to the next.
const BETWEEN: u32 = 20;

/// What is run without arguments.
const SCENES: &[(&str, Option<u64>)] = &[
    ("balls", Some(1000)),
    ("pile", Some(1000)),
    ("mixed", Some(300)),
    ("ragdolls", Some(80)),
    ("stack", Some(15)),
    ("heavy_on_light", Some(10)),
    ("heavy_on_light", Some(100)),
];

/// Of each method.
const SUBSTEPS: [(&str, &[u32]); 2] = [
    ("own-row", &[4, 8, 10, 16, 20]),
    ("coloured", &[2, 3, 4, 6, 10]),
];

fn main() -> Result<(), Problem> {
    println!(
        "scene,count,method,substeps,visits_a_step,ms_a_step,p50_of_r,p99_of_r,deepest_of_r,separation_m,limit_excess_rad,kinetic_energy_j_a_body"
    );
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [name, count] = &words[..] {
        return tell(name, Some(count.parse()?));
    }
    for &(name, count) in SCENES {
        tell(name, count)?;
    }
    Ok(())
}

fn tell(name: &str, count: Option<u64>) -> Result<(), Problem> {
    let scene = Scene::open(name, count, None)?;
    let shown = count.map_or_else(String::new, |count| count.to_string());
    for (method, all) in SUBSTEPS {
        for &substeps in all {
            let settings = Settings {
                substeps: Some(substeps),
                ..Settings::defaults().with_method(method)
            };
            let seen = seen(&scene, Rules::of(&scene, &settings)?)?;
            println!("{name},{shown},{method},{substeps},{seen}");
        }
    }
    Ok(())
}

/// The values of a line, from the visits on.
fn seen(scene: &Scene, rules: Rules) -> Result<String, Problem> {
    let dt = scene.dt as f32;
    let mut lanes =
        <Lanes>::of(scene, rules).map_err(|(why, body)| format!("body {body}: {why}"))?;
    for _ in 0..SETTLE {
        lanes.step(dt, |_| {});
    }
    let mut state = State::default();
    let mut times = Vec::new();
    // Visits, depths, gap, limit, energy.
    let mut sums = [0.0; 7];
    for _ in 0..LOOKS {
        let start = Instant::now();
        for _ in 0..BETWEEN {
            lanes.step(dt, |_| {});
        }
        times.push(1e3 * start.elapsed().as_secs_f64() / f64::from(BETWEEN));
        lanes.bodies.read(&mut state);
        let measures = Measures::of(scene, &state);
        let depth = &measures.penetration.relative;
        let values = [
            visits(&lanes) as f64,
            depth.p50,
            depth.p99,
            depth.deepest,
            measures.joint_separation.unwrap_or_default(),
            measures.limit_excess.unwrap_or_default(),
            measures.conserved.kinetic_energy / scene.dynamic_count() as f64,
        ];
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += value / f64::from(LOOKS);
        }
    }
    times.sort_by(f64::total_cmp);
    let [visits, rest @ ..] = sums;
    let rest: Vec<String> = rest.iter().map(|value| format!("{value:.3e}")).collect();
    let ms = times[times.len() / 2];
    Ok(format!("{visits:.0},{ms:.4},{}", rest.join(",")))
}

/// How often a pair is solved in a step, all pairs together.
fn visits(lanes: &Lanes) -> usize {
    let Rules {
        method,
        back,
        substeps,
        ..
    } = lanes.rules;
    let ways = if method == Method::Coloured && back {
        2
    } else {
        1
    };
    ways * substeps as usize * lanes.pairs.bodies.len()
}
