//! What an iteration looked at, drawn twice: among the differences, where it happens, and on the
//! two solids, whose points the differences are.

use ch00_scenes::{Drawing, Rgb, palette};
use glam::Vec3;

use super::Shown;
use crate::narrow::Touch;
use crate::narrow::epa;
use crate::narrow::shortest_way::{ShortestWay, Side};
use crate::narrow::simplex::Simplex;
use crate::narrow::support_point::Vertex;

const SIMPLEX: Rgb = palette::BLUE;
const NEAREST: Rgb = palette::ORANGE;
const SUPPORT: Rgb = palette::VERMILLION;
const BOUND: Rgb = palette::GREEN;
const POLYTOPE: Rgb = palette::GREEN;
const GOING: Rgb = palette::PURPLE;

/// The leading face on its solid, and the plane against its normal in front of which no difference
/// lies.
pub fn draw_faces(shown: &mut Shown, face: &ShortestWay, support: &Vertex) {
    let spread = shown.spread();
    let normal = face.normal;
    let foot = normal * face.separation;
    let touched = support.point - normal * shown.run.radii();
    let difference = &mut shown.difference;
    difference.line(Vec3::ZERO, foot, 2.5, NEAREST);
    difference.disc(foot, normal, 0.5 * spread, BOUND, 0.16);
    difference.ring(foot, normal, 0.5 * spread, 1.2, BOUND);
    difference.dashes(foot, touched, 0.04 * spread, 1.2, BOUND);
    let tip = foot - normal * (0.4 * spread);
    difference.arrow_with_head(foot, tip, 0.09 * spread, 1.5, palette::BLUE);
    difference.explain(BOUND, "plane: all differences lie on its one side");
    difference.explain(NEAREST, "how far apart, or how deep, along the normal");
    difference.explain(palette::BLUE, "against the normal");
    difference.mark(touched, SUPPORT, "w");
    shown.mark_bodies(support, SUPPORT, "w");
    let (run, origin) = (shown.run, shown.origin);
    let feature = match face.face {
        Some(Side::A) => run.a.widest_feature(-normal),
        _ => run.b.widest_feature(normal),
    };
    let mut outline: Vec<Vec3> = feature.corners().iter().map(|at| origin + *at).collect();
    shown.world.polygon(&outline, NEAREST, 0.35);
    outline.extend(outline.first().copied());
    shown.world.path(&outline, 2.4, NEAREST);
}

/// GJK: simplex, its nearest point v, the support point w and the plane through it.
pub fn draw_gjk(shown: &mut Shown, simplex: &Simplex, support: &Vertex, at_least: f32) {
    let v = simplex.nearest();
    let direction = v.normalize_or_zero();
    let size = shown.spread();
    let vertices = simplex.vertices();
    draw_simplex(&mut shown.difference, vertices, 2.0);
    for vertex in vertices {
        shown.name_vertex(vertex, SIMPLEX);
    }
    let difference = &mut shown.difference;
    difference.line(Vec3::ZERO, v, 2.5, NEAREST);
    difference.mark(v, NEAREST, "v");
    let foot = direction * at_least;
    let spread = 0.5 * size;
    difference.disc(foot, direction.normalize_or(Vec3::Y), spread, BOUND, 0.16);
    difference.ring(foot, direction.normalize_or(Vec3::Y), spread, 1.2, BOUND);
    difference.dashes(foot, support.point, 0.04 * size, 1.2, BOUND);
    for vertex in vertices {
        difference.dashes(vertex.point, support.point, 0.05 * size, 1.2, SUPPORT);
    }
    let tail = v - direction * (0.45 * size);
    difference.arrow_with_head(v, tail, 0.09 * size, 1.5, SUPPORT);
    difference.explain(SIMPLEX, "simplex");
    difference.explain(NEAREST, "v, its nearest point");
    difference.explain(SUPPORT, "w, the support point along −v");
    difference.explain(BOUND, "no difference is nearer than this plane");
    shown.name_vertex(support, SUPPORT);
    let (on_a, on_b) = simplex.witnesses();
    shown.draw_gap(on_a, on_b);
}

/// GJK's end in the origin.
pub fn draw_held(shown: &mut Shown, simplex: &Simplex) {
    draw_simplex(&mut shown.difference, simplex.vertices(), 2.0);
    for vertex in simplex.vertices() {
        shown.name_vertex(vertex, SIMPLEX);
    }
    shown
        .difference
        .explain(SIMPLEX, "simplex that holds the origin");
    let (on_a, on_b) = simplex.witnesses();
    shown.draw_gap(on_a, on_b);
}

/// EPA: the polytope, its nearest face with the origin's foot on it, the support point w, and the
/// faces that go with the nearest one.
pub fn draw_polytope(
    shown: &mut Shown,
    vertices: &[Vertex],
    faces: &[epa::Face],
    nearest: usize,
    support: &Vertex,
    gone: &[usize],
) {
    let size = shown.spread();
    let difference = &mut shown.difference;
    let mut others_go = false;
    for (i, face) in faces.iter().enumerate() {
        let corners = face.corners.map(|i| vertices[usize::from(i)].point);
        let goes = gone.contains(&i);
        others_go |= goes && i != nearest;
        let (color, opacity) = match (i == nearest, goes) {
            (true, _) => (NEAREST, 0.55),
            (false, true) => (GOING, 0.28),
            (false, false) => (POLYTOPE, 0.16),
        };
        difference.face(corners, color, opacity);
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            // Each edge is that of two faces, once in each direction.
            if face.corners[from] < face.corners[to] {
                difference.line(corners[from], corners[to], 1.4, POLYTOPE);
            }
        }
    }
    let face = &faces[nearest];
    let corners = face.corners.map(|i| vertices[usize::from(i)]);
    let points = corners.map(|corner| corner.point);
    difference.path(&[points[0], points[1], points[2], points[0]], 2.4, NEAREST);
    let foot = face.normal * face.distance;
    difference.line(Vec3::ZERO, foot, 2.5, NEAREST);
    let tip = face.normal * (face.distance + 0.4 * size);
    difference.arrow_with_head(foot, tip, 0.09 * size, 1.5, SUPPORT);
    for point in points {
        difference.dashes(point, support.point, 0.05 * size, 1.2, SUPPORT);
    }
    difference.explain(POLYTOPE, "polytope");
    difference.explain(NEAREST, "its nearest face");
    difference.explain(SUPPORT, "w, the support point along its normal");
    if others_go {
        difference.explain(GOING, "faces that go with it");
    }
    for vertex in &corners {
        shown.mark_bodies(vertex, NEAREST, "");
    }
    shown.difference.mark(support.point, SUPPORT, "w");
    shown.mark_bodies(support, SUPPORT, "w");
    let foot = Simplex::new(&corners);
    let (on_a, on_b) = foot.witnesses();
    shown.draw_gap(on_a, on_b);
}

/// The answer: the way out among the differences, contact points and normal on the solids.
pub fn draw_touch(shown: &mut Shown, touch: &Touch) {
    let spread = shown.spread();
    let size = shown.size();
    let way = -touch.depth() * touch.normal;
    let difference = &mut shown.difference;
    difference.line(Vec3::ZERO, way, 3.0, NEAREST);
    difference.mark(way, NEAREST, "");
    let tip = way - touch.normal * (0.4 * spread);
    difference.arrow_with_head(way, tip, 0.1 * spread, 1.5, palette::BLUE);
    difference.explain(NEAREST, "from the origin the shortest way to the surface");
    difference.explain(palette::BLUE, "against the normal");
    for (i, spot) in (1..).zip(touch.spots()) {
        let tip = spot.point + touch.normal * (0.35 * size);
        let world = &mut shown.world;
        world.arrow_with_head(spot.point, tip, 0.08 * size, 1.8, palette::BLUE);
        world.disc(spot.point, touch.normal, 0.07 * size, NEAREST, 0.6);
        world.mark(spot.point, NEAREST, format!("{i}"));
    }
}

/// Vertices, edges and faces.
fn draw_simplex(drawing: &mut Drawing, vertices: &[Vertex], width: f32) {
    for (i, from) in vertices.iter().enumerate() {
        for to in &vertices[i + 1..] {
            drawing.line(from.point, to.point, width, SIMPLEX);
        }
    }
    let faces: &[[usize; 3]] = match vertices.len() {
        3 => &[[0, 1, 2]],
        4 => &[[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]],
        _ => &[],
    };
    for face in faces {
        drawing.face(face.map(|i| vertices[i].point), SIMPLEX, 0.28);
    }
}

impl Shown<'_> {
    /// A letter at a vertex, and at the two points whose difference it is.
    fn name_vertex(&mut self, vertex: &Vertex, color: Rgb) {
        let mut letter = self.run.letter(vertex);
        self.mark_bodies(vertex, color, &letter);
        if color == SUPPORT {
            letter = format!("w = {letter}");
        }
        self.difference.mark(vertex.point, color, letter);
    }

    fn mark_bodies(&mut self, vertex: &Vertex, color: Rgb, letter: &str) {
        for point in [vertex.on_a, vertex.on_b] {
            self.world.mark(self.origin + point, color, letter);
        }
    }

    /// Between the two points of the solids' cores that are nearest as far as is known.
    fn draw_gap(&mut self, on_a: Vec3, on_b: Vec3) {
        let (on_a, on_b) = (self.origin + on_a, self.origin + on_b);
        self.world.line(on_a, on_b, 2.5, NEAREST);
        self.world.mark(on_a, NEAREST, "");
        self.world.mark(on_b, NEAREST, "");
    }
}
