//! Which body is under the pointer: the nearest shape that a line of sight meets. All of it
//! happens in a body's own coordinates, where shapes are centred and their axis is y.

use ch00_scenes::Shape;
use glam::{DVec2, DVec3};

use crate::Session;
use crate::camera::Ray;
use crate::render::Surroundings;

/// Where a line of sight meets a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the body.
    pub body: usize,
    /// From the viewer, m.
    pub distance: f32,
}

/// The nearest body on the line of sight. Walls and ground are looked through.
#[must_use]
pub fn pick(session: &Session, alpha: f64, around: &Surroundings, sight: Ray) -> Option<Hit> {
    let bodies = &session.scene().bodies;
    let (origin, direction) = (sight.origin.as_dvec3(), sight.direction.as_dvec3());
    let meet = |i: usize| {
        let (position, orientation) = session.pose(i, alpha);
        let to_body = orientation.inverse();
        distance(
            &bodies[i].shape,
            to_body * (origin - position),
            to_body * direction,
        )
    };
    let (body, distance) = (0..bodies.len())
        .filter(|&i| !around.is_scenery(i))
        .filter_map(|i| Some((i, meet(i)?)))
        .min_by(|a, b| a.1.total_cmp(&b.1))?;
    #[expect(clippy::cast_possible_truncation, reason = "pictures are f32")]
    let distance = distance as f32;
    Some(Hit { body, distance })
}

/// Distance along a ray in the body's coordinates at which it enters the shape; none if it
/// misses or begins inside. `d` is a unit vector.
#[must_use]
pub fn distance(shape: &Shape, o: DVec3, d: DVec3) -> Option<f64> {
    match *shape {
        Shape::Sphere { radius } => sphere(o, d, radius),
        Shape::Box { half_extents } => cuboid(o, d, half_extents),
        Shape::Capsule {
            radius,
            half_height,
        } => nearest([
            tube(o, d, radius, half_height),
            sphere(o - half_height * DVec3::Y, d, radius),
            sphere(o + half_height * DVec3::Y, d, radius),
        ]),
        Shape::Cylinder {
            radius,
            half_height,
        } => nearest([
            tube(o, d, radius, half_height),
            disc(o, d, radius, half_height),
            disc(o, d, radius, -half_height),
        ]),
    }
}

fn nearest(distances: [Option<f64>; 3]) -> Option<f64> {
    distances.into_iter().flatten().min_by(f64::total_cmp)
}

/// The smaller root of a t² + 2 b t + c = 0 if it is positive.
fn entry(a: f64, b: f64, c: f64) -> Option<f64> {
    let discriminant = b * b - a * c;
    if discriminant < 0.0 || a <= 0.0 {
        return None;
    }
    let t = (-b - discriminant.sqrt()) / a;
    (t > 0.0).then_some(t)
}

/// |o + t d| = radius.
fn sphere(o: DVec3, d: DVec3, radius: f64) -> Option<f64> {
    entry(1.0, o.dot(d), o.length_squared() - radius * radius)
}

/// The round side of a cylinder: |o + t d| = radius without y, where |y| ≤ half height.
fn tube(o: DVec3, d: DVec3, radius: f64, half_height: f64) -> Option<f64> {
    let (across_o, across_d) = (DVec2::new(o.x, o.z), DVec2::new(d.x, d.z));
    let t = entry(
        across_d.length_squared(),
        across_o.dot(across_d),
        across_o.length_squared() - radius * radius,
    )?;
    ((o.y + t * d.y).abs() <= half_height).then_some(t)
}

/// A disc at this height across y, met from outside.
fn disc(o: DVec3, d: DVec3, radius: f64, height: f64) -> Option<f64> {
    if d.y * height >= 0.0 {
        return None;
    }
    let t = (height - o.y) / d.y;
    let p = o + t * d;
    (t > 0.0 && p.x * p.x + p.z * p.z <= radius * radius).then_some(t)
}

/// The slabs between opposite faces: the ray is inside the box while it is inside all three.
fn cuboid(o: DVec3, d: DVec3, half_extents: DVec3) -> Option<f64> {
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        if d[axis] == 0.0 {
            if o[axis].abs() > half_extents[axis] {
                return None;
            }
            continue;
        }
        let t1 = (-half_extents[axis] - o[axis]) / d[axis];
        let t2 = (half_extents[axis] - o[axis]) / d[axis];
        enter = enter.max(t1.min(t2));
        leave = leave.min(t1.max(t2));
    }
    (enter > 0.0 && enter <= leave).then_some(enter)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solids() -> [Shape; 4] {
        let (radius, half_height) = (0.5, 2.0);
        [
            Shape::Sphere { radius },
            Shape::Box {
                half_extents: DVec3::new(0.5, 2.0, 0.25),
            },
            Shape::Capsule {
                radius,
                half_height,
            },
            Shape::Cylinder {
                radius,
                half_height,
            },
        ]
    }

    #[test]
    fn from_the_side_all_are_met_at_their_half_width() {
        for shape in solids() {
            let t = distance(&shape, DVec3::new(3.0, 0.0, 0.0), DVec3::NEG_X);
            assert!((t.unwrap_or(0.0) - 2.5).abs() < 1e-12, "{shape:?}");
        }
    }

    #[test]
    fn from_above_each_is_met_at_its_own_height() {
        for (shape, height) in solids().iter().zip([0.5, 2.0, 2.5, 2.0]) {
            let t = distance(shape, DVec3::new(0.0, 5.0, 0.0), DVec3::NEG_Y);
            assert!(
                (t.unwrap_or(0.0) - (5.0 - height)).abs() < 1e-12,
                "{shape:?}"
            );
        }
    }

    #[test]
    fn a_ray_that_passes_by_meets_none() {
        for shape in solids() {
            let past = distance(&shape, DVec3::new(3.0, 0.0, 0.51), DVec3::NEG_X);
            assert_eq!(past, None, "{shape:?}");
            let away = distance(&shape, DVec3::new(3.0, 0.0, 0.0), DVec3::X);
            assert_eq!(away, None, "{shape:?}");
        }
    }

    #[test]
    fn a_capsules_cap_is_round_and_a_cylinders_edge_is_not() {
        let (o, d) = (DVec3::new(0.45, 5.0, 0.0), DVec3::NEG_Y);
        let [_, _, capsule, cylinder] = solids();
        let cap = 2.0 + (0.5_f64 * 0.5 - 0.45 * 0.45).sqrt();
        let t = distance(&capsule, o, d).unwrap_or(0.0);
        assert!((t - (5.0 - cap)).abs() < 1e-12);
        let t = distance(&cylinder, o, d).unwrap_or(0.0);
        assert!((t - 3.0).abs() < 1e-12);
    }
}
