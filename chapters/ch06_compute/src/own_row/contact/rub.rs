//! Friction.

use super::{Impulses, SMALL, Surface, Touching};
use crate::own_row::side::Side;
use crate::simd::{Inertia, Real, Vec3};

// ANCHOR: mend_friction
/// Mends friction at the mean of the points: against sliding, and against turning about the normal.
/// Static friction holds as long as μ_s allows; beyond it the pair slips and kinetic friction is left.
#[inline(always)]
pub(super) fn mend<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    impulse: &mut Impulses<R, P>,
    surface: &Surface<R>,
    a: &mut Side<R, I>,
    b: &mut Side<R, I>,
) {
    if !I::RUBS {
        return;
    }
    let pressed = impulse.pressed();
    if P > 1 {
        mend_twist(t, impulse, surface, pressed, a, b);
    }
    let sliding = b.velocity_at(t.mean_b) - a.velocity_at(t.mean_a);
    let sliding = sliding - t.normal * sliding.dot(t.normal);
    let reply = sliding_reply(t, a, b).max(R::splat(SMALL));
    let last = impulse.friction;
    let held = last - t.normal * last.dot(t.normal) - sliding * reply.recip();
    impulse.friction = coulomb(held, pressed, surface);
    let change = impulse.friction - last;
    a.take(-change, -t.mean_a.cross(change));
    b.take(change, t.mean_b.cross(change));
}

// ANCHOR: coulomb
/// What friction gives of what it would take to hold.
#[inline(always)]
fn coulomb<R: Real>(held: Vec3<R>, pressed: R, surface: &Surface<R>) -> Vec3<R> {
    let size = held.length();
    let holds = size.le(surface.static_friction * pressed);
    let slips = surface.friction * pressed / size.max(R::splat(SMALL));
    held * R::select(holds, R::splat(1.0), slips)
}
// ANCHOR_END: coulomb

/// Friction against turning about the normal, with the points' spread as its arm.
#[inline(always)]
fn mend_twist<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    impulse: &mut Impulses<R, P>,
    surface: &Surface<R>,
    pressed: R,
    a: &mut Side<R, I>,
    b: &mut Side<R, I>,
) {
    let reply = t
        .normal
        .dot(a.shared_inertia.answer(t.normal) + b.shared_inertia.answer(t.normal));
    let rate = t.normal.dot(b.angular_velocity - a.angular_velocity);
    let most = surface.friction * pressed * t.spread;
    let last = impulse.twist;
    let wanted = last - rate / reply.max(R::splat(SMALL));
    impulse.twist = wanted.clamp(-most, most);
    let change = t.normal * (impulse.twist - last);
    a.take(Vec3::zero(), -change);
    b.take(Vec3::zero(), change);
}

/// The larger of what a unit impulse makes of the sliding speed in two directions across the normal,
/// 1/kg.
#[inline(always)]
fn sliding_reply<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    a: &Side<R, I>,
    b: &Side<R, I>,
) -> R {
    let masses = a.shared_mass + b.shared_mass;
    if I::CENTRAL {
        // The arms lie along the normal, so all directions across it are alike.
        let reply = |side: &Side<R, I>, arm: Vec3<R>| arm.dot(side.shared_inertia.answer(arm));
        return masses + reply(a, t.mean_a) + reply(b, t.mean_b);
    }
    let along = |direction: Vec3<R>| {
        let on_a = t.mean_a.cross(direction);
        let on_b = t.mean_b.cross(direction);
        on_a.dot(a.shared_inertia.answer(on_a)) + on_b.dot(b.shared_inertia.answer(on_b))
    };
    let [one, two] = across(t.normal);
    masses + along(one).max(along(two))
}

/// Two unit vectors across a unit vector and across each other. [Duff and others 2017]
#[inline(always)]
#[must_use]
pub fn across<R: Real>(n: Vec3<R>) -> [Vec3<R>; 2] {
    let one = R::splat(1.0);
    let sign = R::select(n.z.lt(R::splat(0.0)), -one, one);
    let p = -(sign + n.z).recip();
    let q = n.x * n.y * p;
    [
        Vec3::new(one + sign * n.x * n.x * p, sign * q, -sign * n.x),
        Vec3::new(q, sign + n.y * n.y * p, -n.y),
    ]
}
// ANCHOR_END: mend_friction
