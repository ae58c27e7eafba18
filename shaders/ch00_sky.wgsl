// The background: a vertical gradient, drawn behind everything. Needs ch00_frame.

// One triangle that covers the picture, infinitely far away (depth 0, as depth is reversed).
@vertex
fn vs_sky(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    return vec4f(4.0 * corner - 1.0, 0.0, 1.0);
}

@fragment
fn fs_sky(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    return vec4f(sky_display(pixel.y), 1.0);
}
