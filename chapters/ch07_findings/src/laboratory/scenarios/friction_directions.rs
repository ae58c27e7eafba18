//! 15: low boxes that slide to rest in seven directions, all equally far.

use ch00_scenes::{Body, Scene, Shape};
use glam::{DQuat, DVec3};

use super::{G, floor, of_one_stuff};
use crate::lab::worst;
use crate::laboratory::scenario::{AtTimes, SOME_RATES, Scenario, timed};

const SPEED: f64 = 4.0;
const FRICTION: f64 = 0.5;
/// How far a box slides, m.
pub const WAY: f64 = SPEED * SPEED / (2.0 * FRICTION * G);
/// Of a box, m.
pub const HALF: DVec3 = DVec3::new(0.2, 0.02, 0.2);
/// From one to the next, m.
const ASIDE: f64 = 3.0;
const DIRECTIONS: u32 = 7;

pub const SCENARIO: Scenario = Scenario {
    number: 15,
    name: "friction_directions",
    title: "Boxes that slide to rest in seven directions",
    watch: "Friction that is cut off along two axes by themselves holds a box back too little between them, and turns it aside.",
    error: "distance of where it stops from where it should, the worst of seven, of 1.63 m",
    unit: "",
    one_percent: 0.01,
    scale: "of the way, 1.63 m",
    pass: 1e-2,
    fails: "",
    rates: SOME_RATES,
    scenes: |rate, _| {
        let boxes = (0..DIRECTIONS).map(|k| (start(k), direction(k)));
        Ok(vec![timed(scene(boxes), rate, 1.5)])
    },
    watcher: |_| {
        Box::new(AtTimes::new([1.5], |now, _| {
            worst((0..DIRECTIONS).map(|k| {
                let wanted = start(k) + direction(k) * WAY;
                let mut off = now.state.position[k as usize + 1] - wanted;
                off.y = 0.0;
                off.length() / WAY
            }))
        }))
    },
    steps: None,
    page: "ch03_friction",
};

/// Low boxes that begin at these places to slide in these directions.
pub fn scene(boxes: impl Iterator<Item = (DVec3, DVec3)>) -> Scene {
    let mut scene = Scene::new("friction_directions");
    scene.bodies.push(floor(30.0));
    for (start, along) in boxes {
        let shape = Shape::Box { half_extents: HALF };
        scene.bodies.push(Body {
            linear_velocity: along * SPEED,
            orientation: DQuat::from_rotation_arc(DVec3::X, along),
            ..Body::new(shape, 1.0, start)
        });
    }
    of_one_stuff(&mut scene, 0.0, FRICTION);
    scene
}

/// Every 7.5° from x.
fn direction(k: u32) -> DVec3 {
    let angle = (7.5 * f64::from(k)).to_radians();
    DVec3::new(angle.cos(), 0.0, angle.sin())
}

fn start(k: u32) -> DVec3 {
    DVec3::new(-10.0, HALF.y, ASIDE * (f64::from(k) - 3.0))
}
