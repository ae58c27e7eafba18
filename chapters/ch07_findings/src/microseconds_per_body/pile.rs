//! The pile that every engine goes on with, and how well it lies afterwards.

use ch00_scenes::measures::Measures;
use ch00_scenes::{Scene, Settings, State, builtin};

use crate::FindingsError;

/// A pile of so many balls that has come to lie by the cheapest method, after so many steps. It begins without
/// anything that was pressed before.
pub fn settled(balls: u64, steps: u32) -> Result<Scene, FindingsError> {
    let mut scene = builtin::build("pile", Some(balls), Some(1))?;
    let settings = Settings::defaults().with_method("coloured");
    let mut engine = (ch06_compute::LANES.load)(&scene, &settings)?;
    for _ in 0..steps {
        engine.step(scene.dt as f32);
    }
    let mut state = State::default();
    engine.read_state(&mut state);
    for (row, body) in scene.bodies.iter_mut().enumerate() {
        if !body.is_static() {
            body.position = state.position[row];
            body.orientation = state.orientation[row];
            body.linear_velocity = state.linear_velocity[row];
            body.angular_velocity = state.angular_velocity[row];
        }
    }
    Ok(scene)
}

/// The 99th percentile of the overlaps in radii of the smaller ball, and how many balls are gone.
pub fn lies(scene: &Scene, state: &State) -> (f64, usize) {
    let measures = Measures::of(scene, state);
    let gone = measures.escaped.unwrap_or(0) + state.not_finite();
    (measures.penetration.relative.p99, gone)
}
