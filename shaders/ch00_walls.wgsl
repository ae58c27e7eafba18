// Walls: the faces of static boxes that stand around the moving bodies, as tinted glass.
// Only faces towards the inside are drawn, and only from the inside, so that a wall never
// hides what it holds. Needs ch00_frame.

struct Wall {
    @builtin(position) clip: vec4f,
    @location(0) point: vec3f,
    // Position on the face, m.
    @location(1) across: vec2f,
    @location(2) @interpolate(flat) normal: vec3f,
}

@vertex
fn vs_wall(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) across: vec2f,
) -> Wall {
    var out: Wall;
    out.clip = frame.view_projection * vec4f(position, 1.0);
    out.point = position;
    out.across = across;
    out.normal = normal;
    return out;
}

@fragment
fn fs_wall(wall: Wall) -> @location(0) vec4f {
    let away = distance(wall.point, frame.focus) / frame.fade_radius;
    let fade = 1.0 - smoothstep(0.15, 0.6, away);
    let lines = grid(wall.across) * frame.grid_color.a;
    let facing = max(dot(wall.normal, frame.sun_direction), 0.0);
    let light = frame.ground_color.rgb * (frame.sun_light * (0.5 * facing) + frame.sky_light);
    let color = mix(light, frame.grid_color.rgb * frame.sky_light, lines);
    return vec4f(to_display(color), fade * (0.35 + 0.4 * lines));
}
