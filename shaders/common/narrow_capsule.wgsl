// A capsule and another one, or a box: the nearest points in closed form, then as for all others.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots,
// common/narrow_faces, common/narrow_edges, common/narrow_axis, common/narrow_simplex,
// common/narrow_gjk, common/narrow_way, common/narrow_contacts, common/narrow_convex,
// common/narrow_ball.

// Nearer than this share of the coordinates the direction between two points is mostly rounding.
const VAGUE: f32 = 1e-4;

// Two capsules: two balls where their segments are the nearest. If they lie side by side, one ball would
// let them rock, so there are two, at the ends of the stretch that they share.
fn capsule_capsule(a: Core, b: Core, margin: f32) -> Manifold {
    let of_a = edge_towards(a, vec3f(0.0, 1.0, 0.0));
    let of_b = edge_towards(b, vec3f(0.0, 1.0, 0.0));
    let near = nearest_points(of_a, of_b, vec3f(0.0));
    let between = along(of_b, near.y) - along(of_a, near.x);
    let distance = length(between);
    let rounds = a.round + b.round;
    if distance > rounds + margin {
        return Manifold();
    }
    var normal = between / max(distance, TINY);
    let across = way_out(a, b);
    if distance < SAME * extent(a, b) || separation(a, b, across) > separation(a, b, normal) {
        normal = across;
    }
    let slack = slack(a, b);
    let gap = separation(a, b, normal) + rounds;
    var spots = no_spots(normal, ROUND, rounds + margin);
    edges_meet(&spots, of_a, of_b, Meeting(gap, 0.0, a.round, b.round, slack));
    return finished(a, b, &spots, slack);
}

// The way out where two segments cross or nearly do: at a right angle to both; if they are parallel,
// sideways.
fn way_out(a: Core, b: Core) -> vec3f {
    let across = cross(a.axes[1], b.axes[1]);
    let sine = length(across);
    var normal = a.axes[0];
    if sine > 1e-3 {
        normal = across / sine;
    }
    return select(normal, -normal, dot(normal, b.centre - a.centre) < 0.0);
}

// A box and a capsule. Where the segment goes through the box, the best direction across faces and
// edges is the way out.
fn box_capsule(a: Core, b: Core, margin: f32) -> Manifold {
    let centre = to_own(a, b.centre);
    let along = to_own(a, b.axes[1]);
    let p = centre + nearest_to_box(centre, along, b.half.y, a.half) * along;
    let between = p - clamp(p, -a.half, a.half);
    let distance = length(between);
    if distance > b.round + margin {
        return Manifold();
    }
    var way: Way;
    if distance > VAGUE * extent(a, b) {
        way = Way(a.axes * (between / distance), distance - b.round);
    } else {
        way = best_axis(a, b);
    }
    return meet(a, b, way, true, margin);
}

// Where on the segment `centre` + t `along`, with |t| ≤ `reach`, the point nearest to a box is, m.
//
// The squared distance is convex in t, and half its slope is Σ eᵢ uᵢ, with e what p reaches beyond
// the box: straight pieces between the six planes of the faces. So it is 0 between the last place where
// it is negative and the first where it is positive; and on a stretch within the box.
fn nearest_to_box(centre: vec3f, along: vec3f, reach: f32, half: vec3f) -> f32 {
    var low = -reach;
    var high = reach;
    var flat_low = HUGE;
    var flat_high = -HUGE;
    for (var i = 0u; i < 8u; i++) {
        let t = clamp(bend(i, centre, along, half), -reach, reach);
        let slope = slope(centre + t * along, along, half);
        if slope < 0.0 {
            low = max(low, t);
        } else if slope > 0.0 {
            high = min(high, t);
        } else {
            flat_low = min(flat_low, t);
            flat_high = max(flat_high, t);
        }
    }
    if flat_low <= flat_high {
        return 0.5 * (flat_low + flat_high);
    }
    let at_low = slope(centre + low * along, along, half);
    let at_high = slope(centre + high * along, along, half);
    if at_low >= 0.0 {
        return low;
    }
    if at_high <= 0.0 {
        return high;
    }
    return low - at_low * (high - low) / (at_high - at_low);
}

// Where the line goes through plane i of the box's six; beyond its ends for the last two.
fn bend(i: u32, centre: vec3f, along: vec3f, half: vec3f) -> f32 {
    let side = select(1.0, -1.0, (i & 1u) == 0u);
    if i < 2u {
        return through(side * half.x - centre.x, along.x);
    }
    if i < 4u {
        return through(side * half.y - centre.y, along.y);
    }
    if i < 6u {
        return through(side * half.z - centre.z, along.z);
    }
    return side * HUGE;
}

// way / speed, or far away.
fn through(way: f32, speed: f32) -> f32 {
    if abs(speed) < 1e-9 {
        return with_sign(1e9, way);
    }
    return way / speed;
}

// Half the slope of the squared distance from a box along a line through p.
fn slope(p: vec3f, along: vec3f, half: vec3f) -> f32 {
    return dot(p - clamp(p, -half, half), along);
}
