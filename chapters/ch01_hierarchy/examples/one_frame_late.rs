//! A lamp follows a train, in three levels. In the first two it looks at the train while it
//! updates, and it matters who was added first; in the third it looks in `gather`.
//!
//! `cargo run --release -p ch01_hierarchy --example one_frame_late`

use ch01_hierarchy::{GameObject, Level, NodeId, SceneGraph, Shared, Transform};
use glam::Vec3;

const DT: f32 = 1.0 / 64.0;
/// m/s.
const SPEED: f32 = 32.0;

/// Rides along x.
struct Train {
    node: NodeId,
    x: f32,
}

impl GameObject for Train {
    fn node(&self) -> NodeId {
        self.node
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        self.x += SPEED * dt;
        graph.set_local(self.node, along_x(self.x));
    }
}

/// Shines on the train.
struct Lamp {
    node: NodeId,
    train: Option<Shared<Train>>,
    two_phases: bool,
    target: f32,
}

impl Lamp {
    fn look(&mut self) {
        if let Some(train) = &self.train {
            self.target = train.borrow().x;
        }
    }
}

// ANCHOR: phases
impl GameObject for Lamp {
    fn node(&self) -> NodeId {
        self.node
    }

    fn gather(&mut self) {
        if self.two_phases {
            self.look();
        }
    }

    fn update(&mut self, graph: &mut SceneGraph, _dt: f32) {
        if !self.two_phases {
            self.look();
        }
        graph.set_local(self.node, along_x(self.target));
    }
}
// ANCHOR_END: phases

fn along_x(x: f32) -> Transform {
    Transform::from_translation(Vec3::X * x)
}

/// How far the lamp is behind the train after 64 frames, m.
fn behind(lamp_first: bool, two_phases: bool) -> f32 {
    let mut level = Level::new();
    let (train_node, lamp_node) = {
        let graph = &mut level.graph;
        let start = Transform::IDENTITY;
        (
            graph.add("train", None, start),
            graph.add("lamp", None, start),
        )
    };
    let lamp = Lamp {
        node: lamp_node,
        train: None,
        two_phases,
        target: 0.0,
    };
    let train = Train {
        node: train_node,
        x: 0.0,
    };
    let (lamp, train) = if lamp_first {
        let lamp = level.add(lamp);
        (lamp, level.add(train))
    } else {
        let train = level.add(train);
        (level.add(lamp), train)
    };
    lamp.borrow_mut().train = Some(train);
    for _ in 0..64 {
        level.update(DT);
    }
    let x = |node| level.graph.world(node).translation.x;
    x(train_node) - x(lamp_node)
}

fn main() {
    println!("looks in    added first  behind the train by");
    for two_phases in [false, true] {
        for lamp_first in [false, true] {
            let phase = if two_phases { "gather" } else { "update" };
            let first = if lamp_first { "lamp" } else { "train" };
            println!(
                "{phase:<11} {first:<12} {:.2} m",
                behind(lamp_first, two_phases)
            );
        }
    }
}
