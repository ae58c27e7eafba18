// One of the two bodies of a pair, a limit or a loop, as that sees it. Names as in
// `ch06_compute::own_row::contact`. Needs common/rotation, rows.

// Below this an effective inverse mass or a length is none.
const SMALL: f32 = 1e-12;

// ANCHOR: side
struct Side {
    // World position, m.
    position: vec3f,
    // 1/m: with the whole mass.
    inverse_mass: f32,
    // Body to world.
    attitude: vec4f,
    // m/s.
    velocity: vec3f,
    // n/m: with the share of the mass that the pair has.
    shared_mass: f32,
    // rad/s.
    angular_velocity: vec3f,
    // n I⁻¹ in world axes.
    shared_inertia: mat3x3f,
    // What the two velocities were before the substep's kick.
    before: Before,
}
// ANCHOR_END: side

// Both, as one thing, for functions that look at both or change both.
struct Sides {
    a: Side,
    b: Side,
}

fn side_of(rigid: Rigid) -> Side {
    var side: Side;
    side.position = rigid.position;
    side.inverse_mass = rigid.inverse_mass;
    side.attitude = rigid.attitude;
    side.velocity = rigid.velocity;
    side.shared_mass = rigid.shares * rigid.inverse_mass;
    side.angular_velocity = rigid.angular_velocity;
    side.shared_inertia = world_inertia(rigid.attitude, rigid.shares * rigid.inverse_inertia);
    return side;
}

// R D Rᵀ: a diagonal tensor in body axes as a matrix in world axes.
fn world_inertia(q: vec4f, diagonal: vec3f) -> mat3x3f {
    let r = quat_matrix(q);
    let scaled = mat3x3f(r[0] * diagonal.x, r[1] * diagonal.y, r[2] * diagonal.z);
    return scaled * transpose(r);
}

// What an impulse on b and its opposite on a, and an angular impulse on each, make of the two: with the
// shares of their masses, as if nothing else acted.
fn take_both(sides: ptr<function, Sides>, impulse: vec3f, turning_a: vec3f, turning_b: vec3f) {
    (*sides).a.velocity -= impulse * (*sides).a.shared_mass;
    (*sides).a.angular_velocity += (*sides).a.shared_inertia * turning_a;
    (*sides).b.velocity += impulse * (*sides).b.shared_mass;
    (*sides).b.angular_velocity += (*sides).b.shared_inertia * turning_b;
}

// Both without their velocities.
fn stop_both(sides: ptr<function, Sides>) {
    (*sides).a.velocity = vec3f(0.0);
    (*sides).a.angular_velocity = vec3f(0.0);
    (*sides).b.velocity = vec3f(0.0);
    (*sides).b.angular_velocity = vec3f(0.0);
}

// Two unit vectors across a unit vector and across each other: the first of them. [Duff and others 2017]
fn across(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let p = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * p, sign * n.x * n.y * p, -sign * n.x);
}
