// Where each body is drawn: a row a body, in the scene's order, with its place after the last step
// and one step before. An engine on the GPU writes these rows itself; for the others the window does.
// The layout is that of `ch00_shell::Drawn`. Needs ch00_frame.

struct Drawn {
    // World position of the body's origin after the last step, m.
    position: vec3f,
    // Unused.
    spare: f32,
    // Body to world after the last step.
    orientation: vec4f,
    // World position of the body's origin before the last step, m.
    position_last: vec3f,
    // Unused.
    spare_last: f32,
    // Body to world before the last step.
    orientation_last: vec4f,
}

@group(1) @binding(0) var<storage, read> drawn: array<Drawn>;

// ANCHOR: drawn
// Where a body is in this frame, between its last two places.
fn drawn_position(body: u32) -> vec3f {
    return mix(drawn[body].position_last, drawn[body].position, frame.alpha);
}

// How a body is turned in this frame: the shorter way from the one attitude to the other.
fn drawn_orientation(body: u32) -> vec4f {
    let last = drawn[body].orientation_last;
    let now = drawn[body].orientation;
    let near = select(-now, now, dot(last, now) >= 0.0);
    return normalize(mix(last, near, frame.alpha));
}
// ANCHOR_END: drawn

// 1 for the body that is picked.
fn glow(body: u32) -> f32 {
    return select(0.0, 1.0, body == frame.picked);
}
