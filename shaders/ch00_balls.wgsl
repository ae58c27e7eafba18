// Balls: each a square that faces the viewer and just covers the ball; every pixel finds the
// point where its line of sight meets the ball. So a ball is round at any size, costs two
// triangles, and its edge is as smooth as the share of a pixel that it covers.
//
// Solid balls are drawn twice: first only how deep they lie, then the colour where nothing hides
// them, so that a heap costs no more than what is seen of it, in whatever order it is drawn. Their depth is
// that of the square, which within its circle lies inside the ball: between bodies that don't overlap
// it says who is before whom as well as the ball's own surface does, and the device can throw hidden
// pixels away before it colours them. Needs common/rotation, ch00_frame, ch00_drawn, ch00_light.

struct Ball {
    // Radius, m, three times.
    @location(3) size: vec4f,
    // Linear.
    @location(4) color: vec3f,
    // The body's row.
    @location(6) body: u32,
}

struct Square {
    @invariant @builtin(position) clip: vec4f,
    // From the viewer, m.
    @location(0) sight: vec3f,
    // The ball's centre from the viewer, m.
    @location(1) @interpolate(flat) centre: vec3f,
    // Radius, m, and radius of the circle that is seen, pixels.
    @location(2) @interpolate(flat) radius: vec2f,
    @location(3) @interpolate(flat) orientation: vec4f,
    // Linear; a is 1 for the body that is picked.
    @location(4) @interpolate(flat) color: vec4f,
    // From the middle of the circle, pixels.
    @location(5) place: vec2f,
}

struct Pixel {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

// A unit vector across a unit vector.
fn across(direction: vec3f) -> vec3f {
    let other = select(vec3f(0.0, 1.0, 0.0), vec3f(1.0, 0.0, 0.0), abs(direction.y) > 0.9);
    return normalize(cross(direction, other));
}

// The edge of the ball as the viewer sees it is a circle of radius r √(1 − r²/d²) at distance
// d − r²/d; the square lies in its plane and is a pixel wider.
@vertex
fn vs_ball(@builtin(vertex_index) index: u32, ball: Ball) -> Square {
    let centre = drawn_position(ball.body) - frame.camera_position;
    let r = ball.size.x;
    let d = max(length(centre), 1.001 * r);
    let forward = centre / d;
    let to_plane = d - r * r / d;
    let circle = r * sqrt(1.0 - r * r / (d * d));
    let pixel = frame.pixel_angle * to_plane;
    let right = across(forward);
    let up = cross(right, forward);
    let corner = (vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0) * (circle + pixel);
    let sight = forward * to_plane + corner.x * right + corner.y * up;
    var out: Square;
    out.clip = frame.view_projection * vec4f(frame.camera_position + sight, 1.0);
    out.sight = sight;
    out.centre = centre;
    out.radius = vec2f(r, circle / pixel);
    out.orientation = drawn_orientation(ball.body);
    out.color = vec4f(ball.color, glow(ball.body));
    out.place = corner / pixel;
    return out;
}

// 0 on one side of the curve of a tennis ball and 1 on the other, with a border one pixel wide:
// what makes a spin visible. p is on the unit sphere, in the ball's coordinates.
fn tone(p: vec3f, pixel: f32) -> f32 {
    let border = p.y + 1.3 * (p.x * p.x - p.z * p.z);
    return clamp(0.5 * border / pixel + 0.5, 0.0, 1.0);
}

// How much of the pixel the ball covers.
fn cover(square: Square) -> f32 {
    return clamp(square.radius.y - length(square.place) + 0.5, 0.0, 1.0);
}

// Where the line of sight u meets the ball, from the viewer; beside the ball, where it comes nearest to it.
fn hit(square: Square, u: vec3f) -> vec3f {
    let c = square.centre;
    let r = square.radius.x;
    let b = dot(c, u);
    let s2 = max(dot(c, c) - b * b, 0.0);
    return u * (b - sqrt(max(r * r - s2, 0.0)));
}

fn depth_of(point: vec3f) -> f32 {
    return frame.near / dot(point, frame.camera_forward);
}

// How deep the ball lies, where it covers the whole pixel.
@fragment
fn fs_ball_depth(square: Square) {
    if cover(square) < 1.0 {
        discard;
    }
}

// The same with the depth of the ball's surface, for what is drawn after the balls and may be inside
// them, such as lines.
@fragment
fn fs_ball_surface(square: Square) -> @builtin(frag_depth) f32 {
    if cover(square) < 1.0 {
        discard;
    }
    return depth_of(hit(square, normalize(square.sight)));
}

@fragment
fn fs_ball(square: Square) -> @location(0) vec4f {
    let u = normalize(square.sight);
    let point = hit(square, u);
    let n = (point - square.centre) / square.radius.x;
    let local = quat_rotate(square.orientation * vec4f(-1.0, -1.0, -1.0, 1.0), n);
    let sun_share = sunlit(shadow_place(frame.camera_position + point, n));
    let pixel = frame.pixel_angle * dot(square.centre, u);
    let tone = tone(local, pixel / square.radius.x);
    return vec4f(painted(square.color, tone, n, -u, sun_share), cover(square));
}

@fragment
fn fs_glass_ball(square: Square) -> Pixel {
    let u = normalize(square.sight);
    let point = hit(square, u);
    let color = glassy(square.color, (point - square.centre) / square.radius.x, -u);
    let cover = cover(square);
    if cover == 0.0 || is_too_close(point) {
        discard;
    }
    return Pixel(vec4f(color.rgb, color.a * cover), depth_of(point));
}
