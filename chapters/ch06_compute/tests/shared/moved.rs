//! Runs on the CPU whose starts differ by one unit in the last place: how far they come apart is how far a run
//! on a device may be from them.

use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Scene, Settings, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::rules::Rules;

/// The scene with every coordinate of a start moved by one unit in the last place, of its body's size at least,
/// this way, that way or not.
pub fn moved(scene: &Scene, seed: u64) -> Scene {
    let mut moved = scene.clone();
    let mut random = SplitMix64::new(seed);
    for body in moved.bodies.iter_mut().filter(|body| !body.is_static()) {
        let size = f64::from(body.shape.single().bounding_radius());
        for axis in 0..3 {
            let way = [-1.0, 0.0, 1.0][random.next_u64() as usize % 3];
            body.position[axis] +=
                way * f64::from(f32::EPSILON) * body.position[axis].abs().max(size);
        }
    }
    moved
}

/// What is left of the scene after some steps on the CPU.
pub fn on_the_cpu(scene: &Scene, steps: u32) -> State {
    let rules = Rules::of(scene, &Settings::defaults()).expect("the defaults");
    let mut lanes = <Lanes>::of(scene, rules).expect("it is supported");
    for _ in 0..steps {
        lanes.step(1.0 / 60.0, |_| ());
    }
    let mut state = State::default();
    lanes.bodies.read(&mut state);
    state
}
