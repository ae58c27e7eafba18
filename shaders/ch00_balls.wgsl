// Balls: each a square that faces the viewer and just covers the ball; every pixel finds the
// point where its line of sight meets the ball. So a ball is round at any size, costs two
// triangles, and its edge is as smooth as the share of a pixel that it covers.
// Needs common/rotation, ch00_frame, ch00_light.

struct Ball {
    @location(3) position: vec3f,
    @location(5) orientation: vec4f,
    // Radius, m, three times.
    @location(6) size: vec4f,
    // Linear colour; a is 1 for the body that is picked.
    @location(7) color: vec4f,
}

struct Square {
    @builtin(position) clip: vec4f,
    // From the viewer, m.
    @location(0) sight: vec3f,
    // The ball's centre from the viewer, m.
    @location(1) @interpolate(flat) centre: vec3f,
    @location(2) @interpolate(flat) radius: f32,
    @location(3) @interpolate(flat) orientation: vec4f,
    @location(4) @interpolate(flat) color: vec4f,
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
    let centre = ball.position - frame.camera_position;
    let r = ball.size.x;
    let d = max(length(centre), 1.001 * r);
    let forward = centre / d;
    let half_size = r * sqrt(1.0 - r * r / (d * d)) + frame.pixel_angle * d;
    let right = across(forward);
    let up = cross(right, forward);
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    let sight = forward * (d - r * r / d) + half_size * (corner.x * right + corner.y * up);
    var out: Square;
    out.clip = frame.view_projection * vec4f(frame.camera_position + sight, 1.0);
    out.sight = sight;
    out.centre = centre;
    out.radius = r;
    out.orientation = ball.orientation;
    out.color = ball.color;
    return out;
}

// 0 on one side of the curve of a tennis ball and 1 on the other, with a border one pixel wide:
// what makes a spin visible. p is on the unit sphere, in the ball's coordinates.
fn tone(p: vec3f, pixel: f32) -> f32 {
    let border = p.y + 1.3 * (p.x * p.x - p.z * p.z);
    return clamp(0.5 * border / pixel + 0.5, 0.0, 1.0);
}

// Where a line of sight meets the ball.
struct Hit {
    // From the viewer, m.
    point: vec3f,
    normal: vec3f,
    // Width of a pixel there, m.
    pixel: f32,
    // How much of the pixel the ball covers.
    cover: f32,
}

fn hit_of(square: Square, u: vec3f) -> Hit {
    let c = square.centre;
    let r = square.radius;
    // Along u to the point nearest to the centre, and the distance of the two.
    let b = dot(c, u);
    let s2 = max(dot(c, c) - b * b, 0.0);
    let point = u * (b - sqrt(max(r * r - s2, 0.0)));
    let pixel = frame.pixel_angle * b;
    let cover = clamp((r - sqrt(s2)) / pixel + 0.5, 0.0, 1.0);
    return Hit(point, (point - c) / r, pixel, cover);
}

fn depth_of(point: vec3f) -> f32 {
    return frame.near / dot(point, frame.camera_forward);
}

@fragment
fn fs_ball(square: Square) -> Pixel {
    let u = normalize(square.sight);
    let hit = hit_of(square, u);
    let local = quat_rotate(square.orientation * vec4f(-1.0, -1.0, -1.0, 1.0), hit.normal);
    let sun_share = sunlit(shadow_place(frame.camera_position + hit.point, hit.normal));
    let tone = tone(local, hit.pixel / square.radius);
    let color = painted(square.color, tone, hit.normal, -u, sun_share);
    if hit.cover == 0.0 {
        discard;
    }
    return Pixel(vec4f(color, hit.cover), depth_of(hit.point));
}

@fragment
fn fs_glass_ball(square: Square) -> Pixel {
    let u = normalize(square.sight);
    let hit = hit_of(square, u);
    let color = glassy(square.color, hit.normal, -u);
    if hit.cover == 0.0 || is_too_close(hit.point) {
        discard;
    }
    return Pixel(vec4f(color.rgb, color.a * hit.cover), depth_of(hit.point));
}
