// The ground: a square around the focus that fades into the sky, with a grid in world units and
// the bodies' shadows. It is scenery; nothing collides with it. Needs ch00_frame, ch00_light.

// Whether the ground hides what is behind it, or only its grid and shadows are drawn.
override is_opaque: bool = true;

struct Ground {
    @builtin(position) clip: vec4f,
    @location(0) point: vec3f,
    @location(1) shadow: vec3f,
}

@vertex
fn vs_ground(@builtin(vertex_index) index: u32) -> Ground {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    let across = frame.focus.xz + corner * frame.fade_radius;
    var out: Ground;
    out.point = vec3f(across.x, frame.ground_height, across.y);
    out.shadow = shadow_place(out.point, vec3f(0.0, 1.0, 0.0));
    out.clip = frame.view_projection * vec4f(out.point, 1.0);
    return out;
}

@fragment
fn fs_ground(ground: Ground) -> @location(0) vec4f {
    let up = vec3f(0.0, 1.0, 0.0);
    let away = distance(ground.point.xz, frame.focus.xz) / frame.fade_radius;
    let fade = 1.0 - smoothstep(0.25, 1.0, away);
    let lines = grid(ground.point.xz) * frame.grid_color.a;
    let sun = sunlit(ground.shadow);
    let color = mix(frame.ground_color.rgb, frame.grid_color.rgb, lines);
    let light = color * (frame.sun_light * (sun * frame.sun_direction.y) + ambient(up));
    if is_opaque {
        return vec4f(mix(sky_display(ground.clip.y), to_display(light), fade), 1.0);
    }
    return vec4f(to_display(light), fade * max(lines, 0.5 * (1.0 - sun)));
}
