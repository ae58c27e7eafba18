//! The point of a simplex (a point, segment, triangle or tetrahedron) that is nearest to the
//! origin, and which of its vertices carry it.
//!
//! The nearest point is Σ λᵢ wᵢ with weights λᵢ ≥ 0 that add up to 1. If the origin's projection
//! has a negative weight, the nearest point lies on a side opposite to such a vertex, so we look
//! there. Where rounding may have spoiled the signs, in a simplex that is almost flat, all sides
//! are tried. [Ericson 2005, 5.1; Montanari et al. 2017]

use glam::Vec3;

use super::list::List;
use super::support_point::Vertex;

/// A triangle is flat if the sine of its angle is less.
const FLAT: f32 = 1e-6;

/// The weights of a tetrahedron add up to 1, but for this.
const TRUSTED: f32 = 0.01;

// ANCHOR: simplex
/// One to four points of the Minkowski difference, and the point of their simplex that is nearest
/// to the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simplex {
    vertices: List<Vertex, 4>,
    nearest: Nearest,
}

/// A point of a simplex.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Nearest {
    /// The point, m.
    point: Vec3,
    /// How much of each vertex it takes.
    weights: [f32; 4],
}

impl Simplex {
    /// The simplex of one to four vertices, without those that its nearest point doesn't need.
    ///
    /// # Panics
    /// If they are more.
    #[must_use]
    pub fn new(vertices: &[Vertex]) -> Self {
        let mut simplex = Self {
            vertices: List::of(vertices),
            nearest: Nearest::default(),
        };
        simplex.reduce();
        simplex
    }

    /// Takes a vertex in, and drops those that the nearest point doesn't need then.
    ///
    /// # Panics
    /// If it has four already.
    pub fn add(&mut self, vertex: Vertex) {
        self.vertices.push(vertex);
        self.reduce();
    }

    // ANCHOR: reduce
    fn reduce(&mut self) {
        self.nearest = match self.vertices.len() {
            1 => self.at_vertex(0),
            2 => self.on_segment([0, 1]),
            3 => self.on_triangle([0, 1, 2]),
            _ => self.in_tetrahedron(),
        };
        for i in (0..self.vertices.len()).rev() {
            if self.nearest.weights[i] <= 0.0 {
                self.vertices.remove(i);
                self.nearest.weights.copy_within(i + 1.., i);
            }
        }
    }
    // ANCHOR_END: reduce
    // ANCHOR_END: simplex

    /// Its vertices; four if the origin is within.
    #[must_use]
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Its point nearest to the origin, m.
    #[must_use]
    pub fn nearest(&self) -> Vec3 {
        self.nearest.point
    }

    /// The points of a and of b whose difference is the nearest point.
    #[must_use]
    pub fn witnesses(&self) -> (Vec3, Vec3) {
        let (mut on_a, mut on_b) = (Vec3::ZERO, Vec3::ZERO);
        for (vertex, &weight) in self.vertices().iter().zip(&self.nearest.weights) {
            on_a += weight * vertex.on_a;
            on_b += weight * vertex.on_b;
        }
        (on_a, on_b)
    }

    fn at_vertex(&self, i: usize) -> Nearest {
        let mut weights = [0.0; 4];
        weights[i] = 1.0;
        Nearest {
            point: self.vertices[i].point,
            weights,
        }
    }

    // ANCHOR: on_segment
    /// On the segment between two vertices: the origin's projection, kept between the ends.
    fn on_segment(&self, [i, j]: [usize; 2]) -> Nearest {
        let (a, b) = (self.vertices[i].point, self.vertices[j].point);
        let ab = b - a;
        let along = -a.dot(ab);
        let whole = ab.length_squared();
        if along <= 0.0 {
            return self.at_vertex(i);
        }
        if along >= whole {
            return self.at_vertex(j);
        }
        let t = along / whole;
        let mut weights = [0.0; 4];
        (weights[i], weights[j]) = (1.0 - t, t);
        Nearest {
            point: a + t * ab,
            weights,
        }
    }
    // ANCHOR_END: on_segment

    // ANCHOR: on_triangle
    /// On a triangle: the origin's projection a + μ ab + ν ac, where n = ab × ac, μ = n·(ac × a)/n²
    /// and ν = n·(a × ab)/n², if it lies within, else on a side that it lies beyond.
    fn on_triangle(&self, [i, j, k]: [usize; 3]) -> Nearest {
        let [a, b, c] = [i, j, k].map(|i| self.vertices[i].point);
        let (ab, ac) = (b - a, c - a);
        let n = ab.cross(ac);
        let n2 = n.length_squared();
        let flat = n2 <= FLAT * FLAT * ab.length_squared() * ac.length_squared();
        let mu = ac.cross(a).dot(n);
        let nu = a.cross(ab).dot(n);
        let rest = n2 - mu - nu;
        if !flat && mu > 0.0 && nu > 0.0 && rest > 0.0 {
            let mut weights = [0.0; 4];
            (weights[i], weights[j], weights[k]) = (rest / n2, mu / n2, nu / n2);
            let near = weights[i] * a + weights[j] * b + weights[k] * c;
            let large = near.length_squared() < ab.length_squared().max(ac.length_squared());
            let point = if large { n * (n.dot(near) / n2) } else { near };
            return Nearest { point, weights };
        }
        let sides = [(rest, [j, k]), (mu, [i, k]), (nu, [i, j])];
        let beyond = sides.iter().filter(|(weight, _)| flat || *weight <= 0.0);
        nearest_of(beyond.map(|(_, side)| self.on_segment(*side)))
    }
    // ANCHOR_END: on_triangle

    // ANCHOR: in_tetrahedron
    /// In a tetrahedron: the origin itself if it is on the inner side of all four faces, else on a
    /// face that it is outside of.
    ///
    /// The weight of a vertex is how high the origin is above the opposite face, as a share of the
    /// vertex's own height. All four are computed on their own, so if they don't add up to 1,
    /// rounding has spoiled them.
    fn in_tetrahedron(&self) -> Nearest {
        let p = [0, 1, 2, 3].map(|i| self.vertices[i].point);
        let mut weights = [0.0; 4];
        for (i, [j, k, l]) in FACES.into_iter().enumerate() {
            let n = (p[k] - p[j]).cross(p[l] - p[j]);
            weights[i] = -n.dot(p[j]) / n.dot(p[i] - p[j]);
        }
        let trusted = (weights.iter().sum::<f32>() - 1.0).abs() < TRUSTED;
        if trusted && weights.iter().all(|weight| *weight > 0.0) {
            let point = Vec3::ZERO;
            return Nearest { point, weights };
        }
        let faces = FACES.into_iter().zip(weights);
        let outside = faces.filter(|(_, weight)| !trusted || *weight <= 0.0);
        nearest_of(outside.map(|(face, _)| self.on_triangle(face)))
    }
    // ANCHOR_END: in_tetrahedron
}

/// The face opposite to each vertex of a tetrahedron.
const FACES: [[usize; 3]; 4] = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]];

/// The first of the candidates with the smallest distance from the origin.
fn nearest_of(candidates: impl Iterator<Item = Nearest>) -> Nearest {
    let mut best = Nearest::default();
    let mut least = f32::INFINITY;
    for candidate in candidates {
        let squared = candidate.point.length_squared();
        if squared < least {
            (best, least) = (candidate, squared);
        }
    }
    best
}
