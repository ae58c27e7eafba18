// What a body does in a substep: it takes up what pulls and holds it, gathers what its pairs did to it,
// and moves. Names as in `ch06_compute::own_row::body`.
// Needs common/trigonometry, common/rotation, common/rotation_vector, common/free_rotation, rows.

// Natural frequency of the mouse's spring, rad/s.
const FREQUENCY: f32 = 12.0;

// What pulls a body beyond gravity.
struct Pull {
    // m/s².
    acceleration: vec3f,
    // About its origin, world axes, N m.
    torque: vec3f,
}

// Whether nothing moves a body.
fn is_static(rigid: Rigid) -> bool {
    return rigid.inverse_mass == 0.0 && all(rigid.inverse_inertia == vec3f(0.0));
}

// ANCHOR: kick
// Starts a substep: gravity, drag, other pulls, and what held the body in the last substep.
fn kick(rigid: ptr<function, Rigid>, held: Held, pull: Pull, step: Step) {
    let inverse_mass = (*rigid).inverse_mass;
    let pulled = select(vec3f(0.0), step.gravity, inverse_mass > 0.0) + pull.acceleration;
    (*rigid).velocity += step.h * pulled + held.linear * inverse_mass;
    (*rigid).velocity *= step.drag;
    let turning = held.angular + step.h * pull.torque;
    (*rigid).angular_velocity += moved_by(*rigid, turning);
    (*rigid).angular_velocity *= step.drag;
}
// ANCHOR_END: kick

// I⁻¹ T in world axes.
fn moved_by(rigid: Rigid, turning: vec3f) -> vec3f {
    return rotation_moment(rigid.attitude, rigid.inverse_inertia, turning);
}

// ANCHOR: drag
// The pull of the mouse on the body that it holds.
fn drag(rigid: Rigid, mouse: Mouse) -> Pull {
    let arm = quat_rotate(rigid.attitude, mouse.anchor);
    let stretch = mouse.towards - (rigid.position + arm);
    let speed = rigid.velocity + cross(rigid.angular_velocity, arm);
    let force = mouse.mass * FREQUENCY * (FREQUENCY * stretch - 2.0 * speed);
    return Pull(force * rigid.inverse_mass, 0.4 * cross(arm, force));
}
// ANCHOR_END: drag

// ANCHOR: gather
// Adds what a pair did to the body: the body is its b if `side` is 1, else its a.
fn add(sum: ptr<function, Total>, linear: vec4f, push: vec4f, angular: vec3f, push_angular: vec3f, side: u32) {
    let sign = select(-1.0, 1.0, side == 1u);
    (*sum).linear += sign * linear.xyz;
    (*sum).angular += angular;
    (*sum).push += sign * push.xyz;
    (*sum).push_angular += push_angular;
    (*sum).counts += linear.w;
    (*sum).bounces += push.w;
}
// ANCHOR_END: gather

// ANCHOR: exchange
// Puts what holds the body now in the place of what it started the substep with.
fn exchange(rigid: ptr<function, Rigid>, old: Held, linear: vec3f, angular: vec3f) {
    (*rigid).velocity += (linear - old.linear) * (*rigid).inverse_mass;
    (*rigid).angular_velocity += moved_by(*rigid, angular - old.angular);
}
// ANCHOR_END: exchange

// ANCHOR: turned
// The attitude and the angular velocity after a substep: the push turns it, and then it turns freely with
// its angular momentum.
fn turn(rigid: ptr<function, Rigid>, push: vec3f, h: f32) {
    let inverse_inertia = (*rigid).inverse_inertia;
    let q = (*rigid).attitude;
    let spin = (*rigid).angular_velocity;
    if inverse_inertia.x == inverse_inertia.y && inverse_inertia.y == inverse_inertia.z {
        (*rigid).attitude = rotation_turned(q, h * (spin + push));
        return;
    }
    let inertia = 1.0 / inverse_inertia;
    let pushed = rotation_turned(q, h * push);
    let momentum = rotation_moment(pushed, inertia, spin);
    let after = free_rotation_attitude_after(pushed, inertia, momentum, h);
    (*rigid).attitude = after;
    (*rigid).angular_velocity = rotation_moment(after, inverse_inertia, momentum);
}
// ANCHOR_END: turned

// ANCHOR: advance
// A body moves. One that nothing touches falls as it should: by the mean of its speeds before and after
// gravity's kick.
fn advance(rigid: ptr<function, Rigid>, sum: Total, step: Step) {
    let alone = sum.counts == 0.0;
    let early = select(vec3f(0.0), 0.5 * step.h * step.gravity, alone);
    let push = sum.push * (*rigid).inverse_mass;
    let push_spin = moved_by(*rigid, sum.push_angular);
    (*rigid).position += step.h * ((*rigid).velocity + push - early);
    turn(rigid, push_spin, step.h);
}
// ANCHOR_END: advance

// ANCHOR: turn_about
// A body on a fixed point: half of gravity's torque, a free turn, the other half.
fn turn_about(rigid: ptr<function, Rigid>, pivot: Pivot, push: vec3f, step: Step) {
    let weight = pivot.mass * step.gravity;
    let half = 0.5 * step.h;
    let arm = quat_rotate((*rigid).attitude, pivot.arm);
    (*rigid).angular_velocity += moved_by(*rigid, half * cross(arm, weight));
    turn(rigid, push, step.h);
    let arm_after = quat_rotate((*rigid).attitude, pivot.arm);
    (*rigid).angular_velocity += moved_by(*rigid, half * cross(arm_after, weight));
    (*rigid).position = pivot.point + arm_after;
    (*rigid).velocity = cross((*rigid).angular_velocity, arm_after);
}
// ANCHOR_END: turn_about
