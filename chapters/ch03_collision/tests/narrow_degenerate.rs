//! The narrow phase where it is hardest: solids in one place, parallel, touching exactly, very
//! thin, of very different sizes, far from the origin. The result is finite, its normal has length
//! 1, and its depth is right.

use ch00_maths::f32::shape::Shape;
use ch03_collision::narrow::{Placed, Touch, touch};
use glam::{Quat, Vec3};

const QUARTER: f32 = std::f32::consts::FRAC_PI_2;
const EIGHTH: f32 = std::f32::consts::FRAC_PI_4;

/// A solid somewhere.
#[derive(Clone, Copy, Debug)]
struct Solid {
    shape: Shape,
    p: Vec3,
    q: Quat,
    p_before: Vec3,
}

impl Solid {
    fn at(mut self, x: f32, y: f32, z: f32) -> Self {
        self.p = Vec3::new(x, y, z);
        self.p_before = self.p;
        self
    }

    fn turned(mut self, q: Quat) -> Self {
        self.q = q;
        self
    }

    fn came_from(mut self, x: f32, y: f32, z: f32) -> Self {
        self.p_before = Vec3::new(x, y, z);
        self
    }

    fn placed(&self) -> Placed<'_> {
        Placed {
            shape: &self.shape,
            p: self.p,
            q: self.q,
            p_before: self.p_before,
        }
    }
}

fn solid(shape: Shape) -> Solid {
    Solid {
        shape,
        p: Vec3::ZERO,
        q: Quat::IDENTITY,
        p_before: Vec3::ZERO,
    }
}

fn ball(radius: f32) -> Solid {
    solid(Shape::Sphere { radius })
}

fn block(x: f32, y: f32, z: f32) -> Solid {
    let half_extents = Vec3::new(x, y, z);
    solid(Shape::Box { half_extents })
}

fn capsule(radius: f32, half_height: f32) -> Solid {
    solid(Shape::Capsule {
        radius,
        half_height,
    })
}

fn cylinder(radius: f32, half_height: f32) -> Solid {
    solid(Shape::Cylinder {
        radius,
        half_height,
    })
}

/// A floor of 40 m whose upper face is y = 0.
fn floor() -> Solid {
    block(20.0, 0.5, 20.0).at(0.0, -0.5, 0.0)
}

/// Lying along x.
fn lying() -> Quat {
    Quat::from_rotation_z(QUARTER)
}

/// The touch of a and b, after looking at what every touch must be, and that b and a touch alike.
#[track_caller]
fn met(a: &Solid, b: &Solid, margin: f32) -> Option<Touch> {
    let found = touch(&a.placed(), &b.placed(), margin);
    let other = touch(&b.placed(), &a.placed(), margin);
    assert_eq!(found.is_some(), other.is_some(), "{a:?} {b:?}");
    let (found, other) = (found?, other?);
    assert!((found.depth() - other.depth()).abs() < 1e-4, "{a:?} {b:?}");
    for touch in [&found, &other] {
        assert!(!touch.spots().is_empty());
        assert!((touch.normal.length() - 1.0).abs() < 1e-5, "{touch:?}");
        let mut features: Vec<u32> = touch.spots().iter().map(|spot| spot.feature).collect();
        features.sort_unstable();
        features.dedup();
        assert_eq!(features.len(), touch.spots().len(), "{touch:?}");
        for spot in touch.spots() {
            assert!(
                spot.point.is_finite() && spot.depth.is_finite(),
                "{touch:?}"
            );
            assert!(spot.depth >= -margin - 1e-5, "{touch:?}");
        }
    }
    Some(found)
}

/// [`met`], for solids that must touch with this depth.
#[track_caller]
fn meets(a: &Solid, b: &Solid, depth: f32, tolerance: f32) -> Touch {
    let touch = met(a, b, 0.02).expect("they touch");
    assert!(
        (touch.depth() - depth).abs() <= tolerance,
        "{} is not {depth}: {touch:?}",
        touch.depth()
    );
    touch
}

#[track_caller]
fn points_along(touch: &Touch, normal: Vec3) {
    assert!((touch.normal - normal).length() < 1e-4, "{touch:?}");
}

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

/// Sine and cosine.
fn sin_cos(angle: f32) -> (f32, f32) {
    angle.sin_cos()
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
