//! Angle limits as rows: how far a body may turn away from its rest in another, by chapter 4's swing and
//! twist.
//!
//! A limit reads both bodies and writes its own angular impulses, from the same velocities as the contacts
//! do and with the same shares of the masses. Each of its up to three turns has a unit axis u, a rate
//! u·(ω_b − ω_a) and a room C that is left until the bound. [`super::contact`] says why shares.
//!
//! Limits of one kind are solved together, a limit a lane ([`batch`]).

pub mod batch;
mod build;
#[cfg(test)]
mod tests;

use std::f32::consts::PI;

pub use batch::Limits;
pub use build::limit_of;

use super::loops::point_reply;
use super::side::Side;
use super::swing_twist::{SMALL_SINE, cone, swing_axes, swing_of, twist_axis, twist_of};
use crate::rows::{EULER, FREE_ANGLE, Limit};
use crate::simd::{Mask, Quat, Real, Symmetric, Vec3};

/// A limit this near, rad, counts among those that share the masses.
pub const NEAR: f32 = 0.02;

/// A limit further away, rad, is left alone.
pub const FAR: f32 = 0.35;

/// The share of what is beyond a bound that a substep turns back.
pub const TURN_SHARE: f32 = 0.2;

/// The fastest push back, rad/s.
pub const FASTEST_TURN: f32 = 4.0;

/// What is beyond a bound by less than this, rad, is left to the push. Beyond it the impulse turns back
/// too, since what lies on a limb may be heavier than a push can lift.
pub const TURN_SLOP: f32 = 0.01;

/// The share of it that the impulse turns back in a substep.
pub const RETURN_SHARE: f32 = 0.05;

/// The fastest that it does, rad/s: slow enough that no one sees it.
pub const GENTLE_TURN: f32 = 0.25;

// ANCHOR: bounds
/// How far bodies may turn away from their rest in others: a [`Limit`] a lane, all of one kind.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bounds<R> {
    /// Cone and twist, or pitch, yaw and roll.
    pub kind: u32,
    /// The joint's frame in a.
    pub frame_a: Quat<R>,
    /// The joint's frame in b.
    pub frame_b: Quat<R>,
    /// Lower bounds of the three turns, rad.
    pub low: Vec3<R>,
    /// Upper bounds, rad.
    pub high: Vec3<R>,
    /// The joint's point, in a's axes, m.
    pub anchor_a: Vec3<R>,
    /// The joint's point, in b's axes, m.
    pub anchor_b: Vec3<R>,
    /// What held each of the three in the last substep, N m s: positive from below.
    pub impulses: Vec3<R>,
}

/// What limits do to their two bodies in a substep: a [`crate::rows::Turned`] a lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Turning<R> {
    /// Turning impulse that b receives, N m s; a the opposite.
    pub turning: Vec3<R>,
    /// Turning push that b receives, N m s; a the opposite.
    pub push: Vec3<R>,
    /// 1 where it counts among those that share the bodies' masses in the next substep.
    pub counts: R,
}
// ANCHOR_END: bounds

impl<R: Real> Bounds<R> {
    /// Of the limits that `limit` gives for each lane, which are of one kind.
    pub fn of<'a>(limit: impl Fn(usize) -> &'a Limit) -> Self {
        Self {
            kind: limit(0).kind,
            frame_a: Quat::of(|lane| limit(lane).frame_a),
            frame_b: Quat::of(|lane| limit(lane).frame_b),
            low: Vec3::of(|lane| limit(lane).low),
            high: Vec3::of(|lane| limit(lane).high),
            anchor_a: Vec3::of(|lane| limit(lane).anchor_a),
            anchor_b: Vec3::of(|lane| limit(lane).anchor_b),
            impulses: Vec3::of(|lane| limit(lane).impulses),
        }
    }
}

// ANCHOR: bounded
/// A turn that is limited.
#[derive(Clone, Copy, Debug)]
pub struct Bounded<R: Real> {
    /// u: a unit vector, along which the angle grows.
    pub axis: Vec3<R>,
    /// C: how much further it may turn towards the nearer bound, rad; negative beyond it. Of a turn that
    /// is locked, how far it is above.
    pub room: R,
    /// 1 if the nearer bound is below, −1 if it is above, 0 if there is none.
    pub side: R,
    /// Whether both bounds are one.
    pub is_locked: R::Mask,
}
// ANCHOR_END: bounded

impl<R: Real> Bounded<R> {
    /// A turn without bounds.
    #[inline(always)]
    fn free() -> Self {
        Self {
            axis: Vec3::zero(),
            room: R::splat(0.0),
            side: R::splat(0.0),
            is_locked: R::Mask::splat(false),
        }
    }

    /// Whether there is a bound, and not too far away.
    #[inline(always)]
    fn acts(&self) -> R::Mask {
        !self.side.same(R::splat(0.0)) & self.room.le(R::splat(FAR))
    }
}

// ANCHOR: within
/// The nearer bound of an angle whose rate is `axis`·ω. The row is divided by the length of its axis,
/// which grows beyond all bounds where the angle has no value.
#[inline(always)]
fn within<R: Real>(angle: R, low: R, high: R, axis: Vec3<R>) -> Bounded<R> {
    let (zero, one) = (R::splat(0.0), R::splat(1.0));
    let length = axis.length();
    let is_free = (low.le(R::splat(-PI)) & R::splat(PI).le(high)) | length.lt(R::splat(SMALL_SINE));
    let scale = R::select(is_free, zero, R::select(is_free, one, length).recip());
    let (above, below) = (angle - low, high - angle);
    let is_locked = low.same(high);
    let is_low = above.lt(below) | is_locked;
    Bounded {
        axis: axis * scale,
        room: R::select(is_low, above, below) * scale,
        side: R::select(is_free, zero, R::select(is_low, one, -one)),
        is_locked,
    }
}
// ANCHOR_END: within

// ANCHOR: turns
/// The turns that are limited, at these attitudes: tilt, twist and none, or pitch, yaw and roll.
#[inline(always)]
#[must_use]
pub fn turns<R: Real>(limit: &Bounds<R>, a: Quat<R>, b: Quat<R>) -> [Bounded<R>; 3] {
    let up = Vec3::all(glam::Vec3::Y);
    let (rest, frame) = (a.product(limit.frame_a), b.product(limit.frame_b));
    let (y_rest, y) = (rest.rotate(up), frame.rotate(up));
    let turn = rest.conjugate().product(frame);
    let (low, high) = (limit.low, limit.high);
    let twist = within(twist_of(turn), low.y, high.y, twist_axis(y_rest, y));
    if limit.kind == EULER {
        let swing = swing_of(turn);
        let (pitch_axis, roll_axis) = swing_axes(rest, swing, y);
        let pitch = within(swing.x, low.x, high.x, pitch_axis);
        let roll = within(swing.z, low.z, high.z, roll_axis);
        return [pitch, twist, roll];
    }
    let (angle, axis) = cone(y_rest, y);
    let tilt = within(angle, R::splat(-FREE_ANGLE), high.x, axis);
    [tilt, twist, Bounded::free()]
}
// ANCHOR_END: turns

// ANCHOR: pinned
/// The joint's point, about which both turn: what a limit's angular impulse would part there, an impulse
/// at the point keeps together.
///
/// Two bodies that turn about a point answer less than free ones, and a limit that took them for free
/// would go on turning them when they already stand: it would bounce. All joints of a tree together make
/// them answer less still, so a limit that reckons with its own point alone never does too much.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Pinned<R> {
    arm_a: Vec3<R>,
    arm_b: Vec3<R>,
    /// K⁻¹: the impulse at the point that goes with a parting there, kg.
    holding: Symmetric<R>,
}

impl<R: Real> Pinned<R> {
    #[inline(always)]
    fn of(limit: &Bounds<R>, a: &Side<R>, b: &Side<R>) -> Self {
        let arm_a = a.attitude.rotate(limit.anchor_a);
        let arm_b = b.attitude.rotate(limit.anchor_b);
        let reply = point_reply(a, arm_a).plus(point_reply(b, arm_b));
        let holding = reply.inverse(a.shared_mass + b.shared_mass);
        Self {
            arm_a,
            arm_b,
            holding,
        }
    }

    /// How an angular impulse on b, and its opposite on a, changes the spins of both.
    #[inline(always)]
    fn turned_by(&self, a: &Side<R>, b: &Side<R>, turning: Vec3<R>) -> [Vec3<R>; 2] {
        let turn_a = a.shared_inertia.times(turning);
        let turn_b = b.shared_inertia.times(turning);
        let parting = turn_b.cross(self.arm_b) + turn_a.cross(self.arm_a);
        let held = self.holding.times(parting);
        [
            a.shared_inertia.times(self.arm_a.cross(held)) - turn_a,
            turn_b - b.shared_inertia.times(self.arm_b.cross(held)),
        ]
    }

    /// The relative spin that an angular impulse makes.
    #[inline(always)]
    fn spin_of(&self, a: &Side<R>, b: &Side<R>, turning: Vec3<R>) -> Vec3<R> {
        let [spin_a, spin_b] = self.turned_by(a, b, turning);
        spin_b - spin_a
    }

    /// What the limit alone makes of its two bodies, where it acts.
    #[inline(always)]
    fn turn(&self, acts: R::Mask, a: &mut Side<R>, b: &mut Side<R>, turning: Vec3<R>) {
        let [spin_a, spin_b] = self.turned_by(a, b, turning);
        for (side, spin) in [(a, spin_a), (b, spin_b)] {
            let turned = side.angular_velocity + spin;
            side.angular_velocity = Vec3::select(acts, turned, side.angular_velocity);
        }
    }
}
// ANCHOR_END: pinned

// ANCHOR: solve_limit
/// A substep of a limit: it mends its angular impulses so that the bodies, with the share of their masses
/// that it has, don't turn beyond a bound. `before` is what it gave them in the last substep, which they
/// started this one with; it works now only if it counted then.
#[inline(always)]
#[must_use]
pub fn solve_limit<R: Real>(
    limit: &mut Bounds<R>,
    before: &Turning<R>,
    sides: [Side<R>; 2],
    h: f32,
) -> Turning<R> {
    let [mut a, mut b] = sides;
    let turns = turns(limit, a.attitude, b.attitude);
    let works = before.counts.gt(R::splat(0.0));
    let mut turned = Turning::default();
    let mut impulses = [R::splat(0.0); 3];
    if works.any() {
        let pinned = Pinned::of(limit, &a, &b);
        let held = [limit.impulses.x, limit.impulses.y, limit.impulses.z];
        for (k, turn) in turns.iter().enumerate() {
            impulses[k] = R::select(works, still_holds(turn, held[k]), R::splat(0.0));
            turned.turning += turn.axis * impulses[k];
        }
        let change = turned.turning - before.turning;
        pinned.turn(works, &mut a, &mut b, change);
        // First the swing, then the twist, each from the velocities that the one before left.
        for k in [0, 2, 1] {
            let (turn, acts) = (&turns[k], works & turns[k].acts());
            if acts.any() {
                let impulse = &mut impulses[k];
                solve_turn(turn, acts, &pinned, impulse, &mut turned, &mut a, &mut b, h);
            }
        }
    }
    let [x, y, z] = impulses;
    limit.impulses = Vec3::new(x, y, z);
    turned.counts = R::ones(holds(impulses) | is_any_near(&turns, &a, &b, h));
    turned
}
// ANCHOR_END: solve_limit

/// The vector where yes, else none.
#[inline(always)]
fn only<R: Real>(mask: R::Mask, v: Vec3<R>) -> Vec3<R> {
    Vec3::select(mask, v, Vec3::zero())
}

/// What is left of an impulse: nothing, if the nearer bound is another one than it came from.
#[inline(always)]
fn still_holds<R: Real>(turn: &Bounded<R>, impulse: R) -> R {
    let zero = R::splat(0.0);
    let one_way = turn.side * (turn.side * impulse).max(zero);
    let held = R::select(turn.is_locked, impulse, one_way);
    R::select(turn.acts(), held, zero)
}

// ANCHOR: solve_turn
/// Mends the impulse of one turn where it acts, and pushes back what is beyond its bound.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "what one turn has to do with")]
fn solve_turn<R: Real>(
    turn: &Bounded<R>,
    acts: R::Mask,
    pinned: &Pinned<R>,
    impulse: &mut R,
    turned: &mut Turning<R>,
    a: &mut Side<R>,
    b: &mut Side<R>,
    h: f32,
) {
    let zero = R::splat(0.0);
    let reply = turn.axis.dot(pinned.spin_of(a, b, turn.axis));
    let sharing = reply.max(R::splat(SMALL_SINE)).recip();
    let rate = turn.axis.dot(b.angular_velocity - a.angular_velocity);
    let locked = *impulse - (rate - returning(-turn.room, h)) * sharing;
    let slack = turn.room.max(zero) * R::splat(1.0 / h);
    let back = returning((-turn.room - R::splat(TURN_SLOP)).max(zero), h);
    let off = turn.side * rate + slack - back;
    let bounded = turn.side * (turn.side * *impulse - off * sharing).max(zero);
    let wanted = R::select(turn.is_locked, locked, bounded);
    let change = only(acts, turn.axis * (wanted - *impulse));
    *impulse = R::select(acts, wanted, *impulse);
    turned.turning += change;
    pinned.turn(acts, a, b, change);
    let pushed = turn.axis.dot(pinned.spin_of(a, b, turned.push));
    turned.push += only(acts, turn.axis * pushed_back(turn, pushed, sharing, h));
}

/// How fast the impulse turns back what is beyond, rad/s.
#[inline(always)]
fn returning<R: Real>(beyond: R, h: f32) -> R {
    let most = R::splat(GENTLE_TURN);
    (beyond * R::splat(RETURN_SHARE / h)).clamp(-most, most)
}

/// The turning push that turns back what is beyond a bound, N m s, where others push at this rate.
/// `sharing` is the angular impulse that goes with a rate, kg m².
#[inline(always)]
fn pushed_back<R: Real>(turn: &Bounded<R>, pushed: R, sharing: R, h: f32) -> R {
    let (zero, most) = (R::splat(0.0), R::splat(FASTEST_TURN));
    let wanted = (turn.room * R::splat(-TURN_SHARE / h)).clamp(-most, most);
    let locked = (wanted - pushed) * sharing;
    let bounded = turn.side * ((wanted - turn.side * pushed) * sharing).max(zero);
    let beyond = R::select(turn.room.lt(zero), bounded, zero);
    R::select(turn.is_locked, locked, beyond)
}
// ANCHOR_END: solve_turn

/// Whether any of the impulses isn't 0.
#[inline(always)]
fn holds<R: Real>([x, y, z]: [R; 3]) -> R::Mask {
    let zero = R::splat(0.0);
    !(x.same(zero) & y.same(zero) & z.same(zero))
}

/// Whether a turn is at its bound or may be in the next substep.
#[inline(always)]
fn is_any_near<R: Real>(turns: &[Bounded<R>; 3], a: &Side<R>, b: &Side<R>, h: f32) -> R::Mask {
    let is_near = |turn: &Bounded<R>| {
        let rate = turn.side * turn.axis.dot(b.angular_velocity - a.angular_velocity);
        let soon = (turn.room + rate * R::splat(2.0 * h)).lt(R::splat(NEAR));
        !turn.side.same(R::splat(0.0)) & (turn.is_locked | soon)
    };
    let [one, two, three] = turns;
    is_near(one) | is_near(two) | is_near(three)
}
