//! What the overlay can draw of the collision tree: lines in the world.

use ch00_scenes::Line;
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use crate::aabb::Aabb;
use crate::{CollisionTree, Contact};

const BOX: Vec3 = Vec3::new(0.45, 0.75, 0.95);
const NORMAL: Vec3 = Vec3::new(0.95, 0.55, 0.15);
const CROSS: Vec3 = Vec3::new(0.95, 0.85, 0.25);
/// Colours of the KD-tree's levels, from the root down.
const LEVELS: [Vec3; 4] = [
    Vec3::new(0.80, 0.47, 0.65),
    Vec3::new(0.34, 0.71, 0.91),
    Vec3::new(0.0, 0.62, 0.45),
    Vec3::new(0.94, 0.89, 0.26),
];

/// The bounding boxes of the bodies that have one.
pub fn boxes(tree: &CollisionTree) -> Vec<Line> {
    let held_or_real = tree.boxes().iter().filter(|aabb| aabb.min.is_finite());
    held_or_real.flat_map(|aabb| edges(aabb, BOX)).collect()
}

/// The cells of the KD-tree, a colour a level.
pub fn cells(tree: &CollisionTree) -> Vec<Line> {
    let cells = tree.cells();
    let finite = cells.iter().filter(|(cell, _)| cell.min.is_finite());
    finite
        .flat_map(|(cell, depth)| edges(cell, LEVELS[*depth as usize % LEVELS.len()]))
        .collect()
}

/// A cross at each contact, and its normal, longer for a larger impulse.
pub fn contacts(contacts: &[Contact]) -> Vec<Line> {
    let mut lines = Vec::new();
    for contact in contacts {
        let (u, v) = contact.normal.any_orthonormal_pair();
        for arm in [u, v] {
            lines.push(line(
                contact.point - 0.04 * arm,
                contact.point + 0.04 * arm,
                CROSS,
            ));
        }
        let length = 0.1 + 0.05 * contact.impulse.length().sqrt();
        lines.push(line(
            contact.point,
            contact.point + contact.normal * length,
            NORMAL,
        ));
    }
    lines
}

/// The axes of each body: x red, y green, z blue.
pub fn frames(bodies: &[Shared<RigidBody>]) -> Vec<Line> {
    let mut lines = Vec::new();
    for body in bodies.iter().filter(|body| !body.borrow().is_static()) {
        let body = body.borrow();
        let length = 1.2 * body.collider().bounding_radius();
        for axis in Vec3::AXES {
            let colour = 0.25 + 0.7 * axis;
            let tip = body.position() + body.orientation() * axis * length;
            lines.push(line(body.position(), tip, colour));
        }
    }
    lines
}

/// The twelve edges of a box.
fn edges(aabb: &Aabb, colour: Vec3) -> impl Iterator<Item = Line> + use<> {
    let (min, size) = (aabb.min, aabb.size());
    (0..3).flat_map(move |axis| {
        let along = Vec3::AXES[axis] * size;
        let others = [
            Vec3::AXES[(axis + 1) % 3] * size,
            Vec3::AXES[(axis + 2) % 3] * size,
        ];
        [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)].map(|(s, t)| {
            let from = min + s * others[0] + t * others[1];
            line(from, from + along, colour)
        })
    })
}

fn line(from: Vec3, to: Vec3, colour: Vec3) -> Line {
    Line {
        from: from.to_array(),
        to: to.to_array(),
        color: colour.to_array(),
    }
}
