//! Broad phase: boxes about the bodies, chapter 3's KD-tree over the boxes, and the pairs that overlap.

use ch00_maths::f32::rotation;
use ch03_collision::Margins;
use ch03_collision::aabb::Aabb;
use ch03_collision::kd_tree::KdTree;
use glam::Quat;

use super::or_zero;
use crate::data::{BALL, Bodies, shape_of};

/// What the broad phase keeps: its memory from step to step, and its result.
#[derive(Clone, Debug, Default)]
pub struct BroadPhase {
    /// A box a body.
    pub boxes: Vec<Aabb>,
    /// Over the boxes.
    pub tree: KdTree,
    /// Rows of bodies that may touch, the smaller first, in order.
    pub pairs: Vec<(usize, usize)>,
    /// Pairs that a joint connects, in order: they pass through each other.
    pub ignored: Vec<(usize, usize)>,
    /// The margin about obstacles for which the boxes of what can't move were made; None if they
    /// must be made anew.
    pub obstacles_for: Option<f32>,
}

// ANCHOR: boxes
/// Where each body could come near something; nowhere if it hangs on a fixed point. The boxes of what
/// can't move are made once, unless `each_step`.
pub fn boxes(
    bodies: &Bodies,
    fixed: &[u32],
    margins: Margins,
    each_step: bool,
    broad: &mut BroadPhase,
) {
    let rows = bodies.position.len();
    let anew =
        each_step || broad.obstacles_for != Some(margins.obstacle) || broad.boxes.len() != rows;
    broad.boxes.resize(rows, Aabb::EMPTY);
    for (row, aabb) in broad.boxes.iter_mut().enumerate() {
        if bodies.inverse_mass[row] == 0.0 {
            if anew {
                *aabb = about(bodies, row).grown(margins.obstacle);
            }
        } else {
            let margin = 0.5 * margins.moving + ahead_of(bodies, row, margins);
            *aabb = about(bodies, row).grown(margin);
        }
    }
    for &row in fixed {
        broad.boxes[row as usize] = Aabb::EMPTY;
    }
    broad.obstacles_for = Some(margins.obstacle);
}
// ANCHOR_END: boxes

/// The smallest box about a body.
fn about(bodies: &Bodies, row: usize) -> Aabb {
    let shape = shape_of(bodies.shape[row], bodies.size[row]);
    Aabb::of_shape(
        &shape,
        bodies.position[row],
        or_zero(&bodies.orientation, row),
    )
}

/// How far ahead of a body to look, m.
pub(super) fn ahead_of(bodies: &Bodies, row: usize, margins: Margins) -> f32 {
    margins.ahead(or_zero(&bodies.restitution, row), || {
        let (p, p_last) = (bodies.position[row], bodies.last_position[row]);
        let q: Quat = or_zero(&bodies.orientation, row);
        let q_last = bodies.last_orientation.get(row).copied().unwrap_or(q);
        let radius = shape_of(bodies.shape[row], bodies.size[row]).bounding_radius();
        rotation::reach(p, p_last, q, q_last, radius)
    })
}

// ANCHOR: pairs
/// The pairs whose boxes overlap, in order of row. Two bodies that can't move are no pair.
pub fn pairs(inverse_mass: &[f32], broad: &mut BroadPhase) {
    let BroadPhase {
        boxes,
        tree,
        pairs,
        ignored,
        ..
    } = broad;
    tree.build(boxes);
    pairs.clear();
    let is_static = |row: usize| inverse_mass[row] == 0.0;
    for i in (0..boxes.len()).filter(|&i| !is_static(i)) {
        tree.overlapping(boxes, &boxes[i], |j| {
            if j > i || (j < i && is_static(j)) {
                pairs.push((i.min(j), i.max(j)));
            }
        });
    }
    pairs.sort_unstable();
    if !ignored.is_empty() {
        pairs.retain(|pair| ignored.binary_search(pair).is_err());
    }
}
// ANCHOR_END: pairs

/// Whether a body is a ball.
pub(super) fn is_ball(bodies: &Bodies, row: usize) -> bool {
    bodies.shape[row] == BALL
}
