//! Colours that run out: a ball between more others than there are colours.

use ch00_scenes::measures::Conserved;
use ch00_scenes::{Scene, State};
use ch06_compute::lanes::coloured::MOST_COLOURS;
use glam::DVec3;

use super::scenarios::helpers::{at_most, ball, load, of_one_stuff, weightless};

/// Radius of the large ball, m.
const LARGE: f64 = 10.0;

/// Radius of the small ones, m.
const SMALL: f64 = 0.2;

/// So many balls of 1 kg that fly at a large and heavy one from all sides, a centimetre away at the start. They are spread
/// by the golden angle, so that none touches another.
fn star(count: usize) -> Scene {
    let mut scene = weightless("star");
    scene.bodies.push(ball(LARGE, 1e5, DVec3::ZERO));
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    for k in 0..count {
        let y = 1.0 - (2.0 * k as f64 + 1.0) / count as f64;
        let (sine, cosine) = (golden * k as f64).sin_cos();
        let out = DVec3::new(cosine, 0.0, sine) * (1.0 - y * y).sqrt() + DVec3::Y * y;
        let mut small = ball(SMALL, 1.0, out * (LARGE + SMALL + 0.01));
        small.linear_velocity = -out;
        scene.bodies.push(small);
    }
    of_one_stuff(&mut scene, 0.0, 0.5);
    scene
}

/// Steps a star until all have arrived; gives how many contacts had no colour, and how it ended.
fn arrived(scene: &Scene) -> (usize, State) {
    let mut engine = load(scene, 4);
    let mut without = 0;
    for _ in 0..10 {
        engine.step(scene.dt as f32);
        without = without.max(engine.counters().overflow);
    }
    let mut state = State::default();
    engine.read_state(&mut state);
    assert_eq!(state.not_finite(), 0);
    (without, state)
}

#[test]
fn contacts_beyond_the_last_colour_are_counted_and_solved_all_the_same() {
    for count in [MOST_COLOURS - 1, MOST_COLOURS, 100, 5000] {
        let scene = star(count);
        let (without, state) = arrived(&scene);
        assert_eq!(without, count.saturating_sub(MOST_COLOURS), "{count}");
        for (row, place) in state.position.iter().enumerate().skip(1) {
            let gap = place.distance(state.position[0]) - LARGE - SMALL;
            // f32 resolves 10 m to 1 µm; what a ball sinks in beyond the slop is pushed out.
            at_most(gap.abs(), 0.001, "apart or inside, m");
            let speed = (state.linear_velocity[row] - state.linear_velocity[0]).length();
            at_most(speed, 0.01, "left of 1 m/s");
        }
        let of = Conserved::of(&scene, &state);
        // They come from all sides: 5000 kg m/s cancel, to the roundings of f32.
        let start = Conserved::of(&scene, &State::start_of(&scene));
        let gained = (of.momentum - start.momentum).length();
        at_most(gained, 2e-6 * count as f64, "momentum gained, kg m/s");
        at_most(of.energy(), start.energy(), "energy, J");
    }
}
