// How a body answers to impulses when others hang on it: its articulated inertia. [Featherstone 1983]
// Names as in `ch06_compute::own_row::tree`, where it is told. Needs common/rotation, common/symmetric.

// How a body moves, or by how much a solve changes that: m/s of the point that it is taken at, rad/s.
struct Rate {
    velocity: vec3f,
    spin: vec3f,
}

// What moves a body: N s, and N m s about the point that it is taken at.
struct Wrench {
    impulse: vec3f,
    turning: vec3f,
}

// The same motion, taken at the point that is `arm` away.
fn rate_at(rate: Rate, arm: vec3f) -> Rate {
    return Rate(rate.velocity + cross(rate.spin, arm), rate.spin);
}

// The same impulse, taken about the point that is `arm` away.
fn wrench_at(wrench: Wrench, arm: vec3f) -> Wrench {
    return Wrench(wrench.impulse, wrench.turning - cross(arm, wrench.impulse));
}

// ANCHOR: articulated
struct Articulated {
    // A: the impulse that goes with a velocity, kg.
    mass: Symmetric,
    // C: the angular impulse that goes with a velocity, kg m; a column an axis.
    coupling: mat3x3f,
    // D: the angular impulse that goes with an angular velocity, kg m².
    inertia: Symmetric,
}
// ANCHOR_END: articulated

// That of a body alone, at its centre of mass.
fn articulated_of_body(inverse_mass: f32, inverse_inertia: vec3f, attitude: vec4f) -> Articulated {
    var body: Articulated;
    body.mass = symmetric_splat(1.0 / inverse_mass);
    body.inertia = world_moments(attitude, 1.0 / inverse_inertia);
    return body;
}

// ANCHOR: at
// The same inertia, taken at the point that is r away, where the velocity is v' = v + ω × r.
fn articulated_at(body: Articulated, r: vec3f) -> Articulated {
    let columns = symmetric_columns(body.mass);
    let coupling = body.coupling
        + mat3x3f(cross(columns[0], r), cross(columns[1], r), cross(columns[2], r));
    let turned = symmetric_part(times_crossing(body.coupling, r), times_crossing(coupling, r));
    return Articulated(body.mass, coupling, symmetric_plus(body.inertia, turned));
}
// ANCHOR_END: at

// What is felt at the point that is s away from where only `mass` is felt.
fn articulated_felt_at(mass: Symmetric, s: vec3f) -> Articulated {
    let columns = symmetric_columns(mass);
    let coupling = mat3x3f(cross(s, columns[0]), cross(s, columns[1]), cross(s, columns[2]));
    return Articulated(mass, coupling, symmetric_part(mat3x3f(), times_crossing(coupling, -s)));
}

// The impulses that go with a motion.
fn articulated_times(body: Articulated, rate: Rate) -> Wrench {
    return Wrench(
        symmetric_times(body.mass, rate.velocity) + rate.spin * body.coupling,
        body.coupling * rate.velocity + symmetric_times(body.inertia, rate.spin),
    );
}

// R diag(I) Rᵀ: principal moments in world axes.
fn world_moments(attitude: vec4f, moments: vec3f) -> Symmetric {
    let axes = quat_matrix(attitude);
    let x = symmetric_scaled(symmetric_outer(axes[0]), moments.x);
    let y = symmetric_scaled(symmetric_outer(axes[1]), moments.y);
    let z = symmetric_scaled(symmetric_outer(axes[2]), moments.z);
    return symmetric_plus(symmetric_plus(x, y), z);
}

// M [r], with [r] the matrix of r × .
fn times_crossing(m: mat3x3f, r: vec3f) -> mat3x3f {
    return mat3x3f(r.z * m[1] - r.y * m[2], r.x * m[2] - r.z * m[0], r.y * m[0] - r.x * m[1]);
}

// Mᵀ + N, which is symmetric.
fn symmetric_part(m: mat3x3f, n: mat3x3f) -> Symmetric {
    return Symmetric(
        vec3f(m[0].x + n[0].x, m[1].y + n[1].y, m[2].z + n[2].z),
        vec3f(m[1].z + n[2].y, m[2].x + n[0].z, m[0].y + n[1].x),
    );
}
