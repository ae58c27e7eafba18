//! Engine `lanes`: as many lanes and threads as one likes, the bits are the same.

use ch00_scenes::{LoadError, Scene, Settings, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::threads::Threads;
use ch06_compute::rules::Rules;
use ch06_compute::simd::{Eight, Four, Real};

/// Balls in a pile, every shape, joints with limits, loops, poles that pull.
const SCENES: [(&str, Option<u64>); 7] = [
    ("balls", Some(300)),
    ("mixed", Some(60)),
    ("ragdolls", Some(3)),
    ("cradle", None),
    ("magnets", None),
    ("tops", None),
    ("door", None),
];

const STEPS: u32 = 90;

fn open(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in scene")
}

/// The methods that engine `lanes` has.
const METHODS: [&str; 2] = ["own-row", "coloured"];

/// The state after some steps of a method, in lanes of R on so many threads.
fn after<R: Real>(scene: &Scene, method: &str, threads: usize) -> State {
    let settings = Settings::defaults().with_method(method);
    let rules = Rules::of(scene, &settings).expect("the defaults");
    let mut lanes = Lanes::<R>::of(scene, rules).expect("it is supported");
    lanes.threads = Threads::of(threads).expect("the system has so many");
    for _ in 0..STEPS {
        lanes.step(scene.dt as f32, |_| {});
    }
    let mut state = State::default();
    lanes.bodies.read(&mut state);
    state
}

#[test]
fn one_lane_four_and_eight_have_the_same_bits() {
    for (name, count) in SCENES {
        let scene = open(name, count);
        for method in METHODS {
            let one = after::<f32>(&scene, method, 1);
            assert_eq!(one.not_finite(), 0, "{name}");
            let four = after::<Four>(&scene, method, 1);
            assert_eq!(one, four, "{name}, {method} in lanes of four");
            let eight = after::<Eight>(&scene, method, 1);
            assert_eq!(one, eight, "{name}, {method} in lanes of eight");
        }
    }
}

#[test]
fn one_thread_and_several_have_the_same_bits() {
    for (name, count) in [("balls", 600), ("balls", 4000), ("ragdolls", 30)] {
        let scene = open(name, Some(count));
        for method in METHODS {
            let one = after::<Eight>(&scene, method, 1);
            for threads in [2, 3, 7] {
                let many = after::<Eight>(&scene, method, threads);
                assert_eq!(one, many, "{name}, {method} on {threads}");
            }
        }
    }
}

#[test]
fn no_thread_and_ten_thousand_are_errors_that_name_the_setting() {
    let scene = open("balls", Some(3));
    for threads in [0, 10_000] {
        let settings = Settings {
            threads: Some(threads),
            ..Settings::defaults()
        };
        let Err(error) = (ch06_compute::LANES.load)(&scene, &settings) else {
            panic!("{threads} threads are accepted");
        };
        assert!(
            matches!(
                error,
                LoadError::Setting {
                    setting: "threads",
                    ..
                }
            ),
            "{error}"
        );
    }
}
