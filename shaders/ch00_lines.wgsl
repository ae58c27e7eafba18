// Lines of a given width in pixels: each instance is a line, drawn as two triangles that
// face the viewer. Needs common/rotation, ch00_frame, ch00_drawn.

struct Line {
    @location(0) start: vec3f,
    // Width in points of the screen.
    @location(1) width: f32,
    @location(2) end: vec3f,
    // Display colour.
    @location(3) color: vec4f,
}

// A line between two bodies, or within one.
struct Rod {
    // In the first body's coordinates, m.
    @location(0) start: vec3f,
    @location(1) first: u32,
    // In the second body's coordinates, m.
    @location(2) end: vec3f,
    @location(3) second: u32,
    // Width in points of the screen.
    @location(4) width: f32,
    // Display colour.
    @location(5) color: vec4f,
}

struct Stroke {
    @builtin(position) clip: vec4f,
    @location(0) color: vec4f,
    // Across the line from its middle, pixels.
    @location(1) across: f32,
    @location(2) @interpolate(flat) half_width: f32,
}

// Lines are drawn fully where nothing hides them, and thinly elsewhere.
override opacity: f32 = 1.0;

@vertex
fn vs_line(@builtin(vertex_index) index: u32, line: Line) -> Stroke {
    return corner(index, line);
}

@vertex
fn vs_rod(@builtin(vertex_index) index: u32, rod: Rod) -> Stroke {
    let start = held(rod.start, rod.first);
    let end = held(rod.end, rod.second);
    return corner(index, Line(start, rod.width, end, rod.color));
}

// Where a point of a body is in the world.
fn held(point: vec3f, body: u32) -> vec3f {
    return drawn_position(body) + quat_rotate(drawn_orientation(body), point);
}

fn corner(index: u32, line: Line) -> Stroke {
    var a = frame.view_projection * vec4f(line.start, 1.0);
    var b = frame.view_projection * vec4f(line.end, 1.0);
    // Cut off what is behind the viewer.
    let near = 1e-3;
    if a.w < near { a = mix(a, b, (near - a.w) / max(b.w - a.w, 1e-9)); }
    if b.w < near { b = mix(b, a, (near - b.w) / max(a.w - b.w, 1e-9)); }
    let direction = (b.xy / b.w - a.xy / a.w) * frame.viewport;
    let along = direction / max(length(direction), 1e-6);
    let side = f32(index & 1u) * 2.0 - 1.0;
    let half_width = 0.5 * line.width * frame.line_scale;
    // A pixel more on both sides, over which the line fades out.
    let reach = half_width + 1.0;
    let offset = vec2f(-along.y, along.x) * side * reach * 2.0 / frame.viewport;
    let end = select(a, b, index >= 2u);
    var out: Stroke;
    // A thousandth nearer, so that a line that lies on a face is before it.
    out.clip = vec4f(end.xy + offset * end.w, 1.001 * end.z, end.w);
    out.color = line.color;
    out.across = side * reach;
    out.half_width = half_width;
    return out;
}

@fragment
fn fs_line(stroke: Stroke) -> @location(0) vec4f {
    let cover = clamp(stroke.half_width + 0.5 - abs(stroke.across), 0.0, 1.0);
    return vec4f(stroke.color.rgb, stroke.color.a * opacity * cover);
}
