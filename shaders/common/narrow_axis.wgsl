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

// The direction along which the two are the furthest apart. Faces come first, those of the larger body
// before the other's; something else has to be clearly better, or a tremor would change the normal.
fn best_axis(a: Core, b: Core) -> Way {
    let slack = slack(a, b);
    let a_is_larger = reach(a) > reach(b);
    var best = Way(vec3f(0.0, 1.0, 0.0), -HUGE);
    best = best_face(best, a, b, a_is_larger, -HUGE);
    best = best_face(best, a, b, !a_is_larger, best.apart + slack);
    best = best_crossing(best, a, b, best.apart + slack);
    let between = b.centre - a.centre;
    let least = best.apart + slack;
    best = better(best, a, b, between / max(length(between), TINY), least);
    if a.kind == CYLINDER {
        best = better(best, a, b, off_axis(a, between), least);
    }
    if b.kind == CYLINDER {
        best = better(best, a, b, off_axis(b, between), least);
    }
    return best;
}

// The better of a way and the one along `axis`, which must have bodies further apart than `least`, m.
fn better(best: Way, a: Core, b: Core, axis: vec3f, least: f32) -> Way {
    let squared = dot(axis, axis);
    if squared < PARALLEL2 {
        return best;
    }
    var normal = axis / sqrt(squared);
    if dot(normal, b.centre - a.centre) < 0.0 {
        normal = -normal;
    }
    let apart = separation(a, b, normal);
    if apart > best.apart && apart > least {
        return Way(normal, apart);
    }
    return best;
}

// The better of a way and the best one across the faces of a or of b.
fn best_face(best: Way, a: Core, b: Core, of_a: bool, least: f32) -> Way {
    var found = best;
    if of_a && has_faces(a) {
        for (var i = 0u; i < axis_count(a); i++) {
            found = better(found, a, b, axis_of(a, i), least);
        }
    }
    if !of_a && has_faces(b) {
        for (var i = 0u; i < axis_count(b); i++) {
            found = better(found, a, b, axis_of(b, i), least);
        }
    }
    return found;
}

// The better of a way and the best one across an edge of each.
fn best_crossing(best: Way, a: Core, b: Core, least: f32) -> Way {
    var found = best;
    for (var i = 0u; i < axis_count(a); i++) {
        for (var j = 0u; j < axis_count(b); j++) {
            found = better(found, a, b, cross(axis_of(a, i), axis_of(b, j)), least);
        }
    }
    return found;
}

fn has_faces(core: Core) -> bool {
    return core.kind == BOX || core.kind == CYLINDER;
}

// Along how many axes a core has edges: 3 for a box, else its y alone.
fn axis_count(core: Core) -> u32 {
    return select(1u, 3u, core.kind == BOX);
}

fn axis_of(core: Core, i: u32) -> vec3f {
    if core.kind != BOX || i == 1u {
        return core.axes[1];
    }
    if i == 0u {
        return core.axes[0];
    }
    return core.axes[2];
}

// The part of a direction, as a unit vector or none, at a right angle to a core's y.
fn off_axis(core: Core, direction: vec3f) -> vec3f {
    let off = direction - dot(direction, core.axes[1]) * core.axes[1];
    let size = length(off);
    if size > 1e-6 * reach(core) {
        return off / size;
    }
    return vec3f(0.0);
}
