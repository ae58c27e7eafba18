// Features: the edge or face with which a core meets another one.
// Needs common/rotation, common/narrow_core.

// A segment.
const EDGE: u32 = 0u;
// A box's face.
const RECTANGLE: u32 = 1u;
// A cylinder's cap.
const DISC: u32 = 2u;

// A cylinder meets with its cap what comes from within 45° of its axis, else with its side.
const CAP_COSINE: f32 = 0.70710677;

// A direction stands on a face if it is off its normal by less than this, rad.
const STEEP: f32 = 1e-3;

// An edge or a flat face, somewhere.
struct Feature {
    // Its middle, m.
    centre: vec3f,
    // EDGE, RECTANGLE or DISC.
    shape: u32,
    // Unit vector along it.
    u: vec3f,
    // How far it reaches along u: for a disc its radius, m.
    half_u: f32,
    // Unit vector along a face, at a right angle to u.
    v: vec3f,
    // How far it reaches along v, m.
    half_v: f32,
    // Out of a face.
    normal: vec3f,
    // Which feature of its core it is, less than 16.
    name: u32,
}

// The widest feature that looks along the unit vector n: a box's face, a cylinder's cap or the line
// along its side, a capsule's segment.
fn face_towards(core: Core, n: vec3f) -> Feature {
    let d = to_own(core, n);
    if core.kind == BOX {
        return box_face(core, d);
    }
    if core.kind == CYLINDER && abs(d.y) >= CAP_COSINE {
        return cap(core, d);
    }
    return side(core, d);
}

// The edge that looks along the unit vector n: of a box that which is the nearest to a right angle to
// n.
fn edge_towards(core: Core, n: vec3f) -> Feature {
    let d = to_own(core, n);
    if core.kind == BOX {
        return box_edge(core, d);
    }
    return side(core, d);
}

// Whether the unit vector n stands on a flat face.
fn stands_on_face(core: Core, n: vec3f) -> bool {
    let d = to_own(core, n);
    let squared = d * d;
    let off_y = squared.x + squared.z;
    if core.kind == CYLINDER {
        return off_y < STEEP * STEEP;
    }
    let off_x = squared.y + squared.z;
    let off_z = squared.x + squared.y;
    return core.kind == BOX && min(min(off_x, off_y), off_z) < STEEP * STEEP;
}

// The face of a box that looks along d, which is in its own axes. Its name is twice the axis, and 1
// more on the negative side.
fn box_face(core: Core, d: vec3f) -> Feature {
    let size = abs(d);
    let h = core.half;
    let x_axis = core.axes[0];
    let y_axis = core.axes[1];
    let z_axis = core.axes[2];
    var along = d.z;
    var face = Feature(vec3f(0.0), RECTANGLE, x_axis, h.x, y_axis, h.y, z_axis, 4u);
    var half = h.z;
    if size.x >= size.y && size.x >= size.z {
        along = d.x;
        face = Feature(vec3f(0.0), RECTANGLE, y_axis, h.y, z_axis, h.z, x_axis, 0u);
        half = h.x;
    } else if size.y >= size.z {
        along = d.y;
        face = Feature(vec3f(0.0), RECTANGLE, z_axis, h.z, x_axis, h.x, y_axis, 2u);
        half = h.y;
    }
    if along < 0.0 {
        face.normal = -face.normal;
        face.name += 1u;
    }
    face.centre = core.centre + half * face.normal;
    return face;
}

// The edge of a box that is the nearest to a right angle to d and furthest along it. Its name is four
// times the axis, and the sides of the two others.
fn box_edge(core: Core, d: vec3f) -> Feature {
    let size = abs(d);
    let h = core.half;
    let corner = vec3f(with_sign(h.x, d.x), with_sign(h.y, d.y), with_sign(h.z, d.z));
    let side_x = select(0u, 1u, d.x < 0.0);
    let side_y = select(0u, 1u, d.y < 0.0);
    let side_z = select(0u, 1u, d.z < 0.0);
    if size.x <= size.y && size.x <= size.z {
        let middle = core.centre + core.axes * vec3f(0.0, corner.y, corner.z);
        return edge(middle, core.axes[0], h.x, 2u * side_y + side_z);
    }
    if size.y <= size.z {
        let middle = core.centre + core.axes * vec3f(corner.x, 0.0, corner.z);
        return edge(middle, core.axes[1], h.y, 4u + 2u * side_z + side_x);
    }
    let middle = core.centre + core.axes * vec3f(corner.x, corner.y, 0.0);
    return edge(middle, core.axes[2], h.z, 8u + 2u * side_x + side_y);
}

// A cylinder's cap on the side of d: name 0 above, 1 below.
fn cap(core: Core, d: vec3f) -> Feature {
    let normal = with_sign(1.0, d.y) * core.axes[1];
    return Feature(
        core.centre + core.half.y * normal,
        DISC,
        core.axes[2],
        core.half.x,
        core.axes[0],
        core.half.x,
        normal,
        select(0u, 1u, d.y < 0.0),
    );
}

// The line along a cylinder's side that reaches furthest along d, or a capsule's segment: name 2.
fn side(core: Core, d: vec3f) -> Feature {
    var middle = core.centre;
    if core.kind != CAPSULE {
        middle += core.axes * (outward(d) * core.half.x);
    }
    return edge(middle, core.axes[1], core.half.y, 2u);
}

fn edge(centre: vec3f, u: vec3f, half_u: f32, name: u32) -> Feature {
    return Feature(centre, EDGE, u, half_u, u, 0.0, u, name);
}

// How many corners a feature has. A cap is held by eight of its rim, which turn with the body.
fn corner_count(feature: Feature) -> u32 {
    if feature.shape == EDGE {
        return 2u;
    }
    return select(8u, 4u, feature.shape == RECTANGLE);
}

// A corner of a feature; round a face in order.
fn corner(feature: Feature, i: u32) -> vec3f {
    // A square's corners (1, 1), (−1, 1), (−1, −1), (1, −1), and for a rim the points between.
    let turn = select(i, i / 2u, feature.shape == DISC);
    var s = select(1.0, -1.0, turn == 1u || turn == 2u);
    var t = select(1.0, -1.0, turn >= 2u);
    if feature.shape == EDGE {
        return feature.centre - s * feature.half_u * feature.u;
    }
    if feature.shape == DISC {
        if (i & 1u) == 0u {
            s *= CAP_COSINE;
            t *= CAP_COSINE;
        } else if (turn & 1u) == 0u {
            s = 0.0;
        } else {
            t = 0.0;
        }
    }
    return feature.centre + s * feature.half_u * feature.u + t * feature.half_v * feature.v;
}
