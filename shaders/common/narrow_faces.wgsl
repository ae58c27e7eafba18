// Faces that lie on each other: the corners of the part that they share. They are the ends of what one
// face's edges have over the other face, and the other face's corners over the first. "Over" means
// along the contact normal, which stands on one of the two faces.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots.

// Set in the names of b's corners.
const OF_B: u32 = 128u;
// The corner that is a tilted rim's lowest point.
const LOWEST: u32 = 8u;
// The names of the points where two rims cross.
const CROSSING: u32 = 9u;

// A cap lies flat if the sine of its tilt is less: then its rim has no lowest point.
const FLAT: f32 = 1e-3;

// What the points of a feature are added as.
struct Role {
    // 1 for a feature of a, −1 for one of b.
    sign: f32,
    // What all their names have.
    name: u32,
    // How far they may be beyond the sides of the other feature, m.
    slack: f32,
}

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
    let equal = of_a.shape == of_b.shape;
    var name = (1u << 16u) | (of_a.name << 12u) | (of_b.name << 8u);
    var sign = 1.0;
    var cut = of_a;
    var face = of_b;
    if of_a.shape > of_b.shape || (equal && reach(a) >= reach(b)) {
        name |= OF_B;
        sign = -1.0;
        cut = of_b;
        face = of_a;
    }
    var role = Role(sign, name, slack);
    edges_over(spots, cut, face, role);
    rims_cross(spots, cut, face, role);
    for (var i = 0u; i < 2u; i++) {
        // The ends of edges are corners of what is cut.
        if i == 1u || cut.shape == DISC {
            corners_over(spots, cut, face, role);
        }
        let swapped = cut;
        cut = face;
        face = swapped;
        role = Role(-role.sign, role.name ^ OF_B, -slack);
    }
}

// A point over a face: where along the face's u and v, and how far along `normal` the face is from it,
// m.
fn over(face: Feature, p: vec3f, normal: vec3f) -> vec3f {
    let way = dot(face.centre - p, face.normal) / dot(normal, face.normal);
    let foot = p + way * normal - face.centre;
    return vec3f(dot(foot, face.u), dot(foot, face.v), way);
}

// Adds a point of a feature, and what is opposite it on a face.
fn place(spots: ptr<function, Spots>, p: vec3f, face: Feature, sign: f32, name: u32) {
    let normal = (*spots).normal;
    let way = over(face, p, normal).z;
    var on_a = p;
    if sign < 0.0 {
        on_a = p + way * normal;
    }
    add_spot(spots, on_a, sign * way, name);
}

// What a feature's edges have over a face: their ends, and where they leave it. An end is named by the
// corner that it is or the nearer one, so that equal boxes in a stack keep four names while they
// tremble to this side and that of being aligned.
fn edges_over(spots: ptr<function, Spots>, cut: Feature, face: Feature, role: Role) {
    if cut.shape == DISC {
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
        let part = part_over(face, start, end, role.slack);
        for (var k = 0u; k < 2u; k++) {
            let t = select(part.y, part.x, k == 0u);
            // A rectangle's corner is where its next edge starts.
            let is_new = k == 0u || (part.x < part.y && (t < 1.0 || edges == 1u));
            if part.x <= part.y && is_new {
                let name = role.name | select(j, i, t < 0.5);
                place(spots, p + t * (q - p), face, role.sign, name);
            }
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

// The corners of a feature that are over a face.
fn corners_over(spots: ptr<function, Spots>, feature: Feature, face: Feature, role: Role) {
    if face.shape == EDGE {
        return;
    }
    let normal = (*spots).normal;
    let count = corner_count(feature) + lowest_count(feature, normal);
    for (var i = 0u; i < count; i++) {
        var p = corner(feature, i);
        if i == LOWEST {
            p = lowest(feature, role.sign * normal);
        }
        let at = over(face, p, normal).xy;
        if is_over(face, at, role.slack) {
            let name = corner_name(feature, face, role.name, i, at);
            place(spots, p, face, role.sign, name);
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

// The name of a feature's corner i, which is at `at` over a face. Where both are rectangles, it is that
// of the face's corner on its side: a corner that moves a little beyond two sides of a face hands its
// name to the face's own.
fn corner_name(feature: Feature, face: Feature, name: u32, i: u32, at: vec2f) -> u32 {
    if feature.shape == DISC || face.shape == DISC {
        return name | i;
    }
    let side = select(0u, 1u, at.x < 0.0);
    return (name ^ OF_B) | select(side, 3u - side, at.y < 0.0);
}

// 1 for a cap that stands on its rim, else 0.
fn lowest_count(feature: Feature, normal: vec3f) -> u32 {
    let tilt = length(vec2f(dot(feature.u, normal), dot(feature.v, normal)));
    return select(0u, 1u, feature.shape == DISC && tilt > FLAT);
}

// The point of a cap's rim that is furthest along a direction.
fn lowest(disc: Feature, direction: vec3f) -> vec3f {
    let x = dot(disc.u, direction);
    let y = dot(disc.v, direction);
    return disc.centre + disc.half_u / length(vec2f(x, y)) * (x * disc.u + y * disc.v);
}

// Where the rims of two caps cross, as seen along the normal. Where one is tilted so much that its rim
// isn't a circle but for the slack, they have other points.
fn rims_cross(spots: ptr<function, Spots>, disc: Feature, other: Feature, role: Role) {
    if disc.shape != DISC || other.shape != DISC {
        return;
    }
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
        let across = select(-1.0, 1.0, i == 0u) * sqrt(across2);
        let x = along * between.x - across * between.y;
        let y = along * between.y + across * between.x;
        let p = disc.centre + x * disc.u + y * disc.v;
        let at = over(other, p, normal).xy;
        if is_over(other, at, role.slack) {
            place(spots, p, other, role.sign, role.name | (CROSSING + i));
        }
    }
}
