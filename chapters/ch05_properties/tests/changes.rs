//! Bodies that come and go in mid-run, cells that are edited, the mouse; and everything that must be
//! refused.

#[path = "changes/bodies.rs"]
mod bodies;
#[path = "changes/by_hand.rs"]
mod by_hand;

use ch00_scenes::{Body, Cell, Edit, Engine, RowId, Scene, Settings, Shape, State};
use ch05_properties::PropertiesEngine;
use glam::DVec3;

fn open(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in")
}

fn load(scene: &Scene) -> PropertiesEngine {
    PropertiesEngine::load(scene, &Settings::defaults()).expect("it runs")
}

fn objects(scene: &Scene) -> Box<dyn Engine> {
    (ch04_ragdolls::ENGINE.load)(scene, &Settings::defaults()).expect("chapter 4 runs it")
}

fn run(engine: &mut dyn Engine, scene: &Scene, steps: u32) {
    for _ in 0..steps {
        engine.step(scene.dt as f32);
    }
}

fn hash(engine: &dyn Engine) -> u64 {
    let mut state = State::default();
    engine.read_state(&mut state);
    state.hash()
}

/// A ball without friction or spin, far from everything.
fn lone_ball() -> Body {
    let mut ball = Body::new(
        Shape::Sphere { radius: 0.2 },
        3.0,
        DVec3::new(80.0, 5.0, 0.0),
    );
    ball.friction = 0.0;
    ball
}

fn smooth_balls() -> Scene {
    let mut scene = open("balls", Some(20));
    for body in &mut scene.bodies {
        body.friction = 0.0;
        body.angular_velocity = DVec3::ZERO;
    }
    scene
}

fn edit(table: &str, column: &str, slot: u32, value: Cell) -> Edit {
    Edit {
        table: table.to_owned(),
        column: column.to_owned(),
        row: RowId::first(slot),
        value,
    }
}
