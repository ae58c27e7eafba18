// Bodies that are no balls: one mesh a shape, one instance a body.
//
// A mesh's vertex is placed by  position * size.xyz + (0, axis * size.w, 0)  in the body's
// coordinates: a capsule's caps scale with its radius and move by its half height, so that
// they stay round. Needs common/rotation, ch00_frame, ch00_drawn, ch00_light.

struct Vertex {
    @location(0) position: vec3f,
    // -1 or 1 at the lower and upper end of a capsule or cylinder, otherwise 0.
    @location(1) axis: f32,
    @location(2) normal: vec3f,
}

struct Instance {
    // Radius thrice and half height; or half extents and 0, m.
    @location(3) size: vec4f,
    // Linear.
    @location(4) color: vec3f,
    // 1 box, 2 capsule, 3 cylinder.
    @location(5) shape: u32,
    // The body's row.
    @location(6) body: u32,
}

struct Surface {
    @invariant @builtin(position) clip: vec4f,
    @location(0) point: vec3f,
    @location(1) normal: vec3f,
    // In the body's coordinates, in units of its size.
    @location(2) local: vec3f,
    @location(3) @interpolate(flat) shape: u32,
    @location(4) @interpolate(flat) size: vec4f,
    // Linear; a is 1 for the body that is picked.
    @location(5) @interpolate(flat) color: vec4f,
    @location(6) shadow: vec3f,
}

@vertex
fn vs_body(vertex: Vertex, instance: Instance) -> Surface {
    let local = vertex.position * instance.size.xyz + vec3f(0.0, vertex.axis * instance.size.w, 0.0);
    let orientation = drawn_orientation(instance.body);
    let point = drawn_position(instance.body) + quat_rotate(orientation, local);
    var out: Surface;
    out.clip = frame.view_projection * vec4f(point, 1.0);
    out.point = point;
    out.normal = quat_rotate(orientation, vertex.normal);
    out.local = vertex.position;
    out.shape = instance.shape;
    out.size = instance.size;
    out.color = vec4f(instance.color, glow(instance.body));
    out.shadow = shadow_place(point, out.normal);
    return out;
}

// 0 on one part of the surface and 1 on the other, with a soft border: what makes a spin visible.
// A box is divided by a frame along its edges, a capsule and a cylinder into quarters.
fn tone(surface: Surface) -> f32 {
    let p = surface.local;
    var border = p.x * p.z;
    if surface.shape == 1u {
        let rim = (vec3f(1.0) - abs(p)) * surface.size.xyz;
        // Of the three, the middle one is the distance to the nearest edge of the face; the
        // smallest is 0 all over it.
        let to_edge = min(max(rim.x, rim.y), min(max(rim.y, rim.z), max(rim.x, rim.z)));
        let smallest = min(surface.size.x, min(surface.size.y, surface.size.z));
        border = 0.16 * smallest - to_edge;
    }
    let soft = max(fwidth(border), 1e-6);
    return clamp(border / soft + 0.5, 0.0, 1.0);
}

@fragment
fn fs_body(surface: Surface) -> @location(0) vec4f {
    let n = normalize(surface.normal);
    let v = normalize(frame.camera_position - surface.point);
    return vec4f(painted(surface.color, tone(surface), n, v, sunlit(surface.shadow)), 1.0);
}

// Static bodies: plain, with the grid of the ground on what faces up.
@fragment
fn fs_static(surface: Surface) -> @location(0) vec4f {
    let n = normalize(surface.normal);
    let lines = grid(surface.point.xz) * frame.grid_color.a * smoothstep(0.95, 0.99, n.y);
    let color = mix(surface.color.rgb, frame.grid_color.rgb, lines);
    let sun = sunlit(surface.shadow) * max(dot(n, frame.sun_direction), 0.0);
    let light = color * (frame.sun_light * sun + ambient(n));
    return vec4f(to_display(light), 1.0);
}

@fragment
fn fs_glass(surface: Surface) -> @location(0) vec4f {
    let sight = surface.point - frame.camera_position;
    if is_too_close(sight) {
        discard;
    }
    return glassy(surface.color, normalize(surface.normal), -normalize(sight));
}
