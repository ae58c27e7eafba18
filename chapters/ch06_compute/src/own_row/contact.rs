//! What a pair of bodies does in a substep: the contact of the own-row method. Chapter 6 derives it.
//!
//! A pair reads both bodies and writes its own impulses. All pairs do so at once, from the same
//! velocities (Jacobi's way). Were each to stop its bodies alone, a body between n others would be
//! stopped n times over; so each pair is given an n-th of the body's mass to work with: n/m and n I⁻¹
//! instead of 1/m and I⁻¹. The body then gathers the impulses with its whole mass. [Tonge, Benevolenski
//! and Voroshilov 2012: mass splitting]
//!
//! The formulas are written for as many pairs as a [`Real`] has lanes. The pairs of a batch have equally
//! many points, and their normals turn in the same way.

mod given;
mod impacts;
mod impulses;
mod moved;
mod push;
mod rub;
mod smooth;
mod touching;

pub use given::Given;
pub use impacts::{bounces, restore_pair};
pub use impulses::{Impulses, Surface};
pub use moved::{Moved, Visit};
pub use rub::across;
pub use smooth::Smooth;
pub use touching::{Contact, Touching, touching, touching_balls};

use super::side::Side;
use crate::rows::Step;
use crate::simd::{Inertia, Mask, Real, Vec3, array_of};

/// Below this an effective inverse mass or a length is none.
const SMALL: f32 = 1e-12;

/// Sweeps over the points and the friction of a pair of more than one point.
pub const INNER_SWEEPS: u32 = 2;

/// Sweeps over the points of a pair that bounces.
pub const BOUNCE_SWEEPS: u32 = 16;

// ANCHOR: before
/// How a body moved before a substep's kick: what counts as the speed of an impact. Just after the kick
/// what holds it may be out of balance, and a light body between heavy ones seems fast.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Before<R> {
    /// m/s.
    pub velocity: Vec3<R>,
    /// rad/s.
    pub angular_velocity: Vec3<R>,
}
// ANCHOR_END: before

/// Speed of b away from a along the normal at point k, m/s.
#[inline(always)]
fn parting<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    k: usize,
    a: &Side<R, I>,
    b: &Side<R, I>,
) -> R {
    if I::CENTRAL {
        return t.normal.dot(b.velocity - a.velocity);
    }
    t.normal
        .dot(b.velocity_at(t.arm_b[k]) - a.velocity_at(t.arm_a[k]))
}

// ANCHOR: press
/// The impulses of a pair as its bodies receive them.
#[inline(always)]
fn press<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    impulse: &Impulses<R, P>,
) -> Given<R> {
    let mut given = Given {
        stays: R::splat(1.0),
        ..Given::default()
    };
    for k in 0..P {
        let p = t.normal * impulse.normal[k];
        given.linear += p;
        if !I::CENTRAL {
            given.angular_a -= t.arm_a[k].cross(p);
            given.angular_b += t.arm_b[k].cross(p);
        }
    }
    if !I::RUBS {
        return given;
    }
    given.linear += impulse.friction;
    given.angular_a -= t.mean_a.cross(impulse.friction);
    given.angular_b += t.mean_b.cross(impulse.friction);
    if P > 1 {
        let twist = t.normal * impulse.twist;
        given.angular_a -= twist;
        given.angular_b += twist;
    }
    given
}
// ANCHOR_END: press

// ANCHOR: press_again
/// What a pair starts a step with: the impulses that it ended the last one with, where its points are
/// now; and whether it counts.
#[inline(always)]
#[must_use]
pub fn press_again<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    impulse: &Impulses<R, P>,
    [a, b]: [Side<R, I>; 2],
    h: f32,
) -> Given<R> {
    let mut counts = impulse.presses();
    for k in 0..P {
        counts = counts | t.meets(k, &a, &b, h);
    }
    Given {
        counts: R::ones(counts),
        ..press::<R, I, P>(t, impulse)
    }
}
// ANCHOR_END: press_again

/// A substep of a pair: it mends its impulses so that the bodies, with the share of their masses that
/// it has, no longer approach where they touch, and don't slide where friction holds them.
///
/// `approach` keeps the fastest impact of the step at each point, m/s, negative, for [`restore_pair`].
/// `before` is how the bodies moved before the kick.
#[inline(always)]
#[must_use]
pub fn solve_pair<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    surface: &Surface<R>,
    impulse: &mut Impulses<R, P>,
    approach: &mut [R; P],
    sides: [Side<R, I>; 2],
    before: impl FnOnce() -> [Before<R>; 2],
    step: &Step,
) -> Given<R> {
    let mut only = Visit {
        moved: sides.map(Moved::of),
        was_impact: R::Mask::splat(false),
        ends: true,
    };
    solve_moved(t, surface, impulse, approach, &mut only, before, step)
}

/// The same for bodies that others may have moved and pushed already, and what it makes of them.
#[inline(always)]
#[must_use]
pub fn solve_moved<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    surface: &Surface<R>,
    impulse: &mut Impulses<R, P>,
    approach: &mut [R; P],
    visit: &mut Visit<R, I>,
    before: impl FnOnce() -> [Before<R>; 2],
    step: &Step,
) -> Given<R> {
    // ANCHOR: solve_pair
    let moved = &mut visit.moved;
    let were = *moved;
    let sides = were.map(|body| body.side);
    let [mut a, mut b] = sides;
    let soon = impacts::note(t, surface, approach, [&a, &b], before, step);
    let active = is_active(t, impulse, &a, &b, step.h);
    let last = impulse.kept(active);
    let mut now = last;
    let mut given = Given::default();
    if active.any() {
        let reply = replies(t, &a, &b);
        let sweeps = if P > 1 { INNER_SWEEPS } else { 1 };
        for _ in 0..sweeps {
            mend_normals(t, &mut now, &reply, &mut a, &mut b, step.h);
            rub::mend(t, &mut now, surface, &mut a, &mut b);
        }
        given = press::<R, I, P>(t, &now);
        moved[0].side = a;
        moved[1].side = b;
        push::out(t, &reply, moved, step, &mut given);
        for (body, was) in moved.iter_mut().zip(&were) {
            *body = body.or(active, was);
        }
        given = given.kept(active);
        now = now.kept(active);
    }
    let counts = soon | now.presses();
    let is_new = visit.was_impact | !last.presses();
    let impact = is_new & is_impact(&given, &sides, step);
    *impulse = if visit.ends { now.kept(!impact) } else { now };
    given.counts = R::ones(counts);
    given.stays = R::ones(!impact);
    given
    // ANCHOR_END: solve_pair
}

// ANCHOR: is_impact
/// Whether what a pair newly pressed is an impact rather than the beginning of rest.
///
/// A substep begins with the impulses of the last one, and each pair takes back what was too much; but
/// with its share of the mass it takes back only a share. For a weight that is right. For an impact it
/// would leave speed that nobody paid for.
#[inline(always)]
fn is_impact<R: Real, I: Inertia<R>>(
    given: &Given<R>,
    [a, b]: &[Side<R, I>; 2],
    step: &Step,
) -> R::Mask {
    let changes = given.linear.length() * (a.inverse_mass + b.inverse_mass);
    changes.gt(R::splat(step.impact_speed))
}
// ANCHOR_END: is_impact

/// Whether any point presses, touches or comes. Points that don't press no more.
#[inline(always)]
fn is_active<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    impulse: &Impulses<R, P>,
    a: &Side<R, I>,
    b: &Side<R, I>,
    h: f32,
) -> R::Mask {
    (0..P).fold(impulse.presses(), |any, k| any | t.meets(k, a, b, h))
}

// ANCHOR: replies
/// Dₖ = Σⱼ |Aₖⱼ|, 1/kg, where Aₖⱼ is what a unit impulse at point j makes of the speed at point k.
///
/// All points of a pair move at once, so each must reckon with what the others will do: divided by the
/// row's sum of sizes rather than by its diagonal, no set of points overshoots, and the same four
/// corners of a box get the same impulses whatever their order.
#[inline(always)]
fn replies<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    a: &Side<R, I>,
    b: &Side<R, I>,
) -> [R; P] {
    let masses = a.shared_mass + b.shared_mass;
    if I::CENTRAL {
        return [masses.max(R::splat(SMALL)); P];
    }
    let crossed: [_; P] = array_of(|k| [t.arm_a[k].cross(t.normal), t.arm_b[k].cross(t.normal)]);
    array_of(|k| {
        let turned_a = a.shared_inertia.answer(crossed[k][0]);
        let turned_b = b.shared_inertia.answer(crossed[k][1]);
        let reply =
            |[on_a, on_b]: &[Vec3<R>; 2]| (masses + on_a.dot(turned_a) + on_b.dot(turned_b)).abs();
        let sum = crossed.iter().fold(R::splat(0.0), |sum, j| sum + reply(j));
        sum.max(R::splat(SMALL))
    })
}
// ANCHOR_END: replies

// ANCHOR: mend_normals
/// Mends the normal impulses of all points at once. A point that is still apart may come as near as it
/// touches; impulses may be taken back but never pull.
#[inline(always)]
fn mend_normals<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    impulse: &mut Impulses<R, P>,
    reply: &[R; P],
    a: &mut Side<R, I>,
    b: &mut Side<R, I>,
    h: f32,
) {
    let zero = R::splat(0.0);
    let changes = array_of(|k| {
        let room = t.distance[k].max(zero) * R::splat(1.0 / h);
        let wanted = impulse.normal[k] - (parting(t, k, a, b) + room) / reply[k];
        wanted.max(zero) - impulse.normal[k]
    });
    impulse.add(&changes);
    take_normals(t, &changes, a, b);
}
// ANCHOR_END: mend_normals

/// What impulses along the normal make of both bodies.
#[inline(always)]
fn take_normals<R: Real, I: Inertia<R>, const P: usize>(
    t: &Touching<R, P>,
    changes: &[R; P],
    a: &mut Side<R, I>,
    b: &mut Side<R, I>,
) -> [Vec3<R>; 3] {
    let mut linear = Vec3::zero();
    let mut turning_a = Vec3::zero();
    let mut turning_b = Vec3::zero();
    for (k, change) in changes.iter().enumerate() {
        let p = t.normal * *change;
        linear += p;
        if !I::CENTRAL {
            turning_a -= t.arm_a[k].cross(p);
            turning_b += t.arm_b[k].cross(p);
        }
    }
    if I::CENTRAL {
        a.velocity -= linear * a.shared_mass;
        b.velocity += linear * b.shared_mass;
        return [linear, turning_a, turning_b];
    }
    a.take(-linear, turning_a);
    b.take(linear, turning_b);
    [linear, turning_a, turning_b]
}
