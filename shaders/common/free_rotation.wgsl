// A rigid body that turns freely. Names as in `ch00_maths::f32::free_rotation`, where the method is told.
// Needs common/trigonometry, common/rotation, common/rotation_vector.

// The axes in ascending order of their moments; equal moments in the order x, y, z.
fn axes_by_moment(inertia: vec3f) -> vec3u {
    var axes = vec3u(0u, 1u, 2u);
    if inertia[axes.y] < inertia[axes.x] {
        axes = axes.yxz;
    }
    if inertia[axes.z] < inertia[axes.y] {
        axes = axes.xzy;
    }
    if inertia[axes.y] < inertia[axes.x] {
        axes = axes.yxz;
    }
    return axes;
}

// The turn, in body axes, that a body with angular momentum π (body axes, kg m²/s) makes in dt.
fn free_rotation_turn(inertia: vec3f, momentum: vec3f, dt: f32) -> vec4f {
    let axes = axes_by_moment(inertia);
    var stages = array<u32, 5>(axes.x, axes.y, axes.z, axes.y, axes.x);
    var r = vec4f(0.0, 0.0, 0.0, 1.0);
    var pi = momentum;
    for (var stage = 0u; stage < 5u; stage++) {
        let axis = stages[stage];
        let part = select(0.5, 1.0, stage == 2u);
        let half = sine_cosine(0.5 * (part * dt * pi[axis] / inertia[axis]));
        var about_axis = vec4f(0.0, 0.0, 0.0, half.y);
        about_axis[axis] = half.x;
        r = quat_product(r, about_axis);
        pi = quat_rotate_back(about_axis, pi);
    }
    return normalize(r);
}

// The attitude dt seconds after q, for a body whose angular momentum in the world is this.
fn free_rotation_attitude_after(q: vec4f, inertia: vec3f, momentum: vec3f, dt: f32) -> vec4f {
    let turn = free_rotation_turn(inertia, quat_rotate_back(q, momentum), dt);
    return normalize(quat_product(q, turn));
}

// What `free_rotation_momentum_of_turn` finds, or not.
struct FoundMomentum {
    momentum: vec3f,
    is_found: bool,
}

// The rotation vector from the turn that π makes to the turn that was made.
fn missing_turn(inertia: vec3f, pi: vec3f, dt: f32, made: vec4f) -> vec3f {
    let turn = free_rotation_turn(inertia, pi, dt);
    return rotation_log(normalize(quat_product(quat_conjugate(turn), made)));
}

// The matrix of a unit quaternion.
fn matrix_of(q: vec4f) -> mat3x3f {
    return mat3x3f(
        quat_rotate(q, vec3f(1.0, 0.0, 0.0)),
        quat_rotate(q, vec3f(0.0, 1.0, 0.0)),
        quat_rotate(q, vec3f(0.0, 0.0, 1.0)),
    );
}

// The angular momentum in the world, kg m²/s, that leads from q_last to q in dt.
fn free_rotation_momentum_of_turn(q_last: vec4f, q: vec4f, inertia: vec3f, dt: f32) -> FoundMomentum {
    let near_enough = 16.0 * 1.1920929e-7;
    let smallest_gap = 0.25 * 1.1920929e-7;
    let made = normalize(quat_product(quat_conjugate(q_last), q));
    let start = rotation_log(made);
    let halfway = matrix_of(rotation_exp(0.5 * start));
    let scale = inertia / dt;
    var slope = mat3x3f(scale * halfway[0], scale * halfway[1], scale * halfway[2]);
    var pi = inertia * start / dt;
    var gap = missing_turn(inertia, pi, dt, made);
    for (var correction = 0u; correction < 24u; correction++) {
        if dot(gap, gap) <= smallest_gap * smallest_gap {
            return FoundMomentum(quat_rotate(q_last, pi), true);
        }
        let change = slope * gap;
        pi += change;
        let gap_last = gap;
        gap = missing_turn(inertia, pi, dt, made);
        if dot(gap, gap) >= dot(gap_last, gap_last) && length(gap_last) < near_enough {
            return FoundMomentum(quat_rotate(q_last, pi - change), true);
        }
        let predicted = slope * (gap_last - gap);
        let along = dot(change, predicted);
        if along != 0.0 {
            let left = (change - predicted) * (1.0 / along);
            let right = transpose(slope) * change;
            slope += mat3x3f(left * right.x, left * right.y, left * right.z);
        }
    }
    return FoundMomentum(quat_rotate(q_last, pi), length(gap) < near_enough);
}
