// A ball and anything: one point, in closed form. The ball is a, at the origin; all is computed in b's
// own axes.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots.

// Two core points are the same if they are nearer than this share of the sizes.
const SAME: f32 = 1e-6;

// The row of a ball and the point `core_b` of b, in b's own axes. `normal` is in them if it turns with
// b, else in the world.
fn one_point(radius: f32, round_b: f32, normal: vec3f, turns: u32, core_b: vec3f) -> Manifold {
    var m: Manifold;
    m.normal = normal;
    m.turns = turns;
    m.round_a = radius;
    m.round_b = round_b;
    m.points = 1u;
    m.core_a[0] = vec4f(0.0, 0.0, 0.0, bitcast<f32>(FEATURE));
    m.core_b[0] = vec4f(core_b, 0.0);
    return m;
}

// Two balls; b's centre is at `d`.
fn ball_ball(r1: f32, r2: f32, d: vec3f, margin: f32) -> Manifold {
    let distance = length(d);
    if distance > r1 + r2 + margin {
        return Manifold();
    }
    var normal = vec3f(0.0, 1.0, 0.0);
    if distance > SAME * (r1 + r2) {
        normal = d / distance;
    }
    return one_point(r1, r2, normal, ROUND, vec3f(0.0));
}

// A ball and a capsule: two balls, the second where the segment is the nearest.
fn ball_capsule(a: Posed, b: Core, margin: f32) -> Manifold {
    let radius = a.size.x;
    let p = to_own(b, -b.centre);
    let core_b = vec3f(0.0, clamp(p.y, -b.half.y, b.half.y), 0.0);
    let distance = length(core_b - p);
    if distance > radius + b.round + margin {
        return Manifold();
    }
    var normal = vec3f(1.0, 0.0, 0.0);
    if distance > SAME * (radius + b.round) {
        normal = (core_b - p) / distance;
    }
    return one_point(radius, b.round, b.axes * normal, ROUND, core_b);
}

// A ball and a box: the ball's centre is clamped to the box. A centre inside leaves by the nearest
// face.
fn ball_box(a: Posed, b: Core, margin: f32) -> Manifold {
    let radius = a.size.x;
    let p = to_own(b, -b.centre);
    var core_b = clamp(p, -b.half, b.half);
    let between = core_b - p;
    let distance = length(between);
    if distance > radius + margin {
        return Manifold();
    }
    var normal = between / max(distance, TINY);
    if distance == 0.0 {
        let way = b.half - abs(p);
        var out = vec3f(0.0, 0.0, with_sign(1.0, p.z));
        if way.x <= way.y && way.x <= way.z {
            out = vec3f(with_sign(1.0, p.x), 0.0, 0.0);
        } else if way.y <= way.z {
            out = vec3f(0.0, with_sign(1.0, p.y), 0.0);
        }
        normal = -out;
        core_b = p + min(min(way.x, way.y), way.z) * out;
    }
    return one_point(radius, 0.0, normal, WITH_B, core_b);
}

// A ball and a cylinder: the ball's centre is clamped to the cylinder. A centre inside leaves by the
// nearer of the side and the cap on its half. Where the normal runs more outwards than along the axis,
// the core point is on the axis, where it stays while the cylinder spins, and the normal keeps its
// direction.
fn ball_cylinder(a: Posed, b: Core, margin: f32) -> Manifold {
    let radius = a.size.x;
    let p = to_own(b, -b.centre);
    let out = outward(p);
    let up = vec3f(0.0, with_sign(1.0, p.y), 0.0);
    let beyond_side = dot(out, p) - b.half.x;
    let beyond_cap = abs(p.y) - b.half.y;
    var way = max(beyond_side, 0.0) * out + max(beyond_cap, 0.0) * up;
    let distance = length(way);
    if distance > radius + margin {
        return Manifold();
    }
    var normal = -way / max(distance, TINY);
    if distance == 0.0 {
        normal = -up;
        way = beyond_cap * up;
        if beyond_side > beyond_cap {
            normal = -out;
            way = beyond_side * out;
        }
    }
    let across = -dot(normal, out);
    if across < CAP_COSINE {
        return one_point(radius, 0.0, normal, WITH_B, p - way);
    }
    let lift = b.half.x / across;
    return one_point(radius, lift, b.axes * normal, FIXED, p - way + lift * normal);
}
