//! Joints that close a loop, which no tree can hold, as rows: each reads both bodies and writes its own
//! impulses, like a pair that touches.
//!
//! A row has a share of the masses only, so it gives way where a tree's joint wouldn't: a chain that
//! hangs at both ends is taut along its tree and parts a little where the loop closes. The trees are
//! solved after the rows and pass on what they did.

use glam::Vec3;

use super::one_side::{Side, across};
use super::tree::{Bone, Link, Rate, Symmetric, Wrench, link_of};
use crate::rows::{HINGE, Node, Press, ROD};

/// The share of a gap that a substep's push closes.
pub const LOOP_SHARE: f32 = 0.2;

/// Sweeps over the point and the axes of a hinge.
pub const LOOP_SWEEPS: u32 = 2;

/// Below this a reply is none.
const SMALL: f32 = 1e-12;

// ANCHOR: solve_loop
/// A substep of a joint that closes a loop, from a, its parent, to b: it mends its impulses so that its
/// points no longer part. What they have parted by is pushed together. `before` is what it gave in the
/// last substep, which the bodies started this one with.
#[must_use]
pub fn solve_loop(node: &mut Node, before: &Press, sides: [Side; 2], h: f32) -> Press {
    let [mut a, mut b] = sides;
    let link = link_of(node, &still(&b), &still(&a), &Bone::default(), h);
    let mut given = again(node, &link);
    let now = pressed_by(&link, given);
    take(
        &mut a,
        before.linear - now.linear,
        now.angular_a - before.angular_a,
    );
    take(
        &mut b,
        now.linear - before.linear,
        now.angular_b - before.angular_b,
    );
    mend(
        node.kind,
        &link,
        Rate::default(),
        &mut given,
        &mut a,
        &mut b,
    );
    for side in [&mut a, &mut b] {
        side.velocity = Vec3::ZERO;
        side.angular_velocity = Vec3::ZERO;
    }
    let mut pushed = Wrench::default();
    let wanted = closing(&link);
    mend(node.kind, &link, wanted, &mut pushed, &mut a, &mut b);
    node.impulse = given.impulse;
    node.turning = given.turning;
    let push = pressed_by(&link, pushed);
    Press {
        push: push.linear,
        push_a: push.angular_a,
        push_b: push.angular_b,
        counts: 1.0,
        ..pressed_by(&link, given)
    }
}
// ANCHOR_END: solve_loop

/// What the joint gave in the last substep, as it acts now.
fn again(node: &Node, link: &Link) -> Wrench {
    let along = link.along * link.along.dot(node.impulse);
    Wrench {
        impulse: if node.kind == ROD {
            along
        } else {
            node.impulse
        },
        turning: node.turning - link.along * link.along.dot(node.turning),
    }
}

/// How fast a push closes what is open.
fn closing(link: &Link) -> Rate {
    let Rate { velocity, spin } = link.wanted[0];
    Rate {
        velocity: LOOP_SHARE * velocity,
        spin: LOOP_SHARE * spin,
    }
}

/// A body that doesn't move: what its joint wants is then to close the gap and no more.
fn still(side: &Side) -> Bone {
    Bone {
        position: side.position,
        attitude: side.attitude,
        ..Bone::default()
    }
}

/// An impulse about the joint's point, as the two bodies receive it.
fn pressed_by(link: &Link, given: Wrench) -> Press {
    Press {
        linear: given.impulse,
        angular_a: -given.at(-link.parent_arm).turning,
        angular_b: given.at(-link.arm).turning,
        ..Press::default()
    }
}

/// What the row alone makes of a body.
fn take(side: &mut Side, impulse: Vec3, turning: Vec3) {
    side.velocity += impulse * side.shared_mass;
    side.angular_velocity += side.shared_inertia * turning;
}

// ANCHOR: mend
/// Mends `given` so that the relative motion at the joint's point becomes `wanted`: first of the point,
/// then of a hinge's axes.
fn mend(kind: u32, link: &Link, wanted: Rate, given: &mut Wrench, a: &mut Side, b: &mut Side) {
    for _ in 0..LOOP_SWEEPS {
        let lacks = wanted.velocity - parting(link, a, b);
        let reply = point_reply(a, link.parent_arm).plus(point_reply(b, link.arm));
        let impulse = if kind == ROD {
            let lacks = wanted.velocity.x - link.along.dot(parting(link, a, b));
            link.along * (lacks / link.along.dot(reply.times(link.along)).max(SMALL))
        } else {
            reply.inverse(a.shared_mass + b.shared_mass).times(lacks)
        };
        take(a, -impulse, -link.parent_arm.cross(impulse));
        take(b, impulse, link.arm.cross(impulse));
        given.impulse += impulse;
        if kind == HINGE {
            let turning = aligning(link.along, wanted.spin, a, b);
            take(a, Vec3::ZERO, -turning);
            take(b, Vec3::ZERO, turning);
            given.turning += turning;
        }
    }
}
// ANCHOR_END: mend

/// Velocity of b's point away from a's, m/s.
fn parting(link: &Link, a: &Side, b: &Side) -> Vec3 {
    b.velocity + b.angular_velocity.cross(link.arm)
        - a.velocity
        - a.angular_velocity.cross(link.parent_arm)
}

/// What a unit impulse at `arm` makes of the velocity there, along each axis, 1/kg.
#[must_use]
pub fn point_reply(side: &Side, arm: Vec3) -> Symmetric {
    let along = |unit: Vec3| (side.shared_inertia * arm.cross(unit)).cross(arm);
    let [x, y, z] = Vec3::AXES.map(along);
    Symmetric {
        diagonal: Vec3::new(x.x, y.y, z.z) + side.shared_mass,
        off: Vec3::new(y.z, z.x, x.y),
    }
}

/// The turning impulse across a hinge's axis that makes the relative spin there what is wanted.
fn aligning(axis: Vec3, wanted: Vec3, a: &Side, b: &Side) -> Vec3 {
    let [u, w] = across(axis);
    let lacks = wanted - (b.angular_velocity - a.angular_velocity);
    let shared = |v: Vec3| a.shared_inertia * v + b.shared_inertia * v;
    let (by_u, by_w) = (shared(u), shared(w));
    let (uu, uw, ww) = (u.dot(by_u), u.dot(by_w), w.dot(by_w));
    let (along_u, along_w) = (u.dot(lacks), w.dot(lacks));
    let sharing = 1.0 / (uu * ww - uw * uw).max(SMALL);
    (u * (ww * along_u - uw * along_w) + w * (uu * along_w - uw * along_u)) * sharing
}
