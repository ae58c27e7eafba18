//! What the overlay can draw: the drawings of chapters 3 and 4, with values that come from columns.
//!
//! Shapes and masses come from the scene, in whose order the rows are: they don't change, and a world in
//! which nothing touches has no columns of shapes.

use ch00_scenes::{Dissection, Drawing, Engine, Layer};
use ch03_collision::layers::{self, BodyView};
use ch04_ragdolls::Anchors;
use ch04_ragdolls::layers::{self as joint_layers, AngleView, JointView};

use crate::PropertiesEngine;
use crate::columns::AnyTable;
use crate::data::{NONE, limits_of};
use crate::plan::Part;
use crate::systems::narrow_phase::placed;
use crate::systems::or_zero;

/// Where bodies collide and nothing is joined.
const COLLIDING: &[Layer] = &[Layer::Aabbs, Layer::Cells, Layer::Contacts, Layer::Frames];
/// Where bodies are joined and can't collide.
const JOINED: &[Layer] = &[Layer::Frames, Layer::JointFrames, Layer::Limits];

/// The layers that this world has something for.
pub fn of(engine: &PropertiesEngine) -> &'static [Layer] {
    let is_joined = engine.world().data.joints.rows() > 0;
    match (engine.has(Part::Collisions), is_joined) {
        (true, true) => &Layer::ALL,
        (true, false) => COLLIDING,
        (false, true) => JOINED,
        (false, false) => &[Layer::Frames],
    }
}

/// Draws one of them.
pub fn draw(engine: &PropertiesEngine, layer: Layer) -> Drawing {
    let broad = &engine.world().broad;
    match layer {
        Layer::Aabbs => layers::boxes(&broad.boxes, &broad.pairs, &bodies(engine)),
        Layer::Cells => layers::cells(&broad.tree.cells()),
        Layer::Contacts => layers::contacts(&engine.contacts(), &bodies(engine)),
        Layer::Frames => layers::frames(&bodies(engine)),
        Layer::JointFrames => joint_layers::frames(joints(engine)),
        Layer::Limits => joint_layers::limits(joints(engine)),
    }
}

/// The narrow phase of two bodies, after its iteration `step`.
pub fn dissect(engine: &PropertiesEngine, a: usize, b: usize, step: usize) -> Option<Dissection> {
    let scene = &engine.scene().bodies;
    let [one, two] = [scene.get(a)?, scene.get(b)?].map(|body| body.shape.single());
    let bodies = &engine.world().data.bodies;
    let (one, two) = (placed(bodies, a, &one), placed(bodies, b, &two));
    Some(ch03_collision::dissect(&one, &two, step))
}

/// The bodies, in order of row.
fn bodies(engine: &PropertiesEngine) -> Vec<BodyView> {
    let columns = &engine.world().data.bodies;
    let scene = engine.scene().bodies.iter();
    scene
        .enumerate()
        .map(|(row, body)| BodyView {
            shape: body.shape.single(),
            position: columns.position[row],
            orientation: or_zero(&columns.orientation, row),
            mass: (columns.inverse_mass[row] != 0.0).then_some(body.mass as f32),
        })
        .collect()
}

/// The joints, in order of row.
fn joints(engine: &PropertiesEngine) -> impl Iterator<Item = JointView> {
    let data = &engine.world().data;
    let (joints, limits) = (&data.joints, &data.limits);
    let bodies = bodies(engine);
    let angle = |limit: usize| AngleView {
        rest: limits.rest[limit],
        limits: limits_of(
            limits.kind[limit],
            [limits.axis_parent[limit], limits.axis_child[limit]],
            limits.low[limit],
            limits.high[limit],
        ),
    };
    (0..joints.rows()).map(move |joint| {
        let [parent, child] =
            [joints.parent[joint], joints.child[joint]].map(|row| bodies[row as usize]);
        let anchors = Anchors {
            parent: joints.anchor_parent[joint],
            child: joints.anchor_child[joint],
        };
        let pose = |body: &BodyView| (body.position, body.orientation);
        let arms = anchors.arms_at(pose(&parent), pose(&child));
        let limit = joints.limit[joint];
        JointView {
            parent,
            child,
            points: (parent.position + arms.t1, child.position + arms.t2),
            angle: (limit != NONE).then(|| angle(limit as usize)),
        }
    })
}
