//! How deep two boxes overlap: the shortest shift that parts them.
//!
//! The shifts under which two boxes meet fill a polyhedron, the sum of one box and the
//! mirrored other. Each of its faces is spanned by two edges of the boxes, so that it is
//! perpendicular to a face of one of them or to an edge of each: 15 axes. Along an axis n
//! the boxes overlap by what they reach together less what their centres are apart,
//! Σ|n·aᵢ| + Σ|n·bᵢ| − |n·d|, and the shortest shift is along the axis on which that is least
//! [Ericson 2005, section 4.4.1; Gottschalk, Lin, Manocha 1996].

use glam::{DMat3, DVec3};

use super::depth::Placed;
use crate::Shape;

/// How deep two boxes overlap, m. At most 0 where they don't touch, and then minus the
/// widest gap along one of the axes, which is no wider than their distance. `None` if a solid
/// is no box.
pub(super) fn box_depth(a: &Placed, b: &Placed) -> Option<f64> {
    let (edges_a, edges_b) = (half_edges(a)?, half_edges(b)?);
    let d = b.position - a.position;
    let reach = |edges: &DMat3, n: DVec3| (edges.transpose() * n).abs().element_sum();
    let overlap = |n: DVec3| reach(&edges_a, n) + reach(&edges_b, n) - n.dot(d).abs();
    let directions = [a, b].map(|solid| DMat3::from_quat(solid.orientation));
    let [axes_a, axes_b] = directions.map(|m| [m.x_axis, m.y_axis, m.z_axis]);
    // Parallel edges span no face. Nearly parallel ones span one so narrow that its axis
    // differs from that of a box's face by no more than the angle between the edges.
    let spanned = axes_a.into_iter().flat_map(|u| {
        let with = axes_b.into_iter().map(move |v| u.cross(v));
        with.filter(|n| n.length() > NEARLY_PARALLEL)
            .map(DVec3::normalize)
    });
    let axes = axes_a.into_iter().chain(axes_b).chain(spanned);
    Some(axes.map(overlap).fold(f64::INFINITY, f64::min))
}

/// Sine of the angle below which edges count as parallel.
const NEARLY_PARALLEL: f64 = 1e-7;

/// Half of the edges of a box, in the world, m.
fn half_edges(solid: &Placed) -> Option<DMat3> {
    let Shape::Box { half_extents } = solid.shape else {
        return None;
    };
    Some(DMat3::from_quat(solid.orientation) * DMat3::from_diagonal(half_extents))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_4, SQRT_2};

    use glam::DQuat;

    use super::*;
    use crate::random::SplitMix64;

    fn cube(x: f64, y: f64, z: f64) -> Placed {
        Placed {
            shape: Shape::Box {
                half_extents: DVec3::splat(0.5),
            },
            position: DVec3::new(x, y, z),
            orientation: DQuat::IDENTITY,
        }
    }

    fn turned(solid: Placed, orientation: DQuat) -> Placed {
        Placed {
            orientation,
            ..solid
        }
    }

    fn assert_depth(a: &Placed, b: &Placed, expected: f64) {
        for depth in [box_depth(a, b).unwrap(), box_depth(b, a).unwrap()] {
            assert!((depth - expected).abs() < 1e-15, "{depth}, not {expected}");
        }
    }

    #[test]
    fn faces_that_touch_have_depth_zero_and_a_gap_counts_below() {
        let floor = cube(0.0, 0.0, 0.0);
        assert_depth(&floor, &cube(0.3, 1.0, 0.2), 0.0);
        assert_depth(&floor, &cube(0.3, 1.25, 0.2), -0.25);
        assert_depth(&floor, &cube(0.3, 0.9, 0.2), 0.1);
    }

    #[test]
    fn the_shortest_way_out_counts() {
        // Out along x it is 0.25 m, along y and z more.
        assert_depth(&cube(0.0, 0.0, 0.0), &cube(0.75, 0.5, 0.25), 0.25);
    }

    #[test]
    fn boxes_at_one_place_part_by_a_whole_edge() {
        assert_depth(&cube(0.0, 0.0, 0.0), &cube(0.0, 0.0, 0.0), 1.0);
    }

    #[test]
    fn an_edge_that_stands_on_a_face_reaches_in_by_half_a_diagonal() {
        // Half a diagonal of a face is √½; the centre is 1.15 m up.
        let edge_down = turned(cube(0.2, 1.15, 0.1), DQuat::from_rotation_z(FRAC_PI_4));
        let expected = 0.5 + SQRT_2 / 2.0 - 1.15;
        assert_depth(&cube(0.0, 0.0, 0.0), &edge_down, expected);
    }

    #[test]
    fn crossed_edges_part_along_their_common_normal() {
        // Both stand on an edge, one along x, the other along z: the normal is y.
        let below = turned(cube(0.0, 0.0, 0.0), DQuat::from_rotation_x(FRAC_PI_4));
        let above = turned(cube(0.0, 1.4, 0.0), DQuat::from_rotation_z(FRAC_PI_4));
        assert_depth(&below, &above, SQRT_2 - 1.4);
    }

    #[test]
    fn a_corner_that_points_down_reaches_in_by_half_a_space_diagonal() {
        let corner = DVec3::ONE.normalize();
        let corner_down = turned(
            cube(0.0, 1.3, 0.0),
            DQuat::from_rotation_arc(corner, DVec3::NEG_Y),
        );
        let expected = 0.5 + 3.0_f64.sqrt() / 2.0 - 1.3;
        assert_depth(&cube(0.0, 0.0, 0.0), &corner_down, expected);
    }

    #[test]
    fn a_shift_by_the_depth_parts_boxes_and_a_shorter_one_does_not() {
        let mut random = SplitMix64::new(6);
        let mut inside = 0;
        for _ in 0..500 {
            let mut solid = |size: f64| Placed {
                shape: Shape::Box {
                    half_extents: DVec3::splat(0.4) + random.vector(0.3),
                },
                position: random.vector(size),
                orientation: random.rotation(),
            };
            let (a, b) = (solid(0.5), solid(0.5));
            let found = box_depth(&a, &b).unwrap();
            if found <= 0.0 {
                continue;
            }
            inside += 1;
            let parted = (0..3000).any(|_| {
                let way = random.vector(1.0).normalize();
                let moved = |by: f64| Placed {
                    position: b.position + way * by,
                    ..b
                };
                let shorter = box_depth(&a, &moved(found - 1e-9)).unwrap();
                assert!(shorter > 0.0, "{a:?} {b:?} {way}");
                box_depth(&a, &moved(found * 1.05)).unwrap() <= 0.0
            });
            assert!(parted, "nothing near {found} parts {a:?} and {b:?}");
        }
        assert!(inside > 300, "{inside}");
    }

    #[test]
    fn edges_that_are_all_but_parallel_change_nothing() {
        for angle in [0.0, 1e-12, 1e-8, 1e-6] {
            let above = turned(cube(0.1, 0.9, 0.2), DQuat::from_rotation_y(angle));
            let depth = box_depth(&cube(0.0, 0.0, 0.0), &above).unwrap();
            assert!((depth - 0.1).abs() < 1e-15, "{angle}: {depth}");
        }
    }
}
