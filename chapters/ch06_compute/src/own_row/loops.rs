//! Joints that close a loop, which no tree can hold, as rows: each reads both bodies and writes its own
//! impulses, like a pair that touches.
//!
//! A row has a share of the masses only, so it gives way where a tree's joint wouldn't: a chain that
//! hangs at both ends is taut along its tree and parts a little where the loop closes. The trees are
//! solved after the rows and pass on what they did.

use super::side::Side;
use super::tree::{Bone, Fitting, Link, Rate, Wrench, link_of};
use crate::rows::{HINGE, Node, Press, ROD};
use crate::simd::{Real, Symmetric, Vec3};

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
pub fn solve_loop(node: &mut Node, before: &Press, sides: [Side<f32>; 2], h: f32) -> Press {
    let [mut a, mut b] = sides;
    let fitting = Fitting::of(|_| &*node);
    let (child, parent) = (still(&b), still(&a));
    let link = link_of(node.kind, &fitting, &child, &parent, &Bone::default(), h);
    let mut given = again(node, &link);
    let now = pressed_by(&link, given);
    let linear = Vec3::from(now.linear - before.linear);
    a.take(-linear, (now.angular_a - before.angular_a).into());
    b.take(linear, (now.angular_b - before.angular_b).into());
    mend(
        node.kind,
        &link,
        Rate::default(),
        &mut given,
        &mut a,
        &mut b,
    );
    for side in [&mut a, &mut b] {
        side.velocity = Vec3::zero();
        side.angular_velocity = Vec3::zero();
    }
    let mut pushed = Wrench::default();
    let wanted = closing(&link);
    mend(node.kind, &link, wanted, &mut pushed, &mut a, &mut b);
    node.impulse = given.impulse.lane(0);
    node.turning = given.turning.lane(0);
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
fn again(node: &Node, link: &Link<f32>) -> Wrench<f32> {
    let (impulse, turning) = (Vec3::from(node.impulse), Vec3::from(node.turning));
    Wrench {
        impulse: if node.kind == ROD {
            link.along * link.along.dot(impulse)
        } else {
            impulse
        },
        turning: turning - link.along * link.along.dot(turning),
    }
}

/// How fast a push closes what is open.
fn closing(link: &Link<f32>) -> Rate<f32> {
    let Rate { velocity, spin } = link.wanted[0];
    Rate {
        velocity: velocity * LOOP_SHARE,
        spin: spin * LOOP_SHARE,
    }
}

/// A body that doesn't move: what its joint wants is then to close the gap and no more.
fn still(side: &Side<f32>) -> Bone<f32> {
    Bone {
        position: side.position,
        attitude: side.attitude,
        ..Bone::default()
    }
}

/// An impulse about the joint's point, as the two bodies receive it.
fn pressed_by(link: &Link<f32>, given: Wrench<f32>) -> Press {
    Press {
        linear: given.impulse.lane(0),
        angular_a: -given.at(-link.parent_arm).turning.lane(0),
        angular_b: given.at(-link.arm).turning.lane(0),
        ..Press::default()
    }
}

// ANCHOR: mend
/// Mends `given` so that the relative motion at the joint's point becomes `wanted`: first of the point,
/// then of a hinge's axes.
fn mend(
    kind: u32,
    link: &Link<f32>,
    wanted: Rate<f32>,
    given: &mut Wrench<f32>,
    a: &mut Side<f32>,
    b: &mut Side<f32>,
) {
    for _ in 0..LOOP_SWEEPS {
        let lacks = wanted.velocity - parting(link, a, b);
        let reply = point_reply(a, link.parent_arm).plus(point_reply(b, link.arm));
        let impulse = if kind == ROD {
            let lacks = wanted.velocity.x - link.along.dot(parting(link, a, b));
            link.along * (lacks / link.along.dot(reply.times(link.along)).max(SMALL))
        } else {
            reply.inverse(a.shared_mass + b.shared_mass).times(lacks)
        };
        a.take(-impulse, -link.parent_arm.cross(impulse));
        b.take(impulse, link.arm.cross(impulse));
        given.impulse += impulse;
        if kind == HINGE {
            let turning = aligning(link.along, wanted.spin, a, b);
            a.take(Vec3::zero(), -turning);
            b.take(Vec3::zero(), turning);
            given.turning += turning;
        }
    }
}
// ANCHOR_END: mend

/// Velocity of b's point away from a's, m/s.
fn parting(link: &Link<f32>, a: &Side<f32>, b: &Side<f32>) -> Vec3<f32> {
    b.velocity_at(link.arm) - a.velocity_at(link.parent_arm)
}

// ANCHOR: point_reply
/// What a unit impulse at `arm` makes of the velocity there, along each axis, 1/kg.
#[inline(always)]
#[must_use]
pub fn point_reply<R: Real>(side: &Side<R>, arm: Vec3<R>) -> Symmetric<R> {
    let [ix, iy, iz] = side.shared_inertia.columns();
    // I⁻¹ (r × x̂), with r × x̂ = (0, r_z, −r_y), and so on.
    let x = (iy * arm.z - iz * arm.y).cross(arm);
    let y = (iz * arm.x - ix * arm.z).cross(arm);
    let z = (ix * arm.y - iy * arm.x).cross(arm);
    Symmetric {
        diagonal: Vec3::new(x.x, y.y, z.z) + Vec3::splat(side.shared_mass),
        off: Vec3::new(y.z, z.x, x.y),
    }
}
// ANCHOR_END: point_reply

/// The angular impulse across a hinge's axis that makes the relative spin there what is wanted.
fn aligning(axis: Vec3<f32>, wanted: Vec3<f32>, a: &Side<f32>, b: &Side<f32>) -> Vec3<f32> {
    let [u, w] = across(axis);
    let lacks = wanted - (b.angular_velocity - a.angular_velocity);
    let shared = |v: Vec3<f32>| a.shared_inertia.times(v) + b.shared_inertia.times(v);
    let (by_u, by_w) = (shared(u), shared(w));
    let (uu, uw, ww) = (u.dot(by_u), u.dot(by_w), w.dot(by_w));
    let (along_u, along_w) = (u.dot(lacks), w.dot(lacks));
    let sharing = (uu * ww - uw * uw).max(SMALL).recip();
    (u * (ww * along_u - uw * along_w) + w * (uu * along_w - uw * along_u)) * sharing
}

/// Two unit vectors across a unit vector and across each other. [Duff and others 2017]
fn across(n: Vec3<f32>) -> [Vec3<f32>; 2] {
    let sign = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let p = -1.0 / (sign + n.z);
    let q = n.x * n.y * p;
    [
        Vec3::new(1.0 + sign * n.x * n.x * p, sign * q, -sign * n.x),
        Vec3::new(q, sign + n.y * n.y * p, -n.y),
    ]
}
