// Faces that lie on each other: the corners of the part that they share. They are the ends of what one
// face's edges have over the other face, and the other face's corners over the first. "Over" means
// along the contact normal, which stands on one of the two faces.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots.

// Set in the names of b's corners.
const OF_B: u32 = 128u;
// The name of a rim's lowest point.
const LOWEST: u32 = 8u;
// The names of the points where two rims cross.
const CROSSING: u32 = 9u;

// A cap lies flat if the sine of its tilt is less: then its rim has no lowest point.
const FLAT: f32 = 1e-3;

// Adds the points where a's feature and b's lie over each other, of which at most one is an edge. What
// reaches beyond a side by less than `slack`, m, is not cut.
fn faces_meet(
    spots: ptr<function, Spots>,
    a: Core,
    b: Core,
    of_a: Feature,
    of_b: Feature,
    slack: f32,
) {
    let name = (1u << 16u) | (of_a.name << 12u) | (of_b.name << 8u);
    let equal = of_a.shape == of_b.shape;
    if of_a.shape < of_b.shape || (equal && reach(a) < reach(b)) {
        edges_over(spots, of_a, of_b, 1.0, name, slack);
        corners_over(spots, of_b, of_a, -1.0, name | OF_B, -slack);
    } else {
        edges_over(spots, of_b, of_a, -1.0, name | OF_B, slack);
        corners_over(spots, of_a, of_b, 1.0, name, -slack);
    }
    lowest_over(spots, of_a, of_b, 1.0, name | LOWEST);
    lowest_over(spots, of_b, of_a, -1.0, name | OF_B | LOWEST);
}

// A point over a face: where along the face's u and v, and how far along `normal` the face is from it,
// m.
fn over(face: Feature, p: vec3f, normal: vec3f) -> vec3f {
    let way = dot(face.centre - p, face.normal) / dot(normal, face.normal);
    let foot = p + way * normal - face.centre;
    return vec3f(dot(foot, face.u), dot(foot, face.v), way);
}

// Adds a point of a's feature (`sign` 1) or of b's (−1) and what is opposite it on the other one.
fn place(spots: ptr<function, Spots>, p: vec3f, other: Feature, sign: f32, name: u32) {
    let normal = (*spots).normal;
    let way = over(other, p, normal).z;
    var on_a = p;
    if sign < 0.0 {
        on_a = p + way * normal;
    }
    add_spot(spots, on_a, sign * way, name);
}

// What a feature's edges have over a face: their ends, and where they leave it. An end is named by the
// corner that it is or the nearer one, so that equal boxes in a stack keep four names while they
// tremble to this side and that of being aligned.
fn edges_over(
    spots: ptr<function, Spots>,
    cut: Feature,
    face: Feature,
    sign: f32,
    name: u32,
    slack: f32,
) {
    if cut.shape == DISC {
        corners_over(spots, cut, face, sign, name, slack);
        rims_cross(spots, cut, face, sign, name, slack);
        return;
    }
    let normal = (*spots).normal;
    let corners = corner_count(cut);
    let edges = select(corners, 1u, cut.shape == EDGE);
    for (var i = 0u; i < edges; i++) {
        let j = (i + 1u) % corners;
        let p = corner(cut, i);
        let q = corner(cut, j);
        let start = over(face, p, normal).xy;
        let end = over(face, q, normal).xy;
        let t = part_over(face, start, end, slack);
        if t.x > t.y {
            continue;
        }
        let first = name | select(j, i, t.x < 0.5);
        place(spots, p + t.x * (q - p), face, sign, first);
        if t.x < t.y && (t.y < 1.0 || cut.shape == EDGE) {
            let last = name | select(j, i, t.y < 0.5);
            place(spots, p + t.y * (q - p), face, sign, last);
        }
    }
}

// Which part of the way from p to q, from 0 to 1, is over a face; from more than to if none is.
fn part_over(face: Feature, p: vec2f, q: vec2f, slack: f32) -> vec2f {
    if face.shape == DISC {
        return part_in_circle(p, q, face.half_u + slack);
    }
    let along_u = part_between(p.x, q.x, face.half_u + slack);
    let along_v = part_between(p.y, q.y, face.half_v + slack);
    return vec2f(max(along_u.x, along_v.x), min(along_u.y, along_v.y));
}

// Which part of the way from p to q is between −h and h.
fn part_between(p: f32, q: f32, h: f32) -> vec2f {
    let d = q - p;
    if abs(d) < 1e-6 * h {
        return select(vec2f(1.0, 0.0), vec2f(0.0, 1.0), abs(p) <= h);
    }
    let one = (-h - p) / d;
    let other = (h - p) / d;
    return vec2f(max(min(one, other), 0.0), min(max(one, other), 1.0));
}

// Which part of the way from p to q is within r of the origin.
fn part_in_circle(p: vec2f, q: vec2f, r: f32) -> vec2f {
    let d = q - p;
    let d2 = max(dot(d, d), 1e-12 * r * r);
    let half = dot(p, d);
    let root = half * half - d2 * (dot(p, p) - r * r);
    if root < 0.0 {
        return vec2f(1.0, 0.0);
    }
    let reach = sqrt(root);
    return vec2f(max((-half - reach) / d2, 0.0), min((-half + reach) / d2, 1.0));
}

// The corners of a feature that are over a face, or beyond its sides by at most `slack`, m.
fn corners_over(
    spots: ptr<function, Spots>,
    feature: Feature,
    face: Feature,
    sign: f32,
    name: u32,
    slack: f32,
) {
    if face.shape == EDGE {
        return;
    }
    for (var i = 0u; i < corner_count(feature); i++) {
        let p = corner(feature, i);
        let at = over(face, p, (*spots).normal).xy;
        if is_over(face, at, slack) {
            place(spots, p, face, sign, name | i);
        }
    }
}

fn is_over(face: Feature, p: vec2f, slack: f32) -> bool {
    if face.shape == DISC {
        let r = face.half_u + slack;
        return dot(p, p) <= r * r;
    }
    return abs(p.x) <= face.half_u + slack && abs(p.y) <= face.half_v + slack;
}

// The lowest point of a cap that stands on its rim, if it is over the face.
fn lowest_over(spots: ptr<function, Spots>, disc: Feature, face: Feature, sign: f32, name: u32) {
    if disc.shape != DISC || face.shape == EDGE {
        return;
    }
    let normal = (*spots).normal;
    let down = vec2f(dot(disc.u, normal), dot(disc.v, normal));
    let tilt = length(down);
    if tilt < FLAT {
        return;
    }
    let way = sign * disc.half_u / tilt * down;
    let p = disc.centre + way.x * disc.u + way.y * disc.v;
    let at = over(face, p, normal).xy;
    if is_over(face, at, 0.0) {
        place(spots, p, face, sign, name);
    }
}

// Where the rims of two caps cross, as seen along the normal. Where one is tilted so much that its rim
// isn't a circle but for `slack`, m, they have other points.
fn rims_cross(
    spots: ptr<function, Spots>,
    disc: Feature,
    other: Feature,
    sign: f32,
    name: u32,
    slack: f32,
) {
    let normal = (*spots).normal;
    let between = over(disc, other.centre, normal).xy;
    let d2 = dot(between, between);
    let r = disc.half_u;
    let s = other.half_u;
    if d2 < 1e-6 * r * r {
        return;
    }
    let along = 0.5 + 0.5 * (r * r - s * s) / d2;
    let across2 = r * r / d2 - along * along;
    if across2 < 0.0 {
        return;
    }
    for (var i = 0u; i < 2u; i++) {
        let across = select(-sqrt(across2), sqrt(across2), i == 0u);
        let x = along * between.x - across * between.y;
        let y = along * between.y + across * between.x;
        let p = disc.centre + x * disc.u + y * disc.v;
        let at = over(other, p, normal).xy;
        if is_over(other, at, slack) {
            place(spots, p, other, sign, name | (CROSSING + i));
        }
    }
}
