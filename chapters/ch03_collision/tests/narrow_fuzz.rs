//! The narrow phase against an independent judge: parry3d in f64, on 100,000 random pairs for each
//! pair of shapes.
//!
//! Sizes range over two decades, any pose, from deep overlap to apart. "Size" is the bounding
//! radius of the smaller solid: to it all tolerances refer.
//!
//! Whose answer is right, if two differ, needs no judge. Along any unit vector n two solids are
//! apart by s(n) = −h(−n), with h the support function of their Minkowski difference, which takes a
//! line of f64 for each shape. Their distance, or minus their depth, is the largest s. So s(n) for
//! a normal n is a proof that they are at least so far apart, and the larger of s(ours) and
//! s(parry's) is the truth as far as anyone knows. Where parry's own distance is off by more than
//! 1e-3 of size it is counted, and its normal still is a candidate.

use ch00_maths::f32::shape::Shape;
use ch00_scenes::random::SplitMix64;
use ch03_collision::narrow::epa::epa;
use ch03_collision::narrow::gjk::{Gjk, gjk};
use ch03_collision::narrow::support_point::Core;
use ch03_collision::narrow::{Placed, Touch, touch};
use glam::{DQuat, DVec3, DVec4, Vec3};
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::{Ball, Capsule, Cuboid, Cylinder, Shape as ParryShape};

const PAIRS: usize = 100_000;

/// Largest error of a distance or a depth, as a share of size.
const TOLERANCE: f64 = 1e-3;

/// Largest angle between our normal and parry's, degrees.
const ANGLE: f64 = 1.0;

/// A normal that is further off is as good if along it the solids are as far apart but for this
/// share of size: a depth with two such normals is ambiguous.
const AMBIGUOUS: f64 = 1e-4;

#[derive(Clone, Copy)]
enum Kind {
    Ball,
    Box,
    Capsule,
    Cylinder,
}

/// A solid somewhere, with numbers that an f32 holds exactly.
#[derive(Clone, Copy, Debug)]
struct Solid {
    shape: Shape,
    p: DVec3,
    q: DQuat,
}

impl Solid {
    /// Any size from 5 cm to 5 m along each axis, any orientation.
    fn random(kind: Kind, random: &mut SplitMix64) -> Self {
        let mut length = || (0.05 * 100_f64.powf(random.unit())) as f32;
        let shape = match kind {
            Kind::Ball => Shape::Sphere { radius: length() },
            Kind::Box => Shape::Box {
                half_extents: Vec3::new(length(), length(), length()),
            },
            Kind::Capsule => Shape::Capsule {
                radius: length(),
                half_height: length(),
            },
            Kind::Cylinder => Shape::Cylinder {
                radius: length(),
                half_height: length(),
            },
        };
        Self {
            shape,
            p: DVec3::ZERO,
            q: rotation(random),
        }
    }

    fn placed(&self) -> Placed<'_> {
        Placed {
            shape: &self.shape,
            p: self.p.as_vec3(),
            q: self.q.as_quat(),
            p_before: self.p.as_vec3(),
        }
    }

    fn size(&self) -> f64 {
        f64::from(self.shape.bounding_radius())
    }

    /// The same for parry.
    fn for_parry(&self) -> (Pose, Box<dyn ParryShape>) {
        let q = self.q.normalize();
        let pose = Pose::from_parts(
            Vector::new(self.p.x, self.p.y, self.p.z),
            Rotation::from_xyzw(q.x, q.y, q.z, q.w),
        );
        let shape: Box<dyn ParryShape> = match self.shape {
            Shape::Sphere { radius } => Box::new(Ball::new(radius.into())),
            Shape::Box { half_extents: h } => {
                Box::new(Cuboid::new(Vector::new(h.x.into(), h.y.into(), h.z.into())))
            }
            Shape::Capsule {
                radius,
                half_height,
            } => Box::new(Capsule::new_y(half_height.into(), radius.into())),
            Shape::Cylinder {
                radius,
                half_height,
            } => Box::new(Cylinder::new(half_height.into(), radius.into())),
        };
        (pose, shape)
    }

    /// The support function: how far the solid reaches from the origin along a unit vector, m.
    fn reach(&self, n: DVec3) -> f64 {
        let d = self.q.normalize().conjugate() * n;
        let across = d.x.hypot(d.z);
        let own = match self.shape {
            Shape::Sphere { radius } => f64::from(radius),
            Shape::Box { half_extents } => d.abs().dot(half_extents.as_dvec3()),
            Shape::Capsule {
                radius,
                half_height,
            } => f64::from(radius) + d.y.abs() * f64::from(half_height),
            Shape::Cylinder {
                radius,
                half_height,
            } => across * f64::from(radius) + d.y.abs() * f64::from(half_height),
        };
        self.p.dot(n) + own
    }

    /// How far a point is outside, m.
    fn distance_to(&self, point: DVec3) -> f64 {
        let p = self.q.normalize().conjugate() * (point - self.p);
        let across = p.x.hypot(p.z);
        let outside = match self.shape {
            Shape::Sphere { radius } => p.length() - f64::from(radius),
            Shape::Box { half_extents } => {
                let h = half_extents.as_dvec3();
                (p.abs() - h).max(DVec3::ZERO).length()
            }
            Shape::Capsule {
                radius,
                half_height,
            } => across.hypot((p.y.abs() - f64::from(half_height)).max(0.0)) - f64::from(radius),
            Shape::Cylinder {
                radius,
                half_height,
            } => {
                let beyond_side = (across - f64::from(radius)).max(0.0);
                beyond_side.hypot((p.y.abs() - f64::from(half_height)).max(0.0))
            }
        };
        outside.max(0.0)
    }
}

/// s(n): how far apart two solids are along the unit vector n from b to a, m.
fn apart_along(a: &Solid, b: &Solid, n: DVec3) -> f64 {
    -a.reach(-n) - b.reach(n)
}

/// Any orientation, each as likely, rounded to f32.
fn rotation(random: &mut SplitMix64) -> DQuat {
    loop {
        let v = DVec4::from((random.vector(1.0), random.between(-1.0, 1.0)));
        if (0.1..1.0).contains(&v.length()) {
            return DQuat::from_vec4(v.normalize().as_vec4().as_dvec4());
        }
    }
}

/// Two solids: a quarter in any overlap, a quarter within 2 % of touching, a quarter up to apart by
/// a size, a quarter in overlaps and gaps of any magnitude.
fn pair(kinds: [Kind; 2], i: usize, random: &mut SplitMix64) -> (Solid, Solid) {
    let [mut a, mut b] = kinds.map(|kind| Solid::random(kind, random));
    if i % 8 >= 4 {
        std::mem::swap(&mut a, &mut b);
    }
    let direction = rotation(random) * DVec3::X;
    let touching = -apart_along(&a, &b, direction);
    let size = a.size().min(b.size());
    let gap = match i % 4 {
        0 => -touching * random.unit(),
        1 => size * random.between(-0.02, 0.02),
        2 => size * random.between(-0.5, 1.0),
        _ => size * 10_f64.powf(random.between(-6.0, 0.0)) * random.between(-1.0, 1.0),
    };
    b.p = random.vector(3.0).as_vec3().as_dvec3();
    a.p = (b.p + direction * (touching + gap)).as_vec3().as_dvec3();
    (a, b)
}

/// Distance (negative for a depth) and normal of GJK and EPA alone, on the solids as they are.
fn by_gjk_and_epa(a: &Placed, b: &Placed) -> (f32, Vec3, bool) {
    let (a, b) = Core::pair(a, b);
    let radii = a.radius + b.radius;
    match gjk(&a, &b, f32::INFINITY) {
        Gjk::Far => unreachable!("nothing is further than infinity"),
        Gjk::Apart(apart) => (apart.distance - radii, apart.normal, apart.converged),
        Gjk::Overlapping(simplex) => {
            let found = epa(&a, &b, &simplex);
            (-found.depth - radii, found.normal, found.converged)
        }
    }
}

/// What was wrong, at worst, as shares of size.
#[derive(Default, Debug)]
struct Tally {
    worst_distance: f64,
    sum_of_errors: f64,
    worst_angle: f64,
    ambiguous: usize,
    unconverged: usize,
}

impl Tally {
    /// Compares an answer with the best that is known.
    fn judge(
        &mut self,
        (a, b): (&Solid, &Solid),
        (distance, normal, converged): (f32, Vec3, bool),
        parrys_normal: DVec3,
    ) {
        let size = a.size().min(b.size());
        assert!((normal.length() - 1.0).abs() < 1e-5, "{normal} {a:?} {b:?}");
        let normal = normal.as_dvec3().normalize();
        let (ours, parrys) = (apart_along(a, b, normal), apart_along(a, b, parrys_normal));
        let error = (f64::from(distance) - ours.max(parrys)).abs() / size;
        assert!(
            error <= TOLERANCE,
            "{distance} for {ours} and {parrys}, size {size}, {a:?} {b:?}"
        );
        let angle = normal.angle_between(parrys_normal).to_degrees();
        if angle <= ANGLE {
            self.worst_angle = self.worst_angle.max(angle);
        } else if ours < parrys - AMBIGUOUS * size {
            panic!("{angle}° off, {ours} for {parrys}, size {size}, {a:?} {b:?}");
        } else {
            self.ambiguous += 1;
        }
        self.worst_distance = self.worst_distance.max(error);
        self.sum_of_errors += error;
        self.unconverged += usize::from(!converged);
    }
}

/// Every contact point of solids that barely overlap lies on both.
fn lies_on_both(a: &Solid, b: &Solid, touch: &Touch) {
    let size = a.size().min(b.size());
    if touch.depth().abs() > 0.01 * size as f32 {
        return;
    }
    for spot in touch.spots() {
        let slack = 2.0 * TOLERANCE * size + 0.5 * f64::from(spot.depth.abs());
        for solid in [a, b] {
            let off = solid.distance_to(spot.point.as_dvec3());
            assert!(
                off <= slack,
                "{off} off, size {size}, {touch:?} {a:?} {b:?}"
            );
        }
    }
}

/// The whole test of one pair of shapes.
fn judge_all(kind_a: Kind, kind_b: Kind) {
    let seed = 10 * kind_a as u64 + kind_b as u64;
    let mut random = SplitMix64::new(seed);
    let (mut whole, mut pure) = (Tally::default(), Tally::default());
    let mut parry_was_wrong = 0;
    for i in 0..PAIRS {
        let (a, b) = pair([kind_a, kind_b], i, &mut random);
        let size = a.size().min(b.size());
        let (pose_a, shape_a) = a.for_parry();
        let (pose_b, shape_b) = b.for_parry();
        let judge = query::contact(&pose_a, &*shape_a, &pose_b, &*shape_b, 1e6)
            .expect("parry knows the pair")
            .expect("within 1000 km");
        let n = judge.normal1;
        let parrys_normal = -DVec3::new(n.x, n.y, n.z).normalize();
        let proven = apart_along(&a, &b, parrys_normal);

        let (placed_a, placed_b) = (a.placed(), b.placed());
        let touch = touch(&placed_a, &placed_b, 1e6).expect("within 1000 km");
        let found = (-touch.depth(), touch.normal, touch.converged);
        let alone = by_gjk_and_epa(&placed_a, &placed_b);
        whole.judge((&a, &b), found, parrys_normal);
        pure.judge((&a, &b), alone, parrys_normal);
        lies_on_both(&a, &b, &touch);
        let best = proven.max(apart_along(&a, &b, alone.1.as_dvec3().normalize()));
        parry_was_wrong += usize::from((judge.dist - best).abs() > TOLERANCE * size);
    }
    println!("touch: {whole:?}\nGJK and EPA alone: {pure:?}\nparry was wrong: {parry_was_wrong}");
    // EPA may run out of room deep within a cylinder, where all ways out are about equally long.
    assert!(whole.unconverged <= PAIRS / 1000, "{}", whole.unconverged);
    assert!(pure.unconverged <= PAIRS / 200, "{}", pure.unconverged);
    assert!(whole.ambiguous <= PAIRS / 200, "{}", whole.ambiguous);
}

#[test]
fn ball_against_ball() {
    judge_all(Kind::Ball, Kind::Ball);
}

#[test]
fn ball_against_box() {
    judge_all(Kind::Ball, Kind::Box);
}

#[test]
fn ball_against_capsule() {
    judge_all(Kind::Ball, Kind::Capsule);
}

#[test]
fn ball_against_cylinder() {
    judge_all(Kind::Ball, Kind::Cylinder);
}

#[test]
fn box_against_box() {
    judge_all(Kind::Box, Kind::Box);
}

#[test]
fn box_against_capsule() {
    judge_all(Kind::Box, Kind::Capsule);
}

#[test]
fn box_against_cylinder() {
    judge_all(Kind::Box, Kind::Cylinder);
}

#[test]
fn capsule_against_capsule() {
    judge_all(Kind::Capsule, Kind::Capsule);
}

#[test]
fn capsule_against_cylinder() {
    judge_all(Kind::Capsule, Kind::Cylinder);
}

#[test]
fn cylinder_against_cylinder() {
    judge_all(Kind::Cylinder, Kind::Cylinder);
}
