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
