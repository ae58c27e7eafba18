//! Capsules and cylinders, of usual shapes and very thin ones.

use glam::{Quat, Vec3};

use crate::{
    QUARTER, ball, block, capsule, cylinder, floor, lying, meets, met, points_along, sin_cos,
};

#[test]
fn parallel_capsules_touch_along_the_stretch_that_they_share() {
    let one = capsule(0.1, 0.5);
    for turn in [Quat::IDENTITY, lying(), Quat::from_rotation_x(1.0)] {
        let aside = turn * Vec3::new(0.19, 0.4, 0.0);
        let other = one.turned(turn).at(aside.x, aside.y, aside.z);
        let touch = meets(&other, &one.turned(turn), 0.01, 1e-6);
        points_along(&touch, turn * Vec3::X);
        assert_eq!(touch.spots().len(), 2);
        let stretch = touch.spots()[0].point.distance(touch.spots()[1].point);
        assert!((stretch - 0.6).abs() < 1e-5);
    }
}

#[test]
fn capsules_a_little_out_of_parallel_keep_their_second_point_while_it_is_near() {
    let one = capsule(0.1, 0.5);
    for (angle, points) in [(0.005, 2), (0.015, 2), (0.05, 1)] {
        // One end of the other sinks in by a millimetre, the other one stands off.
        let aside = 0.199 + 0.5 * sin_cos(angle).0;
        let other = one.at(aside, 0.0, 0.0).turned(Quat::from_rotation_z(angle));
        let touch = meets(&other, &one, 0.001, 1e-4);
        assert_eq!(touch.spots().len(), points, "{touch:?}");
    }
}

#[test]
fn capsules_on_one_axis_touch_at_their_ends() {
    let touch = meets(
        &capsule(0.1, 0.5).at(0.0, 1.19, 0.0),
        &capsule(0.1, 0.5),
        0.01,
        1e-6,
    );
    points_along(&touch, Vec3::Y);
    assert_eq!(touch.spots().len(), 1);
}

#[test]
fn crossing_axes_part_at_a_right_angle_to_both() {
    let other = capsule(0.1, 0.5).turned(lying());
    let touch = meets(&capsule(0.2, 0.5), &other, 0.3, 1e-6);
    assert!((touch.normal.z.abs() - 1.0).abs() < 1e-5, "{touch:?}");
}

#[test]
fn a_capsule_on_the_floor_rests_on_two_points_and_stands_on_one() {
    let limb = capsule(0.05, 0.2);
    let touch = meets(
        &limb.turned(lying()).at(1.0, 0.0495, 2.0),
        &floor(),
        0.0005,
        1e-6,
    );
    assert_eq!(touch.normal, Vec3::Y);
    assert_eq!(touch.spots().len(), 2);
    let touch = meets(&limb.at(1.0, 0.2495, 2.0), &floor(), 0.0005, 1e-6);
    assert_eq!(touch.normal, Vec3::Y);
    assert_eq!(touch.spots().len(), 1);
}

#[test]
fn a_capsule_along_the_edge_of_a_box_touches_it_in_two_points() {
    let aside = 0.5 + 0.199 * std::f32::consts::FRAC_1_SQRT_2;
    let touch = meets(
        &capsule(0.2, 0.3).at(aside, 0.0, aside),
        &block(0.5, 0.5, 0.5),
        0.001,
        1e-5,
    );
    points_along(&touch, Vec3::new(1.0, 0.0, 1.0).normalize());
    assert_eq!(touch.spots().len(), 2);
}

#[test]
fn a_cylinder_stands_on_four_points_lies_on_two_and_leans_on_its_rim() {
    let drum = cylinder(0.3, 0.2);
    for turn in [0.0, 0.1, 1.0] {
        let turned = drum.turned(Quat::from_rotation_y(turn));
        let touch = meets(&turned.at(0.0, 0.199, 0.0), &floor(), 0.001, 1e-6);
        assert_eq!(touch.normal, Vec3::Y);
        assert_eq!(touch.spots().len(), 4);
        let centre = touch.spots().iter().map(|spot| spot.point).sum::<Vec3>() / 4.0;
        assert!(centre.length() < 1e-3, "a square about the axis: {touch:?}");
    }
    let touch = meets(
        &drum.turned(lying()).at(0.0, 0.299, 0.0),
        &floor(),
        0.001,
        1e-6,
    );
    assert_eq!(touch.normal, Vec3::Y);
    assert_eq!(touch.spots().len(), 2);
    for turn in [0.0, 0.2, 0.39, 1.0] {
        // Turned about its own axis, the rim's lowest point is between the cap's corners.
        let leaning = Quat::from_rotation_z(0.5) * Quat::from_rotation_y(turn);
        let height = 0.2 * sin_cos(0.5).1 + 0.3 * sin_cos(0.5).0;
        let touch = meets(
            &drum.turned(leaning).at(0.0, height - 0.001, 0.0),
            &floor(),
            0.001,
            1e-6,
        );
        assert_eq!(touch.normal, Vec3::Y);
    }
}

#[test]
fn cylinders_side_by_side_and_on_each_other() {
    let drum = cylinder(0.3, 0.2);
    let touch = meets(&drum.at(0.599, 0.1, 0.0), &drum, 0.001, 1e-5);
    // The side is round, and EPA ends where it is right to a rounding: a mrad.
    assert!((touch.normal - Vec3::X).length() < 2e-3, "{touch:?}");
    assert_eq!(touch.spots().len(), 2);
    let touch = meets(&drum.at(0.1, 0.399, 0.0), &drum, 0.001, 1e-5);
    points_along(&touch, Vec3::Y);
    assert_eq!(touch.spots().len(), 4);
}

#[test]
fn a_capsule_without_height_is_a_ball() {
    let (round, ball) = (capsule(0.25, 0.0), ball(0.25));
    let others = [
        capsule(0.1, 0.5).turned(Quat::from_rotation_x(0.7)),
        block(0.4, 0.3, 0.5).turned(Quat::from_rotation_z(0.4)),
        cylinder(0.4, 0.3).turned(Quat::from_rotation_x(0.3)),
        capsule(0.1, 0.0),
    ];
    let directions = [
        Vec3::new(1.0, 0.1, 0.05),
        Vec3::Y,
        Vec3::ONE,
        Vec3::new(-0.3, 0.8, 0.1),
    ];
    for other in &others {
        for direction in directions {
            for distance in [0.1, 0.3, 0.5] {
                let p = direction.normalize() * distance;
                let wanted = met(&ball.at(p.x, p.y, p.z), other, 0.1);
                let found = met(&round.at(p.x, p.y, p.z), other, 0.1);
                assert_eq!(wanted.is_some(), found.is_some());
                if let (Some(wanted), Some(found)) = (wanted, found) {
                    assert!(
                        (wanted.depth() - found.depth()).abs() < 1e-5,
                        "{wanted:?} {found:?}"
                    );
                    assert!(
                        wanted.normal.dot(found.normal) > 0.999_9,
                        "{wanted:?} {found:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_needle_lies_on_the_floor_and_across_another_needle() {
    let needle = block(0.001, 0.001, 1.0);
    let touch = meets(&needle.at(3.0, 0.000_9, 2.0), &floor(), 1e-4, 1e-6);
    assert_eq!(touch.normal, Vec3::Y);
    assert_eq!(touch.spots().len(), 4);
    let across = needle
        .turned(Quat::from_rotation_y(QUARTER))
        .at(0.3, 0.001_9, 0.4);
    let touch = meets(&across, &needle, 1e-4, 1e-6);
    points_along(&touch, Vec3::Y);
    let crossing = Vec3::new(0.0, 0.000_95, 0.4);
    for spot in touch.spots() {
        assert!((spot.point - crossing).length() < 0.002, "{touch:?}");
    }
    // Standing on its tip, which is a face of 2 mm.
    let touch = meets(
        &needle
            .turned(Quat::from_rotation_x(QUARTER))
            .at(0.0, 0.999_9, 0.0),
        &floor(),
        1e-4,
        1e-6,
    );
    assert_eq!(touch.normal, Vec3::Y);
    assert_eq!(touch.spots().len(), 4);
}

#[test]
fn a_coin_lies_flat_stands_on_its_rim_and_lies_on_another_coin() {
    let coin = cylinder(1.0, 0.001);
    let touch = meets(&coin.at(3.0, 0.000_9, 2.0), &floor(), 1e-4, 1e-6);
    assert_eq!(touch.normal, Vec3::Y);
    assert_eq!(touch.spots().len(), 4);
    let touch = meets(
        &coin.turned(lying()).at(0.0, 0.999_9, 0.0),
        &floor(),
        1e-4,
        1e-5,
    );
    assert_eq!(touch.normal, Vec3::Y);
    let touch = meets(&coin.at(0.5, 0.001_9, 0.0), &coin, 1e-4, 1e-6);
    points_along(&touch, Vec3::Y);
    assert_eq!(touch.spots().len(), 4);
}
