//! What the overlay can draw without asking the device for more than where the bodies are: the cells of the
//! grid that hold bodies, and the bodies' frames. It is as late as the state that came down.

use std::collections::BTreeMap;

use ch00_scenes::{Drawing, Layer, Scene, State, palette};
use ch03_collision::layers::{BodyView, frames};
use glam::Vec3;

/// The layers that there are.
pub const LAYERS: &[Layer] = &[Layer::Cells, Layer::Frames];

/// Draws one of them; cells are `edge` m wide and hold bodies that reach no farther than `largest`, m.
#[must_use]
pub fn draw(layer: Layer, scene: &Scene, state: &State, edge: f32, largest: f32) -> Drawing {
    match layer {
        Layer::Cells => cells(scene, state, edge, largest),
        Layer::Frames => frames(&bodies(scene, state)),
        _ => Drawing::default(),
    }
}

/// The cells that hold the centre of a body.
fn cells(scene: &Scene, state: &State, edge: f32, largest: f32) -> Drawing {
    let mut held: BTreeMap<[i32; 3], usize> = BTreeMap::new();
    for (body, position) in scene.bodies.iter().zip(&state.position) {
        let reach = body.shape.single().bounding_radius();
        if !body.is_static() && reach <= largest && position.is_finite() {
            let cell = (position.as_vec3() / edge).floor().to_array();
            *held.entry(cell.map(|c| c as i32)).or_default() += 1;
        }
    }
    let mut drawing = Drawing::default();
    for (&cell, &count) in &held {
        let low = Vec3::from(cell.map(|c| c as f32)) * edge;
        let (width, color) = if count > 1 {
            (1.5, palette::ORANGE)
        } else {
            (0.8, palette::BLUE)
        };
        drawing.cuboid(low, low + Vec3::splat(edge), width, color);
    }
    let crowded = held.values().filter(|&&count| count > 1).count();
    let single = held.len() - crowded;
    drawing.explain(
        palette::BLUE,
        format!("cell of {edge:.2} m with one body: {single}"),
    );
    drawing.explain(palette::ORANGE, format!("with more than one: {crowded}"));
    drawing
}

/// The bodies where they were when their state came down.
fn bodies(scene: &Scene, state: &State) -> Vec<BodyView> {
    let places = state.position.iter().zip(&state.orientation);
    let view =
        |(body, (position, orientation)): (&ch00_scenes::Body, (&glam::DVec3, &glam::DQuat))| {
            BodyView {
                shape: body.shape.single(),
                position: position.as_vec3(),
                orientation: orientation.as_quat(),
                mass: (!body.is_static()).then_some(body.mass as f32),
            }
        };
    scene.bodies.iter().zip(places).map(view).collect()
}
