//! A run that goes on neither gains energy nor takes more memory. `--example long_run` makes a million steps; here
//! it is twenty thousand. It is a test by itself, since memory is that of the whole program.

use ch00_scenes::measures::{Conserved, escaped};
use ch00_scenes::{Scene, Settings, State};

/// Resident memory, KiB; None where the system doesn't say.
fn resident() -> Option<u64> {
    let statm = std::fs::read_to_string("/proc/self/statm").ok()?;
    let pages: u64 = statm.split_whitespace().nth(1)?.parse().ok()?;
    Some(4 * pages)
}

#[test]
fn twenty_thousand_steps_of_sixty_balls_gain_no_energy_and_take_no_more_memory() {
    let scene = Scene::open("balls", Some(60), None).expect("a built-in scene");
    for (method, sleeping) in [("own-row", false), ("coloured", false), ("own-row", true)] {
        let settings = Settings {
            threads: Some(1),
            sleeping,
            ..Settings::defaults().with_method(method)
        };
        let mut engine = (ch06_compute::LANES.load)(&scene, &settings).expect("it is supported");
        let mut state = State::start_of(&scene);
        let start = Conserved::of(&scene, &state).energy();
        let mut before = None;
        let mut last = f64::INFINITY;
        for thousand in 1..=20 {
            for _ in 0..1000 {
                engine.step(scene.dt as f32);
            }
            engine.read_state(&mut state);
            assert_eq!(state.not_finite(), 0, "{method}");
            assert_eq!(escaped(&scene, &state), Some(0), "{method}");
            let energy = Conserved::of(&scene, &state).energy();
            assert!(energy < start, "{method}: {energy} J of {start}");
            if thousand == 2 {
                (before, last) = (resident(), energy);
            }
            // A heap that has come to rest may sink, but not rise: by 1 mJ of some 6 kJ no position in f32 is
            // known. By colours balls creep, and lift others by parts of a millimetre: see the page on lanes.
            let rise = if method == "coloured" {
                1e-4 * last
            } else {
                1e-3
            };
            assert!(energy <= last + rise, "{method}: {energy} J after {last}");
        }
        if let (Some(before), Some(after)) = (before, resident()) {
            assert!(after <= before + 64, "{method}: {before} KiB, then {after}");
        }
    }
}
