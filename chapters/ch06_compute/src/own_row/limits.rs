//! Angle limits as rows: how far a body may turn away from its rest in another, by chapter 4's swing and
//! twist.
//!
//! A limit reads both bodies and writes its own turning impulses, from the same velocities as the contacts
//! do and with the same shares of the masses. Each of its up to three turns has a unit axis u, a rate
//! u·(ω_b − ω_a) and a room C that is left until the bound. [`super::contact`] says why shares.

#[cfg(test)]
mod tests;

use std::f32::consts::PI;

use ch00_maths::f32::swing_twist::{cone, decompose, swing_axes, twist_axis};
use ch00_scenes::{EulerLimits, Joint, Scene};
use glam::{DQuat, DVec3, Quat, Vec3};

use super::loops::point_reply;
use super::one_side::Side;
use super::tree::Symmetric;
use crate::rows::{CONE_TWIST, EULER, FREE_ANGLE, Limit, Turned};

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

/// Below this an axis is none.
const SMALL: f32 = 1e-6;

// ANCHOR: bounded
/// A turn that is limited.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounded {
    /// u: a unit vector, along which the angle grows.
    pub axis: Vec3,
    /// C: how much further it may turn towards the nearer bound, rad; negative beyond it. Of a turn that
    /// is locked, how far it is above.
    pub room: f32,
    /// 1 if the nearer bound is below, −1 if it is above, 0 if there is none.
    pub side: f32,
    /// Whether both bounds are one.
    pub is_locked: bool,
}
// ANCHOR_END: bounded

// ANCHOR: within
/// The nearer bound of an angle whose rate is `axis`·ω. The row is divided by the length of its axis,
/// which grows beyond all bounds where the angle has no value.
fn within(angle: f32, low: f32, high: f32, axis: Vec3) -> Bounded {
    let length = axis.length();
    if (low <= -PI && high >= PI) || length < SMALL {
        return Bounded::default();
    }
    let (above, below) = (angle - low, high - angle);
    let is_locked = low == high;
    let (room, side) = if above < below || is_locked {
        (above, 1.0)
    } else {
        (below, -1.0)
    };
    Bounded {
        axis: axis / length,
        room: room / length,
        side,
        is_locked,
    }
}
// ANCHOR_END: within

// ANCHOR: turns
/// The turns that are limited, at these attitudes: tilt, twist and none, or pitch, yaw and roll.
#[must_use]
pub fn turns(limit: &Limit, a: Quat, b: Quat) -> [Bounded; 3] {
    let (rest, frame) = (a * limit.frame_a, b * limit.frame_b);
    let (y_rest, y) = (rest * Vec3::Y, frame * Vec3::Y);
    let parts = decompose(rest.conjugate() * frame);
    let (low, high) = (limit.low, limit.high);
    let twist = within(parts.twist, low.y, high.y, twist_axis(y_rest, y));
    if limit.kind == EULER {
        let (pitch_axis, roll_axis) = swing_axes(rest, parts.swing, y);
        let pitch = within(parts.swing.x, low.x, high.x, pitch_axis);
        let roll = within(parts.swing.z, low.z, high.z, roll_axis);
        return [pitch, twist, roll];
    }
    let (angle, axis) = cone(y_rest, y);
    let tilt = within(angle, -FREE_ANGLE, high.x, axis.unwrap_or(Vec3::ZERO));
    [tilt, twist, Bounded::default()]
}
// ANCHOR_END: turns

// ANCHOR: pinned
/// The joint's point, about which both turn: what a limit's turning impulse would part there, an impulse
/// at the point keeps together.
///
/// Two bodies that turn about a point answer less than free ones, and a limit that took them for free
/// would go on turning them when they already stand: it would bounce. All joints of a tree together make
/// them answer less still, so a limit that reckons with its own point alone never does too much.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Pinned {
    arm_a: Vec3,
    arm_b: Vec3,
    /// K⁻¹: the impulse at the point that goes with a parting there, kg.
    holding: Symmetric,
}

impl Pinned {
    fn of(limit: &Limit, a: &Side, b: &Side) -> Self {
        let arm_a = a.attitude * limit.anchor_a;
        let arm_b = b.attitude * limit.anchor_b;
        let reply = point_reply(a, arm_a).plus(point_reply(b, arm_b));
        let holding = reply.inverse(a.shared_mass + b.shared_mass);
        Self {
            arm_a,
            arm_b,
            holding,
        }
    }

    /// How a turning impulse on b, and its opposite on a, changes the spins of both.
    fn turned_by(&self, a: &Side, b: &Side, turning: Vec3) -> [Vec3; 2] {
        let (turn_a, turn_b) = (a.shared_inertia * turning, b.shared_inertia * turning);
        let parting = turn_b.cross(self.arm_b) + turn_a.cross(self.arm_a);
        let held = self.holding.times(parting);
        [
            a.shared_inertia * self.arm_a.cross(held) - turn_a,
            turn_b - b.shared_inertia * self.arm_b.cross(held),
        ]
    }

    /// The relative spin that a turning impulse makes.
    fn spin_of(&self, a: &Side, b: &Side, turning: Vec3) -> Vec3 {
        let [spin_a, spin_b] = self.turned_by(a, b, turning);
        spin_b - spin_a
    }

    /// What the limit alone makes of its two bodies.
    fn turn(&self, a: &mut Side, b: &mut Side, turning: Vec3) {
        let [spin_a, spin_b] = self.turned_by(a, b, turning);
        a.angular_velocity += spin_a;
        b.angular_velocity += spin_b;
    }
}
// ANCHOR_END: pinned

// ANCHOR: solve_limit
/// A substep of a limit: it mends its turning impulses so that the bodies, with the share of their masses
/// that it has, don't turn beyond a bound. `before` is what it gave them in the last substep, which they
/// started this one with; it works now only if it counted then.
#[must_use]
pub fn solve_limit(limit: &mut Limit, before: &Turned, sides: [Side; 2], h: f32) -> Turned {
    let [mut a, mut b] = sides;
    let turns = turns(limit, a.attitude, b.attitude);
    let mut impulses = Vec3::ZERO;
    let mut turned = Turned::default();
    if before.counts > 0.0 {
        let pinned = Pinned::of(limit, &a, &b);
        for (k, turn) in turns.iter().enumerate() {
            impulses[k] = still_holds(turn, limit.impulses[k]);
            turned.turning += impulses[k] * turn.axis;
        }
        pinned.turn(&mut a, &mut b, turned.turning - before.turning);
        // First the swing, then the twist, each from the velocities that the one before left.
        for k in [0, 2, 1] {
            let (turn, impulse) = (&turns[k], &mut impulses[k]);
            solve_turn(turn, &pinned, impulse, &mut turned, &mut a, &mut b, h);
        }
    }
    limit.impulses = impulses;
    let holds = impulses != Vec3::ZERO;
    let counts = holds || turns.iter().any(|turn| is_near(turn, &a, &b, h));
    turned.counts = if counts { 1.0 } else { 0.0 };
    turned
}
// ANCHOR_END: solve_limit

/// What is left of an impulse: nothing, if the nearer bound is another one than it came from.
fn still_holds(turn: &Bounded, impulse: f32) -> f32 {
    if turn.side == 0.0 || turn.room > FAR {
        return 0.0;
    }
    if turn.is_locked {
        return impulse;
    }
    turn.side * (turn.side * impulse).max(0.0)
}

// ANCHOR: solve_turn
/// Mends the impulse of one turn, and pushes back what is beyond its bound.
fn solve_turn(
    turn: &Bounded,
    pinned: &Pinned,
    impulse: &mut f32,
    turned: &mut Turned,
    a: &mut Side,
    b: &mut Side,
    h: f32,
) {
    if turn.side == 0.0 || turn.room > FAR {
        return;
    }
    let reply = turn.axis.dot(pinned.spin_of(a, b, turn.axis)).max(SMALL);
    let rate = turn.axis.dot(b.angular_velocity - a.angular_velocity);
    let wanted = if turn.is_locked {
        *impulse - (rate - returning(-turn.room, h)) / reply
    } else {
        let slack = turn.room.max(0.0) / h;
        let back = returning((-turn.room - TURN_SLOP).max(0.0), h);
        let off = turn.side * rate + slack - back;
        turn.side * (turn.side * *impulse - off / reply).max(0.0)
    };
    let change = (wanted - *impulse) * turn.axis;
    *impulse = wanted;
    turned.turning += change;
    pinned.turn(a, b, change);
    let pushed = turn.axis.dot(pinned.spin_of(a, b, turned.push));
    turned.push += turn.axis * pushed_back(turn, pushed, reply, h);
}

/// How fast the impulse turns back what is beyond, rad/s.
fn returning(beyond: f32, h: f32) -> f32 {
    (beyond * (RETURN_SHARE / h)).clamp(-GENTLE_TURN, GENTLE_TURN)
}

/// The turning push that turns back what is beyond a bound, N m s, where others push at this rate.
fn pushed_back(turn: &Bounded, pushed: f32, reply: f32, h: f32) -> f32 {
    let wanted = (turn.room * (-TURN_SHARE / h)).clamp(-FASTEST_TURN, FASTEST_TURN);
    if turn.is_locked {
        return (wanted - pushed) / reply;
    }
    if turn.room >= 0.0 {
        return 0.0;
    }
    turn.side * ((wanted - turn.side * pushed) / reply).max(0.0)
}
// ANCHOR_END: solve_turn

/// Whether a turn is at its bound or may be in the next substep.
fn is_near(turn: &Bounded, a: &Side, b: &Side, h: f32) -> bool {
    let rate = turn.side * turn.axis.dot(b.angular_velocity - a.angular_velocity);
    turn.side != 0.0 && (turn.is_locked || turn.room + 2.0 * h * rate < NEAR)
}

// ANCHOR: limit_of
/// The limit of a joint of the scene, if it has one.
///
/// A hinge's range is a twist about its axis: the frame in b turns y onto that.
#[must_use]
pub fn limit_of(scene: &Scene, index: usize) -> Option<Limit> {
    let joint = &scene.joints[index];
    let (a, b) = joint.bodies();
    let (anchor_a, anchor_b) = joint.anchors();
    let attitude = |body: usize| scene.bodies[body].orientation;
    let as_loaded = (attitude(a).conjugate() * attitude(b)).normalize();
    let free = f64::from(FREE_ANGLE);
    let (low, high, kind, rest, frame_b) = match *joint {
        Joint::Ball {
            limits: Some(limits),
            rest,
            ..
        } => {
            let [low, high] = euler_bounds(limits);
            (low, high, EULER, rest, DQuat::IDENTITY)
        }
        Joint::Ball {
            cone, twist, rest, ..
        } if cone.is_some() || twist.is_some() => {
            let [low, high] = twist.unwrap_or([-free, free]);
            let (low, high) = (
                DVec3::new(-free, low, -free),
                DVec3::new(cone.unwrap_or(free), high, free),
            );
            (low, high, CONE_TWIST, rest, DQuat::IDENTITY)
        }
        Joint::Hinge {
            axis_b,
            range: Some([low, high]),
            ..
        } => {
            let frame_b = DQuat::from_rotation_arc(DVec3::Y, axis_b.normalize());
            let (low, high) = (DVec3::new(-free, low, -free), DVec3::new(free, high, free));
            (low, high, CONE_TWIST, None, frame_b)
        }
        Joint::Ball { .. } | Joint::Hinge { .. } | Joint::Distance { .. } => return None,
    };
    Some(Limit {
        a: a as u32,
        b: b as u32,
        joint: index as u32,
        kind,
        frame_a: (rest.unwrap_or(as_loaded) * frame_b).normalize().as_quat(),
        frame_b: frame_b.as_quat(),
        low: low.as_vec3(),
        high: high.as_vec3(),
        anchor_a: anchor_a.as_vec3(),
        anchor_b: anchor_b.as_vec3(),
        ..Limit::default()
    })
}

fn euler_bounds(limits: EulerLimits) -> [DVec3; 2] {
    [0, 1].map(|end| DVec3::new(limits.pitch[end], limits.yaw[end], limits.roll[end]))
}
// ANCHOR_END: limit_of
