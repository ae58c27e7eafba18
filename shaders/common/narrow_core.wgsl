// A body as the narrow phase computes with it: a core, rounded by a radius. A ball's core is its
// centre, a capsule's the segment within; a box and a cylinder are cores themselves, with radius 0.
// Coordinates are along the world's axes, from the first body's centre.
// Needs common/rotation.

// The kinds of bodies.
const BALL: u32 = 0u;
const BOX: u32 = 1u;
const CAPSULE: u32 = 2u;
const CYLINDER: u32 = 3u;

// Longer than anything, m.
const HUGE: f32 = 3e38;

// Shorter than anything, m, and no subnormal number, even times a size.
const TINY: f32 = 1e-30;

// Rounding of a support point, as a share of the coordinates.
const ROUNDING: f32 = 5e-7;

// Lengths that differ by less than this share of the smaller body's size count as equal.
const SLACK: f32 = 5e-4;

// A body as the narrow phase is given it.
struct Posed {
    // World position of its origin, m.
    position: vec3f,
    // Its kind.
    kind: u32,
    // Ball: radius, 0, 0. Box: half extents. Capsule and cylinder: radius, half height, 0. m.
    size: vec3f,
    // Body to world.
    attitude: vec4f,
}

// A body's core.
struct Core {
    // Where its centre is, m.
    centre: vec3f,
    // Of the body.
    kind: u32,
    // How far it reaches along its own axes, m.
    half: vec3f,
    // How far the body's surface is outside of it, m.
    round: f32,
    // Its own axes, in the world.
    axes: mat3x3f,
}

// The core of a body of this kind, seen from somewhere.
fn core_of(kind: u32, body: Posed, centre: vec3f) -> Core {
    let size = body.size;
    var half = vec3f(0.0);
    var round = 0.0;
    switch kind {
        case BALL: {
            round = size.x;
        }
        case BOX: {
            half = size;
        }
        case CAPSULE: {
            half = vec3f(0.0, size.y, 0.0);
            round = size.x;
        }
        default: {
            half = vec3f(size.x, size.y, size.x);
        }
    }
    return Core(centre, kind, half, round, quat_matrix(body.attitude));
}

// A vector in the core's own axes.
fn to_own(core: Core, v: vec3f) -> vec3f {
    return v * core.axes;
}

// The point of the core that is furthest along `direction`, which needn't be a unit vector.
fn support(core: Core, direction: vec3f) -> vec3f {
    let d = to_own(core, direction);
    var own = vec3f(
        with_sign(core.half.x, d.x),
        with_sign(core.half.y, d.y),
        with_sign(core.half.z, d.z),
    );
    if core.kind == CYLINDER {
        let out = outward(d) * core.half.x;
        own = vec3f(out.x, own.y, out.z);
    }
    return core.centre + core.axes * own;
}

// The unit vector from the axis y along d.
fn outward(d: vec3f) -> vec3f {
    let across = sqrt(d.x * d.x + d.z * d.z);
    if across > 0.0 {
        return vec3f(d.x / across, 0.0, d.z / across);
    }
    return vec3f(1.0, 0.0, 0.0);
}

// `size` with the sign of `d`; positive for both zeros.
fn with_sign(size: f32, d: f32) -> f32 {
    return select(size, -size, d < 0.0);
}

// How far the core reaches from its centre along a unit vector, m.
fn half_width(core: Core, n: vec3f) -> f32 {
    let d = abs(to_own(core, n));
    if core.kind == CYLINDER {
        return sqrt(d.x * d.x + d.z * d.z) * core.half.x + d.y * core.half.y;
    }
    return dot(d, core.half);
}

// How far apart two bodies are along a unit vector from a to b, m; negative by the way that b has to
// go along it until they touch. Over all directions the largest is their distance.
fn separation(a: Core, b: Core, n: vec3f) -> f32 {
    let between = dot(b.centre - a.centre, n);
    return between - half_width(a, n) - half_width(b, n) - a.round - b.round;
}

// Radius of the ball about the centre that holds the core, m.
fn reach(core: Core) -> f32 {
    if core.kind == CYLINDER {
        return sqrt(core.half.x * core.half.x + core.half.y * core.half.y);
    }
    return length(core.half);
}

// The smallest half extent of a body, m.
fn thin(core: Core) -> f32 {
    let least = min(core.half.x, min(core.half.y, core.half.z));
    return select(least, core.round, core.round > 0.0);
}

// How large the smaller of two bodies is, m.
fn smaller_size(a: Core, b: Core) -> f32 {
    return min(reach(a) + a.round, reach(b) + b.round);
}

// How large the coordinates of support points may be, m.
fn extent(a: Core, b: Core) -> f32 {
    return length(b.centre - a.centre) + reach(a) + reach(b);
}

// By how much a computed length may be off, m.
fn rounding(a: Core, b: Core) -> f32 {
    return ROUNDING * extent(a, b);
}

// Lengths that differ by less count as equal, m.
fn slack(a: Core, b: Core) -> f32 {
    return SLACK * smaller_size(a, b) + rounding(a, b);
}
