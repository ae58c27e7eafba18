//! Pushing apart what is inside each other.

use super::{Given, Moved, Touching, parting, take_normals};
use crate::own_row::contact::INNER_SWEEPS;
use crate::own_row::side::Side;
use crate::rows::Step;
use crate::simd::{Inertia, Real, array_of};

// ANCHOR: push_out
/// Pushes bodies that are inside each other apart: a velocity that moves them in this substep and is
/// then forgotten, so that no speed is left of it.
#[inline(always)]
pub(super) fn out<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    reply: &[R; P],
    moved: &mut [Moved<R, I>; 2],
    step: &Step,
    given: &mut Given<R>,
) {
    let [mut a, mut b] = moved.map(|body| Side {
        velocity: body.push,
        angular_velocity: body.turning_push,
        ..body.side
    });
    let (share, sweeps) = if P > 1 {
        (step.push_share_of_many, INNER_SWEEPS)
    } else {
        (step.push_share, 1)
    };
    let zero = R::splat(0.0);
    let mut pushes = [zero; P];
    for _ in 0..sweeps {
        let changes = array_of(|k| {
            let depth = -t.distance[k] - R::splat(step.slop);
            let speed = (depth * R::splat(share / step.h)).min(R::splat(step.fastest_push));
            let lacks = speed - parting(t, k, &a, &b);
            let wanted = (pushes[k] + lacks / reply[k]).max(zero);
            R::select(depth.gt(zero), wanted, zero) - pushes[k]
        });
        for k in 0..P {
            pushes[k] += changes[k];
        }
        let [linear, turning_a, turning_b] = take_normals(t, &changes, &mut a, &mut b);
        given.push += linear;
        given.push_a += turning_a;
        given.push_b += turning_b;
    }
    for (body, pushed) in moved.iter_mut().zip([a, b]) {
        body.push = pushed.velocity;
        body.turning_push = pushed.angular_velocity;
    }
}
// ANCHOR_END: push_out
