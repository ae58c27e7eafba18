//! Solids of any kind: in one place, touching exactly, large, far away, apart.

use glam::{Quat, Vec3};

use crate::{EIGHTH, QUARTER, ball, block, capsule, cylinder, lying, meets, met, points_along};

#[test]
fn solids_with_one_centre_part_along_the_shortest_way() {
    // All upright, so that the depth is known: widths 0.5, 0.3 and 0.4 m, heights 0.7 m and more.
    let solids = [
        ball(0.5),
        block(0.3, 0.7, 0.4),
        capsule(0.25, 0.9),
        cylinder(0.35, 0.8),
    ];
    let widths = [0.5, 0.3, 0.25, 0.35];
    for (a, width_a) in solids.iter().zip(widths) {
        for (b, width_b) in solids.iter().zip(widths) {
            let touch = meets(a, b, width_a + width_b, 1e-3 * (width_a + width_b));
            assert!(
                touch.normal.y.abs() < 0.05 || a.shape == b.shape,
                "{touch:?}"
            );
        }
    }
}

#[test]
fn solids_with_one_centre_in_any_pose_stay_finite() {
    let solids = [
        ball(0.5),
        block(0.3, 0.7, 0.4),
        capsule(0.25, 0.9),
        cylinder(0.35, 0.8),
    ];
    let turns = [0.0, 1e-4, 0.3, EIGHTH, QUARTER, 3.0];
    for a in &solids {
        for b in &solids {
            for turn in turns {
                let b = b.turned(Quat::from_rotation_x(turn) * Quat::from_rotation_z(turn));
                let touch = met(a, &b, 0.0).expect("they touch");
                // At least as deep as the balls within are.
                assert!(touch.depth() > 0.499, "{touch:?}");
            }
        }
    }
}

#[test]
fn solids_that_touch_exactly_have_no_depth() {
    let solids = [
        (ball(0.5), 0.5),
        (block(0.25, 0.5, 0.75), 0.5),
        (capsule(0.25, 0.25), 0.5),
        (cylinder(0.25, 0.5), 0.5),
    ];
    for (a, height_a) in solids {
        for (b, height_b) in solids {
            for turn in [0.0, 0.7] {
                let a = a.turned(Quat::from_rotation_y(turn));
                let touch = meets(
                    &a.at(0.1, height_a + height_b, 0.0),
                    &b.at(0.1, 0.0, 0.0),
                    0.0,
                    1e-6,
                );
                points_along(&touch, Vec3::Y);
            }
        }
    }
}

#[test]
fn a_hundred_times_larger_is_no_different() {
    for small in [
        block(0.05, 0.05, 0.05),
        cylinder(0.05, 0.05),
        capsule(0.025, 0.025),
        ball(0.05),
    ] {
        for large in [block(5.0, 5.0, 5.0), cylinder(5.0, 5.0)] {
            let touch = meets(&small.at(2.0, 5.049, 1.5), &large, 0.001, 2e-6);
            points_along(&touch, Vec3::Y);
            // Deep inside, it leaves by the nearest face.
            let touch = meets(&small.at(0.3, 4.5, 0.2), &large, 0.55, 1e-5);
            points_along(&touch, Vec3::Y);
        }
    }
}

#[test]
fn a_kilometre_from_the_origin_depths_are_as_exact_as_positions() {
    let solids = [
        ball(0.25),
        block(0.25, 0.25, 0.25),
        capsule(0.125, 0.125),
        cylinder(0.25, 0.25),
    ];
    for a in solids {
        for b in solids {
            // Heights that an f32 holds exactly there, so that the depth is 1/256 m.
            let touch = meets(
                &a.at(1000.0, 1000.0 + 127.0 / 256.0, -1000.0),
                &b.at(1000.0, 1000.0, -1000.0),
                1.0 / 256.0,
                1e-6,
            );
            points_along(&touch, Vec3::Y);
            for spot in touch.spots() {
                assert!((spot.point.y - 1000.248).abs() < 1e-3, "{touch:?}");
            }
        }
    }
}

#[test]
fn a_gap_counts_up_to_the_margin() {
    let solids = [
        ball(0.5),
        block(0.25, 0.5, 0.75),
        capsule(0.25, 0.25),
        cylinder(0.25, 0.5),
    ];
    for a in solids {
        for b in solids {
            let above = a.at(0.0, 1.01, 0.0);
            assert!(met(&above, &b, 0.009).is_none(), "{a:?} {b:?}");
            let touch = met(&above, &b, 0.011).expect("within the margin");
            assert!((touch.depth() + 0.01).abs() < 1e-5, "{touch:?}");
            points_along(&touch, Vec3::Y);
        }
    }
}

#[test]
fn a_limb_that_fell_past_the_middle_of_a_thin_floor_leaves_upwards() {
    let floor = block(2.0, 0.05, 2.0);
    for limb in [
        capsule(0.02, 0.2).turned(lying()),
        block(0.2, 0.02, 0.02),
        cylinder(0.02, 0.2).turned(lying()),
    ] {
        let fell = limb.at(0.0, -0.03, 0.0);
        let touch = meets(&fell, &floor, 0.04, 1e-5);
        points_along(&touch, Vec3::NEG_Y);
        let touch = meets(&fell.came_from(0.0, 0.3, 0.0), &floor, 0.1, 1e-5);
        points_along(&touch, Vec3::Y);
        assert!(touch.spots().len() >= 2);
    }
}
