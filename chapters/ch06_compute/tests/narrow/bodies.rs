//! Bodies for the tests of the narrow phase: random ones, and what is true of them in f64.

use std::f64::consts::FRAC_PI_2;

use ch00_scenes::random::SplitMix64;
use ch06_compute::own_row::narrow::Posed;
use ch06_compute::rows::{Manifold, WITH_A, WITH_B};
use glam::{DQuat, DVec3, Quat, Vec3};
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::{Ball, Capsule, Cuboid, Cylinder, Shape};

pub const BALL: u32 = 0;
pub const BOX: u32 = 1;
pub const CAPSULE: u32 = 2;
pub const CYLINDER: u32 = 3;

/// A body at the origin.
pub fn body(kind: u32, size: Vec3) -> Posed {
    Posed {
        position: Vec3::ZERO,
        attitude: Quat::IDENTITY,
        kind,
        size,
    }
}

/// Any size from 5 cm to 5 m along each axis, any orientation.
pub fn random_body(kind: u32, random: &mut SplitMix64) -> Posed {
    let mut length = || (0.05 * 100_f64.powf(random.unit())) as f32;
    let size = match kind {
        BALL => Vec3::new(length(), 0.0, 0.0),
        BOX => Vec3::new(length(), length(), length()),
        _ => Vec3::new(length(), length(), 0.0),
    };
    let attitude = random.rotation().as_quat().normalize();
    Posed {
        attitude,
        ..body(kind, size)
    }
}

/// Two bodies, four in five in any attitude: a fifth in any overlap, a fifth within 2 % of touching, a fifth
/// up to apart by a size, a fifth in overlaps and gaps of any magnitude; and a fifth lying on each other.
pub fn random_pair(kinds: [u32; 2], i: usize, random: &mut SplitMix64) -> (Posed, Posed) {
    let [mut a, mut b] = kinds.map(|kind| random_body(kind, random));
    if i % 10 >= 5 {
        std::mem::swap(&mut a, &mut b);
    }
    if i % 5 == 4 {
        return lying_pair(a, b, random);
    }
    let direction = random.rotation() * DVec3::X;
    let touching = -apart_along(&a, &b, direction);
    let size = size(&a).min(size(&b));
    let gap = match i % 5 {
        0 => -touching * random.unit(),
        1 => size * random.between(-0.02, 0.02),
        2 => size * random.between(-0.5, 1.0),
        _ => size * 10_f64.powf(random.between(-6.0, 0.0)) * random.between(-1.0, 1.0),
    };
    a.position = random.vector(3.0).as_vec3();
    b.position = (a.position.as_dvec3() + direction * (touching + gap)).as_vec3();
    (a, b)
}

/// The second body on the first one, both standing or lying, nearly upright, and a little aside.
fn lying_pair(mut a: Posed, mut b: Posed, random: &mut SplitMix64) -> (Posed, Posed) {
    for body in [&mut a, &mut b] {
        let quarter = DQuat::from_rotation_z(FRAC_PI_2 * f64::from(random.unit() < 0.5));
        let turn = DQuat::from_rotation_y(random.between(0.0, 6.0));
        let most = 1e-2 * random.unit();
        let tilt = DQuat::from_scaled_axis(random.vector(most));
        body.attitude = (tilt * turn * quarter).as_quat().normalize();
    }
    let size = size(&a).min(size(&b));
    let gap = size * random.between(-0.01, 0.01);
    let aside = random.vector(size) * DVec3::new(1.0, 0.0, 1.0);
    b.position = (aside + (gap - apart_along(&a, &b, DVec3::Y)) * DVec3::Y).as_vec3();
    (a, b)
}

/// Its bounding radius, m.
pub fn size(body: &Posed) -> f64 {
    let size = body.size.as_dvec3();
    match body.kind {
        CAPSULE => size.x + size.y,
        _ => size.length(),
    }
}

fn attitude(body: &Posed) -> DQuat {
    body.attitude.as_dquat().normalize()
}

/// How far a body reaches from its centre along a unit vector, m.
fn reach(body: &Posed, n: DVec3) -> f64 {
    let d = (attitude(body).conjugate() * n).abs();
    let size = body.size.as_dvec3();
    match body.kind {
        BALL => size.x,
        BOX => d.dot(size),
        CAPSULE => size.x + d.y * size.y,
        _ => d.x.hypot(d.z) * size.x + d.y * size.y,
    }
}

/// s(n): how far apart two bodies are along the unit vector n from a to b, m.
pub fn apart_along(a: &Posed, b: &Posed, n: DVec3) -> f64 {
    let between = b.position.as_dvec3() - a.position.as_dvec3();
    between.dot(n) - reach(a, n) - reach(b, -n)
}

/// The normal of a pair, from a to b in the world.
pub fn normal_of(m: &Manifold, a: &Posed, b: &Posed) -> DVec3 {
    let normal = m.normal.as_dvec3();
    match m.turns {
        WITH_A => attitude(a) * normal,
        WITH_B => attitude(b) * normal,
        _ => normal,
    }
}

/// The core points of a pair in the world, a's and b's.
pub fn cores(m: &Manifold, a: &Posed, b: &Posed) -> Vec<(DVec3, DVec3)> {
    let place =
        |body: &Posed, own: Vec3| body.position.as_dvec3() + attitude(body) * own.as_dvec3();
    (0..m.points as usize)
        .map(|k| {
            let core_a = place(a, m.core_a[k].truncate());
            let core_b = place(b, m.core_b[k].truncate());
            (core_a, core_b)
        })
        .collect()
}

/// The distances at the points of a pair, m, as a solver computes them.
pub fn at_points(m: &Manifold, a: &Posed, b: &Posed) -> Vec<f64> {
    let normal = normal_of(m, a, b);
    let rounds = f64::from(m.round_a) + f64::from(m.round_b);
    let between = |(on_a, on_b): (DVec3, DVec3)| (on_b - on_a).dot(normal) - rounds;
    cores(m, a, b).into_iter().map(between).collect()
}

/// The same body for parry.
fn for_parry(body: &Posed) -> (Pose, Box<dyn Shape>) {
    let q = attitude(body);
    let p = body.position.as_dvec3();
    let pose = Pose::from_parts(
        Vector::new(p.x, p.y, p.z),
        Rotation::from_xyzw(q.x, q.y, q.z, q.w),
    );
    let size = body.size.as_dvec3();
    let shape: Box<dyn Shape> = match body.kind {
        BALL => Box::new(Ball::new(size.x)),
        BOX => Box::new(Cuboid::new(Vector::new(size.x, size.y, size.z))),
        CAPSULE => Box::new(Capsule::new_y(size.y, size.x)),
        _ => Box::new(Cylinder::new(size.y, size.x)),
    };
    (pose, shape)
}

/// The unit vector from a to b along which parry would part them.
pub fn parrys_normal(a: &Posed, b: &Posed) -> DVec3 {
    let (pose_a, shape_a) = for_parry(a);
    let (pose_b, shape_b) = for_parry(b);
    let found = query::contact(&pose_a, &*shape_a, &pose_b, &*shape_b, 1e6);
    let n = found
        .expect("parry knows the pair")
        .expect("within 1000 km")
        .normal1;
    DVec3::new(n.x, n.y, n.z).normalize()
}

/// Half of a body's thickness, m.
pub fn thin(body: &Posed) -> f64 {
    f64::from(match body.kind {
        BALL | CAPSULE => body.size.x,
        BOX => body.size.min_element(),
        _ => body.size.x.min(body.size.y),
    })
}

/// How far a point is outside of a body, m; inside negative, by the nearest side.
fn outside(body: &Posed, point: DVec3) -> f64 {
    let p = attitude(body).conjugate() * (point - body.position.as_dvec3());
    let size = body.size.as_dvec3();
    let beyond = match body.kind {
        BALL => return p.length() - size.x,
        CAPSULE => {
            let along = p.y.clamp(-size.y, size.y);
            return (p - along * DVec3::Y).length() - size.x;
        }
        BOX => p.abs() - size,
        _ => DVec3::new(
            p.x.hypot(p.z) - size.x,
            p.y.abs() - size.y,
            f64::NEG_INFINITY,
        ),
    };
    beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
}

/// How far the nearest point of a pair is from lying on the surfaces of both, m.
pub fn off_surfaces(m: &Manifold, a: &Posed, b: &Posed) -> f64 {
    let normal = normal_of(m, a, b);
    let distance = at_points(m, a, b);
    let near = (0..distance.len()).min_by(|&i, &j| distance[i].total_cmp(&distance[j]));
    let (core_a, core_b) = cores(m, a, b)[near.expect("there is a point")];
    let on_a = core_a + f64::from(m.round_a) * normal;
    let on_b = core_b - f64::from(m.round_b) * normal;
    outside(a, on_a).abs().max(outside(b, on_b).abs())
}
