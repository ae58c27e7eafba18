// The shadow map: depths of all bodies as the sun sees them. Needs common/rotation, ch00_frame.

@vertex
fn vs_body_shadow(
    @location(0) vertex_position: vec3f,
    @location(1) axis: f32,
    @location(3) position: vec3f,
    @location(5) orientation: vec4f,
    @location(6) size: vec4f,
) -> @builtin(position) vec4f {
    let local = vertex_position * size.xyz + vec3f(0.0, axis * size.w, 0.0);
    let point = position + quat_rotate(orientation, local);
    return frame.light_view_projection * vec4f(point, 1.0);
}

const CORNERS: u32 = 20;

// A ball's shadow is that of the disc through its centre across the sunlight: a strip of
// triangles that zigzags between the two halves of the rim. The half of the ball that faces
// the sun lies before the disc, so it does not shade itself.
@vertex
fn vs_ball_shadow(
    @builtin(vertex_index) index: u32,
    @location(3) position: vec3f,
    @location(6) size: vec4f,
) -> @builtin(position) vec4f {
    let along = f32((index + 1u) / 2u) * select(1.0, -1.0, (index & 1u) == 0u);
    let angle = along * (6.2831853 / f32(CORNERS));
    // The rows of the rotation to the sun's view are the unit vectors across the sunlight.
    let view = transpose(frame.light_view_projection);
    let right = normalize(view[0].xyz);
    let up = normalize(view[1].xyz);
    let point = position + size.x * (cos(angle) * right + sin(angle) * up);
    return frame.light_view_projection * vec4f(point, 1.0);
}
