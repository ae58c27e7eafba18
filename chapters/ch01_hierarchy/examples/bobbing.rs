//! Answer to the exercise: a part that bobs up and down, and a buoy made of it and of the
//! orrery's spin.
//!
//! `cargo run --release -p ch01_hierarchy --example bobbing`

use std::f64::consts::FRAC_PI_2;

use ch01_hierarchy::{
    Component, GameObject, Level, NodeId, SceneGraph, Spin, SteadyAngle, Transform,
};
use glam::Vec2;

// ANCHOR: bob
/// Moves its owner up and down.
struct Bob {
    /// m.
    height: f32,
    phase: SteadyAngle,
}

impl Component for Bob {
    fn update(&mut self, local: &mut Transform, dt: f32) {
        self.phase.advance(dt);
        // The sine, from glam's own trigonometry.
        local.translation.y = self.height * Vec2::from_angle(self.phase.now()).y;
    }
}

/// A buoy on the waves.
struct Buoy {
    node: NodeId,
    bob: Bob,
    spin: Spin,
}

impl GameObject for Buoy {
    fn node(&self) -> NodeId {
        self.node
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        let local = graph.local_mut(self.node);
        self.bob.update(local, dt);
        self.spin.update(local, dt);
    }
}
// ANCHOR_END: bob

fn main() {
    let mut level = Level::new();
    let node = level.graph.add("buoy", None, Transform::IDENTITY);
    level.add(Buoy {
        node,
        bob: Bob {
            height: 0.5,
            phase: SteadyAngle::new(0.0, FRAC_PI_2),
        },
        spin: Spin {
            angle: SteadyAngle::new(0.0, FRAC_PI_2),
        },
    });
    println!("time  height    turned");
    for second in 1..=4 {
        for _ in 0..64 {
            level.update(1.0 / 64.0);
        }
        let place = level.graph.world(node);
        let (_, turned) = place.rotation.to_axis_angle();
        // Less than a micrometre is rounding; adding 0 turns −0 into 0.
        let height = (place.translation.y * 1e6).round() / 1e6 + 0.0;
        println!("{second} s  {height:>6.3} m  {turned:.3} rad");
    }
}
