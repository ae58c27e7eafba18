//! What is measured after ten seconds on the device, against runs on the CPU.
//!
//! Most scenes are chaotic: after 600 steps no position agrees, not even between two runs on the CPU whose
//! starts differ by one unit in the last place. What is measured of a run agrees all the same: energy, momentum,
//! how deep bodies overlap, how far joints are apart. So 20 runs on the CPU that differ so little say how far a
//! measure spreads, from the smallest to the largest, and the device's must lie between one spread below the
//! smallest and one above the largest: an interval three times as wide, about the same middle. Where nothing is
//! chaotic the spread is nothing or a few roundings, and those of the device, which may be others, are added:
//! [`OF_LENGTHS`], [`OF_SUMS`].

use std::sync::OnceLock;

use ch00_scenes::measures::{Conserved, Measures};
use ch00_scenes::{Scene, Settings, State};
use ch06_compute::compute::{Driver, Pairs};
use ch06_compute::rules::Rules;
use ch06_compute::stream::Gpu;

use super::moved::{moved, on_the_cpu};

const DT: f32 = 1.0 / 60.0;

/// Ten seconds.
const STEPS: u32 = 600;

/// Runs on the CPU whose starts differ by one unit in the last place.
const RUNS: u64 = 20;

/// What roundings may make of lengths, m: a place some metres away is rounded by 2·10⁻⁷ m.
const OF_LENGTHS: f64 = 1e-5;

/// What roundings may make of sums of energy and momentum, as part of what was summed: three times the distance
/// that a walk goes in which every substep adds a unit in the last place this way or that,
/// 3 √(600 · 8) · 1.2·10⁻⁷.
const OF_SUMS: f64 = 2.5e-5;

/// A measure: what it is, its value, and what roundings may make of it.
type Measure = (&'static str, f64, f64);

/// One device for all tests: what one of them has compiled the others have too.
fn gpu() -> Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    let open = || Gpu::open().expect("a graphics device, or package mesa-vulkan-drivers");
    GPU.get_or_init(open).clone()
}

fn rules(scene: &Scene) -> Rules {
    Rules::of(scene, &Settings::defaults()).expect("the defaults")
}

/// As the engine runs it: balls among walls by kernels of their own, all else by pairs.
fn chosen(scene: &Scene) -> Driver {
    Driver::of(&gpu(), scene, rules(scene)).expect("it fits")
}

fn by_pairs(scene: &Scene) -> Driver {
    Driver::Pairs(Box::new(
        Pairs::of(&gpu(), scene, rules(scene)).expect("it fits"),
    ))
}

fn on_the_device(mut driver: Driver) -> State {
    driver.step(DT, STEPS).expect("it runs");
    let mut state = State::default();
    driver.read(&mut state).expect("the device is there");
    state
}

/// The radius of the smallest ball about a body that moves, m: overlaps are measured in it.
fn smallest(scene: &Scene) -> f64 {
    let moving = scene.bodies.iter().filter(|body| !body.is_static());
    moving
        .map(|body| body.shape.bounding_radius())
        .fold(f64::INFINITY, f64::min)
}

fn measures_of(scene: &Scene, state: &State) -> Vec<Measure> {
    let start = Conserved::of(scene, &State::start_of(scene));
    let of = Measures::of(scene, state);
    let (now, depth) = (of.conserved, of.penetration.relative);
    let energies = start.kinetic_energy + start.potential_energy.abs();
    let momenta = start.momentum_sum.max(now.momentum_sum);
    let turning = start.angular_momentum_sum.max(now.angular_momentum_sum);
    let overlap = OF_LENGTHS / smallest(scene);
    let mut all = vec![
        ("energy", now.energy(), OF_SUMS * energies),
        ("momentum", now.momentum.length(), OF_SUMS * momenta),
        (
            "angular momentum",
            now.angular_momentum.length(),
            OF_SUMS * turning,
        ),
        ("overlap p50", depth.p50, overlap),
        ("overlap p99", depth.p99, overlap),
        ("deepest overlap", depth.deepest, overlap),
    ];
    all.extend(
        of.joint_separation
            .map(|gap| ("joint gap", gap, OF_LENGTHS)),
    );
    all
}

/// The measures of a run on the device that are not where those of runs on the CPU allow, in words.
fn outside(scene: &Scene, driver: Driver) -> Vec<String> {
    let device = on_the_device(driver);
    assert_eq!(device.not_finite(), 0, "{}", scene.name);
    let runs: Vec<Vec<Measure>> = (1..=RUNS)
        .map(|seed| measures_of(scene, &on_the_cpu(&moved(scene, seed), STEPS)))
        .collect();
    let mut outside = Vec::new();
    for (i, (what, found, roundings)) in measures_of(scene, &device).into_iter().enumerate() {
        let values = || runs.iter().map(|run| run[i].1);
        let (least, most) = (
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        );
        let beyond = (most - least) + roundings;
        let says = format!(
            "{}, {what}: {found:.6e} on the device, {least:.6e} to {most:.6e} on the CPU, roundings {roundings:.1e}",
            scene.name
        );
        println!("{says}");
        if !(least - beyond..=most + beyond).contains(&found) {
            outside.push(says);
        }
    }
    outside
}

/// Checks scenes with so many bodies, where a scene lets one choose.
fn agree(scenes: &[(&str, Option<u64>)], drive: fn(&Scene) -> Driver) {
    let found = scenes.iter().flat_map(|&(name, count)| {
        let scene = Scene::open(name, count, None).expect("a built-in scene");
        outside(&scene, drive(&scene))
    });
    let found: Vec<String> = found.collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn measures_of_balls_lie_within_the_spread_of_runs_on_the_cpu() {
    agree(
        &[
            ("balls", Some(30)),
            ("smooth_balls", Some(30)),
            ("pile", Some(40)),
            ("pair", None),
            ("bounce", None),
            ("bounce_half", None),
        ],
        chosen,
    );
}

#[test]
fn measures_of_friction_lie_within_the_spread_of_runs_on_the_cpu() {
    agree(
        &[("incline", None), ("slide", None), ("oblique", None)],
        chosen,
    );
}

#[test]
fn measures_of_boxes_lie_within_the_spread_of_runs_on_the_cpu() {
    agree(&[("stack", None), ("heavy_on_light", None)], chosen);
}

#[test]
fn measures_of_all_shapes_lie_within_the_spread_of_runs_on_the_cpu() {
    agree(&[("mixed", Some(20)), ("tunnelling", Some(1))], chosen);
}

#[test]
fn measures_of_forces_lie_within_the_spread_of_runs_on_the_cpu() {
    agree(
        &[
            ("tops", None),
            ("magnets", None),
            ("magnets_on_a_table", None),
        ],
        chosen,
    );
}

#[test]
fn measures_of_chains_and_doors_lie_within_the_spread_of_runs_on_the_cpu() {
    agree(
        &[
            ("cradle", None),
            ("chain", Some(20)),
            ("chain_hanging", Some(20)),
            ("door", None),
            ("door_pins", None),
        ],
        chosen,
    );
}

#[test]
fn measures_of_ragdolls_lie_within_the_spread_of_runs_on_the_cpu() {
    agree(&[("ragdolls", Some(2)), ("ragdoll_field", Some(2))], chosen);
}

/// Where a ball rolls over the end of a plate, the kernels for balls and the CPU differ: a pair finds its points
/// once a step and keeps them, here and on the CPU, while the kernels for balls look at each substep where a ball
/// touches a box, and see the end sooner. So these scenes are compared by pairs.
#[test]
fn measures_of_balls_on_plates_lie_within_the_spread_of_runs_on_the_cpu_by_pairs() {
    agree(&[("slip_to_roll", None), ("slopes", None)], by_pairs);
}

/// After 3.772 s the ball of `slip_to_roll` is at the plate's end, too fast to roll down its edge. So it falls for
/// 6.228 s and is then at y = 0.5 m − ½ g t² = −189.74 m.
#[test]
fn the_kernels_for_balls_and_the_cpu_differ_where_a_ball_rolls_over_an_edge() {
    let scene = Scene::open("slip_to_roll", None, None).expect("a built-in scene");
    let exact = -189.736;
    let off = |state: &State| (state.position[1].y - exact).abs();
    let by_balls = off(&on_the_device(chosen(&scene)));
    let on_the_cpu = off(&on_the_cpu(&moved(&scene, 1), STEPS));
    // A fall of 61 m/s that begins a substep late, 1/480 s, and one that begins up to a step late.
    assert!(by_balls < 0.15, "{by_balls} m");
    assert!(on_the_cpu < 1.1, "{on_the_cpu} m");
    assert!(by_balls < on_the_cpu);
}
