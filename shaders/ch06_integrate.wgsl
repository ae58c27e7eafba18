// Chapter 5's systems `positions` and `orientations`, a body an invocation: gravity and drag, no contacts.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, advance, tables/bodies.

@group(0) @binding(0) var<uniform> advance: Advance;

// ANCHOR: positions
// p⁺ by Verlet for uneven steps; p becomes p*.
@compute @workgroup_size(WORKGROUP)
fn positions(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= advance.rows || get_bodies_inverse_mass(row) == 0.0 {
        return;
    }
    let p = get_bodies_position(row);
    let last = get_bodies_last_position(row);
    let moved = displacement(p, last, advance.gravity);
    set_bodies_last_position(row, p);
    set_bodies_position(row, p + moved);
}
// ANCHOR_END: positions

// The displacement of a step, m.
fn displacement(p: vec3f, p_last: vec3f, a: vec3f) -> vec3f {
    let dt = advance.dt;
    let goes_on = (p - p_last) * (advance.kept * dt / advance.dt_last);
    return goes_on + a * (0.5 * dt * (dt + advance.dt_last));
}

// ANCHOR: orientations
// q⁺ by the free turn of the angular momentum; q becomes q*.
@compute @workgroup_size(WORKGROUP)
fn orientations(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= advance.rows || get_bodies_inverse_mass(row) == 0.0 {
        return;
    }
    let q = get_bodies_orientation(row);
    let last = get_bodies_last_orientation(row);
    set_bodies_last_orientation(row, q);
    set_bodies_orientation(row, next_orientation(q, last, get_bodies_inertia(row)));
}
// ANCHOR_END: orientations

// A ball turns on as it turned; another body keeps its angular momentum.
fn next_orientation(q: vec4f, q_last: vec4f, inertia: vec3f) -> vec4f {
    let omega = rotation_angular_velocity(q, q_last, advance.dt_last);
    if inertia.x == inertia.y && inertia.y == inertia.z {
        return rotation_turned(q, omega * (advance.kept * advance.dt));
    }
    var found = free_rotation_momentum_of_turn(q_last, q, inertia, advance.dt_last);
    if !found.is_found {
        found.momentum = rotation_moment(q, inertia, omega);
    }
    return free_rotation_attitude_after(q, inertia, found.momentum * advance.kept, advance.dt);
}
