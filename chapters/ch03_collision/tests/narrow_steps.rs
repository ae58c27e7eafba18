//! GJK and EPA step by step: what must hold in every iteration, and answers that are known.

use ch00_maths::f32::shape::Shape;
use ch00_scenes::random::SplitMix64;
use ch03_collision::narrow::Placed;
use ch03_collision::narrow::epa;
use ch03_collision::narrow::gjk::{self, Apart, Gjk};
use ch03_collision::narrow::support_point::{Core, Hull};
use glam::{Quat, Vec3};

fn cores(a: (&Shape, Vec3, Quat), b: (&Shape, Vec3, Quat)) -> (Core, Core) {
    let placed = |(shape, p, q)| Placed {
        shape,
        p,
        q,
        p_before: p,
    };
    Core::pair(&placed(a), &placed(b))
}

/// Two cubes of 2 m, the first at p.
fn cubes(p: Vec3) -> (Core, Core) {
    let cube = Shape::Box {
        half_extents: Vec3::ONE,
    };
    cores(
        (&cube, p, Quat::IDENTITY),
        (&cube, Vec3::ZERO, Quat::IDENTITY),
    )
}

fn apart(a: &Core, b: &Core) -> Apart {
    match gjk::gjk(a, b, f32::INFINITY) {
        Gjk::Apart(apart) => apart,
        other => panic!("{other:?}"),
    }
}

fn near(value: f32, wanted: f32) {
    assert!(
        (value - wanted).abs() < 1e-6 * wanted.abs().max(1.0),
        "{value} is not {wanted}"
    );
}

#[test]
fn cubes_apart_face_to_face_edge_to_edge_and_corner_to_corner() {
    for direction in [Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::ONE] {
        let (a, b) = cubes(direction * 2.5);
        let found = apart(&a, &b);
        near(found.distance, 0.5 * direction.length());
        assert!(
            (found.normal - direction.normalize()).length() < 1e-6,
            "{found:?}"
        );
        assert!(
            (found.on_a - found.on_b - 0.5 * direction).length() < 1e-6,
            "{found:?}"
        );
    }
}

#[test]
fn what_is_further_than_the_limit_is_far_at_once() {
    let (a, b) = cubes(Vec3::X * 3.0);
    let mut looks = 0;
    assert_eq!(gjk::watched(&a, &b, 0.5, |_| looks += 1), Gjk::Far);
    assert!(looks <= 2, "{looks}");
    assert!(matches!(gjk::gjk(&a, &b, 1.5), Gjk::Apart(_)));
}

#[test]
fn a_cube_that_is_a_quarter_deep_leaves_by_the_nearest_face() {
    let (a, b) = cubes(Vec3::new(0.3, 1.75, -0.2));
    let Gjk::Overlapping(simplex) = gjk::gjk(&a, &b, f32::INFINITY) else {
        panic!("they overlap");
    };
    let found = epa::epa(&a, &b, &simplex);
    near(found.depth, 0.25);
    assert!((found.normal - Vec3::Y).length() < 1e-6, "{found:?}");
    assert!(
        (found.on_b - found.on_a - 0.25 * Vec3::Y).length() < 1e-6,
        "{found:?}"
    );
    assert!(found.converged);
}

#[test]
fn cubes_in_one_place_are_an_edge_deep() {
    let (a, b) = cubes(Vec3::ZERO);
    let Gjk::Overlapping(simplex) = gjk::gjk(&a, &b, f32::INFINITY) else {
        panic!("they overlap");
    };
    near(epa::epa(&a, &b, &simplex).depth, 2.0);
}

/// Pairs of boxes, capsules and cylinders of about half a metre, in any pose.
fn pairs() -> impl Iterator<Item = (Core, Core)> {
    let mut random = SplitMix64::new(4);
    (0..3000).map(move |i| {
        let mut solid = |kind| {
            let mut length = || random.between(0.1, 0.5) as f32;
            let shape = match kind % 3 {
                0 => Shape::Box {
                    half_extents: Vec3::new(length(), length(), length()),
                },
                1 => Shape::Capsule {
                    radius: length(),
                    half_height: length(),
                },
                _ => Shape::Cylinder {
                    radius: length(),
                    half_height: length(),
                },
            };
            let axis = random.vector(1.0).as_vec3().normalize_or(Vec3::Y);
            let turn = Quat::from_axis_angle(axis, random.between(0.0, 6.0) as f32);
            (shape, random.vector(0.7).as_vec3(), turn)
        };
        let (a, b) = (solid(i), solid(i / 3));
        cores((&a.0, a.1, a.2), (&b.0, b.1, b.2))
    })
}

#[test]
fn the_bounds_of_a_distance_close_in() {
    let mut iterations = 0;
    for (a, b) in pairs() {
        let (mut upper, mut lower) = (f32::INFINITY, f32::NEG_INFINITY);
        let found = gjk::watched(&a, &b, f32::INFINITY, |step| {
            let distance = step.simplex.nearest().length();
            assert!(distance <= upper + 1e-5, "{distance} after {upper}");
            assert!(step.at_least <= distance + 1e-5, "{step:?}");
            upper = distance;
            lower = lower.max(step.at_least);
            iterations += 1;
        });
        match found {
            Gjk::Apart(apart) => {
                assert!(apart.converged);
                assert!(upper - lower < 1e-4, "{lower} to {upper}");
                assert!(((apart.on_a - apart.on_b).length() - apart.distance).abs() < 1e-5);
            }
            Gjk::Overlapping(_) => assert!(lower < 1e-5, "{lower}"),
            Gjk::Far => panic!("nothing is further than infinity"),
        }
    }
    // On average; cylinders take more than boxes.
    assert!(iterations < 6 * 3000, "{iterations}");
}

#[test]
fn the_polytope_is_closed_and_grows_to_the_depth() {
    for (a, b) in pairs() {
        let Gjk::Overlapping(simplex) = gjk::gjk(&a, &b, f32::INFINITY) else {
            continue;
        };
        let round = [a, b].map(|core| matches!(core.hull, Hull::Cylinder { .. }));
        let mut last = -1e-5;
        let found = epa::watched(&a, &b, &simplex, |step| {
            let mut edges: Vec<[u8; 2]> = step.faces.iter().flat_map(epa::Face::edges).collect();
            edges.sort_unstable();
            let mut back = edges.iter().map(|[i, j]| [*j, *i]);
            assert!(back.all(|edge| edges.binary_search(&edge).is_ok()));
            edges.dedup();
            assert_eq!(
                edges.len(),
                3 * step.faces.len(),
                "each edge once in each direction"
            );

            let nearest = &step.faces[step.nearest];
            assert!(nearest.distance <= step.support.point.dot(nearest.normal) + 1e-5);
            // On a round side triangles become so slender that rounding may fold one over: in
            // one pair of five hundred.
            if round == [false, false] {
                assert!(
                    nearest.distance >= last,
                    "{} after {last}",
                    nearest.distance
                );
                last = nearest.distance - 1e-5;
            }
        });
        assert!(found.depth >= last && (found.normal.length() - 1.0).abs() < 1e-5);
        if found.converged {
            let between = (found.on_b - found.on_a).length();
            assert!((between - found.depth).abs() < 1e-3, "{found:?}");
        }
    }
}
