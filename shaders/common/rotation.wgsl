// Rotations as unit quaternions, stored x, y, z, w. Names as in `ch00_maths`.

// v turned by q: v + 2 w (u × v) + 2 u × (u × v), where q = (u, w).
fn quat_rotate(q: vec4f, v: vec3f) -> vec3f {
    let t = 2.0 * cross(q.xyz, v);
    return v + q.w * t + cross(q.xyz, t);
}
