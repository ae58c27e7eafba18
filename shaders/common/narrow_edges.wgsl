// Edges that meet: a box's edge, the line along a cylinder's side, a capsule's segment. Where they
// cross they meet in a point; side by side, along a stretch, and its ends are two points.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots.

// Edges run side by side if the sine of the angle between them is less.
const PARALLEL: f32 = 0.1;

// How far round edges that run side by side may be from lying opposite each other, as a share of their
// radii.
const ASIDE: f32 = 0.05;

// A stretch that is shorter than this share of the edge is a point.
const SHORT: f32 = 0.01;

// Two edges as they meet.
struct Meeting {
    // How far apart they are along the normal, m.
    gap: f32,
    // How far they are pushed apart before their nearest points are taken, m.
    push: f32,
    // How round the first one's body is there: its radius, m.
    round_a: f32,
    // How round the other one's body is.
    round_b: f32,
    // m.
    slack: f32,
}

// The point at s along an edge from its middle, m.
fn along(edge: Feature, s: f32) -> vec3f {
    return edge.centre + s * edge.u;
}

// Where along an edge, from its middle, the point nearest to p is, m.
fn nearest_along(edge: Feature, p: vec3f) -> f32 {
    return clamp(dot(p - edge.centre, edge.u), -edge.half_u, edge.half_u);
}

// Where along two edges, from their middles, the points are that are nearest to each other, m, if the
// second is moved by `shift`.
fn nearest_points(one: Feature, other: Feature, shift: vec3f) -> vec2f {
    let between = other.centre + shift - one.centre;
    let n = cross(one.u, other.u);
    let sine2 = dot(n, n);
    var s = nearest_along(one, other.centre + shift);
    if sine2 > 1e-10 {
        let crossing = dot(cross(between, other.u), n) / sine2;
        s = clamp(crossing, -one.half_u, one.half_u);
    }
    let t = nearest_along(other, along(one, s) - shift);
    return vec2f(nearest_along(one, along(other, t) + shift), t);
}

// Adds the point or the points where two edges meet. The nearest points of edges that overlap say
// little. Pushed apart along the normal, they are those that overlap the most.
fn edges_meet(spots: ptr<function, Spots>, one: Feature, other: Feature, meeting: Meeting) {
    let normal = (*spots).normal;
    let name = (3u << 16u) | (one.name << 12u) | (other.name << 8u);
    let near = nearest_points(one, other, meeting.push * normal);
    let p = along(one, near.x);
    let q = along(other, near.y);
    // The rounder one yields: it is hardly thinner a little aside.
    let rounds = meeting.round_a + meeting.round_b;
    let share = (meeting.round_a + meeting.slack) / (rounds + 2.0 * meeting.slack);
    let aside = ASIDE * rounds + meeting.slack;
    let part = stretch(one, other, near.x, normal, aside);
    if part.y - part.x > SHORT * one.half_u {
        opposite(spots, one, other, part.x, share, name | 1u);
        opposite(spots, one, other, part.y, share, name | 2u);
    } else {
        add_spot(spots, p + share * off(normal, p, q), meeting.gap, name);
    }
    (*spots).least = dot(q - p, normal);
    if length(off(normal, p, q)) > meeting.slack {
        (*spots).least = HUGE;
    }
}

// How q is off from lying opposite p along the normal, m.
fn off(normal: vec3f, p: vec3f, q: vec3f) -> vec3f {
    return (q - p) - dot(q - p, normal) * normal;
}

// Adds the point at s along an edge, and the nearest one of the other; the first one is moved by a share
// of what it is off from lying opposite.
fn opposite(
    spots: ptr<function, Spots>,
    one: Feature,
    other: Feature,
    s: f32,
    share: f32,
    name: u32,
) {
    let normal = (*spots).normal;
    let p = along(one, s);
    let q = along(other, nearest_along(other, p));
    let on_a = p + share * off(normal, p, q);
    add_spot(spots, on_a, dot(q - p, normal), name);
}

// The part of an edge, from its middle, m, that lies beside another one and off from it by at most
// `aside`, m; from not less than to if there is none. They are the nearest at `s`.
fn stretch(one: Feature, other: Feature, s: f32, normal: vec3f, aside: f32) -> vec2f {
    let turn = cross(one.u, other.u);
    if dot(turn, turn) > PARALLEL * PARALLEL {
        return vec2f(0.0);
    }
    let middle = dot(other.centre - one.centre, one.u);
    let reach = other.half_u * abs(dot(one.u, other.u));
    let far = aside / max(abs(dot(turn, normal)), 1e-6);
    return vec2f(
        max(max(middle - reach, -one.half_u), s - far),
        min(min(middle + reach, one.half_u), s + far),
    );
}
