// Faces of a drawing: triangles in a display colour each, seen from both sides, mixed with what
// is behind them by their opacity. Needs ch00_frame.

struct Corner {
    @location(0) position: vec3f,
    // Display colour.
    @location(1) color: vec4f,
}

struct Face {
    @builtin(position) clip: vec4f,
    @location(0) color: vec4f,
}

// Faces are drawn fully where nothing hides them, and thinly elsewhere.
override opacity: f32 = 1.0;

@vertex
fn vs_face(corner: Corner) -> Face {
    var out: Face;
    out.clip = frame.view_projection * vec4f(corner.position, 1.0);
    // Half a thousandth nearer: before a body's surface, behind a line.
    out.clip.z *= 1.0005;
    out.color = corner.color;
    return out;
}

@fragment
fn fs_face(face: Face) -> @location(0) vec4f {
    return vec4f(face.color.rgb, face.color.a * opacity);
}
