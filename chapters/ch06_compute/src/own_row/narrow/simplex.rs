//! The point of a simplex (a point, segment, triangle or tetrahedron) that is nearest to the origin, and
//! which of its corners carry it. [Ericson 2005, 5.1]

use glam::Vec3;

/// A triangle is flat if the sine of its angle is less, squared.
const FLAT2: f32 = 1e-12;

// ANCHOR: simplex
/// One to three points whose nearest point to the origin needs them all, and room for one more.
#[derive(Clone, Copy, Debug)]
pub struct Simplex {
    /// The points, m.
    pub corners: [Vec3; 4],
    /// How many there are.
    pub count: u32,
    /// The point of the simplex that is nearest to the origin, m.
    pub nearest: Vec3,
}

/// A point of a segment or triangle.
#[derive(Clone, Copy, Debug)]
struct Nearest {
    /// m.
    point: Vec3,
    /// A bit for each corner that it needs.
    needs: u32,
}

/// The simplex of one point.
#[must_use]
pub fn simplex_of(corner: Vec3) -> Simplex {
    Simplex {
        corners: [corner, Vec3::ZERO, Vec3::ZERO, Vec3::ZERO],
        count: 1,
        nearest: corner,
    }
}

/// Takes a corner in, and drops those that the nearest point doesn't need then. It is taken to be
/// needed, since GJK takes in no other: so the point is on a triangle of it and two of the old ones.
pub fn take_in(simplex: &mut Simplex, corner: Vec3) {
    let last = simplex.count;
    simplex.corners[last as usize] = corner;
    let triangles = if last == 3 { 3 } else { 1 };
    let mut best = Nearest {
        point: corner,
        needs: 1 << last,
    };
    for k in 0..triangles {
        // 0 and 1, 0 and 2, 1 and 2; a single old corner twice.
        let i = k / 2;
        let j = (k + 1).min(2).min(last - 1);
        let p = simplex.corners[i as usize];
        let q = simplex.corners[j as usize];
        best = nearer(best, with_bits(on_triangle(p, q, corner), i, j, last));
    }
    simplex.nearest = best.point;
    let mut kept = 0;
    for i in 0..=last {
        if best.needs >> i & 1 == 1 {
            simplex.corners[kept as usize] = simplex.corners[i as usize];
            kept += 1;
        }
    }
    simplex.count = kept;
}
// ANCHOR_END: simplex

fn nearer(one: Nearest, other: Nearest) -> Nearest {
    if other.point.length_squared() < one.point.length_squared() {
        other
    } else {
        one
    }
}

/// The same where the three corners were the ones with bits i, j and `last`.
fn with_bits(nearest: Nearest, i: u32, j: u32, last: u32) -> Nearest {
    let needs = nearest.needs;
    Nearest {
        point: nearest.point,
        needs: (needs & 1) << i | (needs >> 1 & 1) << j | (needs >> 2 & 1) << last,
    }
}

// ANCHOR: on_segment
/// On the segment from a to b: the origin's projection, kept between the ends.
fn on_segment(a: Vec3, b: Vec3) -> Nearest {
    let ab = b - a;
    let along = -a.dot(ab);
    let whole = ab.length_squared();
    if along <= 0.0 {
        return Nearest { point: a, needs: 1 };
    }
    if along >= whole {
        return Nearest { point: b, needs: 2 };
    }
    Nearest {
        point: a + along / whole * ab,
        needs: 3,
    }
}
// ANCHOR_END: on_segment

// ANCHOR: on_triangle
/// On a triangle: the origin's projection a + μ ab + ν ac, where n = ab × ac, μ = n·(ac × a)/n² and
/// ν = n·(a × ab)/n², if it lies within, else on a side that it lies beyond.
fn on_triangle(a: Vec3, b: Vec3, c: Vec3) -> Nearest {
    let ab = b - a;
    let ac = c - a;
    let n = ab.cross(ac);
    let n2 = n.length_squared();
    let is_flat = n2 <= FLAT2 * ab.length_squared() * ac.length_squared();
    let mu = ac.cross(a).dot(n);
    let nu = a.cross(ab).dot(n);
    let rest = n2 - mu - nu;
    if !is_flat && mu > 0.0 && nu > 0.0 && rest > 0.0 {
        return Nearest {
            point: n.dot(a) / n2 * n,
            needs: 7,
        };
    }
    let mut best = Nearest { point: a, needs: 1 };
    if is_flat || nu <= 0.0 {
        best = nearer(best, on_segment(a, b));
    }
    if is_flat || mu <= 0.0 {
        let on_ac = on_segment(a, c);
        let needs = (on_ac.needs & 1) | (on_ac.needs & 2) << 1;
        best = nearer(
            best,
            Nearest {
                point: on_ac.point,
                needs,
            },
        );
    }
    if is_flat || rest <= 0.0 {
        let on_bc = on_segment(b, c);
        let needs = on_bc.needs << 1;
        best = nearer(
            best,
            Nearest {
                point: on_bc.point,
                needs,
            },
        );
    }
    best
}
// ANCHOR_END: on_triangle
