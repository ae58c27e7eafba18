//! The surface of the Minkowski difference as triangles: the sphere of all directions, each
//! direction taken to its support point. Where the difference has a corner, a whole patch of
//! directions ends up there; where it is round, the triangles stay small.

use std::collections::BTreeMap;

use ch00_scenes::SurfacePoint;
use glam::Vec3;

use crate::narrow::support_point::{Core, Vertex};

/// Each edge of an octahedron is divided into so many.
const PIECES: i8 = 32;

/// A triangle of the surface that is lower than this share of the whole isn't worth drawing.
const THINNEST: f32 = 1e-8;

/// The surface of a − b, both rounded by `radius` together.
pub fn surface(a: &Core, b: &Core, radius: f32) -> Vec<[SurfacePoint; 3]> {
    let extent = a.reach() + b.reach() + radius;
    let point = |direction: Vec3| {
        let normal = direction.normalize();
        let at = Vertex::support(a, b, normal).point + radius * normal;
        (at, normal)
    };
    let mut triangles = Vec::new();
    for corners in directions() {
        let corners = corners.map(point);
        let [p, q, r] = corners.map(|corner| corner.0);
        let across = (q - p).cross(r - p);
        if across.length() < THINNEST * extent * extent {
            continue;
        }
        let outward = corners
            .iter()
            .map(|corner| corner.1)
            .sum::<Vec3>()
            .normalize();
        let own_normal = across.normalize() * across.dot(outward).signum();
        // Directions that end up side by side on a sharp rim span a sliver with no normal of its
        // own.
        if own_normal.dot(outward) < 0.97 {
            continue;
        }
        // Neighbouring directions that end up far apart span a flat part.
        let longest = p.distance(q).max(q.distance(r)).max(r.distance(p));
        let is_flat = longest > 4.0 * extent / f32::from(PIECES);
        triangles.push(corners.map(|(at, normal)| SurfacePoint {
            at: at.to_array(),
            normal: if is_flat { own_normal } else { normal }.to_array(),
        }));
    }
    triangles
}

/// How often two corners must be neighbours to be the ends of an edge: the diagonal of a flat
/// part is met once or twice, an edge by all directions between its two flat parts.
const NEIGHBOURS: usize = 4;

/// The edges of a − b where that is a polytope: pairs of corners. Round parts have none.
pub fn edges(a: &Core, b: &Core) -> Vec<[Vec3; 2]> {
    let shortest = 0.02 * (a.reach() + b.reach());
    let mut met: BTreeMap<[[u32; 3]; 2], usize> = BTreeMap::new();
    for corners in directions() {
        let points = corners.map(|direction| Vertex::support(a, b, direction).point);
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let mut ends = [points[i], points[j]].map(|p| p.to_array().map(f32::to_bits));
            ends.sort_unstable();
            if points[i].distance(points[j]) > shortest {
                *met.entry(ends).or_default() += 1;
            }
        }
    }
    // Each side of a triangle is that of two.
    let often = met
        .into_iter()
        .filter(|(_, times)| *times >= 2 * NEIGHBOURS);
    often
        .map(|(ends, _)| ends.map(|end| Vec3::from(end.map(f32::from_bits))))
        .collect()
}

/// Triangles that cover all directions: an octahedron's faces, divided. Their corners are a hair
/// off the axes, where boxes can't decide between two corners.
fn directions() -> Vec<[Vec3; 3]> {
    let mut all = Vec::new();
    for octant in 0..8_u8 {
        let sign = |bit: u8| if octant & bit == 0 { 1.0 } else { -1.0 };
        let signs = Vec3::new(sign(1), sign(2), sign(4));
        let corner = |i: i8, j: i8| {
            let [x, y, z] = [i, j, PIECES - i - j].map(f32::from);
            signs * Vec3::new(x, y, z) + Vec3::new(1.1e-3, 2.3e-3, 3.7e-3)
        };
        for i in 0..PIECES {
            for j in 0..PIECES - i {
                all.push([corner(i, j), corner(i + 1, j), corner(i, j + 1)]);
                if i + j + 2 <= PIECES {
                    all.push([corner(i + 1, j + 1), corner(i, j + 1), corner(i + 1, j)]);
                }
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use ch00_maths::f32::shape::Shape;
    use glam::Quat;

    use super::*;
    use crate::narrow::Placed;

    fn cores(one: &Shape, two: &Shape) -> (Core, Core) {
        let at = |shape, p| Placed {
            shape,
            p,
            q: Quat::IDENTITY,
            p_before: p,
        };
        Core::pair(&at(one, Vec3::new(3.0, 0.0, 0.0)), &at(two, Vec3::ZERO))
    }

    fn area(surface: &[[SurfacePoint; 3]]) -> f32 {
        let area_of = |corners: &[SurfacePoint; 3]| {
            let [p, q, r] = corners.map(|corner| Vec3::from(corner.at));
            0.5 * (q - p).cross(r - p).length()
        };
        surface.iter().map(area_of).sum()
    }

    #[test]
    fn the_difference_of_two_boxes_is_a_box_of_all_their_edges() {
        let half = |x, y, z| Shape::Box {
            half_extents: Vec3::new(x, y, z),
        };
        let (a, b) = cores(&half(0.5, 0.2, 0.1), &half(1.0, 0.3, 0.4));
        let surface = surface(&a, &b, 0.0);
        // 3 × 1 × 1 m.
        assert!((area(&surface) - 14.0).abs() < 1e-3, "{}", area(&surface));
    }

    #[test]
    fn a_boxs_edges_are_found_and_no_diagonals() {
        let half = Shape::Box {
            half_extents: Vec3::new(0.5, 0.2, 0.1),
        };
        let (a, b) = cores(&half, &Shape::Sphere { radius: 1.0 });
        let mut lengths: Vec<f32> = edges(&a, &b).iter().map(|[p, q]| p.distance(*q)).collect();
        lengths.sort_by(f32::total_cmp);
        assert_eq!(lengths.len(), 12, "{lengths:?}");
        for (length, expected) in lengths.iter().zip([0.2, 0.2, 0.2, 0.2, 0.4, 0.4, 0.4, 0.4]) {
            assert!((length - expected).abs() < 1e-6);
        }
    }

    #[test]
    fn the_difference_of_two_balls_is_a_ball_of_both_radii() {
        let ball = |radius| Shape::Sphere { radius };
        let (a, b) = cores(&ball(0.3), &ball(0.2));
        let surface = surface(&a, &b, a.radius + b.radius);
        for point in surface.iter().flatten() {
            let from_centre = Vec3::from(point.at) - Vec3::new(3.0, 0.0, 0.0);
            assert!((from_centre.length() - 0.5).abs() < 1e-6);
            assert!(from_centre.dot(point.normal.into()) > 0.499);
        }
        // π 1² m², a little less for the flat triangles.
        assert!((area(&surface) - std::f32::consts::PI).abs() < 0.03);
    }
}
