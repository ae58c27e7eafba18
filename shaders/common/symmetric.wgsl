// Symmetric 3 × 3 matrices: six numbers instead of nine. Names as in `ch06_compute::own_row::tree`.

struct Symmetric {
    // xx, yy, zz.
    diagonal: vec3f,
    // yz, zx, xy.
    off: vec3f,
}

// The same number thrice on the diagonal.
fn symmetric_splat(number: f32) -> Symmetric {
    return Symmetric(vec3f(number), vec3f(0.0));
}

// u uᵀ.
fn symmetric_outer(u: vec3f) -> Symmetric {
    return Symmetric(u * u, u.yzx * u.zxy);
}

// u vᵀ + v uᵀ.
fn symmetric_outer_pair(u: vec3f, v: vec3f) -> Symmetric {
    return Symmetric(2.0 * u * v, u.yzx * v.zxy + u.zxy * v.yzx);
}

// The sum of both.
fn symmetric_plus(s: Symmetric, t: Symmetric) -> Symmetric {
    return Symmetric(s.diagonal + t.diagonal, s.off + t.off);
}

// All six times a number.
fn symmetric_scaled(s: Symmetric, number: f32) -> Symmetric {
    return Symmetric(s.diagonal * number, s.off * number);
}

// S v.
fn symmetric_times(s: Symmetric, v: vec3f) -> vec3f {
    return s.diagonal * v + s.off.zzy * v.yxx + s.off.yxx * v.zzy;
}

// Its columns, which are its rows too.
fn symmetric_columns(s: Symmetric) -> mat3x3f {
    return mat3x3f(
        s.diagonal.x, s.off.z, s.off.y,
        s.off.z, s.diagonal.y, s.off.x,
        s.off.y, s.off.x, s.diagonal.z,
    );
}

// ANCHOR: inverse
// S⁻¹ of a positive definite S, none of whose eigenvalues is below `least`: by S = L D Lᵀ.
fn symmetric_inverse(s: Symmetric, least: f32) -> Symmetric {
    let d1 = 1.0 / max(s.diagonal.x, least);
    let l21 = s.off.z * d1;
    let l31 = s.off.y * d1;
    let d2 = 1.0 / max(s.diagonal.y - s.off.z * l21, least);
    let below = s.off.x - s.off.y * l21;
    let l32 = below * d2;
    let d3 = 1.0 / max(s.diagonal.z - s.off.y * l31 - below * l32, least);
    let m31 = l21 * l32 - l31;
    let diagonal = vec3f(d1 + l21 * l21 * d2 + m31 * m31 * d3, d2 + l32 * l32 * d3, d3);
    return Symmetric(diagonal, vec3f(-l32 * d3, m31 * d3, -l21 * d2 - m31 * l32 * d3));
}
// ANCHOR_END: inverse
