//! Where the points of a contact are: how many, with which names, and that they stay right while the
//! bodies move a little.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use ch06_compute::own_row::narrow::{Posed, manifold};
use ch06_compute::rows::{FIXED, Manifold, ROUND, WITH_A, WITH_B};
use glam::{DVec3, Quat, Vec3};

use crate::bodies::{BALL, BOX, CAPSULE, CYLINDER, at_points, body, cores, normal_of};

/// A floor of 40 m whose upper face is y = 0.
fn floor() -> Posed {
    at(body(BOX, Vec3::new(20.0, 0.5, 20.0)), 0.0, -0.5, 0.0)
}

fn ball(radius: f32) -> Posed {
    body(BALL, Vec3::new(radius, 0.0, 0.0))
}

fn block(x: f32, y: f32, z: f32) -> Posed {
    body(BOX, Vec3::new(x, y, z))
}

fn capsule(radius: f32, half_height: f32) -> Posed {
    body(CAPSULE, Vec3::new(radius, half_height, 0.0))
}

fn cylinder(radius: f32, half_height: f32) -> Posed {
    body(CYLINDER, Vec3::new(radius, half_height, 0.0))
}

fn at(mut body: Posed, x: f32, y: f32, z: f32) -> Posed {
    body.position = Vec3::new(x, y, z);
    body
}

fn turned(mut body: Posed, q: Quat) -> Posed {
    body.attitude = (q * body.attitude).normalize();
    body
}

/// Lying along x.
fn lying(body: Posed) -> Posed {
    turned(body, Quat::from_rotation_z(FRAC_PI_2))
}

fn names(m: &Manifold) -> Vec<u32> {
    let mut names: Vec<u32> = (0..m.points as usize)
        .map(|k| m.core_a[k].w.to_bits())
        .collect();
    names.sort_unstable();
    names
}

/// The contact of a body on the floor, which has so many points, all with this distance.
#[track_caller]
fn stands(on_floor: &Posed, points: u32, distance: f64) -> Manifold {
    let m = manifold(&floor(), on_floor, 0.02);
    assert_eq!(m.points, points, "{m:?}");
    assert!(
        (normal_of(&m, &floor(), on_floor) - DVec3::Y).length() < 1e-5,
        "{m:?}"
    );
    for one in at_points(&m, &floor(), on_floor) {
        assert!((one - distance).abs() < 1e-5, "{one} {m:?}");
    }
    m
}

#[test]
fn a_box_on_the_floor_has_its_four_corners() {
    let cube = at(block(0.25, 0.25, 0.25), 3.0, 0.249, 2.0);
    let m = stands(&turned(cube, Quat::from_rotation_y(0.3)), 4, -0.001);
    assert_eq!(m.turns, FIXED);
    for k in 0..4 {
        let corner = m.core_b[k].truncate().abs();
        assert!((corner - Vec3::splat(0.25)).length() < 1e-5, "{m:?}");
    }
}

#[test]
fn a_cylinder_stands_on_four_points_of_its_rim() {
    let m = stands(&at(cylinder(0.3, 0.5), 1.0, 0.501, -2.0), 4, 0.001);
    for k in 0..4 {
        let p = m.core_b[k];
        assert!(
            (p.x.hypot(p.z) - 0.3).abs() < 1e-5 && (p.y + 0.5).abs() < 1e-5,
            "{m:?}"
        );
    }
    // A square, which stands as well in all directions as four points can.
    let middle: Vec3 = (0..4).map(|k| m.core_b[k].truncate()).sum();
    assert!(
        (middle - Vec3::new(0.0, -2.0, 0.0)).length() < 1e-5,
        "{m:?}"
    );
}

#[test]
fn a_lying_cylinder_and_a_lying_capsule_have_two_points_on_their_axes() {
    for (lies, half) in [(cylinder(0.3, 0.5), 0.5), (capsule(0.3, 0.4), 0.4)] {
        let m = stands(&lying(at(lies, 0.0, 0.299, 0.0)), 2, -0.001);
        assert_eq!(m.turns, WITH_A);
        assert!((m.round_b - 0.3).abs() < 1e-6, "{m:?}");
        for k in 0..2 {
            let p = m.core_b[k].truncate();
            assert!((p.abs() - Vec3::Y * half).length() < 1e-5, "{m:?}");
        }
    }
}

#[test]
fn a_ball_has_one_point_wherever_it_lies() {
    let m = stands(&at(ball(0.2), 3.0, 0.199, 0.0), 1, -0.001);
    assert_eq!((m.turns, m.round_b), (WITH_A, 0.2));
}

#[test]
fn a_cylinder_that_spins_keeps_its_distance() {
    // A wheel that rolls on the floor, and a coin that rolls on its rim, tilted by 30°.
    let wheel = lying(at(cylinder(0.3, 0.1), 0.0, 0.299, 0.0));
    let coin = lying(at(cylinder(0.3, 0.01), 0.0, 0.27, 0.0));
    for rolls in [wheel, turned(coin, Quat::from_rotation_z(0.5))] {
        let m = manifold(&floor(), &rolls, 0.1);
        let before = at_points(&m, &floor(), &rolls);
        let axis = rolls.attitude * Vec3::Y;
        let spun = turned(rolls, Quat::from_axis_angle(axis, 0.5));
        let after = at_points(&m, &floor(), &spun);
        for (one, other) in before.iter().zip(&after) {
            assert!((one - other).abs() < 2e-5, "{before:?} {after:?} {m:?}");
        }
    }
}

#[test]
fn a_box_that_tips_a_little_has_the_right_distances() {
    let cube = at(block(0.25, 0.25, 0.25), 0.0, 0.251, 0.0);
    let m = manifold(&floor(), &cube, 0.02);
    let tipped = turned(cube, Quat::from_rotation_z(1e-3));
    for ((core_a, core_b), distance) in
        cores(&m, &floor(), &tipped)
            .iter()
            .zip(at_points(&m, &floor(), &tipped))
    {
        assert!((core_a.y).abs() < 1e-6);
        assert!((core_b.y - distance).abs() < 1e-7);
        assert!(
            (distance - (0.001 + 0.25e-3 * core_b.x.signum())).abs() < 1e-6,
            "{distance}"
        );
    }
}

#[test]
fn plates_that_lean_a_little_keep_four_points() {
    // The nearest points are where edges cross, but a plate doesn't lie on a point.
    let lower = turned(block(1.0, 0.05, 1.0), Quat::from_rotation_x(0.01));
    let upper = turned(block(1.0, 0.05, 1.0), Quat::from_rotation_z(0.01));
    for x in [-0.7, -0.4, 0.4, 0.7] {
        let upper = at(upper, x, 0.115, 0.3);
        let m = manifold(&lower, &upper, 0.05);
        assert_eq!(m.points, 4, "{m:?}");
        let normal = normal_of(&m, &lower, &upper);
        assert!((normal - DVec3::Y).length() < 0.011, "{normal}");
    }
}

#[test]
fn a_stack_keeps_its_names_while_it_trembles() {
    let lower = at(block(0.5, 0.5, 0.5), 0.0, 0.5, 0.0);
    let upper = at(block(0.5, 0.5, 0.5), 0.0, 1.4999, 0.0);
    let first = manifold(&lower, &upper, 0.02);
    assert_eq!(first.points, 4);
    for i in 0..50 {
        let (x, z) = (1e-3 * (i % 7) as f32 - 3e-3, 1e-3 * (i % 5) as f32 - 2e-3);
        let shaken = Quat::from_euler(glam::EulerRot::XYZ, 1e-4 * x, x, 1e-4 * z);
        let m = manifold(&lower, &turned(at(upper, x, 1.4999, z), shaken), 0.02);
        assert_eq!(names(&m), names(&first), "{i}");
    }
}

#[test]
fn a_sliding_box_keeps_the_names_of_its_corners() {
    let cube = turned(block(0.25, 0.25, 0.25), Quat::from_rotation_y(0.4));
    let first = manifold(&floor(), &at(cube, 0.0, 0.2495, 0.0), 0.02);
    for step in 1..200 {
        let x = 0.01 * step as f32;
        let m = manifold(&floor(), &at(cube, x, 0.2495, 0.3 * x), 0.02);
        assert_eq!(names(&m), names(&first));
    }
}

#[test]
fn the_points_of_a_manifold_have_names_of_their_own() {
    let coin = cylinder(0.5, 0.05);
    for i in 0..40 {
        let across = 0.025 * i as f32;
        let tilt = Quat::from_rotation_z(0.002 * i as f32);
        for upper in [coin, block(0.3, 0.05, 0.5), block(2.0, 0.05, 0.2)] {
            let upper = turned(at(upper, across, 0.0995, 0.0), tilt);
            let m = manifold(&coin, &upper, 0.05);
            let mut names = names(&m);
            names.dedup();
            assert_eq!(names.len(), m.points as usize, "{i} {m:?}");
        }
    }
}

#[test]
fn capsules_side_by_side_have_two_points_and_crossed_ones_have_one() {
    let log = lying(capsule(0.2, 1.0));
    let beside = at(log, 0.5, 0.399, 0.0);
    let m = manifold(&log, &beside, 0.02);
    assert_eq!((m.points, m.turns), (2, ROUND));
    for one in at_points(&m, &log, &beside) {
        assert!((one + 0.001).abs() < 1e-6);
    }
    let crossed = turned(beside, Quat::from_rotation_y(1.0));
    assert_eq!(manifold(&log, &crossed, 0.02).points, 1);
    // A degree off parallel, the two points stand opposite each other all the same.
    let nearly = turned(beside, Quat::from_rotation_y(0.02));
    let m = manifold(&log, &nearly, 0.02);
    assert_eq!(m.points, 2);
    let normal = normal_of(&m, &log, &nearly);
    for (core_a, core_b) in cores(&m, &log, &nearly) {
        assert!((core_b - core_a).normalize().dot(normal) > 1.0 - 1e-6);
    }
}

#[test]
fn logs_side_by_side_have_two_points() {
    let log = lying(cylinder(0.2, 1.0));
    let other = at(lying(cylinder(0.3, 0.5)), 0.2, 0.4, 0.299);
    let m = manifold(&log, &other, 0.02);
    assert_eq!((m.points, m.turns), (2, FIXED));
    for (core_a, core_b) in cores(&m, &log, &other) {
        assert!(core_a.y.hypot(core_a.z) < 1e-5, "{core_a}");
        assert!((core_b - core_a).length() > 0.49);
    }
}

#[test]
fn a_capsule_along_an_edge_has_two_points_and_across_it_one() {
    let edge = turned(block(1.0, 0.5, 0.5), Quat::from_rotation_x(FRAC_PI_4));
    let height = 0.5_f32.sqrt() + 0.099;
    let along = at(lying(capsule(0.1, 0.3)), 0.2, height, 0.0);
    let m = manifold(&edge, &along, 0.02);
    assert_eq!((m.points, m.turns), (2, WITH_A));
    let across = turned(along, Quat::from_rotation_y(1.0));
    let m = manifold(&edge, &across, 0.02);
    assert_eq!(m.points, 1);
    assert!((at_points(&m, &edge, &across)[0] + 0.001).abs() < 1e-5);
}

#[test]
fn edges_that_cross_touch_in_one_point() {
    let cube = block(0.5, 0.5, 0.5);
    let diagonal = 0.5_f32.sqrt();
    let lower = turned(cube, Quat::from_rotation_x(FRAC_PI_4));
    let upper = turned(cube, Quat::from_rotation_z(FRAC_PI_4));
    let upper = at(upper, 0.1, 2.0 * diagonal - 0.01, 0.2);
    let m = manifold(&lower, &upper, 0.02);
    assert_eq!(m.points, 1);
    assert!((normal_of(&m, &lower, &upper) - DVec3::Y).length() < 1e-4);
    let (core_a, core_b) = cores(&m, &lower, &upper)[0];
    let crossing = DVec3::new(0.1, f64::from(diagonal) - 0.005, 0.0);
    let middle = 0.5 * (core_a + core_b);
    // Where along the edges, not how high, a hundredth of the other's place may remain.
    assert!((middle - crossing).length() < 1e-4, "{middle}");
}

#[test]
fn a_box_reaches_the_edge_of_a_round_table() {
    // Two corners are over the table, and two beyond its rim: the box is held where its edges leave it.
    let table = cylinder(1.0, 0.4);
    let small = at(block(0.2, 0.1, 0.1), 0.95, 0.499, 0.0);
    let m = manifold(&table, &small, 0.01);
    assert_eq!(m.points, 4);
    let far = cores(&m, &table, &small)
        .into_iter()
        .map(|(p, _)| p.x.hypot(p.z));
    let far: Vec<f64> = far.collect();
    assert_eq!(
        far.iter().filter(|r| (*r - 1.0).abs() < 2e-3).count(),
        2,
        "{far:?}"
    );
    assert_eq!(far.iter().filter(|r| **r < 0.8).count(), 2, "{far:?}");
}

#[test]
fn swapped_bodies_have_the_same_contact_from_the_other_side() {
    let bodies = [
        at(ball(0.3), 0.0, 0.4, 0.0),
        at(block(0.3, 0.2, 0.25), 0.1, 0.0, 0.0),
        at(capsule(0.15, 0.3), 0.2, 0.3, 0.1),
        at(cylinder(0.3, 0.2), -0.1, 0.2, 0.2),
    ];
    for (i, a) in bodies.iter().enumerate() {
        for b in &bodies[i + 1..] {
            let (one, other) = (manifold(a, b, 0.5), manifold(b, a, 0.5));
            assert_eq!((one.points, one.kind), (other.points, other.kind));
            assert_eq!(normal_of(&one, a, b), -normal_of(&other, b, a));
            assert_eq!(names(&one), names(&other));
            let with = [ROUND, WITH_B, WITH_A, FIXED][other.turns as usize];
            assert_eq!(one.turns, with);
            for (there, back) in cores(&one, a, b).iter().zip(cores(&other, b, a)) {
                assert_eq!((there.0, there.1), (back.1, back.0));
            }
        }
    }
}
