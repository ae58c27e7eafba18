// The shadow map: depths of all bodies as the sun sees them. Needs common/rotation, ch00_frame.

@vertex
fn vs_shadow(
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
