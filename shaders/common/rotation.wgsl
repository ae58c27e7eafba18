// Rotations as unit quaternions, stored x, y, z, w. Names as in `ch00_maths`.

// v turned by q: v + 2 w (u × v) + 2 u × (u × v), where q = (u, w).
fn quat_rotate(q: vec4f, v: vec3f) -> vec3f {
    let t = 2.0 * cross(q.xyz, v);
    return v + q.w * t + cross(q.xyz, t);
}

// The matrix that turns as q does: its columns are the turned axes.
fn quat_matrix(q: vec4f) -> mat3x3f {
    let v = q.xyz;
    let twice = 2.0 * v;
    let xx = v.x * twice.x;
    let yy = v.y * twice.y;
    let zz = v.z * twice.z;
    let xy = v.x * twice.y;
    let xz = v.x * twice.z;
    let yz = v.y * twice.z;
    let wv = q.w * twice;
    return mat3x3f(
        1.0 - (yy + zz), xy + wv.z, xz - wv.y,
        xy - wv.z, 1.0 - (xx + zz), yz + wv.x,
        xz + wv.y, yz - wv.x, 1.0 - (xx + yy),
    );
}
