//! How deep two solids overlap, exactly: the shortest way that parts them.
//!
//! A sphere or capsule is a segment (a point) with a radius. So every pair here is a
//! distance from a segment to a segment, a point or a box, less the radii; and where a
//! segment runs through a box, the separating axes of the two decide [Ericson 2005,
//! sections 5.1.9 and 5.2.1]. Two boxes are in `boxes.rs`.

use glam::{DQuat, DVec3};

use super::boxes::box_depth;
use crate::{Scene, Shape, State};

/// A solid somewhere in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The solid.
    pub shape: Shape,
    /// World position of its origin, m.
    pub position: DVec3,
    /// Body to world.
    pub orientation: DQuat,
}

impl Placed {
    /// Body `i` of a scene, where `state` has it.
    #[must_use]
    pub fn new(scene: &Scene, state: &State, i: usize) -> Self {
        Self {
            shape: scene.bodies[i].shape,
            position: state.position[i],
            orientation: state.orientation[i],
        }
    }
}

/// Points within `radius` of a segment from `centre` − `half` to `centre` + `half`.
#[derive(Clone, Copy)]
struct Round {
    centre: DVec3,
    half: DVec3,
    radius: f64,
}

/// How deep a and b overlap, m: the length of the shortest shift that parts them. At most
/// 0 where they don't touch, and then minus their distance, of which two boxes may give
/// less. `None` for cylinders.
#[must_use]
pub fn depth(a: &Placed, b: &Placed) -> Option<f64> {
    match (round(a), round(b)) {
        (Some(a), Some(b)) => Some(a.radius + b.radius - segment_distance(&a, &b)),
        (Some(a), None) => in_box(&a, b),
        (None, Some(b)) => in_box(&b, a),
        (None, None) => box_depth(a, b),
    }
}

fn round(solid: &Placed) -> Option<Round> {
    let (radius, half_height) = match solid.shape {
        Shape::Sphere { radius } => (radius, 0.0),
        Shape::Capsule {
            radius,
            half_height,
        } => (radius, half_height),
        Shape::Box { .. } | Shape::Cylinder { .. } => return None,
    };
    Some(Round {
        centre: solid.position,
        half: solid.orientation * DVec3::new(0.0, half_height, 0.0),
        radius,
    })
}

/// Smallest |d + s u − t v| over −1 ≤ s, t ≤ 1, where d joins the centres and u, v are the
/// half-segments [Ericson 2005, section 5.1.9, there with 0 ≤ s, t ≤ 1].
fn segment_distance(a: &Round, b: &Round) -> f64 {
    let (u, v, d) = (a.half, b.half, a.centre - b.centre);
    let (uu, uv, vv) = (u.dot(u), u.dot(v), v.dot(v));
    let (ud, vd) = (u.dot(d), v.dot(d));
    let best_s = |t: f64| clamped_ratio(t * uv - ud, uu);
    let best_t = |s: f64| clamped_ratio(s * uv + vd, vv);
    // Of parallel segments any s will do, as t and then s follow.
    let determinant = uu * vv - uv * uv;
    let s = if determinant > 1e-12 * uu * vv {
        ((uv * vd - ud * vv) / determinant).clamp(-1.0, 1.0)
    } else {
        0.0
    };
    let t = best_t(s);
    let s = best_s(t);
    (d + s * u - t * v).length()
}

/// `numerator / denominator` within −1 … 1; 0 for the point-like segment of 0 / 0.
fn clamped_ratio(numerator: f64, denominator: f64) -> f64 {
    if denominator > 0.0 {
        (numerator / denominator).clamp(-1.0, 1.0)
    } else {
        0.0
    }
}

/// Depth of a round solid in a box; `None` if the other solid is none.
fn in_box(round: &Round, solid: &Placed) -> Option<f64> {
    let Shape::Box { half_extents } = solid.shape else {
        return None;
    };
    let to_box = solid.orientation.conjugate();
    let centre = to_box * (round.centre - solid.position);
    let half = to_box * round.half;
    let distance = distance_to_box(centre, half, half_extents);
    // Where the segment meets the box, rounding may leave a distance of some 1e-17 m.
    let rounding = 1e-12 * (centre.length() + half.length() + half_extents.length());
    if distance > rounding {
        return Some(round.radius - distance);
    }
    Some(round.radius + way_out_of_box(centre, half, half_extents))
}

/// Distance from the segment to a box about the origin; 0 if they meet.
///
/// The squared distance at `centre` + t `half` is convex in t, and its slope is linear
/// between the places where the segment crosses the planes of the faces: the zero of the
/// slope is found between two of those.
fn distance_to_box(centre: DVec3, half: DVec3, extents: DVec3) -> f64 {
    let outside = |t: f64| {
        let p = centre + t * half;
        p - p.clamp(-extents, extents)
    };
    let slope = |t: f64| outside(t).dot(half);
    let mut low = (-1.0, slope(-1.0));
    if low.1 >= 0.0 {
        return outside(low.0).length();
    }
    for t in face_crossings(centre, half, extents) {
        let high = (t, slope(t));
        if high.1 >= 0.0 {
            let t = low.0 + (high.0 - low.0) * -low.1 / (high.1 - low.1);
            return outside(t).length();
        }
        low = high;
    }
    outside(1.0).length()
}

/// Where within −1 < t ≤ 1 the segment crosses the planes of the box's faces, and its end,
/// in ascending order.
fn face_crossings(centre: DVec3, half: DVec3, extents: DVec3) -> [f64; 7] {
    let low = (-extents - centre) / half;
    let high = (extents - centre) / half;
    let mut crossings = [low.x, low.y, low.z, high.x, high.y, high.z, 1.0];
    for t in &mut crossings {
        // Also where the segment runs along a face and the quotient is no number.
        if !(-1.0..=1.0).contains(t) {
            *t = 1.0;
        }
    }
    crossings.sort_by(f64::total_cmp);
    crossings
}

/// The shortest shift that takes a segment which meets a box about the origin out of it.
///
/// Box and segment span a polyhedron of shifts under which they meet; its faces are
/// perpendicular to an axis of the box or to one of those and the segment.
fn way_out_of_box(centre: DVec3, half: DVec3, extents: DVec3) -> f64 {
    let along = |n: DVec3| n.abs().dot(extents) + half.dot(n).abs() - centre.dot(n).abs();
    let axes = DVec3::AXES.into_iter();
    let faces = axes.clone().map(along);
    let edges = axes
        .filter_map(|axis| axis.cross(half).try_normalize())
        .map(along);
    faces.chain(edges).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};

    use super::*;
    use crate::random::SplitMix64;

    fn at(shape: Shape, x: f64, y: f64, z: f64) -> Placed {
        Placed {
            shape,
            position: DVec3::new(x, y, z),
            orientation: DQuat::IDENTITY,
        }
    }

    fn turned(solid: Placed, axis: DVec3, angle: f64) -> Placed {
        Placed {
            orientation: DQuat::from_axis_angle(axis, angle),
            ..solid
        }
    }

    fn sphere(radius: f64) -> Shape {
        Shape::Sphere { radius }
    }

    fn capsule(radius: f64, half_height: f64) -> Shape {
        Shape::Capsule {
            radius,
            half_height,
        }
    }

    fn cube(half: f64) -> Shape {
        let half_extents = DVec3::splat(half);
        Shape::Box { half_extents }
    }

    fn assert_depth(a: &Placed, b: &Placed, expected: f64) {
        for (a, b) in [(a, b), (b, a)] {
            let found = depth(a, b).unwrap();
            assert!((found - expected).abs() < 1e-12, "{found} not {expected}");
        }
    }

    #[test]
    fn two_spheres_overlap_by_their_radii_less_their_distance() {
        let (a, b) = (
            at(sphere(0.3), 0.0, 0.0, 0.0),
            at(sphere(0.2), 0.3, 0.4, 0.0),
        );
        assert_depth(&a, &b, 0.0);
        assert_depth(&a, &at(sphere(0.2), 0.0, 0.4, 0.0), 0.1);
        assert_depth(&a, &at(sphere(0.2), 0.0, 0.0, 2.0), -1.5);
    }

    #[test]
    fn a_sphere_beside_a_capsule_and_over_its_end() {
        let upright = at(capsule(0.1, 0.5), 0.0, 0.0, 0.0);
        assert_depth(&upright, &at(sphere(0.2), 0.25, 0.3, 0.0), 0.05);
        assert_depth(&upright, &at(sphere(0.2), 0.0, 0.75, 0.0), 0.05);
    }

    #[test]
    fn crossed_capsules_overlap_by_their_radii_less_the_gap_of_their_axes() {
        let a = at(capsule(0.1, 0.5), 0.0, 0.0, 0.0);
        let b = turned(at(capsule(0.1, 0.5), 0.2, 0.1, 0.15), DVec3::Z, FRAC_PI_2);
        assert_depth(&a, &b, 0.05);
    }

    #[test]
    fn parallel_capsules_overlap_over_a_stretch_and_past_their_ends() {
        let a = at(capsule(0.1, 0.5), 0.0, 0.0, 0.0);
        assert_depth(&a, &at(capsule(0.1, 0.5), 0.15, 0.7, 0.0), 0.05);
        assert_depth(&a, &at(capsule(0.1, 0.5), 0.0, 1.15, 0.0), 0.05);
        let diagonal = 0.2 - (0.03_f64.powi(2) + 0.04_f64.powi(2)).sqrt();
        assert_depth(&a, &at(capsule(0.1, 0.5), 0.03, 1.04, 0.0), diagonal);
    }

    #[test]
    fn a_sphere_on_a_face_an_edge_and_a_corner_of_a_box() {
        let block = at(cube(1.0), 0.0, 0.0, 0.0);
        let ball = |x, y, z| at(sphere(0.5), x, y, z);
        assert_depth(&block, &ball(0.2, 1.4, -0.3), 0.1);
        assert_depth(&block, &ball(1.3, 1.4, 0.0), 0.0);
        let corner = 0.5 - 0.2 * 3.0_f64.sqrt();
        assert_depth(&block, &ball(1.2, -1.2, 1.2), corner);
    }

    #[test]
    fn a_sphere_whose_centre_is_inside_a_box_leaves_by_the_nearest_face() {
        let block = at(cube(1.0), 0.0, 0.0, 0.0);
        assert_depth(&block, &at(sphere(0.5), 0.2, -0.9, 0.3), 0.6);
    }

    #[test]
    fn a_turned_box_meets_a_sphere_with_its_edge() {
        let block = turned(at(cube(1.0), 0.0, 0.0, 0.0), DVec3::Z, FRAC_PI_4);
        assert_depth(&block, &at(sphere(0.5), SQRT_2 + 0.4, 0.0, 0.0), 0.1);
    }

    #[test]
    fn a_capsule_stands_lies_and_leans_on_a_box() {
        let block = at(cube(1.0), 0.0, 0.0, 0.0);
        let standing = at(capsule(0.1, 0.5), 0.0, 1.55, 0.0);
        assert_depth(&block, &standing, 0.05);
        let lying = turned(at(capsule(0.1, 0.5), 0.8, 1.05, 0.0), DVec3::Z, FRAC_PI_2);
        assert_depth(&block, &lying, 0.05);
        // Its lower end is at y = 1.6 − 0.5 cos 45°.
        let leaning = turned(at(capsule(0.1, 0.5), 0.0, 1.6, 0.0), DVec3::Z, FRAC_PI_4);
        assert_depth(&block, &leaning, 0.1 - (0.6 - 0.5 / SQRT_2));
    }

    #[test]
    fn a_capsule_over_an_edge_of_a_box_is_measured_between_its_ends() {
        let block = at(cube(1.0), 0.0, 0.0, 0.0);
        // Its axis crosses the line x = y at right angles, 0.05 beyond the edge (1, 1, z).
        let centre = 1.0 + 0.05 / SQRT_2;
        let across = turned(
            at(capsule(0.1, 2.0), centre, centre, 0.0),
            DVec3::Z,
            FRAC_PI_4,
        );
        assert_depth(&block, &across, 0.05);
    }

    #[test]
    fn a_capsule_through_an_edge_of_a_box_leaves_across_it() {
        let block = at(cube(1.0), 0.0, 0.0, 0.0);
        let centre = 1.0 - 0.05 / SQRT_2;
        let across = turned(
            at(capsule(0.1, 2.0), centre, centre, 0.0),
            DVec3::Z,
            FRAC_PI_4,
        );
        assert_depth(&block, &across, 0.15);
    }

    #[test]
    fn a_capsule_whose_axis_runs_through_a_box_is_deeper_than_its_radius() {
        let half_extents = DVec3::new(0.3, 0.5, 0.7);
        let mut random = SplitMix64::new(6);
        for _ in 0..2000 {
            // The middle of the capsule is at least 0.03 m from all faces.
            let place = random.vector(0.9) * half_extents;
            let rod = Placed {
                orientation: random.rotation(),
                ..at(capsule(0.1, 0.6), place.x, place.y, place.z)
            };
            let turn = random.rotation();
            let [mut block, mut rod] = [at(Shape::Box { half_extents }, 0.0, 0.0, 0.0), rod];
            for solid in [&mut block, &mut rod] {
                solid.position = turn * solid.position;
                solid.orientation = turn * solid.orientation;
            }
            let found = depth(&rod, &block).unwrap();
            assert!(found > 0.1 + 0.03 - 1e-15, "{found} {rod:?} {block:?}");
        }
    }

    #[test]
    fn cylinders_have_no_closed_form_here() {
        let (radius, half_height) = (0.1, 0.1);
        let rod = Shape::Cylinder {
            radius,
            half_height,
        };
        for other in [cube(1.0), sphere(1.0), capsule(0.1, 0.1), rod] {
            let found = depth(&at(rod, 0.0, 0.0, 0.0), &at(other, 0.0, 0.0, 0.0));
            assert_eq!(found, None);
        }
    }

    /// The least of `distance` over 20,001 points of the capsule's axis.
    fn search(rod: &Placed, distance: impl Fn(DVec3) -> f64) -> f64 {
        let axis = round(rod).unwrap();
        (0..=20_000)
            .map(|i| axis.centre + (f64::from(i) / 10_000.0 - 1.0) * axis.half)
            .map(distance)
            .fold(f64::INFINITY, f64::min)
    }

    fn random_capsule(random: &mut SplitMix64) -> Placed {
        Placed {
            shape: capsule(0.1, random.between(0.0, 2.0)),
            position: random.vector(2.0),
            orientation: DQuat::from_axis_angle(
                random.vector(1.0).normalize(),
                random.between(0.0, 3.0),
            ),
        }
    }

    #[test]
    fn distances_to_a_box_agree_with_a_search_along_the_segment() {
        let extents = DVec3::new(0.3, 0.5, 0.7);
        let block = at(
            Shape::Box {
                half_extents: extents,
            },
            0.0,
            0.0,
            0.0,
        );
        let mut random = SplitMix64::new(3);
        for _ in 0..200 {
            let rod = random_capsule(&mut random);
            let searched = search(&rod, |p| (p - p.clamp(-extents, extents)).length());
            let found = depth(&rod, &block).unwrap();
            if searched > 0.0 {
                // A step of the search is at most 2e-4 m.
                assert!((0.1 - found - searched).abs() < 2e-4, "{rod:?}");
            } else {
                assert!(found >= 0.1 - 2e-4, "{rod:?}");
            }
        }
    }

    #[test]
    fn distances_between_capsules_agree_with_a_search_along_one_of_them() {
        let mut random = SplitMix64::new(4);
        for _ in 0..200 {
            let (a, b) = (random_capsule(&mut random), random_capsule(&mut random));
            let other = round(&b).unwrap();
            let searched = search(&a, |p| {
                let t = clamped_ratio(
                    (p - other.centre).dot(other.half),
                    other.half.length_squared(),
                );
                p.distance(other.centre + t * other.half)
            });
            let found = depth(&a, &b).unwrap();
            assert!((0.2 - found - searched).abs() < 2e-4, "{a:?} {b:?}");
        }
    }

    #[test]
    fn a_shift_by_the_depth_parts_a_capsule_from_a_box_and_a_shorter_one_does_not() {
        let extents = DVec3::new(0.3, 0.5, 0.7);
        let block = at(
            Shape::Box {
                half_extents: extents,
            },
            0.0,
            0.0,
            0.0,
        );
        let mut random = SplitMix64::new(5);
        let mut inside = 0;
        for _ in 0..500 {
            let rod = random_capsule(&mut random);
            let found = depth(&rod, &block).unwrap();
            if found <= 0.1 {
                continue;
            }
            inside += 1;
            let mut parted_by = f64::INFINITY;
            for _ in 0..2000 {
                let way = random.vector(1.0).normalize();
                let mut moved = rod;
                moved.position += way * (found - 1e-9);
                assert!(depth(&moved, &block).unwrap() > 0.0, "{rod:?} {way}");
                moved.position = rod.position + way * (found * 1.05);
                if depth(&moved, &block).unwrap() <= 0.0 {
                    parted_by = found * 1.05;
                }
            }
            assert!(parted_by.is_finite(), "nothing near {found} parts {rod:?}");
        }
        assert!(inside > 20, "{inside}");
    }
}
