// The point of a simplex (a point, segment, triangle or tetrahedron) that is nearest to the origin, and
// which of its corners carry it.

// A triangle is flat if the sine of its angle is less, squared.
const FLAT2: f32 = 1e-12;

// One to three points whose nearest point to the origin needs them all, and room for one more.
struct Simplex {
    // The points, m.
    corners: array<vec3f, 4>,
    // How many there are.
    count: u32,
    // The point of the simplex that is nearest to the origin, m.
    nearest: vec3f,
}

// A point of a segment or triangle.
struct Nearest {
    // m.
    point: vec3f,
    // A bit for each corner that it needs.
    needs: u32,
}

// The simplex of one point.
fn simplex_of(corner: vec3f) -> Simplex {
    var simplex: Simplex;
    simplex.corners[0] = corner;
    simplex.count = 1u;
    simplex.nearest = corner;
    return simplex;
}

// Takes a corner in, and drops those that the nearest point doesn't need then. It is taken to be
// needed, since GJK takes in no other: so the point is on a triangle of it and two of the old ones.
fn take_in(simplex: ptr<function, Simplex>, corner: vec3f) {
    let last = (*simplex).count;
    (*simplex).corners[last] = corner;
    let triangles = select(1u, 3u, last == 3u);
    var best = Nearest(corner, 1u << last);
    for (var k = 0u; k < triangles; k++) {
        // 0 and 1, 0 and 2, 1 and 2; a single old corner twice.
        let i = k / 2u;
        let j = min(min(k + 1u, 2u), last - 1u);
        let p = (*simplex).corners[i];
        let q = (*simplex).corners[j];
        best = nearer(best, with_bits(on_triangle(p, q, corner), i, j, last));
    }
    (*simplex).nearest = best.point;
    var kept = 0u;
    for (var i = 0u; i <= last; i++) {
        if ((best.needs >> i) & 1u) == 1u {
            (*simplex).corners[kept] = (*simplex).corners[i];
            kept += 1u;
        }
    }
    (*simplex).count = kept;
}

fn nearer(one: Nearest, other: Nearest) -> Nearest {
    if dot(other.point, other.point) < dot(one.point, one.point) {
        return other;
    }
    return one;
}

// The same where the three corners were the ones with bits i, j and `last`.
fn with_bits(nearest: Nearest, i: u32, j: u32, last: u32) -> Nearest {
    let needs = nearest.needs;
    let bits = ((needs & 1u) << i) | (((needs >> 1u) & 1u) << j) | (((needs >> 2u) & 1u) << last);
    return Nearest(nearest.point, bits);
}

// On the segment from a to b: the origin's projection, kept between the ends.
fn on_segment(a: vec3f, b: vec3f) -> Nearest {
    let ab = b - a;
    let along = -dot(a, ab);
    let whole = dot(ab, ab);
    if along <= 0.0 {
        return Nearest(a, 1u);
    }
    if along >= whole {
        return Nearest(b, 2u);
    }
    return Nearest(a + along / whole * ab, 3u);
}

// On a triangle: the origin's projection a + μ ab + ν ac, where n = ab × ac, μ = n·(ac × a)/n² and
// ν = n·(a × ab)/n², if it lies within, else on a side that it lies beyond.
fn on_triangle(a: vec3f, b: vec3f, c: vec3f) -> Nearest {
    let ab = b - a;
    let ac = c - a;
    let n = cross(ab, ac);
    let n2 = dot(n, n);
    let is_flat = n2 <= FLAT2 * dot(ab, ab) * dot(ac, ac);
    let mu = dot(cross(ac, a), n);
    let nu = dot(cross(a, ab), n);
    let rest = n2 - mu - nu;
    if !is_flat && mu > 0.0 && nu > 0.0 && rest > 0.0 {
        return Nearest(dot(n, a) / n2 * n, 7u);
    }
    var best = Nearest(a, 1u);
    if is_flat || nu <= 0.0 {
        best = nearer(best, on_segment(a, b));
    }
    if is_flat || mu <= 0.0 {
        let on_ac = on_segment(a, c);
        best = nearer(best, Nearest(on_ac.point, (on_ac.needs & 1u) | ((on_ac.needs & 2u) << 1u)));
    }
    if is_flat || rest <= 0.0 {
        let on_bc = on_segment(b, c);
        best = nearer(best, Nearest(on_bc.point, on_bc.needs << 1u));
    }
    return best;
}
