//! The way back: a limb that falls past the middle of a thin floor within one step is nearest to
//! the floor's lower face, and the shortest way apart would push it through. Where it was a step
//! ago tells which way is the right one.

use ch00_maths::f32::shape::Shape;

use super::Placed;
use super::shortest_way::{ShortestWay, Side};
use super::support_point::{Core, Vertex, separation};

// ANCHOR: way_back
/// The way apart `way`; but if the larger solid is a box, and the other one's centre went in
/// through one of its faces and past the middle in this step, the way back through that face.
#[must_use]
pub fn way_back(a: &Placed, b: &Placed, cores: (&Core, &Core), way: ShortestWay) -> ShortestWay {
    let (core_a, core_b) = cores;
    let (solid, block, block_core, side) = if core_a.reach() > core_b.reach() {
        (b, a, core_a, Side::A)
    } else {
        (a, b, core_b, Side::B)
    };
    let Shape::Box { half_extents } = *block.shape else {
        return way;
    };
    let before = block_core.to_own(solid.p_before - block.p_before);
    let now = block_core.to_own(solid.p - block.p);
    let axis = (before.abs() - half_extents).max_position();
    let was_outside = before[axis].abs() > half_extents[axis];
    let is_past_the_middle = now[axis] * before[axis] < 0.0;
    if !(was_outside && is_past_the_middle) {
        return way;
    }
    let face = block_core.axes.col(axis) * before[axis].signum();
    let normal = if side == Side::A { -face } else { face };
    let deepest = Vertex::support(core_a, core_b, -normal);
    let surfaces = deepest.on_a + deepest.on_b + (core_b.radius - core_a.radius) * normal;
    ShortestWay {
        normal,
        separation: separation(core_a, core_b, normal),
        point: 0.5 * surfaces,
        face: Some(side),
        converged: true,
    }
}
// ANCHOR_END: way_back
