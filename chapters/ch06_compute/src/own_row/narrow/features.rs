//! Features: the edge or face with which a core meets another one. A feature has a name that stays with
//! it while the body moves, so that a contact is known again in the next step.

use glam::Vec3;

use super::core::{BOX, CAPSULE, CYLINDER, Core, outward, to_own, with_sign};

/// A segment.
pub const EDGE: u32 = 0;
/// A box's face.
pub const RECTANGLE: u32 = 1;
/// A cylinder's cap.
pub const DISC: u32 = 2;

/// A cylinder meets with its cap what comes from within 45° of its axis, else with its side.
pub const CAP_COSINE: f32 = std::f32::consts::FRAC_1_SQRT_2;

/// A direction stands on a face if it is off its normal by less than this, rad.
const STEEP: f32 = 1e-3;

/// An edge or a flat face, somewhere.
#[derive(Clone, Copy, Debug)]
pub struct Feature {
    /// Its middle, m.
    pub centre: Vec3,
    /// [`EDGE`], [`RECTANGLE`] or [`DISC`].
    pub shape: u32,
    /// Unit vector along it.
    pub u: Vec3,
    /// How far it reaches along u: for a disc its radius, m.
    pub half_u: f32,
    /// Unit vector along a face, at a right angle to u.
    pub v: Vec3,
    /// How far it reaches along v, m.
    pub half_v: f32,
    /// Out of a face.
    pub normal: Vec3,
    /// Which feature of its core it is, less than 16.
    pub name: u32,
}

// ANCHOR: face_towards
/// The widest feature that looks along the unit vector n: a box's face, a cylinder's cap or the line
/// along its side, a capsule's segment.
#[must_use]
pub fn face_towards(core: &Core, n: Vec3) -> Feature {
    let d = to_own(core, n);
    if core.kind == BOX {
        return box_face(core, d);
    }
    if core.kind == CYLINDER && d.y.abs() >= CAP_COSINE {
        return cap(core, d);
    }
    side(core, d)
}

/// The edge that looks along the unit vector n: of a box that which is the nearest to a right angle to n.
#[must_use]
pub fn edge_towards(core: &Core, n: Vec3) -> Feature {
    let d = to_own(core, n);
    if core.kind == BOX {
        return box_edge(core, d);
    }
    side(core, d)
}
// ANCHOR_END: face_towards

/// Whether the unit vector n stands on a flat face.
#[must_use]
pub fn stands_on_face(core: &Core, n: Vec3) -> bool {
    let d = to_own(core, n);
    let squared = d * d;
    let off_y = squared.x + squared.z;
    if core.kind == CYLINDER {
        return off_y < STEEP * STEEP;
    }
    let off_x = squared.y + squared.z;
    let off_z = squared.x + squared.y;
    core.kind == BOX && off_x.min(off_y).min(off_z) < STEEP * STEEP
}

/// The face of a box that looks along d, which is in its own axes. Its name is twice the axis, and 1 more
/// on the negative side.
fn box_face(core: &Core, d: Vec3) -> Feature {
    let size = d.abs();
    let h = core.half;
    let axes = core.axes;
    let mut along = d.z;
    let mut face = rectangle((axes.x_axis, h.x), (axes.y_axis, h.y), axes.z_axis, 4);
    let mut half = h.z;
    if size.x >= size.y && size.x >= size.z {
        along = d.x;
        face = rectangle((axes.y_axis, h.y), (axes.z_axis, h.z), axes.x_axis, 0);
        half = h.x;
    } else if size.y >= size.z {
        along = d.y;
        face = rectangle((axes.z_axis, h.z), (axes.x_axis, h.x), axes.y_axis, 2);
        half = h.y;
    }
    if along < 0.0 {
        face.normal = -face.normal;
        face.name += 1;
    }
    face.centre = core.centre + half * face.normal;
    face
}

/// A rectangle about the origin.
fn rectangle(
    (u, half_u): (Vec3, f32),
    (v, half_v): (Vec3, f32),
    normal: Vec3,
    name: u32,
) -> Feature {
    Feature {
        centre: Vec3::ZERO,
        shape: RECTANGLE,
        u,
        half_u,
        v,
        half_v,
        normal,
        name,
    }
}

/// The edge of a box that is the nearest to a right angle to d and furthest along it. Its name is four
/// times the axis, and the sides of the two others.
fn box_edge(core: &Core, d: Vec3) -> Feature {
    let size = d.abs();
    let h = core.half;
    let axes = core.axes;
    let corner = Vec3::new(
        with_sign(h.x, d.x),
        with_sign(h.y, d.y),
        with_sign(h.z, d.z),
    );
    let side_x = u32::from(d.x < 0.0);
    let side_y = u32::from(d.y < 0.0);
    let side_z = u32::from(d.z < 0.0);
    if size.x <= size.y && size.x <= size.z {
        let middle = core.centre + axes * Vec3::new(0.0, corner.y, corner.z);
        return edge(middle, axes.x_axis, h.x, 2 * side_y + side_z);
    }
    if size.y <= size.z {
        let middle = core.centre + axes * Vec3::new(corner.x, 0.0, corner.z);
        return edge(middle, axes.y_axis, h.y, 4 + 2 * side_z + side_x);
    }
    let middle = core.centre + axes * Vec3::new(corner.x, corner.y, 0.0);
    edge(middle, axes.z_axis, h.z, 8 + 2 * side_x + side_y)
}

/// A cylinder's cap on the side of d: name 0 above, 1 below.
fn cap(core: &Core, d: Vec3) -> Feature {
    let sign = with_sign(1.0, d.y);
    Feature {
        centre: core.centre + sign * core.half.y * core.axes.y_axis,
        shape: DISC,
        u: core.axes.z_axis,
        half_u: core.half.x,
        v: core.axes.x_axis,
        half_v: core.half.x,
        normal: sign * core.axes.y_axis,
        name: u32::from(d.y < 0.0),
    }
}

/// The line along a cylinder's side that reaches furthest along d, or a capsule's segment: name 2.
fn side(core: &Core, d: Vec3) -> Feature {
    let mut middle = core.centre;
    if core.kind != CAPSULE {
        middle += core.axes * (outward(d) * core.half.x);
    }
    edge(middle, core.axes.y_axis, core.half.y, 2)
}

fn edge(centre: Vec3, u: Vec3, half_u: f32, name: u32) -> Feature {
    Feature {
        centre,
        shape: EDGE,
        u,
        half_u,
        v: u,
        half_v: 0.0,
        normal: u,
        name,
    }
}

// ANCHOR: corners
/// How many corners a feature has. A cap is held by eight of its rim, which turn with the body.
#[must_use]
pub fn corner_count(feature: &Feature) -> u32 {
    if feature.shape == EDGE {
        return 2;
    }
    if feature.shape == RECTANGLE { 4 } else { 8 }
}

/// A corner of a feature; round a face in order.
#[must_use]
pub fn corner(feature: &Feature, i: u32) -> Vec3 {
    // The squares' corners (1, 1), (−1, 1), (−1, −1), (1, −1), and for a rim the points between.
    let turn = if feature.shape == DISC { i / 2 } else { i };
    let mut s = if turn == 1 || turn == 2 { -1.0 } else { 1.0 };
    let mut t = if turn >= 2 { -1.0 } else { 1.0 };
    if feature.shape == EDGE {
        return feature.centre - s * feature.half_u * feature.u;
    }
    if feature.shape == DISC {
        if i & 1 == 0 {
            s *= CAP_COSINE;
            t *= CAP_COSINE;
        } else if turn & 1 == 0 {
            s = 0.0;
        } else {
            t = 0.0;
        }
    }
    feature.centre + s * feature.half_u * feature.u + t * feature.half_v * feature.v
}
// ANCHOR_END: corners
