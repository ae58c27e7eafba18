//! A rigid body that turns freely, a body a lane. Names as in `ch00_maths::f32::free_rotation`, where the
//! method is told.

use crate::simd::{Quat, Real, Vec3, sine_cosine};

/// An axis of the body: its unit vector, and the moment about it.
#[derive(Clone, Copy)]
struct Axis<R> {
    along: Vec3<R>,
    moment: R,
}

/// The turn, in body axes, that a body with angular momentum π (body axes, kg m²/s) makes in `dt`.
#[inline(always)]
#[must_use]
pub fn turn<R: Real>(inertia: Vec3<R>, momentum: Vec3<R>, dt: f32) -> Quat<R> {
    let [first, second, third] = axes_by_moment(inertia);
    let stages = [
        (first, 0.5),
        (second, 0.5),
        (third, 1.0),
        (second, 0.5),
        (first, 0.5),
    ];
    let mut r = Quat::identity();
    let mut pi = momentum;
    for (axis, part) in stages {
        let half_angle = pi.dot(axis.along) / axis.moment * R::splat(0.5 * part * dt);
        let (sine, cosine) = sine_cosine(half_angle);
        let about_axis = Quat {
            v: axis.along * sine,
            w: cosine,
        };
        r = r.product(about_axis);
        pi = about_axis.rotate_back(pi);
    }
    r.normalize()
}

/// The attitude `dt` seconds after q, for a body whose angular momentum in the world is L.
#[inline(always)]
#[must_use]
pub fn attitude_after<R: Real>(
    q: Quat<R>,
    inertia: Vec3<R>,
    angular_momentum: Vec3<R>,
    dt: f32,
) -> Quat<R> {
    q.product(turn(inertia, q.rotate_back(angular_momentum), dt))
        .normalize()
}

/// The axes in ascending order of their moments; equal moments in the order x, y, z.
#[inline(always)]
fn axes_by_moment<R: Real>(inertia: Vec3<R>) -> [Axis<R>; 3] {
    let (one, zero) = (R::splat(1.0), R::splat(0.0));
    let axis = |along: Vec3<R>, moment: R| Axis { along, moment };
    let x = axis(Vec3::new(one, zero, zero), inertia.x);
    let y = axis(Vec3::new(zero, one, zero), inertia.y);
    let z = axis(Vec3::new(zero, zero, one), inertia.z);
    let (x, y) = in_order(x, y);
    let (y, z) = in_order(y, z);
    let (x, y) = in_order(x, y);
    [x, y, z]
}

/// Two axes, the one with the smaller moment first.
#[inline(always)]
fn in_order<R: Real>(a: Axis<R>, b: Axis<R>) -> (Axis<R>, Axis<R>) {
    let swaps = b.moment.lt(a.moment);
    let either = |yes: Axis<R>, no: Axis<R>| Axis {
        along: Vec3::select(swaps, yes.along, no.along),
        moment: R::select(swaps, yes.moment, no.moment),
    };
    (either(b, a), either(a, b))
}

#[cfg(test)]
mod tests {
    use ch00_maths::f32::free_rotation;

    use super::*;

    #[test]
    fn a_free_turn_is_that_of_chapter_two() {
        let q = glam::Quat::from_xyzw(0.5, -0.5, 0.1, 0.7).normalize();
        for inertia in [
            glam::Vec3::new(1.0, 2.0, 3.0),
            glam::Vec3::new(3.0, 2.0, 1.0),
            glam::Vec3::new(2.0, 2.0, 0.5),
        ] {
            let momentum = glam::Vec3::new(0.3, 5.0, -7.0);
            let there = free_rotation::attitude_after(q, inertia, momentum, 0.1);
            let here = attitude_after::<f32>(q.into(), inertia.into(), momentum.into(), 0.1);
            assert!(there.dot(here.lane(0)).abs() > 1.0 - 1e-6);
        }
    }
}
