//! A node on the way up to the root and on the way down again.
//!
//! Up: what hangs at a joint is felt by the parent as an inertia and an impulse at the joint's point, so
//! the node's body is folded into the parent's. At the root nothing is left to fold: it moves. Down:
//! each child follows its parent. Together this is block LDLᵀ of the system of all joints of the tree,
//! without fill-in since a child has one parent, in as many steps as the tree has levels.

use super::{Articulated, Heft, Link, Rate, Wrench};
use crate::rows::{HINGE, PIN, ROD, TWO_RODS};
use crate::simd::{Mat3, Real, Symmetric, Vec3};

/// Below this a reply is none.
const SMALL: f32 = 1e-12;

/// Two rods whose directions are this near to one line, as the square of their sine, pull as if they
/// were not quite.
const LEAST_SINE2: f32 = 1e-4;

// ANCHOR: carried
/// What a body and all that hangs on it answer, and what moves them: first for the velocities, then for
/// the pushes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Carried<R> {
    /// How they answer.
    pub articulated: Articulated<R>,
    /// What moves them.
    pub wrench: [Wrench<R>; 2],
}
// ANCHOR_END: carried

impl<R: Real> Carried<R> {
    /// The sum of both, which are taken at the same point.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            articulated: self.articulated.plus(other.articulated),
            wrench: [
                self.wrench[0].plus(other.wrench[0]),
                self.wrench[1].plus(other.wrench[1]),
            ],
        }
    }
}

// ANCHOR: kept
/// What a node keeps from the way up for the way down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Kept<R> {
    /// What the joint's motion makes of the body's spin: Δω = rest − gain · Δv_c. Of a hinge the columns
    /// are what velocity and spin make of its turn, and its axis.
    pub gain: Mat3<R>,
    /// The body's spin while the joint's point stays; of a hinge x is its turn.
    pub rest: [Vec3<R>; 2],
    /// K⁻¹: how the joint's point yields, for joints that leave it free in some direction.
    pub give: Symmetric<R>,
    /// How the joint's point moves if nothing holds it.
    pub free: [Vec3<R>; 2],
}
// ANCHOR_END: kept

/// The same for velocities, 0, and for pushes, 1.
#[inline(always)]
fn for_both<T>(of: impl Fn(usize) -> T) -> [T; 2] {
    [of(0), of(1)]
}

// ANCHOR: fold
/// On the way up: folds a body, with all that was folded into it, into its joint. Gives what it keeps
/// for the way down, and what the parent feels, about the parent's centre.
#[inline(always)]
#[must_use]
pub fn fold<R: Real>(
    kind: u32,
    link: &Link<R>,
    heft: &Heft<R>,
    body: &Carried<R>,
) -> (Kept<R>, Carried<R>) {
    let at_joint = Carried {
        articulated: body.articulated.at(link.arm),
        wrench: for_both(|k| body.wrench[k].at(link.arm)),
    };
    let (kept, felt) = if kind == HINGE {
        fold_hinge(link, heft, &at_joint)
    } else {
        fold_point(kind, link, heft, &at_joint)
    };
    let wrench = for_both(|k| felt.wrench[k].at(-link.parent_arm));
    (kept, Carried { wrench, ..felt })
}
// ANCHOR_END: fold

// ANCHOR: fold_point
/// A joint about whose point the body turns freely: it gives way until no angular impulse is left. What
/// is felt at the point is the mass K = A − Cᵀ D⁻¹ C.
#[inline(always)]
// ANCHOR: felt_mass
fn fold_point<R: Real>(
    kind: u32,
    link: &Link<R>,
    heft: &Heft<R>,
    at_joint: &Carried<R>,
) -> (Kept<R>, Carried<R>) {
    let Articulated {
        mass,
        coupling,
        inertia,
    } = at_joint.articulated;
    let turns = inertia.inverse(heft.least);
    let gain = Mat3::from_cols(
        turns.times(coupling.x),
        turns.times(coupling.y),
        turns.times(coupling.z),
    );
    let felt = less_product(mass, gain, coupling);
    let acts = at_joint.wrench;
    let impulse = for_both(|k| acts[k].impulse - gain.transposed_times(acts[k].turning));
    let mut kept = Kept {
        gain,
        rest: for_both(|k| turns.times(acts[k].turning)),
        ..Kept::default()
    };
    if kind == PIN {
        let lacks = for_both(|k| impulse[k] - felt.times(link.wanted[k].velocity));
        return (kept, felt_at(felt, lacks, link));
    }
    let stiffest = heft.inverse_mass + link.arm.length_squared() * heft.stiffest;
    kept.give = felt.inverse(stiffest.recip());
    kept.free = for_both(|k| kept.give.times(impulse[k]));
    let carried = match kind {
        ROD | TWO_RODS => fold_rods(kind, link, &kept),
        _ => Carried::default(),
    };
    (kept, carried)
}
// ANCHOR_END: felt_mass

/// A − Gᵀ C where that is symmetric.
#[inline(always)]
fn less_product<R: Real>(a: Symmetric<R>, g: Mat3<R>, c: Mat3<R>) -> Symmetric<R> {
    Symmetric {
        diagonal: a.diagonal - Vec3::new(g.x.dot(c.x), g.y.dot(c.y), g.z.dot(c.z)),
        off: a.off - Vec3::new(g.y.dot(c.z), g.z.dot(c.x), g.x.dot(c.y)),
    }
}

/// What the parent feels where a mass is felt at the joint's point. The impulses stay about that point.
#[inline(always)]
fn felt_at<R: Real>(mass: Symmetric<R>, impulse: [Vec3<R>; 2], link: &Link<R>) -> Carried<R> {
    Carried {
        articulated: Articulated::felt_at(mass, link.parent_arm),
        wrench: for_both(|k| Wrench {
            impulse: impulse[k],
            turning: Vec3::zero(),
        }),
    }
}
// ANCHOR_END: fold_point

// ANCHOR: fold_rods
/// One or two rods, of which the parent feels what acts along them: with U their directions the mass
/// U κ Uᵀ, κ = (Uᵀ K⁻¹ U)⁻¹.
#[inline(always)]
fn fold_rods<R: Real>(kind: u32, link: &Link<R>, kept: &Kept<R>) -> Carried<R> {
    let small = R::splat(SMALL);
    let (u1, u2) = (link.along, link.second);
    let n1 = kept.give.times(u1);
    let reply = u1.dot(n1).max(small);
    let lacks = |k: usize, u: Vec3<R>, wanted: R| u.dot(kept.free[k]) - wanted;
    let first = for_both(|k| lacks(k, u1, link.wanted[k].velocity.x));
    if kind == ROD {
        let sharing = reply.recip();
        let mass = Symmetric::outer(u1).scaled(sharing);
        let impulse = for_both(|k| u1 * (first[k] * sharing));
        return felt_at(mass, impulse, link);
    }
    let n2 = kept.give.times(u2);
    let (both, other) = (u1.dot(n2), u2.dot(n2).max(small));
    let alone = reply * other;
    let least = alone * R::splat(LEAST_SINE2);
    let sharing = (alone - both * both).max(least).recip();
    let mass = Symmetric::outer(u1)
        .scaled(other)
        .plus(Symmetric::outer(u2).scaled(reply))
        .plus(Symmetric::outer_pair(u1, u2).scaled(-both))
        .scaled(sharing);
    let impulse = for_both(|k| {
        let second = lacks(k, u2, link.wanted[k].velocity.y);
        (u1 * (other * first[k] - both * second) + u2 * (reply * second - both * first[k]))
            * sharing
    });
    felt_at(mass, impulse, link)
}
// ANCHOR_END: fold_rods

// ANCHOR: fold_hinge
/// A hinge: the body gives way about its axis alone, until no angular impulse is left along that.
#[inline(always)]
fn fold_hinge<R: Real>(
    link: &Link<R>,
    heft: &Heft<R>,
    at_joint: &Carried<R>,
) -> (Kept<R>, Carried<R>) {
    let Articulated {
        mass,
        coupling,
        inertia,
    } = at_joint.articulated;
    let axis = link.along;
    let turning = inertia.times(axis);
    let moving = coupling.transposed_times(axis);
    let reply = axis.dot(turning).max(heft.least).recip();
    let given = turning * reply;
    let felt = Articulated {
        mass: mass.plus(Symmetric::outer(moving).scaled(-reply)),
        coupling: coupling
            + Mat3::from_cols(given * -moving.x, given * -moving.y, given * -moving.z),
        inertia: inertia.plus(Symmetric::outer(turning).scaled(-reply)),
    };
    let turns = for_both(|k| axis.dot(at_joint.wrench[k].turning) * reply);
    let lacks = for_both(|k| {
        let yielded = Wrench {
            impulse: moving * turns[k],
            turning: turning * turns[k],
        };
        let wrench = at_joint.wrench[k].minus(yielded);
        wrench.minus(felt.times(link.wanted[k]))
    });
    let kept = Kept {
        gain: Mat3::from_cols(moving * reply, given, axis),
        rest: for_both(|k| Vec3::new(turns[k], R::splat(0.0), R::splat(0.0))),
        ..Kept::default()
    };
    let carried = Carried {
        articulated: felt.at(-link.parent_arm),
        wrench: lacks,
    };
    (kept, carried)
}
// ANCHOR_END: fold_hinge

// ANCHOR: unfold
/// On the way down: how the body's motion changes, for velocities and pushes, where its parent's does so;
/// and the impulse at the joint's point that changes its velocity.
#[inline(always)]
#[must_use]
pub fn unfold<R: Real>(
    kind: u32,
    link: &Link<R>,
    kept: &Kept<R>,
    felt: &Carried<R>,
    parent: [Rate<R>; 2],
) -> ([Rate<R>; 2], Vec3<R>) {
    let given = for_both(|k| felt.articulated.times(parent[k]).impulse - felt.wrench[k].impulse);
    let change = for_both(|k| follow(kind, link, kept, k, parent[k], given[k]));
    (change, given[0])
}

/// How the body's motion changes where its parent's does so and the joint gives this impulse.
#[inline(always)]
fn follow<R: Real>(
    kind: u32,
    link: &Link<R>,
    kept: &Kept<R>,
    k: usize,
    parent: Rate<R>,
    given: Vec3<R>,
) -> Rate<R> {
    let here = parent.at(link.parent_arm);
    match kind {
        HINGE => follow_hinge(link, kept, k, here),
        PIN => follow_point(link, kept, k, here.velocity + link.wanted[k].velocity),
        _ => follow_point(link, kept, k, kept.free[k] + kept.give.times(given)),
    }
}

/// The body's motion if its joint's point moves so.
#[inline(always)]
fn follow_point<R: Real>(link: &Link<R>, kept: &Kept<R>, k: usize, velocity: Vec3<R>) -> Rate<R> {
    let spin = kept.rest[k] - kept.gain * velocity;
    Rate { velocity, spin }.at(-link.arm)
}
// ANCHOR_END: unfold

/// The body's motion on a hinge if the parent moves so there.
#[inline(always)]
fn follow_hinge<R: Real>(link: &Link<R>, kept: &Kept<R>, k: usize, here: Rate<R>) -> Rate<R> {
    let velocity = here.velocity + link.wanted[k].velocity;
    let spin = here.spin + link.wanted[k].spin;
    let turn = kept.rest[k].x - kept.gain.x.dot(velocity) - kept.gain.y.dot(spin);
    let spin = spin + kept.gain.z * turn;
    Rate { velocity, spin }.at(-link.arm)
}
