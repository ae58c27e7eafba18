//! The narrow phase where it is hardest: bodies in one place, parallel, touching exactly, very thin, of
//! very different sizes. The result is finite, its normal has length 1, and its depth is right.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use ch06_compute::own_row::narrow::{Posed, manifold};
use ch06_compute::rows::Manifold;
use glam::{DVec3, Quat, Vec3};

use crate::bodies::{BALL, BOX, CAPSULE, CYLINDER, apart_along, at_points, body, normal_of, size};

fn at(mut body: Posed, position: Vec3) -> Posed {
    body.position = position;
    body
}

fn turned(mut body: Posed, q: Quat) -> Posed {
    body.attitude = q;
    body
}

/// One of each kind, about 1 m large.
fn one_of_each() -> [Posed; 4] {
    [
        body(BALL, Vec3::new(0.5, 0.0, 0.0)),
        body(BOX, Vec3::new(0.3, 0.7, 0.4)),
        body(CAPSULE, Vec3::new(0.25, 0.65, 0.0)),
        body(CYLINDER, Vec3::new(0.35, 0.8, 0.0)),
    ]
}

/// The manifold, after looking at what each must be.
#[track_caller]
fn met(a: &Posed, b: &Posed, margin: f32) -> Manifold {
    let m = manifold(a, b, margin);
    let normal = normal_of(&m, a, b);
    assert!((1..=4).contains(&m.points), "{m:?} {a:?} {b:?}");
    assert!((normal.length() - 1.0).abs() < 1e-5, "{m:?} {a:?} {b:?}");
    assert!(m.round_a >= 0.0 && m.round_b >= 0.0, "{m:?}");
    for k in 0..m.points as usize {
        assert!(
            m.core_a[k].is_finite() && m.core_b[k].is_finite(),
            "{m:?} {a:?} {b:?}"
        );
    }
    m
}

/// [`met`], for bodies with this distance, m, but for a share of the smaller one's size.
#[track_caller]
fn meets(a: &Posed, b: &Posed, distance: f64, share: f64) -> Manifold {
    let m = met(a, b, 0.05 * size(a).min(size(b)) as f32);
    let nearest = at_points(&m, a, b)
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    let tolerance = share * size(a).min(size(b));
    assert!(
        (nearest - distance).abs() <= tolerance,
        "{nearest} {distance} {m:?} {a:?} {b:?}"
    );
    m
}

#[test]
fn bodies_with_one_centre_part_along_the_shortest_way() {
    // All upright, so that the depth is known.
    for a in one_of_each() {
        for b in one_of_each() {
            let along = DVec3::AXES.map(|axis| apart_along(&a, &b, axis));
            let shortest = along.into_iter().fold(f64::NEG_INFINITY, f64::max);
            meets(&a, &b, shortest, 1e-3);
        }
    }
}

#[test]
fn bodies_in_one_place_in_any_attitude_have_a_way_out() {
    for a in one_of_each() {
        for b in one_of_each() {
            for i in 0..60 {
                let q =
                    Quat::from_euler(glam::EulerRot::XYZ, 0.11 * i as f32, 0.07 * i as f32, 0.3);
                let b = turned(b, q.normalize());
                let m = met(&a, &b, 0.0);
                let depth = -at_points(&m, &a, &b)
                    .into_iter()
                    .fold(f64::INFINITY, f64::min);
                assert!(depth > 0.49 && depth < 1.3, "{depth} {m:?}");
            }
        }
    }
}

#[test]
fn bodies_that_touch_exactly_have_distance_0() {
    for a in one_of_each() {
        for b in one_of_each() {
            for axis in DVec3::AXES {
                let way = (-apart_along(&a, &b, axis) * axis).as_vec3();
                for side in [way, -way] {
                    let m = meets(&a, &at(b, side), 0.0, 1e-5);
                    let normal = normal_of(&m, &a, &at(b, side));
                    assert!(
                        normal.dot(side.as_dvec3().normalize()) > 0.999,
                        "{m:?} {b:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_gap_counts_up_to_the_margin() {
    for a in one_of_each() {
        for b in one_of_each() {
            let way = 0.01 - apart_along(&a, &b, DVec3::Y);
            let above = at(b, Vec3::new(0.0, way as f32, 0.0));
            assert_eq!(manifold(&a, &above, 0.009).points, 0, "{a:?} {b:?}");
            assert_eq!(manifold(&above, &a, 0.009).points, 0, "{a:?} {b:?}");
            let m = meets(&a, &above, 0.01, 1e-5);
            assert!(
                (normal_of(&m, &a, &above) - DVec3::Y).length() < 1e-3,
                "{m:?}"
            );
        }
    }
}

/// A tilted body near another one, both so many times as large: their distance, as a share of that.
fn distance_of(kinds: [usize; 2], times: f32) -> f64 {
    let [a, b] = kinds.map(|kind| Posed {
        size: times * one_of_each()[kind].size,
        ..one_of_each()[kind]
    });
    let b = turned(b, Quat::from_rotation_x(0.4));
    let way = DVec3::new(0.48, 0.6, 0.64);
    let far = 0.02 * f64::from(times) - apart_along(&a, &b, way);
    let b = at(b, (far * way).as_vec3());
    let m = met(&a, &b, times);
    let nearest = at_points(&m, &a, &b)
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    nearest / f64::from(times)
}

#[test]
fn sizes_from_a_centimetre_to_a_hundred_metres_are_no_different() {
    for kinds in (0..4).flat_map(|a| (0..4).map(move |b| [a, b])) {
        let one = distance_of(kinds, 1.0);
        for times in [0.01, 100.0] {
            let scaled = distance_of(kinds, times);
            assert!(
                (scaled - one).abs() < 1e-5,
                "{kinds:?} {one} {times} {scaled}"
            );
        }
    }
}

#[test]
fn a_small_body_lies_on_a_huge_box_and_a_huge_cylinder() {
    for large in [
        body(BOX, Vec3::new(100.0, 5.0, 100.0)),
        body(CYLINDER, Vec3::new(100.0, 5.0, 0.0)),
    ] {
        for small in one_of_each() {
            let small = Posed {
                size: 0.02 * small.size,
                ..small
            };
            let half = -apart_along(&small, &body(BALL, Vec3::ZERO), DVec3::Y);
            // Exact to the digits that a height of 5 m has.
            for (distance, share) in [(-1e-4, 1e-3), (1e-4, 1e-3)] {
                let p = DVec3::new(31.0, 5.0 + half + distance, 17.0).as_vec3();
                let m = meets(&at(small, p), &large, distance, share);
                assert!((normal_of(&m, &at(small, p), &large) + DVec3::Y).length() < 1e-5);
            }
        }
    }
}

#[test]
fn a_coin_lies_flat_stands_on_its_rim_and_lies_on_another_coin() {
    let coin = body(CYLINDER, Vec3::new(1.0, 0.001, 0.0));
    let floor = at(
        body(BOX, Vec3::new(20.0, 0.5, 20.0)),
        Vec3::new(0.0, -0.5, 0.0),
    );
    let m = meets(&at(coin, Vec3::new(3.0, 0.0009, 2.0)), &floor, -1e-4, 1e-6);
    assert_eq!(m.points, 4);
    let upright = turned(coin, Quat::from_rotation_z(FRAC_PI_2));
    meets(
        &at(upright, Vec3::new(0.0, 0.9999, 0.0)),
        &floor,
        -1e-4,
        1e-5,
    );
    let m = meets(&at(coin, Vec3::new(0.5, 0.0019, 0.0)), &coin, -1e-4, 1e-5);
    assert_eq!(m.points, 4);
}

#[test]
fn needles_and_plates_give_finite_answers() {
    let needle = body(BOX, Vec3::new(1.0, 1e-3, 1e-3));
    let plate = body(BOX, Vec3::new(1.0, 1e-3, 1.0));
    let wire = body(CAPSULE, Vec3::new(1e-3, 1.0, 0.0));
    let rod = body(CYLINDER, Vec3::new(1e-3, 1.0, 0.0));
    let coin = body(CYLINDER, Vec3::new(1.0, 1e-3, 0.0));
    let dot = body(BALL, Vec3::new(1e-3, 0.0, 0.0));
    let thin = [needle, plate, wire, rod, coin, dot];
    for a in thin {
        for b in thin {
            for i in 0..200 {
                let turn = 0.37 * i as f32;
                let q = Quat::from_euler(glam::EulerRot::ZYX, turn, 1.7 * turn, 0.6 * turn);
                let p = Vec3::new(0.4, 0.01 * (i % 10) as f32, 0.3) * (i % 3) as f32;
                met(&a, &at(turned(b, q.normalize()), p), 10.0);
            }
        }
    }
}

#[test]
fn edges_side_by_side_and_edges_that_lie_on_each_other_are_told_apart() {
    // Two roofs, ridge over ridge: apart they have the ridge's two ends.
    let roof = turned(
        body(BOX, Vec3::splat(0.5)),
        Quat::from_rotation_x(FRAC_PI_4),
    );
    let height = 2.0 * 0.5_f32.sqrt();
    let upper = at(roof, Vec3::new(0.4, height + 0.01, 0.0));
    let m = meets(&roof, &upper, 0.01, 1e-4);
    assert_eq!(m.points, 2, "{m:?}");
    assert!((normal_of(&m, &roof, &upper) - DVec3::Y).length() < 1e-3);
    // Where they overlap, the shorter way is to the side, by 1/√2.
    let lower = at(roof, Vec3::new(0.4, height - 0.01, 0.0));
    meets(&roof, &lower, -0.01 * 0.5_f64.sqrt(), 1e-3);
}

#[test]
fn a_ball_in_the_middle_of_a_face_and_one_at_the_centre_of_a_box() {
    let block = body(BOX, Vec3::new(0.5, 0.25, 0.5));
    let ball = body(BALL, Vec3::new(0.1, 0.0, 0.0));
    for (y, distance) in [(0.35, 0.0), (0.25, -0.1), (0.1, -0.25), (0.0, -0.35)] {
        let m = meets(&at(ball, Vec3::new(0.0, y, 0.0)), &block, distance, 1e-5);
        let normal = normal_of(&m, &at(ball, Vec3::new(0.0, y, 0.0)), &block);
        assert!((normal + DVec3::Y).length() < 1e-6, "{normal}");
    }
}

#[test]
fn a_ball_inside_a_cylinder_leaves_by_the_nearer_way() {
    let drum = body(CYLINDER, Vec3::new(1.0, 0.5, 0.0));
    let ball = body(BALL, Vec3::new(0.2, 0.0, 0.0));
    let cases = [
        (Vec3::new(0.1, -0.3, 0.0), DVec3::Y, -0.4),
        (Vec3::new(0.0, 0.1, 0.8), DVec3::NEG_Z, -0.4),
        (Vec3::ZERO, DVec3::NEG_Y, -0.7),
        (Vec3::new(0.5, 0.65, 0.3), DVec3::NEG_Y, -0.05),
        (Vec3::new(0.0, 0.3, -1.15), DVec3::Z, -0.05),
    ];
    for (p, normal, distance) in cases {
        let m = meets(&at(ball, p), &drum, distance, 1e-5);
        assert!(
            (normal_of(&m, &at(ball, p), &drum) - normal).length() < 1e-6,
            "{m:?}"
        );
    }
}
