// Rotation vectors: along the axis, as long as the angle, rad. Names as in `ch00_maths::f32::rotation`.
// Needs common/trigonometry, common/rotation.

// The product a b: first b's turn, then a's.
fn quat_product(a: vec4f, b: vec4f) -> vec4f {
    let v = a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz);
    return vec4f(v, a.w * b.w - dot(a.xyz, b.xyz));
}

// q̄: the turn back.
fn quat_conjugate(q: vec4f) -> vec4f {
    return vec4f(-q.xyz, q.w);
}

// v turned back by q.
fn quat_rotate_back(q: vec4f, v: vec3f) -> vec3f {
    return quat_rotate(quat_conjugate(q), v);
}

// exp: the unit quaternion that turns by θ, rad.
fn rotation_exp(theta: vec3f) -> vec4f {
    let half2 = 0.25 * dot(theta, theta);
    let half = sqrt(half2);
    let turn = sine_cosine(half);
    var half_sinc = 0.5 - half2 / 12.0 + half2 * half2 / 240.0;
    if half >= 0.01 {
        half_sinc = 0.5 * turn.x / half;
    }
    return vec4f(half_sinc * theta, turn.y);
}

// log: the rotation vector of a unit quaternion, rad, the shorter way round.
fn rotation_log(q: vec4f) -> vec3f {
    let upper = select(q, -q, q.w < 0.0);
    let w = upper.w;
    let sine2 = dot(upper.xyz, upper.xyz);
    let sine = sqrt(sine2);
    if sine < 0.01 * w {
        let t2 = sine2 / (w * w);
        return upper.xyz * ((2.0 - t2 * (2.0 / 3.0 - t2 * (0.4 - t2 * 2.0 / 7.0))) / w);
    }
    return upper.xyz * (2.0 * arc_tangent_of(sine, w) / sine);
}

// ω(q, q*), rad/s, world frame: how it turned in the last dt seconds.
fn rotation_angular_velocity(q: vec4f, q_last: vec4f, dt: f32) -> vec3f {
    return rotation_log(normalize(quat_product(q, quat_conjugate(q_last)))) / dt;
}

// q turned by the world-frame rotation vector θ, rad.
fn rotation_turned(q: vec4f, theta: vec3f) -> vec4f {
    return normalize(quat_product(rotation_exp(theta), q));
}

// M(q, I, a): what the world vector a, an angular momentum or a torque, is as angular velocity or
// acceleration, where the body has these inverse moments.
fn rotation_moment(q: vec4f, inverse_inertia: vec3f, a: vec3f) -> vec3f {
    return quat_rotate(q, quat_rotate_back(q, a) * inverse_inertia);
}
