//! How deep any two solids overlap, through parry3d in f64: an independent judge for the tests and
//! the laboratory, which want the pairs that have no closed form here. Feature `parry`.

use glam::DVec3;
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::{Ball, Capsule, Cuboid, Cylinder, Shape as Solid};

use super::depth::Placed;
use crate::Shape;

/// How deep a and b overlap, m: the length of the shortest shift that parts them. At most
/// 0 where they don't touch, and then minus their distance. `None` where parry's answer
/// contradicts itself.
///
/// GJK and EPA find the direction of that shift; how far the solids reach into each other
/// along it is computed here. EPA's own length is off by 1e-3 m now and then where surfaces
/// are round, its direction hardly, and an error of the direction counts only squared. Only
/// where solids just touch the direction may be any: so those that are likely for such
/// solids are tried as well. Each of them parts the solids, so what comes out is never less
/// than the depth.
#[must_use]
pub fn convex_depth(a: &Placed, b: &Placed) -> Option<f64> {
    let (solid_a, solid_b) = (solid(a.shape), solid(b.shape));
    let (pose_a, pose_b) = (pose(a), pose(b));
    let contact = query::contact(&pose_a, &*solid_a, &pose_b, &*solid_b, 0.0).ok()?;
    let Some(contact) = contact else {
        let apart = query::distance(&pose_a, &*solid_a, &pose_b, &*solid_b).ok()?;
        return Some(-apart.distance);
    };
    let [x, y, z] = contact.normal1.into();
    let found = likely_directions(a, b)
        .into_iter()
        .chain([DVec3::new(x, y, z)])
        .filter_map(DVec3::try_normalize)
        .map(|n| overlap_along(a, b, n))
        .fold(f64::INFINITY, f64::min);
    let size = a.shape.bounding_radius().min(b.shape.bounding_radius());
    let agrees = (found + contact.dist).abs() < TRUST * size;
    agrees.then_some(found)
}

/// How far parry's length of a shift may be from that along its direction, in sizes of the
/// smaller solid.
const TRUST: f64 = 0.02;

/// Across flat faces, across the round sides of cylinders, and from centre to centre: not of
/// unit length, and some may be zero.
fn likely_directions(a: &Placed, b: &Placed) -> [DVec3; 10] {
    let between = b.position - a.position;
    let [u, v] = [a, b].map(|solid| solid.orientation * DVec3::Y);
    let [of_a, of_b] = [a, b].map(|solid| DVec3::AXES.map(|axis| solid.orientation * axis));
    let [ax, ay, az] = of_a;
    let [bx, by, bz] = of_b;
    let across = |axis: DVec3| between - axis * axis.dot(between);
    [
        ax,
        ay,
        az,
        bx,
        by,
        bz,
        between,
        across(u),
        across(v),
        u.cross(v),
    ]
}

/// How far a and b reach into each other along a unit vector, m: the shift of b along it or
/// against it that parts them.
fn overlap_along(a: &Placed, b: &Placed, n: DVec3) -> f64 {
    let reach_along = |solid: &Placed| reach(solid.shape, solid.orientation.conjugate() * n);
    reach_along(a) + reach_along(b) - n.dot(b.position - a.position).abs()
}

/// How far a solid reaches from its centre along a unit vector of its own frame, m; as far the
/// other way, since all of them are symmetric.
fn reach(shape: Shape, n: DVec3) -> f64 {
    match shape {
        Shape::Sphere { radius } => radius,
        Shape::Box { half_extents } => half_extents.dot(n.abs()),
        Shape::Capsule {
            radius,
            half_height,
        } => radius + half_height * n.y.abs(),
        Shape::Cylinder {
            radius,
            half_height,
        } => radius * n.x.hypot(n.z) + half_height * n.y.abs(),
    }
}

fn solid(shape: Shape) -> Box<dyn Solid> {
    match shape {
        Shape::Sphere { radius } => Box::new(Ball::new(radius)),
        Shape::Box { half_extents: h } => Box::new(Cuboid::new(Vector::new(h.x, h.y, h.z))),
        Shape::Capsule {
            radius,
            half_height,
        } => Box::new(Capsule::new_y(half_height, radius)),
        Shape::Cylinder {
            radius,
            half_height,
        } => Box::new(Cylinder::new(half_height, radius)),
    }
}

/// Its glam is another version than ours, so numbers go over one by one.
fn pose(solid: &Placed) -> Pose {
    let [x, y, z] = solid.position.to_array();
    let [i, j, k, w] = solid.orientation.to_array();
    Pose::from_parts(Vector::new(x, y, z), Rotation::from_xyzw(i, j, k, w))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};

    use glam::DQuat;

    use super::super::depth::depth;
    use super::*;
    use crate::random::SplitMix64;

    fn at(shape: Shape, x: f64, y: f64, z: f64) -> Placed {
        Placed {
            shape,
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

    fn block(x: f64, y: f64, z: f64) -> Shape {
        let half_extents = DVec3::new(x, y, z);
        Shape::Box { half_extents }
    }

    fn cylinder(radius: f64, half_height: f64) -> Shape {
        Shape::Cylinder {
            radius,
            half_height,
        }
    }

    fn assert_depth(a: &Placed, b: &Placed, expected: f64) {
        for depth in [convex_depth(a, b).unwrap(), convex_depth(b, a).unwrap()] {
            assert!((depth - expected).abs() < 1e-9, "{depth}, not {expected}");
        }
    }

    /// A solid of a size of about 0.5 m: a ball, a capsule, a box or a cylinder.
    fn random_solid(kind: usize, random: &mut SplitMix64) -> Placed {
        let (radius, half_height) = (random.between(0.1, 0.4), random.between(0.1, 0.5));
        let shape = match kind {
            0 => Shape::Sphere { radius },
            1 => Shape::Capsule {
                radius,
                half_height,
            },
            2 => Shape::Box {
                half_extents: DVec3::splat(0.3) + random.vector(0.2),
            },
            _ => cylinder(radius, half_height),
        };
        Placed {
            shape,
            position: random.vector(0.5),
            orientation: random.rotation(),
        }
    }

    #[test]
    fn parry_and_the_closed_forms_agree_on_balls_capsules_and_boxes() {
        let mut random = SplitMix64::new(12);
        for i in 0..20_000 {
            let a = random_solid(i % 3, &mut random);
            let b = random_solid(i / 3 % 3, &mut random);
            let exact = depth(&a, &b).unwrap();
            let found = convex_depth(&a, &b).unwrap();
            // Of boxes that are apart the closed form knows the widest gap only.
            let are_boxes = i % 3 == 2 && i / 3 % 3 == 2;
            let may_differ = are_boxes && exact <= 0.0 && found < exact;
            let agree = may_differ || (found - exact).abs() < 5e-5;
            assert!(agree, "{found} {exact} {a:?} {b:?}");
        }
    }

    /// The least overlap along any direction, by trying many and going on from the best few.
    fn searched(a: &Placed, b: &Placed, random: &mut SplitMix64) -> f64 {
        let tried = |n: DVec3| (overlap_along(a, b, n), n);
        let mut tries: Vec<_> = (0..300)
            .map(|_| tried(random.vector(1.0).normalize()))
            .collect();
        tries.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let mut best = f64::INFINITY;
        for &(mut least, mut n) in &tries[..5] {
            let mut size = 0.1;
            while size > 1e-6 {
                let nearby = (0..20).map(|_| tried((n + random.vector(size)).normalize()));
                let (found, way) = nearby.min_by(|(a, _), (b, _)| a.total_cmp(b)).unwrap();
                if found < least {
                    (least, n) = (found, way);
                } else {
                    size *= 0.7;
                }
            }
            best = best.min(least);
        }
        best
    }

    #[test]
    fn no_search_parts_a_cylinder_from_anything_by_less() {
        let mut random = SplitMix64::new(13);
        let mut inside = 0;
        for i in 0..2000 {
            let a = random_solid(3, &mut random);
            let b = random_solid(i % 4, &mut random);
            let found = convex_depth(&a, &b).unwrap();
            if found > 0.0 {
                inside += 1;
                let least = searched(&a, &b, &mut random);
                assert!(found < least + 1e-5, "{found} {least} {a:?} {b:?}");
            }
        }
        assert!(inside > 900, "{inside}");
    }

    #[test]
    fn cylinders_that_stand_lie_and_lean_reach_into_a_floor_by_their_lowest_point() {
        let floor = at(block(2.0, 0.5, 2.0), 0.0, -0.5, 0.0);
        let (radius, half_height) = (0.3, 0.2);
        for lean in [0.0, 0.3, FRAC_PI_4, 1.2, FRAC_PI_2] {
            let lowest = half_height * lean.cos() + radius * lean.sin();
            let above = at(cylinder(radius, half_height), 0.4, lowest - 0.02, 0.3);
            let turn = DQuat::from_rotation_y(0.7) * DQuat::from_rotation_z(lean);
            assert_depth(&floor, &turned(above, turn), 0.02);
        }
    }

    #[test]
    fn cylinders_side_by_side_end_to_end_and_crossed_are_measured() {
        let here = at(cylinder(0.3, 0.5), 0.0, 0.0, 0.0);
        assert_depth(
            &here,
            &at(cylinder(0.2, 0.4), 0.3, 0.1, 0.36),
            0.5 - 0.3_f64.hypot(0.36),
        );
        assert_depth(&here, &at(cylinder(0.2, 0.4), 0.1, 0.87, 0.1), 0.03);
        let across = turned(
            at(cylinder(0.2, 0.4), 0.0, 0.1, 0.46),
            DQuat::from_rotation_z(FRAC_PI_2),
        );
        assert_depth(&here, &across, 0.04);
    }

    #[test]
    fn a_ball_and_a_capsule_reach_into_a_cylinder() {
        let here = at(cylinder(0.3, 0.5), 0.0, 0.0, 0.0);
        let radius = 0.2;
        let ball = at(Shape::Sphere { radius }, 0.45, 0.1, 0.0);
        assert_depth(&here, &ball, 0.05);
        // Above the rim: 0.15 m out and 0.08 m up from it.
        let ball = at(Shape::Sphere { radius }, 0.45, 0.58, 0.0);
        assert_depth(&here, &ball, 0.2 - 0.17);
        let half_height = 0.4;
        let rod = Shape::Capsule {
            radius,
            half_height,
        };
        assert_depth(&here, &at(rod, 0.1, 1.05, 0.0), 0.05);
    }

    #[test]
    fn boxes_reach_into_each_other_by_faces_edges_and_corners() {
        let cube = |y: f64| at(block(0.5, 0.5, 0.5), 0.0, y, 0.0);
        assert_depth(&cube(0.0), &cube(0.9), 0.1);
        // Half a diagonal of a face, and of the cube, is √½ and √¾.
        let on_edge = DQuat::from_rotation_z(FRAC_PI_4);
        assert_depth(
            &cube(0.0),
            &turned(cube(1.15), on_edge),
            SQRT_2 / 2.0 - 0.65,
        );
        let other_way = turned(cube(0.0), DQuat::from_rotation_x(FRAC_PI_4));
        assert_depth(&other_way, &turned(cube(1.4), on_edge), SQRT_2 - 1.4);
        let on_corner = DQuat::from_rotation_arc(DVec3::ONE.normalize(), DVec3::NEG_Y);
        assert_depth(
            &cube(0.0),
            &turned(cube(1.3), on_corner),
            0.75_f64.sqrt() - 0.8,
        );
    }

    #[test]
    fn solids_that_just_touch_have_depth_zero_whatever_direction_parry_gives() {
        let floor = at(block(2.0, 0.5, 2.0), 0.0, -0.5, 0.0);
        for shape in [cylinder(0.3, 0.2), block(0.3, 0.2, 0.3)] {
            for gap in [0.0, 1e-16, -1e-16, 1e-12, -1e-12] {
                for x in [0.0, 0.3, 1.9] {
                    let above = at(shape, x, 0.2 + gap, 0.3 * x);
                    for turn in [0.0, 0.3] {
                        let above = turned(above, DQuat::from_rotation_y(turn));
                        for pair in [[floor, above], [above, floor]] {
                            let found = convex_depth(&pair[0], &pair[1]).unwrap();
                            assert!((found + gap).abs() < 1e-15, "{gap} {x}: {found}");
                        }
                    }
                }
            }
        }
    }
}
