// The points where two bodies touch, before four of them are chosen: those that span the widest area,
// and the deepest. The choice begins with the first point, and of points that are about as good the
// first one wins: which four they are must not change with every tremor.
// Needs common/rotation, rows, common/narrow_core.

// Points that there can be: twice eight of a rim with the lowest, and two where rims cross.
const MOST_SPOTS: u32 = 20u;

// A point is taken instead of an earlier one if it adds more by this factor.
const CLEARLY: f32 = 1.001;

// A number between 1 and 2, whose lowest bits are a feature's name.
const FEATURE: u32 = 0x3f800000u;

// Points of two cores that lie opposite each other along a normal.
struct Spots {
    // Unit vector from a to b.
    normal: vec3f,
    // How the normal turns.
    turns: u32,
    // Cores further apart than this don't count, m.
    limit: f32,
    // How far the cores are apart where they are the nearest, m; huge if they lie nowhere opposite
    // each other.
    least: f32,
    // By how much a's core points are moved inwards along the normal, m: onto a cylinder's axis.
    lift_a: f32,
    // By how much b's are.
    lift_b: f32,
    // How many points there are.
    count: u32,
    // A point of a's core, and how far along the normal that of b's core is, m.
    at: array<vec4f, MOST_SPOTS>,
    // The points' features.
    names: array<u32, MOST_SPOTS>,
}

// No points yet.
fn no_spots(normal: vec3f, turns: u32, limit: f32) -> Spots {
    var spots: Spots;
    spots.normal = normal;
    spots.turns = turns;
    spots.limit = limit;
    spots.least = HUGE;
    return spots;
}

// Adds a point of a's core with b's core `gap` further along the normal, m, unless that is too far.
fn add_spot(spots: ptr<function, Spots>, on_a: vec3f, gap: f32, name: u32) {
    (*spots).least = min((*spots).least, gap);
    let count = (*spots).count;
    if gap <= (*spots).limit && count < MOST_SPOTS {
        (*spots).at[count] = vec4f(on_a, gap);
        (*spots).names[count] = name;
        (*spots).count = count + 1u;
    }
}

// The row that solvers read: all points if there are four at most, else the widest four with the
// deepest.
fn finished(a: Core, b: Core, spots: ptr<function, Spots>, slack: f32) -> Manifold {
    let normal = (*spots).normal;
    var m = started(a, b, normal, (*spots).turns, (*spots).lift_a, (*spots).lift_b);
    var chosen = array<u32, 4>(0u, 1u, 2u, 3u);
    var count = (*spots).count;
    if count > 4u {
        count = widest(spots, &chosen);
        keep_deepest(spots, &chosen, count, slack);
    }
    for (var i = 0u; i < count; i++) {
        let k = chosen[i];
        var name = (*spots).names[k];
        for (var j = 0u; j < i; j++) {
            // Points of the same corner get names of their own.
            if (*spots).names[chosen[j]] == (*spots).names[k] {
                name += 16u;
            }
        }
        let at = (*spots).at[k];
        put(&m, a, b, normal, at.xyz, at.w, name);
    }
    return m;
}

// A row without points.
fn started(a: Core, b: Core, normal: vec3f, turns: u32, lift_a: f32, lift_b: f32) -> Manifold {
    var m: Manifold;
    m.normal = normal;
    m.turns = turns;
    m.round_a = a.round + lift_a;
    m.round_b = b.round + lift_b;
    if turns == WITH_A {
        m.normal = to_own(a, normal);
    }
    if turns == WITH_B {
        m.normal = to_own(b, normal);
    }
    return m;
}

// Adds a point to a row that has room: one of a's core, and b's core `gap` further along the normal,
// m.
fn put(
    m: ptr<function, Manifold>,
    a: Core,
    b: Core,
    normal: vec3f,
    on_a: vec3f,
    gap: f32,
    name: u32,
) {
    let core_a = on_a - normal * ((*m).round_a - a.round) - a.centre;
    let core_b = on_a + normal * (gap + (*m).round_b - b.round) - b.centre;
    let k = (*m).points;
    (*m).core_a[k] = vec4f(to_own(a, core_a), bitcast<f32>(FEATURE | name));
    (*m).core_b[k] = vec4f(to_own(b, core_b), 0.0);
    (*m).points = k + 1u;
}

// The first point, the one furthest from it, the one that makes the largest triangle with these, and
// the one that adds most to the triangle: says how many they are.
fn widest(spots: ptr<function, Spots>, chosen: ptr<function, array<u32, 4>>) -> u32 {
    var count = 1u;
    (*chosen)[0] = 0u;
    for (var i = 1u; i < 4u; i++) {
        var best = 0u;
        var most = 0.0;
        for (var k = 1u; k < (*spots).count; k++) {
            let more = gain(spots, chosen, count, k);
            if more > CLEARLY * most {
                best = k;
                most = more;
            }
        }
        if most == 0.0 {
            break;
        }
        (*chosen)[count] = best;
        count += 1u;
    }
    return count;
}

// What point k adds to the extent of the chosen ones: a length squared, then twice an area.
fn gain(
    spots: ptr<function, Spots>,
    chosen: ptr<function, array<u32, 4>>,
    count: u32,
    k: u32,
) -> f32 {
    let normal = (*spots).normal;
    let p = (*spots).at[k].xyz;
    let first = (*spots).at[(*chosen)[0]].xyz;
    if count == 1u {
        return dot(p - first, p - first);
    }
    let second = (*spots).at[(*chosen)[1]].xyz;
    let beyond_1 = area(normal, first, second, p);
    if count == 2u {
        return abs(beyond_1);
    }
    let third = (*spots).at[(*chosen)[2]].xyz;
    let turn = with_sign(1.0, area(normal, first, second, third));
    let beyond_2 = area(normal, second, third, p);
    let beyond_3 = area(normal, third, first, p);
    let beyond = min(min(turn * beyond_1, turn * beyond_2), turn * beyond_3);
    return max(-beyond, 0.0);
}

// Twice the area of a triangle as seen along the normal, with a sign for its turn.
fn area(normal: vec3f, p: vec3f, q: vec3f, r: vec3f) -> f32 {
    return dot(cross(q - p, r - p), normal);
}

// Puts the deepest point in the place of its neighbour if none of the chosen is as deep.
fn keep_deepest(
    spots: ptr<function, Spots>,
    chosen: ptr<function, array<u32, 4>>,
    count: u32,
    slack: f32,
) {
    var deepest = 0u;
    for (var k = 1u; k < (*spots).count; k++) {
        if (*spots).at[k].w < (*spots).at[deepest].w {
            deepest = k;
        }
    }
    let at = (*spots).at[deepest];
    var have = HUGE;
    var nearest = 0u;
    var least = HUGE;
    for (var i = 0u; i < count; i++) {
        let other = (*spots).at[(*chosen)[i]];
        have = min(have, other.w);
        let away = dot(other.xyz - at.xyz, other.xyz - at.xyz);
        if away < least {
            least = away;
            nearest = i;
        }
    }
    if have > at.w + slack {
        (*chosen)[nearest] = deepest;
    }
}
