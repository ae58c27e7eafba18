// Any two bodies that aren't balls, from a first direction to the row of points.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots,
// common/narrow_faces, common/narrow_edges, common/narrow_axis, common/narrow_simplex,
// common/narrow_gjk, common/narrow_way, common/narrow_contacts.

// The name of a point where bodies are the deepest in each other, if no feature has it.
const DEEPEST: u32 = 0x40000u;

// A body is pierced where it overlaps by more than this share of its smallest half extent.
const SHALLOW: f32 = 0.5;

// A normal is taken to stand on a face if it leans by less, rad.
const LEANING: f32 = 0.03;

// Where a and b meet, by the likely directions first. The best of these is the answer for boxes that
// overlap.
fn convex_convex(a: Core, b: Core, margin: f32) -> Manifold {
    let way = best_axis(a, b);
    let is_known = a.kind == BOX && b.kind == BOX && way.apart < 0.0;
    return meet(a, b, way, is_known, margin);
}

// Where a and b meet along `first`. If it isn't known to be the best way, then only if points lie
// opposite each other along it that are as near as the bodies are: no direction near it can do better
// then. A body that is pierced may be left by a quite different one.
fn meet(a: Core, b: Core, first: Way, is_known: bool, margin: f32) -> Manifold {
    let slack = slack(a, b);
    var way = first;
    var spots: Spots;
    for (var i = 0u; i < 3u; i++) {
        if way.apart > margin {
            return Manifold();
        }
        let is_last = i == 2u || (is_known && i == 1u);
        var tried = way;
        if !is_last {
            tried = settled(a, b, way);
        }
        spots = contacts(a, b, tried, margin);
        let is_there = spots.least <= way.apart + a.round + b.round + slack;
        let is_shallow = way.apart > -SHALLOW * min(thin(a), thin(b));
        if is_last || (is_there && (is_shallow || is_known || i == 1u)) {
            break;
        }
        if !is_known && i == 0u {
            way = push_apart(a, b, way);
        }
    }
    add_deepest(&spots, a, b, way, slack);
    return finished(a, b, &spots, slack);
}

// The same way, with a normal that stands on a face if it nearly does: the larger body's before the
// other's. Faces that are tilted to each other touch where an edge of one crosses an edge of the other,
// and the normal there is a little off both. One point can't hold a face; along the face's normal there
// are up to four, and the gaps there are wrong only by the square of the tilt.
fn settled(a: Core, b: Core, way: Way) -> Way {
    let of_a = face_towards(a, way.normal);
    let of_b = face_towards(b, -way.normal);
    let is_on_a = of_a.shape != EDGE && is_near(of_a.normal, way.normal);
    let is_on_b = of_b.shape != EDGE && is_near(of_b.normal, -way.normal);
    var normal = way.normal;
    if is_on_a && (reach(a) > reach(b) || !is_on_b) {
        normal = of_a.normal;
    } else if is_on_b {
        normal = -of_b.normal;
    }
    return Way(normal, way.apart);
}

fn is_near(one: vec3f, other: vec3f) -> bool {
    let turn = cross(one, other);
    return dot(turn, turn) < LEANING * LEANING;
}

// Adds the point where the two are the nearest or deepest, if no other is as near but for `slack`, m.
fn add_deepest(spots: ptr<function, Spots>, a: Core, b: Core, way: Way, slack: f32) {
    let gap = way.apart + a.round + b.round;
    var nearest = (*spots).limit;
    for (var k = 0u; k < (*spots).count; k++) {
        nearest = min(nearest, (*spots).at[k].w);
    }
    if (*spots).count > 0u && nearest <= gap + slack {
        return;
    }
    var on_a = support(a, way.normal);
    if stands_on_face(a, way.normal) {
        on_a = support(b, -way.normal) - gap * way.normal;
    }
    add_spot(spots, on_a, gap, DEEPEST);
}
