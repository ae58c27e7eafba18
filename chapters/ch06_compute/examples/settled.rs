//! How deep do bodies lie in each other that have come to rest, and do they rest? By the number of substeps
//! and, for balls, by the share of a depth that a substep pushes out. From the page on own rows.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example settled -- [SCENE COUNT]`

use ch00_scenes::measures::Measures;
use ch00_scenes::{Scene, Settings, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::rules::{PUSH_SHARE, Rules};

type Problem = Box<dyn std::error::Error>;

/// Ten seconds.
const STEPS: u32 = 600;

fn main() -> Result<(), Problem> {
    let mut words = std::env::args().skip(1);
    let name = words.next().unwrap_or_else(|| "pile".to_owned());
    let count = words.next().map_or(Ok(300), |count| count.parse())?;
    let scene = Scene::open(&name, Some(count), None)?;
    println!("{name} {count} after 10 s; depths in parts of the smaller radius, and in mm");
    println!("substeps  share pushed  99 of 100 below  deepest       mm  fastest, m/s");
    for substeps in [4, 8, 10, 16, 20] {
        tell(&scene, substeps, PUSH_SHARE)?;
    }
    if name == "pile" {
        for share in [0.1, 0.2, 0.5, 1.0] {
            tell(&scene, 10, share)?;
        }
    }
    Ok(())
}

fn tell(scene: &Scene, substeps: u32, push_share: f32) -> Result<(), Problem> {
    let settings = Settings {
        substeps: Some(substeps),
        ..Settings::defaults()
    };
    let rules = Rules {
        push_share,
        ..Rules::of(scene, &settings)?
    };
    let mut lanes =
        <Lanes>::of(scene, rules).map_err(|(why, body)| format!("body {body}: {why}"))?;
    for _ in 0..STEPS {
        lanes.step(scene.dt as f32, |_| {});
    }
    let mut state = State::default();
    lanes.bodies.read(&mut state);
    let found = Measures::of(scene, &state).penetration;
    let speeds = state.linear_velocity.iter().map(|v| v.length());
    println!(
        "{substeps:>8}{push_share:>14.1}{:>17.4}{:>9.4}{:>9.2}{:>14.1e}",
        found.relative.p99,
        found.relative.deepest,
        1e3 * found.deepest,
        speeds.fold(0.0, f64::max)
    );
    Ok(())
}
