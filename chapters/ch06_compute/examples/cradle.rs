//! Newton's cradle: a ball comes with 1 m/s, four hang still. Who has which speed after the impact? All
//! contacts of a step bounce at once, so it matters how many impacts fall into one. The answer to an
//! exercise of the page on own rows.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example cradle`

use ch00_scenes::measures::Conserved;
use ch00_scenes::{Scene, Settings, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::rules::Rules;

/// The first impact is over by then, s.
const TIME: f64 = 23.0 / 60.0;
/// Where the balls are in the scene: two hooks come before them.
const BALLS: std::ops::Range<usize> = 2..7;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("steps a second   speeds of the balls, m/s                kinetic energy, J");
    for rate in [60.0, 600.0, 6000.0] {
        let mut scene = Scene::open("cradle", Some(1), None)?;
        scene.dt = 1.0 / rate;
        let rules = Rules::of(&scene, &Settings::defaults())?;
        let mut lanes =
            <Lanes>::of(&scene, rules).map_err(|(why, body)| format!("body {body}: {why}"))?;
        for _ in 0..(TIME * rate).round() as u32 {
            lanes.step(scene.dt as f32, |_| {});
        }
        let mut state = State::default();
        lanes.bodies.read(&mut state);
        // To a thousandth, and nothing as 0, not as −0.
        let thousandths = |x: f64| (1e3 * x).round() / 1e3 + 0.0;
        let speeds = state.linear_velocity[BALLS].iter();
        let speeds = speeds.map(|v| format!("{:8.3}", thousandths(v.x)));
        let energy = Conserved::of(&scene, &state).kinetic_energy;
        println!("{rate:>14}{}{energy:>21.3}", speeds.collect::<String>());
    }
    Ok(())
}
