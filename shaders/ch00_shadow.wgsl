// The shadow map: depths of all bodies as the sun sees them.
// Needs common/rotation, ch00_frame, ch00_drawn.

@vertex
fn vs_body_shadow(
    @location(0) vertex_position: vec3f,
    @location(1) axis: f32,
    @location(3) size: vec4f,
    @location(6) body: u32,
) -> @builtin(position) vec4f {
    let local = vertex_position * size.xyz + vec3f(0.0, axis * size.w, 0.0);
    let point = drawn_position(body) + quat_rotate(drawn_orientation(body), local);
    return frame.light_view_projection * vec4f(point, 1.0);
}

// A ball's shadow is that of the disc through its centre across the sunlight: a strip of
// triangles that zigzags between the two halves of the rim, as large as the disc. The half of the ball that
// faces the sun lies before the disc, so it does not shade itself.
@vertex
fn vs_ball_shadow(
    @builtin(vertex_index) index: u32,
    @location(3) size: vec4f,
    @location(6) body: u32,
) -> @builtin(position) vec4f {
    let along = f32((index + 1u) / 2u) * select(1.0, -1.0, (index & 1u) == 0u);
    let part = 6.2831853 / f32(frame.ball_shadow_corners);
    let radius = size.x * sqrt(part / sin(part));
    // The rows of the rotation to the sun's view are the unit vectors across the sunlight.
    let view = transpose(frame.light_view_projection);
    let right = normalize(view[0].xyz);
    let up = normalize(view[1].xyz);
    let point = drawn_position(body) + radius * (cos(along * part) * right + sin(along * part) * up);
    return frame.light_view_projection * vec4f(point, 1.0);
}
