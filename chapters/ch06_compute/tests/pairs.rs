//! Bodies of any shape on the device: the same as on the CPU, the same bits each time, and what happens when
//! things go wrong. On a machine without a graphics card they run on the software device.

#[path = "pairs/agreeing.rs"]
mod agreeing;
#[path = "pairs/failing.rs"]
mod failing;
#[path = "pairs/handing.rs"]
mod handing;
#[path = "shared/moved.rs"]
mod moved;

use std::sync::OnceLock;

use ch00_scenes::{Body, Scene, Settings, Shape, State};
use ch06_compute::compute::Pairs;
use ch06_compute::compute::pairs::Room;
use ch06_compute::rules::Rules;
use ch06_compute::stream::Gpu;
use glam::DVec3;

const DT: f32 = 1.0 / 60.0;

/// One device for all tests: what one of them has compiled the others have too.
fn gpu() -> Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    let open = || Gpu::open().expect("a graphics device, or package mesa-vulkan-drivers");
    GPU.get_or_init(open).clone()
}

fn built_in(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in scene")
}

fn rules(scene: &Scene) -> Rules {
    Rules::of(scene, &Settings::defaults()).expect("the defaults")
}

fn pairs(gpu: &Gpu, scene: &Scene) -> Pairs {
    Pairs::of(gpu, scene, rules(scene)).expect("it fits")
}

/// With room for one of each at first.
fn tight(gpu: &Gpu, scene: &Scene) -> Pairs {
    let room = Room {
        partners: 1,
        pairs: 1,
        large_pairs: 1,
    };
    Pairs::with_room(gpu, scene, rules(scene), room).expect("it fits")
}

fn read(pairs: &mut Pairs) -> State {
    let mut state = State::default();
    pairs.read(&mut state).expect("the device is there");
    state
}

/// The state after so many steps.
fn after(pairs: &mut Pairs, steps: u32) -> State {
    pairs.step(DT, steps).expect("it runs");
    read(pairs)
}

fn largest_gap(one: &State, other: &State) -> f64 {
    let pairs = one.position.iter().zip(&other.position);
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

fn ball(radius: f64, mass: f64, position: DVec3) -> Body {
    Body::new(Shape::Sphere { radius }, mass, position)
}

/// A cube of 0.2 m and 1 kg.
fn cube(position: DVec3) -> Body {
    let half_extents = DVec3::splat(0.1);
    Body::new(Shape::Box { half_extents }, 1.0, position)
}

/// A static box whose upper face is at y = 0.
fn floor() -> Body {
    let half_extents = DVec3::new(20.0, 0.5, 20.0);
    Body::new(Shape::Box { half_extents }, 0.0, DVec3::Y * -0.5)
}
