// The background: a vertical gradient, drawn behind everything. Needs ch00_frame.

struct Sky {
    @builtin(position) clip: vec4f,
    // 0 at the bottom of the picture, 1 at its top.
    @location(0) height: f32,
}

// One triangle that covers the picture, infinitely far away (depth 0, as depth is reversed).
@vertex
fn vs_sky(@builtin(vertex_index) index: u32) -> Sky {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    var out: Sky;
    out.clip = vec4f(4.0 * corner - 1.0, 0.0, 1.0);
    out.height = 2.0 * corner.y;
    return out;
}

@fragment
fn fs_sky(sky: Sky) -> @location(0) vec4f {
    return vec4f(mix(frame.sky_low_display.rgb, frame.sky_top_display.rgb, sky.height), 1.0);
}
