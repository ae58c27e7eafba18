//! Boxes: faces, edges and corners.

use ch03_collision::narrow::Touch;
use glam::{Quat, Vec3};

use crate::{EIGHTH, QUARTER, block, floor, meets, met, points_along, sin_cos};

#[test]
fn a_box_on_the_floor_rests_on_four_equal_corners() {
    for turn in [0.0, 0.3, EIGHTH, 1.0, QUARTER] {
        let cube = block(0.25, 0.25, 0.25).turned(Quat::from_rotation_y(turn));
        for (x, z) in [(0.0, 0.0), (3.7, -2.1), (19.0, 19.0)] {
            let touch = meets(&cube.at(x, 0.249, z), &floor(), 0.001, 1e-6);
            assert_eq!(touch.normal, Vec3::Y);
            assert_eq!(touch.spots().len(), 4);
            for spot in touch.spots() {
                assert_eq!(spot.depth, touch.spots()[0].depth);
                assert!((spot.point.y + 0.0005).abs() < 1e-6);
            }
        }
    }
}

/// The names of the points, in order.
fn names(touch: &Touch) -> Vec<u32> {
    let mut names: Vec<u32> = touch.spots().iter().map(|spot| spot.feature).collect();
    names.sort_unstable();
    names
}

/// A small number of either sign that looks random, of at most `size`.
fn tremor(i: u32, k: u32, size: f32) -> f32 {
    size * (((7 * k + 1) * i + k) as f32 % 13.0 - 6.0) / 6.0
}

#[test]
fn equal_boxes_in_a_stack_keep_their_normal_and_their_corners_while_they_tremble() {
    let cube = block(0.25, 0.25, 0.25);
    let lower = cube.at(1.0, 0.25, 1.0);
    let first = meets(&lower, &cube.at(1.0, 0.7499, 1.0), 1e-4, 1e-6);
    assert_eq!(first.spots().len(), 4);
    // By rounding, and by what a solver leaves.
    for size in [1e-6, 1e-3] {
        for i in 0..200 {
            let [x, y, z, turn] = [1, 2, 3, 4].map(|k| tremor(i, k, size));
            let tilt =
                Quat::from_rotation_x(x) * Quat::from_rotation_z(z) * Quat::from_rotation_y(turn);
            let upper = cube.at(1.0 + x, 0.7499 + 0.1 * y, 1.0 + z).turned(tilt);
            let touch = met(&lower, &upper, 0.01).expect("they touch");
            assert!(
                (touch.normal + Vec3::Y).length() < 2.0 * size + 1e-6,
                "{touch:?}"
            );
            assert_eq!(names(&touch), names(&first), "{touch:?}");
        }
    }
}

#[test]
fn a_wide_box_on_a_narrow_one_rests_on_the_narrow_ones_corners() {
    let touch = meets(
        &block(1.0, 0.1, 1.0).at(0.0, 0.599, 0.0),
        &block(0.3, 0.5, 0.2),
        0.001,
        1e-6,
    );
    points_along(&touch, Vec3::Y);
    assert_eq!(touch.spots().len(), 4);
    for spot in touch.spots() {
        let p = spot.point.abs();
        assert!(
            (p - Vec3::new(0.3, 0.4995, 0.2)).length() < 1e-5,
            "{spot:?}"
        );
    }
}

#[test]
fn a_box_turned_by_an_eighth_on_its_like_keeps_the_widest_four_of_eight_points() {
    let cube = block(0.5, 0.5, 0.5);
    let upper = cube
        .at(0.0, 0.999, 0.0)
        .turned(Quat::from_rotation_y(EIGHTH));
    let touch = meets(&upper, &cube, 0.001, 1e-6);
    assert_eq!(touch.spots().len(), 4);
    let centre = touch.spots().iter().map(|spot| spot.point).sum::<Vec3>() / 4.0;
    assert!(
        Vec3::new(centre.x, 0.0, centre.z).length() < 0.01,
        "{centre}"
    );
}

#[test]
fn edges_that_cross_touch_in_one_point() {
    let cube = block(0.5, 0.5, 0.5);
    let diagonal = 0.5_f32.sqrt();
    let lower = cube.turned(Quat::from_rotation_x(EIGHTH));
    let upper = cube.turned(Quat::from_rotation_z(EIGHTH));
    let touch = meets(
        &upper.at(0.1, 2.0 * diagonal - 0.01, 0.2),
        &lower,
        0.01,
        1e-5,
    );
    points_along(&touch, Vec3::Y);
    assert_eq!(touch.spots().len(), 1);
    let crossing = Vec3::new(0.1, diagonal - 0.005, 0.0);
    assert!(
        (touch.spots()[0].point - crossing).length() < 1e-4,
        "{touch:?}"
    );
}

#[test]
fn edges_side_by_side_touch_in_two_points() {
    let cube = block(0.5, 0.5, 0.5).turned(Quat::from_rotation_x(EIGHTH));
    let diagonal = 0.5_f32.sqrt();
    let touch = met(&cube.at(0.4, 2.0 * diagonal + 0.01, 0.0), &cube, 0.02).expect("near enough");
    points_along(&touch, Vec3::Y);
    assert_eq!(touch.spots().len(), 2);
    assert!((touch.depth() + 0.01).abs() < 1e-5);
}

#[test]
fn a_corner_on_a_face_touches_in_that_corner() {
    let cube = block(0.5, 0.5, 0.5);
    // The diagonal from corner to corner upright.
    let upright = Quat::from_rotation_arc(Vec3::ONE.normalize(), Vec3::Y);
    let reach = 0.75_f32.sqrt();
    let touch = meets(
        &cube.turned(upright).at(2.0, reach - 0.001, 1.0),
        &floor(),
        0.001,
        1e-5,
    );
    assert_eq!(touch.normal, Vec3::Y);
    assert_eq!(touch.spots().len(), 1);
    assert!((touch.spots()[0].point - Vec3::new(2.0, -0.0005, 1.0)).length() < 1e-4);
}

#[test]
fn a_tilted_box_drops_the_points_that_are_further_than_the_margin() {
    // 1 m wide, tilted by 0.05 rad: one side is 50 mm higher.
    let tilted = block(0.5, 0.1, 0.5).turned(Quat::from_rotation_z(0.05));
    let (sine, cosine) = sin_cos(0.05);
    let height = 0.5 * sine + 0.1 * cosine;
    for (margin, points) in [(0.01, 2), (0.1, 4)] {
        let touch =
            met(&tilted.at(0.0, height - 0.001, 0.0), &floor(), margin).expect("it touches");
        assert_eq!(touch.spots().len(), points, "{touch:?}");
        assert!((touch.depth() - 0.001).abs() < 1e-5);
    }
}

#[test]
fn a_sliding_box_keeps_the_names_of_its_corners() {
    let cube = block(0.25, 0.25, 0.25).turned(Quat::from_rotation_y(0.4));
    let first = meets(&cube.at(0.0, 0.2495, 0.0), &floor(), 0.0005, 1e-6);
    for step in 1..200 {
        let x = 0.01 * step as f32;
        let touch = meets(&cube.at(x, 0.2495, 0.3 * x), &floor(), 0.0005, 1e-6);
        assert_eq!(names(&touch), names(&first));
    }
}
