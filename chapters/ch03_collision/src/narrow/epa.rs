//! EPA: how deep two convex solids overlap, and along which normal they part soonest.
//!
//! If a and b overlap, their Minkowski difference a − b holds the origin, and the shortest way to
//! its surface is the shortest way apart. EPA holds a polytope within a − b that holds the origin,
//! and blows it up: it takes the face nearest to the origin, and asks for the support point of a − b
//! along the face's normal. If that lies on the face, the face is part of the surface and the
//! answer; if not, the polytope grows by that point, and the faces which see it are replaced.
//! [van den Bergen 2001; 2003, 4.3.8]

use glam::Vec3;

use super::list::List;
use super::simplex::Simplex;
use super::support_point::{Core, ROUNDING, Vertex, extent};

/// Vertices that a polytope can have.
pub const MOST_VERTICES: usize = 64;

/// Faces that a closed polytope of so many vertices has at most: 2V − 4 [Euler].
pub const MOST_FACES: usize = 2 * MOST_VERTICES - 4;

/// Edges that a rim can have while it is gathered: all those of faces that share none.
const MOST_RIM: usize = 3 * MOST_FACES;

/// The depth is known where its bounds differ by this share of it.
const TOLERANCE: f32 = 1e-5;

/// A triangle that is lower than this share of the polytope's extent has no normal that one could
/// trust.
const THINNEST: f32 = 1e-5;

/// What one iteration looked at, for those who watch. All of it is in the coordinates of
/// [`Core::pair`]: the world's axes, the origin at b's centre.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// Counts from 0.
    pub iteration: usize,
    /// The polytope's vertices, in order of arrival. A vertex that is swallowed stays here.
    pub vertices: &'a [Vertex],
    /// The polytope's faces, in an order that means nothing.
    pub faces: &'a List<Face, MOST_FACES>,
    /// The place in `faces` of the one that is nearest to the origin.
    pub nearest: usize,
    /// The support point along its normal.
    pub support: Vertex,
}

/// A triangle of the polytope.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Face {
    /// Places of its corners, anticlockwise as seen from outside.
    pub corners: [u8; 3],
    /// Unit vector outwards; zero for a triangle without an area.
    pub normal: Vec3,
    /// How far the origin is behind the face's plane, m; infinite for a triangle without an area.
    pub distance: f32,
}

/// How two cores overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penetration {
    /// How far a has to go along the normal until the cores touch, m.
    pub depth: f32,
    /// Unit vector from b to a: the shortest way apart.
    pub normal: Vec3,
    /// The point of a that is deepest in b.
    pub on_a: Vec3,
    /// The point of b that is deepest in a.
    pub on_b: Vec3,
    /// False if the polytope had no room left: the depth may be a little smaller then.
    pub converged: bool,
}

/// How two cores overlap whose Minkowski difference holds the origin within `simplex`, in the
/// coordinates of [`Core::pair`].
#[must_use]
pub fn epa(a: &Core, b: &Core, simplex: &Simplex) -> Penetration {
    watched(a, b, simplex, |_| ())
}

// ANCHOR: epa
/// [`epa`], with a look at every iteration.
pub fn watched(a: &Core, b: &Core, simplex: &Simplex, mut watch: impl FnMut(&Step)) -> Penetration {
    let mut polytope = Polytope::new(&tetrahedron(a, b, simplex), extent(a, b));
    let mut best = Penetration::unknown();
    for iteration in 0.. {
        let nearest = polytope.nearest();
        let face = polytope.faces[nearest];
        let support = Vertex::support(a, b, face.normal);
        watch(&Step {
            iteration,
            vertices: &polytope.vertices,
            faces: &polytope.faces,
            nearest,
            support,
        });
        // The whole of a − b lies behind this plane, so the way out is no longer than that.
        let depth = support.point.dot(face.normal);
        if depth < best.depth {
            (best.depth, best.normal) = (depth, -face.normal);
        }
        let known = best.depth - face.distance <= polytope.tolerance(best.depth);
        best.converged = known || polytope.has(&support);
        if best.converged || !polytope.grow(nearest, support) {
            break;
        }
    }
    (best.on_a, best.on_b) = polytope.witnesses(best.depth);
    if !best.converged {
        best.polish(a, b);
    }
    best
}
// ANCHOR_END: epa

impl Penetration {
    fn unknown() -> Self {
        Self {
            depth: f32::INFINITY,
            normal: Vec3::Y,
            on_a: Vec3::ZERO,
            on_b: Vec3::ZERO,
            converged: false,
        }
    }

    // ANCHOR: polish
    /// Where a side is round, many faces are almost equally near, and the polytope may run out of
    /// room before one of them is the nearest for sure. The normal is close then: it walks
    /// downhill, at a right angle to an edge and around it, as long as that makes the way out
    /// shorter.
    fn polish(&mut self, a: &Core, b: &Core) {
        for axis in a.edge_axes().chain(b.edge_axes()) {
            self.improve(a, b, axis);
            self.improve(a, b, -axis);
            self.improve(a, b, self.normal - axis * axis.dot(self.normal));
            let mut turn = 1.0;
            while turn > 1e-3 {
                self.improve(a, b, self.normal + turn * axis.cross(self.normal));
                self.improve(a, b, self.normal - turn * axis.cross(self.normal));
                turn *= 0.5;
            }
        }
    }

    /// Takes the direction instead of the normal if that way out is shorter.
    fn improve(&mut self, a: &Core, b: &Core, direction: Vec3) {
        let normal = direction.normalize_or(self.normal);
        let depth = -Vertex::support(a, b, -normal).point.dot(normal);
        if depth < self.depth {
            (self.normal, self.depth) = (normal, depth);
        }
    }
    // ANCHOR_END: polish
}

// ANCHOR: tetrahedron
/// A tetrahedron of support points to begin with: where GJK's simplex has fewer than four
/// vertices, those furthest from it are added.
fn tetrahedron(a: &Core, b: &Core, simplex: &Simplex) -> [Vertex; 4] {
    let support = |direction| Vertex::support(a, b, direction);
    let count = simplex.vertices().len();
    let mut corners = [simplex.vertices()[0]; 4];
    corners[..count].copy_from_slice(simplex.vertices());
    let p = corners[0].point;
    if count < 2 {
        let away = |w: Vec3| (w - p).length_squared();
        corners[1] = furthest(&Vec3::AXES, support, away);
    }
    let along = corners[1].point - p;
    if count < 3 {
        let (u, v) = along.normalize_or(Vec3::Y).any_orthonormal_pair();
        let away = |w: Vec3| along.cross(w - p).length_squared();
        corners[2] = furthest(&[u, v, u + v, u - v], support, away);
    }
    let n = along.cross(corners[2].point - p);
    if count < 4 {
        let away = |w: Vec3| n.dot(w - p).abs();
        corners[3] = furthest(&[n], support, away);
    }
    if n.dot(corners[3].point - p) > 0.0 {
        corners.swap(0, 1);
    }
    corners
}
// ANCHOR_END: tetrahedron

/// Of the support points along and against some directions, the one furthest away.
fn furthest(
    directions: &[Vec3],
    support: impl Fn(Vec3) -> Vertex,
    away: impl Fn(Vec3) -> f32,
) -> Vertex {
    let mut best = support(directions[0]);
    for direction in directions.iter().flat_map(|d| [*d, -*d]) {
        let vertex = support(direction);
        if away(vertex.point) > away(best.point) {
            best = vertex;
        }
    }
    best
}

/// A closed polytope within a − b.
struct Polytope {
    vertices: List<Vertex, MOST_VERTICES>,
    faces: List<Face, MOST_FACES>,
    /// How large its coordinates may be, m.
    extent: f32,
}

impl Polytope {
    /// A tetrahedron whose fourth corner is behind the triangle of the first three.
    fn new(corners: &[Vertex; 4], extent: f32) -> Self {
        let mut polytope = Self {
            vertices: List::of(corners),
            faces: List::default(),
            extent,
        };
        for corners in [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]] {
            let face = polytope.face(corners);
            polytope.faces.push(face);
        }
        polytope
    }

    /// The place of the face whose plane is nearest to the origin.
    fn nearest(&self) -> usize {
        let (mut best, mut least) = (0, f32::INFINITY);
        for (i, face) in self.faces.iter().enumerate() {
            if face.distance < least {
                (best, least) = (i, face.distance);
            }
        }
        best
    }

    /// Whether a vertex is there already. Then the polytope has all of a − b that matters here, and
    /// what is left between the bounds is rounding.
    fn has(&self, vertex: &Vertex) -> bool {
        self.vertices
            .iter()
            .any(|known| known.point == vertex.point)
    }

    /// By how much the bounds of a depth may differ at the end, m.
    fn tolerance(&self, depth: f32) -> f32 {
        TOLERANCE * depth + ROUNDING * self.extent
    }

    // ANCHOR: grow
    /// Takes a point in: the faces of the hole go, and its rim is joined to the point. False if
    /// there is no room for that.
    fn grow(&mut self, nearest: usize, vertex: Vertex) -> bool {
        let hole = Hole::new(&self.faces, nearest, &vertex, self.extent);
        let faces = self.faces.len() - hole.faces.len() + hole.rim.len();
        if self.vertices.is_full() || faces > MOST_FACES {
            return false;
        }
        self.faces.retain(|face| !hole.has(face));
        let new = self.vertices.len() as u8;
        self.vertices.push(vertex);
        for &[i, j] in hole.rim.iter() {
            let face = self.face([i, j, new]);
            self.faces.push(face);
        }
        true
    }
    // ANCHOR_END: grow

    // ANCHOR: face
    /// The triangle of three vertices, anticlockwise as seen from outside. One without an area lies
    /// in the plane of the face beyond its first edge.
    fn face(&self, corners: [u8; 3]) -> Face {
        let [a, b, c] = corners.map(|i| self.vertices[usize::from(i)].point);
        let n = (b - a).cross(c - a);
        let area = n.length();
        let edges = [b - a, c - b, a - c].map(Vec3::length_squared);
        let longest = edges.into_iter().fold(0.0, f32::max).sqrt();
        let (normal, distance) = if area > THINNEST * self.extent * longest {
            let normal = n / area;
            (normal, normal.dot(a))
        } else {
            self.plane_beyond(corners[0], corners[1])
        };
        Face {
            corners,
            normal,
            distance,
        }
    }
    // ANCHOR_END: face

    /// The plane of the face that has the edge from j to i; none of any use if there is no such
    /// face yet.
    fn plane_beyond(&self, i: u8, j: u8) -> (Vec3, f32) {
        let beyond = self
            .faces
            .iter()
            .find(|face| face.edges().contains(&[j, i]));
        beyond.map_or((Vec3::ZERO, f32::INFINITY), |face| {
            (face.normal, face.distance)
        })
    }

    // ANCHOR: witnesses
    /// The points of a and b that belong to the point of the surface nearest to the origin. A flat
    /// side of a − b is many triangles with the same distance, and only one of them holds that
    /// point.
    fn witnesses(&self, depth: f32) -> (Vec3, Vec3) {
        let nearest = self.faces[self.nearest()].distance;
        let reach = depth.max(nearest) + self.tolerance(depth);
        let mut best = (Vec3::ZERO, Vec3::ZERO);
        let mut least = f32::INFINITY;
        for face in self.faces.iter().filter(|face| face.distance <= reach) {
            let corners = face.corners.map(|i| self.vertices[usize::from(i)]);
            let triangle = Simplex::new(&corners);
            let squared = triangle.nearest().length_squared();
            if squared < least {
                (best, least) = (triangle.witnesses(), squared);
            }
        }
        best
    }
    // ANCHOR_END: witnesses
}

/// Faces that go, and the edges between them and the faces that stay.
#[derive(Clone, Debug, Default)]
pub struct Hole {
    faces: List<[u8; 3], MOST_FACES>,
    rim: List<[u8; 2], MOST_RIM>,
}

impl Hole {
    // ANCHOR: hole
    /// Of a polytope of this extent that takes a point in: the face nearest to the origin goes,
    /// with all faces around it that see the point.
    ///
    /// Faces that see the point from elsewhere do so by rounding; they stay, since a second hole
    /// would tear the surface.
    #[must_use]
    pub fn new(
        faces: &List<Face, MOST_FACES>,
        nearest: usize,
        vertex: &Vertex,
        extent: f32,
    ) -> Self {
        let slack = ROUNDING * extent;
        let sees = |face: &Face| face.normal.dot(vertex.point) > face.distance + slack;
        let mut seeing = *faces;
        seeing.swap_remove(nearest);
        seeing.retain(sees);
        let mut hole = Self::default();
        hole.add(&faces[nearest]);
        while let Some(next) = seeing.iter().position(|face| hole.touches(face)) {
            hole.add(&seeing[next]);
            seeing.swap_remove(next);
        }
        hole
    }
    // ANCHOR_END: hole

    /// Whether a face goes.
    #[must_use]
    pub fn has(&self, face: &Face) -> bool {
        self.faces.contains(&face.corners)
    }

    // ANCHOR: rim
    /// Adds a face. Where the face beyond one of its edges has gone before, it has left the same
    /// edge the other way round: that edge is within the hole now, and forgotten.
    fn add(&mut self, face: &Face) {
        self.faces.push(face.corners);
        for [from, to] in face.edges() {
            match self.rim.iter().position(|&edge| edge == [to, from]) {
                Some(at) => self.rim.swap_remove(at),
                None => self.rim.push([from, to]),
            }
        }
    }

    /// Whether a face is right beyond the rim.
    fn touches(&self, face: &Face) -> bool {
        let mut edges = face.edges().into_iter();
        edges.any(|[from, to]| self.rim.contains(&[to, from]))
    }
    // ANCHOR_END: rim
}

impl Face {
    /// From one corner to the next.
    #[must_use]
    pub fn edges(&self) -> [[u8; 2]; 3] {
        let [i, j, k] = self.corners;
        [[i, j], [j, k], [k, i]]
    }
}
