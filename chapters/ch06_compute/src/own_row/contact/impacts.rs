//! Impacts: how fast they come, and restitution.

use super::{
    BOUNCE_SWEEPS, Before, Given, Impulses, Surface, Touching, parting, press, replies, rub,
    take_normals,
};
use crate::own_row::side::Side;
use crate::rows::Step;
use crate::simd::{Inertia, Mask, Real, Vec3, array_of};

// ANCHOR: note_impacts
// ANCHOR: impact_speed
/// Notes how fast the points come that will touch in this substep; says whether one touches or may
/// touch in the next.
///
/// The speed is that at the surface: u² = c² + 2 a s, where c is the speed of approach before the substep's
/// kick, a the acceleration of approach, and s the gap that is left.
#[inline(always)]
pub(super) fn note<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    surface: &Surface<R>,
    approach: &mut [R; P],
    [a, b]: [&Side<R, I>; 2],
    before: impl FnOnce() -> [Before<R>; 2],
    step: &Step,
) -> R::Mask {
    let zero = R::splat(0.0);
    let come: [_; P] = array_of(|k| t.comes(k, a, b, step.h));
    if (any(&come) & surface.restitution.gt(zero)).any() {
        let before = before();
        let closing = closing_pull(t.normal, a, b, step.gravity);
        for k in 0..P {
            let speed = (-parting_before(t, k, &before)).max(zero);
            let gap = t.distance[k].max(zero);
            let squared = speed * speed + closing * gap * R::splat(2.0);
            let fastest = approach[k].min(-squared.max(zero).sqrt());
            approach[k] = R::select(come[k], fastest, approach[k]);
        }
    }
    let soon: [_; P] = array_of(|k| t.meets(k, a, b, 2.0 * step.h));
    any(&soon)
}
// ANCHOR_END: impact_speed

#[inline(always)]
fn any<M: Mask, const P: usize>(masks: &[M; P]) -> M {
    masks.iter().fold(M::splat(false), |any, mask| any | *mask)
}

/// Speed of b away from a along the normal at point k before the kick, m/s.
#[inline(always)]
fn parting_before<R: Real, const P: usize>(
    t: &Touching<R, P>,
    k: usize,
    [a, b]: &[Before<R>; 2],
) -> R {
    let of_a = a.velocity + a.angular_velocity.cross(t.arm_a[k]);
    let of_b = b.velocity + b.angular_velocity.cross(t.arm_b[k]);
    t.normal.dot(of_b - of_a)
}

/// The acceleration with which gravity brings a and b together along the normal, m/s².
#[inline(always)]
fn closing_pull<R: Real, I: Inertia<R>>(
    normal: Vec3<R>,
    a: &Side<R, I>,
    b: &Side<R, I>,
    gravity: glam::Vec3,
) -> R {
    let zero = R::splat(0.0);
    let pull = Vec3::all(gravity).dot(normal);
    let falls = |side: &Side<R, I>| R::select(side.inverse_mass.gt(zero), pull, zero);
    falls(a) - falls(b)
}
// ANCHOR_END: note_impacts

/// Whether a pair bounces at the end of the step: it had an impact faster than the threshold.
#[inline(always)]
#[must_use]
pub fn bounces<R: Real, const P: usize>(
    approach: &[R; P],
    surface: &Surface<R>,
    step: &Step,
) -> R::Mask {
    let least = R::splat(-step.restitution_threshold);
    let hits: [_; P] = array_of(|k| approach[k].lt(least));
    surface.restitution.gt(R::splat(0.0)) & any(&hits)
}

// ANCHOR: restore_pair
/// What restitution adds at the end of a step: where an impact came with speed u, the bodies shall part
/// with e u; and the friction that goes with it. Shares are those among the pairs that bounce.
#[inline(always)]
#[must_use]
pub fn restore_pair<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    surface: &Surface<R>,
    approach: &[R; P],
    [mut a, mut b]: [Side<R, I>; 2],
    step: &Step,
) -> Given<R> {
    let zero = R::splat(0.0);
    let reply = replies(t, &a, &b);
    let mut added = Impulses::<R, P>::default();
    let least = R::splat(-step.restitution_threshold);
    for _ in 0..BOUNCE_SWEEPS {
        let changes = array_of(|k| {
            let lacks = -surface.restitution * approach[k] - parting(t, k, &a, &b);
            let wanted = (added.normal[k] + lacks / reply[k]).max(zero);
            R::select(approach[k].lt(least), wanted, zero) - added.normal[k]
        });
        added.add(&changes);
        take_normals(t, &changes, &mut a, &mut b);
        rub::mend(t, &mut added, surface, &mut a, &mut b);
    }
    press::<R, I, P>(t, &added).kept(bounces(approach, surface, step))
}
// ANCHOR_END: restore_pair
