// Directions in which two bodies are likely to be far apart: across their faces, across an edge of
// each, from centre to centre, and straight out from a cylinder's axis.
// Needs common/rotation, common/narrow_core.

// The sine of an angle between edges below which they have no direction across them, squared.
const PARALLEL2: f32 = 1e-6;

// A direction in which two bodies could part.
struct Way {
    // Unit vector from a to b.
    normal: vec3f,
    // How far apart they are along it, m; negative if they overlap.
    apart: f32,
}

// How many directions `candidate` has.
const CANDIDATES: u32 = 18u;

// The direction along which the two are the furthest apart. Faces come first, those of the larger body
// before the other's; something else has to be clearly better, or a tremor would change the normal.
fn best_axis(a: Core, b: Core) -> Way {
    let slack = slack(a, b);
    let between = b.centre - a.centre;
    let a_is_larger = reach(a) > reach(b);
    var best = Way(vec3f(0.0, 1.0, 0.0), -HUGE);
    var least = -HUGE;
    for (var i = 0u; i < CANDIDATES; i++) {
        if i == 3u || i == 6u || i == 15u {
            least = best.apart + slack;
        }
        let axis = candidate(a, b, a_is_larger, i);
        let squared = dot(axis, axis);
        if squared < PARALLEL2 {
            continue;
        }
        var normal = axis / sqrt(squared);
        if dot(normal, between) < 0.0 {
            normal = -normal;
        }
        let apart = separation(a, b, normal);
        if apart > best.apart && apart > least {
            best = Way(normal, apart);
        }
    }
    return best;
}

// The direction with number i, or none: 0 to 2 across the larger body's faces, 3 to 5 across the
// other's, 6 to 14 across an edge of each, 15 from centre to centre, 16 and 17 straight out from the
// axis of a cylinder.
fn candidate(a: Core, b: Core, a_is_larger: bool, i: u32) -> vec3f {
    if i < 6u {
        let of_a = (i < 3u) == a_is_larger;
        return select(face_axis(b, i % 3u), face_axis(a, i % 3u), of_a);
    }
    if i < 15u {
        return cross(edge_axis(a, i / 3u - 2u), edge_axis(b, i % 3u));
    }
    let between = b.centre - a.centre;
    if i == 16u {
        return off_axis(a, between);
    }
    if i == 17u {
        return off_axis(b, between);
    }
    return between / max(length(between), TINY);
}

// The normal of face i of three, or none.
fn face_axis(core: Core, i: u32) -> vec3f {
    if core.kind == CAPSULE {
        return vec3f(0.0);
    }
    return edge_axis(core, i);
}

// The direction of edge i of three, or none: a cylinder and a capsule have the second one.
fn edge_axis(core: Core, i: u32) -> vec3f {
    if i == 1u {
        return core.axes[1];
    }
    if core.kind != BOX {
        return vec3f(0.0);
    }
    return select(core.axes[2], core.axes[0], i == 0u);
}

// The unit vector along the part of a direction that is at a right angle to a cylinder's axis; any, if
// there is none.
fn off_axis(core: Core, direction: vec3f) -> vec3f {
    if core.kind != CYLINDER {
        return vec3f(0.0);
    }
    let off = direction - dot(direction, core.axes[1]) * core.axes[1];
    let size = length(off);
    if size > 1e-6 * reach(core) {
        return off / size;
    }
    return core.axes[0];
}
