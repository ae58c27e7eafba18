// What a body does in a substep: it takes up what pulls and holds it, gathers what its pairs did to it,
// and moves. Names as in `ch06_compute::own_row::body`.
// Needs common/trigonometry, common/rotation, common/rotation_vector, common/free_rotation, rows,
// common/mouse.

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
// Starts a substep: gravity, drag, other pulls, and what held the body in the last substep: what touches
// it, and the joints of its tree.
fn kick(rigid: ptr<function, Rigid>, holding: ptr<function, Holding>, joined: Held, pull: Pull, step: Step) {
    let inverse_mass = (*rigid).inverse_mass;
    let pulled = select(vec3f(0.0), step.gravity, inverse_mass > 0.0) + pull.acceleration;
    (*rigid).velocity += step.h * pulled + ((*holding).linear + joined.linear) * inverse_mass;
    (*rigid).velocity *= step.drag;
    let turning = (*holding).angular + joined.angular + step.h * pull.torque;
    (*rigid).angular_velocity += moved_by(*rigid, turning);
    (*rigid).angular_velocity *= step.drag;
    (*holding).momentum = ((*holding).momentum + turning) * step.drag;
}
// ANCHOR_END: kick

// I⁻¹ T in world axes.
fn moved_by(rigid: Rigid, turning: vec3f) -> vec3f {
    return rotation_moment(rigid.attitude, rigid.inverse_inertia, turning);
}

// ANCHOR: drag
// The pull of the mouse on the body that it holds.
fn drag(rigid: Rigid, mouse: Mouse) -> Pull {
    let spring = spring_at(mouse, rigid.position, rigid.attitude, rigid.velocity, rigid.angular_velocity);
    return Pull(spring.force * rigid.inverse_mass, spring.torque);
}
// ANCHOR_END: drag

// ANCHOR: gather
// What a pair did to one of its bodies.
struct Given {
    // Impulse that b receives, and whether the pair counts.
    linear: vec4f,
    // Push that b receives, and whether the pair bounces.
    push: vec4f,
    // Turning impulse that the body receives, and whether the next substep begins with it.
    angular: vec4f,
    // Turning push that the body receives.
    push_angular: vec3f,
    // 1 for b, −1 for a.
    sign: f32,
}

// Adds it to the sum.
fn add(sum: ptr<function, Total>, given: Given) {
    let linear = given.sign * given.linear.xyz;
    (*sum).linear += linear;
    (*sum).angular += given.angular.xyz;
    (*sum).stays_linear += given.angular.w * linear;
    (*sum).stays_angular += given.angular.w * given.angular.xyz;
    (*sum).push += given.sign * given.push.xyz;
    (*sum).push_angular += given.push_angular;
    (*sum).counts += given.linear.w;
    (*sum).touches += given.linear.w;
    (*sum).bounces += given.push.w;
}

// Adds what a limit did to the sum: the body is its b where `sign` is 1.
fn add_turned(sum: ptr<function, Total>, turned: Turned, sign: f32) {
    (*sum).angular += sign * turned.turning;
    (*sum).stays_angular += sign * turned.turning;
    (*sum).push_angular += sign * turned.push;
    (*sum).counts += turned.counts;
}
// ANCHOR_END: gather

// ANCHOR: exchange
// Puts what holds the body now in the place of what it started the substep with.
fn exchange(rigid: ptr<function, Rigid>, holding: ptr<function, Holding>, sum: Total) {
    let turning = sum.angular - (*holding).angular;
    (*rigid).velocity += (sum.linear - (*holding).linear) * (*rigid).inverse_mass;
    (*rigid).angular_velocity += moved_by(*rigid, turning);
    (*holding).momentum += turning;
    (*holding).linear = sum.stays_linear;
    (*holding).angular = sum.stays_angular;
}
// ANCHOR_END: exchange

// The velocities that pushes are, for this body.
fn push_of(rigid: Rigid, sum: Total) -> Push {
    return Push(sum.push * rigid.inverse_mass, 0.0, moved_by(rigid, sum.push_angular), 0.0);
}

// Whether the three moments are equal, as a ball's are.
fn is_round(inertia: vec3f) -> bool {
    return inertia.x == inertia.y && inertia.y == inertia.z;
}

// ANCHOR: turned
// The attitude and the angular velocity after a substep: the push turns it, and then it turns freely with
// its angular momentum.
fn turn(rigid: ptr<function, Rigid>, momentum: vec3f, push: vec3f, h: f32) {
    let inverse_inertia = (*rigid).inverse_inertia;
    let q = (*rigid).attitude;
    if is_round(inverse_inertia) {
        (*rigid).attitude = rotation_turned(q, h * ((*rigid).angular_velocity + push));
        return;
    }
    let pushed = rotation_turned(q, h * push);
    let after = free_rotation_attitude_after(pushed, 1.0 / inverse_inertia, momentum, h);
    (*rigid).attitude = after;
    (*rigid).angular_velocity = rotation_moment(after, inverse_inertia, momentum);
}
// ANCHOR_END: turned

// ANCHOR: advance
// A body moves. One that nothing touches falls as it should: by the mean of its speeds before and after
// gravity's kick.
fn advance(rigid: ptr<function, Rigid>, momentum: vec3f, push: Push, is_alone: bool, step: Step) {
    let early = select(vec3f(0.0), 0.5 * step.h * step.gravity, is_alone);
    (*rigid).position += step.h * ((*rigid).velocity + push.velocity - early);
    turn(rigid, momentum, push.angular_velocity, step.h);
}
// ANCHOR_END: advance

// ANCHOR: turn_about
// A body on a fixed point: half of gravity's torque, a free turn, the other half.
fn turn_about(
    rigid: ptr<function, Rigid>,
    holding: ptr<function, Holding>,
    pivot: Pivot,
    push: vec3f,
    step: Step,
) {
    let weight = pivot.mass * step.gravity;
    let half = 0.5 * step.h;
    let arm = quat_rotate((*rigid).attitude, pivot.arm);
    (*holding).momentum += half * cross(arm, weight);
    turn(rigid, (*holding).momentum, push, step.h);
    let arm_after = quat_rotate((*rigid).attitude, pivot.arm);
    (*holding).momentum += half * cross(arm_after, weight);
    let omega = moved_by(*rigid, (*holding).momentum);
    (*rigid).angular_velocity = omega;
    (*rigid).position = pivot.point + arm_after;
    (*rigid).velocity = cross(omega, arm_after);
}
// ANCHOR_END: turn_about
