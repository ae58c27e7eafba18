//! The meshes of box, capsule and cylinder, in units of the body's size; balls need none. A vertex stands at
//! `position * size.xyz + (0, axis * size.w, 0)` in the body's coordinates, so that one
//! capsule serves all radii and heights and its caps stay round.

use std::f32::consts::{FRAC_PI_2, TAU};

use glam::Vec3;

/// A corner of a triangle.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Vertex {
    /// In units of the body's size.
    pub position: [f32; 3],
    /// −1 or 1 at the lower or upper end of a capsule or cylinder, otherwise 0.
    pub axis: f32,
    /// Unit vector.
    pub normal: [f32; 3],
}

/// Triangles, seen anticlockwise from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The corners.
    pub vertices: Vec<Vertex>,
    /// Three a triangle.
    pub indices: Vec<u32>,
}

impl Mesh {
    fn add_vertex(&mut self, position: Vec3, axis: f32, normal: Vec3) -> u32 {
        self.vertices.push(Vertex {
            position: position.to_array(),
            axis,
            normal: normal.to_array(),
        });
        index(self.vertices.len() - 1)
    }

    /// Two triangles between corners a, b on one edge and c, d on the opposite one.
    fn add_quad(&mut self, [a, b, c, d]: [u32; 4]) {
        self.indices.extend([a, b, d, a, d, c]);
    }
}

/// A box with corners at ±1, each face with its own corners for its own normal.
#[must_use]
pub fn cube() -> Mesh {
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let normal = sign * Vec3::AXES[axis];
            let across = Vec3::AXES[(axis + 1) % 3];
            let up = normal.cross(across);
            let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)]
                .map(|(x, y)| mesh.add_vertex(normal + x * across + y * up, 0.0, normal));
            mesh.add_quad(corners);
        }
    }
    mesh
}

/// A cylinder of radius 1 whose ends move with the half height.
#[must_use]
pub fn cylinder(segments: u16) -> Mesh {
    let mut mesh = Mesh::default();
    let around = ring_directions(segments);
    let side: Vec<[u32; 2]> = around
        .iter()
        .map(|&d| [-1.0, 1.0].map(|axis| mesh.add_vertex(d, axis, d)))
        .collect();
    for pair in side.windows(2) {
        mesh.add_quad([pair[0][0], pair[1][0], pair[0][1], pair[1][1]]);
    }
    for axis in [-1.0, 1.0] {
        let normal = axis * Vec3::Y;
        let centre = mesh.add_vertex(Vec3::ZERO, axis, normal);
        let rim: Vec<u32> = around
            .iter()
            .map(|&d| mesh.add_vertex(d, axis, normal))
            .collect();
        for pair in rim.windows(2) {
            let (first, second) = if axis > 0.0 { (0, 1) } else { (1, 0) };
            mesh.indices.extend([centre, pair[first], pair[second]]);
        }
    }
    mesh
}

/// A capsule of radius 1: two half-balls of `rings` rings each, moved by the half height.
#[must_use]
pub fn capsule(segments: u16, rings: u16) -> Mesh {
    let mut mesh = Mesh::default();
    let around = ring_directions(segments);
    let levels = (0..=rings)
        .map(|ring| (ring, -1.0))
        .chain((0..=rings).map(|ring| (ring, 1.0)));
    let mut below: Option<Vec<u32>> = None;
    for (ring, axis) in levels {
        let share = f32::from(ring) / f32::from(rings);
        let latitude = FRAC_PI_2 * if axis < 0.0 { share - 1.0 } else { share };
        let (sin, cos) = latitude.sin_cos();
        let level: Vec<u32> = around
            .iter()
            .map(|&d| cos * d + sin * Vec3::Y)
            .map(|d| mesh.add_vertex(d, axis, d))
            .collect();
        if let Some(below) = below {
            for (low, high) in below.windows(2).zip(level.windows(2)) {
                mesh.add_quad([low[0], low[1], high[0], high[1]]);
            }
        }
        below = Some(level);
    }
    mesh
}

/// Unit vectors around the y axis, anticlockwise from above; the first comes again at the end.
fn ring_directions(segments: u16) -> Vec<Vec3> {
    (0..=segments)
        .map(|i| TAU * f32::from(i) / f32::from(segments))
        .map(|angle| Vec3::new(angle.cos(), 0.0, -angle.sin()))
        .collect()
}

/// Meshes have thousands of corners, not billions.
#[expect(clippy::cast_possible_truncation, reason = "a few thousand at most")]
fn index(i: usize) -> u32 {
    i as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> [Mesh; 3] {
        [cube(), capsule(24, 6), cylinder(24)]
    }

    /// Six times the signed volume of the mesh with radius 1 and half height 1.
    fn six_volumes(mesh: &Mesh) -> f32 {
        let point = |i: u32| {
            let vertex = mesh.vertices[i as usize];
            Vec3::from(vertex.position) + vertex.axis * Vec3::Y
        };
        let of_triangle = |t: &[u32]| point(t[0]).dot(point(t[1]).cross(point(t[2])));
        mesh.indices.chunks_exact(3).map(of_triangle).sum()
    }

    #[test]
    fn triangles_face_outwards_and_enclose_the_solid() {
        use std::f32::consts::PI;
        let solids = [8.0, 2.0 * PI + 4.0 / 3.0 * PI, 2.0 * PI];
        for (mesh, volume) in all().iter().zip(solids) {
            let ratio = six_volumes(mesh) / 6.0 / volume;
            // A polyhedron inside the solid lacks a few percent at this fineness.
            assert!((0.93..=1.0001).contains(&ratio), "{ratio}");
        }
    }

    #[test]
    fn normals_have_length_one_and_indices_are_in_range() {
        for mesh in all() {
            for vertex in &mesh.vertices {
                assert!((Vec3::from(vertex.normal).length() - 1.0).abs() < 1e-5);
            }
            let count = index(mesh.vertices.len());
            assert!(mesh.indices.iter().all(|&i| i < count));
        }
    }
}
