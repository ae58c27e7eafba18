// The mouse's pull on a body: a critically damped spring, as `ch00_maths::force::spring`.
// Needs common/rotation, rows.

// Natural frequency of the spring, rad/s.
const FREQUENCY: f32 = 12.0;

// What the spring does to the body that it holds.
struct Spring {
    // N.
    force: vec3f,
    // About the body's origin, world axes, N m. The arm is kept short for it, so that a long thin body
    // isn't whirled round.
    torque: vec3f,
}

// The spring at a body that is here and moves so.
fn spring_at(mouse: Mouse, position: vec3f, attitude: vec4f, velocity: vec3f, spin: vec3f) -> Spring {
    let arm = quat_rotate(attitude, mouse.anchor);
    let stretch = mouse.towards - (position + arm);
    let speed = velocity + cross(spin, arm);
    let force = mouse.mass * FREQUENCY * (FREQUENCY * stretch - 2.0 * speed);
    return Spring(force, 0.4 * cross(arm, force));
}
