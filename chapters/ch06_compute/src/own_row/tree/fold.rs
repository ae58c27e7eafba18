//! A node on the way up to the root and on the way down again.
//!
//! Up: what hangs at a joint is felt by the parent as an inertia and an impulse at the joint's point, so
//! the node's body is folded into the parent's. At the root nothing is left to fold: it moves. Down:
//! each child follows its parent. Together this is block LDLᵀ of the system of all joints of the tree,
//! without fill-in since a child has one parent, in as many steps as the tree has levels.

use glam::{Mat3, Vec3};

use super::articulated::transposed_times;
use super::{Articulated, Bone, Link, Rate, Symmetric, Wrench};
use crate::rows::{HINGE, PIN, ROD, TWO_RODS};

/// Below this a reply is none.
const SMALL: f32 = 1e-12;

/// Two rods whose directions are this near to one line, as the square of their sine, pull as if they
/// were not quite.
const LEAST_SINE2: f32 = 1e-4;

// ANCHOR: carried
/// What a body and all that hangs on it answer, and what moves them: first for the velocities, then for
/// the pushes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Carried {
    /// How they answer.
    pub articulated: Articulated,
    /// What moves them.
    pub wrench: [Wrench; 2],
}
// ANCHOR_END: carried

impl Carried {
    /// The sum of both, which are taken at the same point.
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
pub struct Kept {
    /// What the joint's motion makes of the body's spin: Δω = rest − gain · Δv_c. Of a hinge the columns
    /// are what velocity and spin make of its turn, and its axis.
    pub gain: Mat3,
    /// The body's spin while the joint's point stays; of a hinge x is its turn.
    pub rest: [Vec3; 2],
    /// K⁻¹: how the joint's point yields, for joints that leave it free in some direction.
    pub give: Symmetric,
    /// How the joint's point moves if nothing holds it.
    pub free: [Vec3; 2],
}
// ANCHOR_END: kept

// ANCHOR: fold
/// On the way up: folds a body, with all that was folded into it, into its joint. Gives what it keeps
/// for the way down, and what the parent feels, about the parent's centre.
#[must_use]
pub fn fold(kind: u32, link: &Link, bone: &Bone, body: &Carried) -> (Kept, Carried) {
    let at_joint = Carried {
        articulated: body.articulated.at(link.arm),
        wrench: body.wrench.map(|wrench| wrench.at(link.arm)),
    };
    let (kept, felt) = if kind == HINGE {
        fold_hinge(link, bone, &at_joint)
    } else {
        fold_point(kind, link, bone, &at_joint)
    };
    let wrench = felt.wrench.map(|wrench| wrench.at(-link.parent_arm));
    (kept, Carried { wrench, ..felt })
}
// ANCHOR_END: fold

// ANCHOR: fold_point
// ANCHOR: felt_mass
/// A joint about whose point the body turns freely: it gives way until no turning impulse is left. What
/// is felt at the point is the mass K = A − Cᵀ D⁻¹ C.
fn fold_point(kind: u32, link: &Link, bone: &Bone, at_joint: &Carried) -> (Kept, Carried) {
    let Articulated {
        mass,
        coupling,
        inertia,
    } = at_joint.articulated;
    let stiffest = bone.inverse_inertia.max_element();
    let turns = inertia.inverse(1.0 / stiffest);
    let gain = Mat3::from_cols(
        turns.times(coupling.x_axis),
        turns.times(coupling.y_axis),
        turns.times(coupling.z_axis),
    );
    let felt = less_product(mass, gain, coupling);
    let impulse = at_joint
        .wrench
        .map(|wrench| wrench.impulse - transposed_times(gain, wrench.turning));
    let mut kept = Kept {
        gain,
        rest: at_joint.wrench.map(|wrench| turns.times(wrench.turning)),
        ..Kept::default()
    };
    if kind == PIN {
        let lacks = |k: usize| impulse[k] - felt.times(link.wanted[k].velocity);
        return (kept, felt_at(felt, [lacks(0), lacks(1)], link));
    }
    kept.give = felt.inverse(1.0 / (bone.inverse_mass + link.arm.length_squared() * stiffest));
    kept.free = impulse.map(|impulse| kept.give.times(impulse));
    let carried = match kind {
        ROD | TWO_RODS => fold_rods(kind, link, &kept),
        _ => Carried::default(),
    };
    (kept, carried)
}
// ANCHOR_END: felt_mass

/// A − Gᵀ C where that is symmetric.
fn less_product(a: Symmetric, g: Mat3, c: Mat3) -> Symmetric {
    Symmetric {
        diagonal: a.diagonal
            - Vec3::new(
                g.x_axis.dot(c.x_axis),
                g.y_axis.dot(c.y_axis),
                g.z_axis.dot(c.z_axis),
            ),
        off: a.off
            - Vec3::new(
                g.y_axis.dot(c.z_axis),
                g.z_axis.dot(c.x_axis),
                g.x_axis.dot(c.y_axis),
            ),
    }
}

/// What the parent feels where a mass is felt at the joint's point. The impulses stay about that point.
fn felt_at(mass: Symmetric, impulse: [Vec3; 2], link: &Link) -> Carried {
    Carried {
        articulated: Articulated::felt_at(mass, link.parent_arm),
        wrench: impulse.map(|impulse| Wrench {
            impulse,
            turning: Vec3::ZERO,
        }),
    }
}
// ANCHOR_END: fold_point

// ANCHOR: fold_rods
/// One or two rods, of which the parent feels what acts along them: with U their directions the mass
/// U κ Uᵀ, κ = (Uᵀ K⁻¹ U)⁻¹.
fn fold_rods(kind: u32, link: &Link, kept: &Kept) -> Carried {
    let (u1, u2) = (link.along, link.second);
    let n1 = kept.give.times(u1);
    let reply = u1.dot(n1).max(SMALL);
    let lacks = |k: usize, u: Vec3, wanted: f32| u.dot(kept.free[k]) - wanted;
    let first = [0, 1].map(|k| lacks(k, u1, link.wanted[k].velocity.x));
    if kind == ROD {
        let mass = Symmetric::outer(u1).scaled(1.0 / reply);
        return felt_at(mass, first.map(|lacks| u1 * (lacks / reply)), link);
    }
    let n2 = kept.give.times(u2);
    let (both, other) = (u1.dot(n2), u2.dot(n2).max(SMALL));
    let sharing = 1.0 / (reply * other - both * both).max(LEAST_SINE2 * reply * other);
    let mass = Symmetric::outer(u1)
        .scaled(other)
        .plus(Symmetric::outer(u2).scaled(reply))
        .plus(Symmetric::outer_pair(u1, u2).scaled(-both))
        .scaled(sharing);
    let impulse = [0, 1].map(|k| {
        let second = lacks(k, u2, link.wanted[k].velocity.y);
        (u1 * (other * first[k] - both * second) + u2 * (reply * second - both * first[k]))
            * sharing
    });
    felt_at(mass, impulse, link)
}
// ANCHOR_END: fold_rods

// ANCHOR: fold_hinge
/// A hinge: the body gives way about its axis alone, until no turning impulse is left along that.
fn fold_hinge(link: &Link, bone: &Bone, at_joint: &Carried) -> (Kept, Carried) {
    let Articulated {
        mass,
        coupling,
        inertia,
    } = at_joint.articulated;
    let axis = link.along;
    let turning = inertia.times(axis);
    let moving = transposed_times(coupling, axis);
    let least = 1.0 / bone.inverse_inertia.max_element();
    let reply = 1.0 / axis.dot(turning).max(least);
    let felt = Articulated {
        mass: mass.plus(Symmetric::outer(moving).scaled(-reply)),
        coupling: coupling
            - Mat3::from_cols(turning * moving.x, turning * moving.y, turning * moving.z) * reply,
        inertia: inertia.plus(Symmetric::outer(turning).scaled(-reply)),
    };
    let turns = at_joint
        .wrench
        .map(|wrench| reply * axis.dot(wrench.turning));
    let lacks = |k: usize| {
        let given = Wrench {
            impulse: moving * turns[k],
            turning: turning * turns[k],
        };
        let wrench = at_joint.wrench[k].minus(given);
        wrench.minus(felt.times(link.wanted[k]))
    };
    let kept = Kept {
        gain: Mat3::from_cols(moving * reply, turning * reply, axis),
        rest: turns.map(|turn| Vec3::new(turn, 0.0, 0.0)),
        ..Kept::default()
    };
    let carried = Carried {
        articulated: felt.at(-link.parent_arm),
        wrench: [lacks(0), lacks(1)],
    };
    (kept, carried)
}
// ANCHOR_END: fold_hinge

// ANCHOR: unfold
/// On the way down: how the body's motion changes, for velocities and pushes, where its parent's does so;
/// and the impulse at the joint's point that changes its velocity.
#[must_use]
pub fn unfold(
    kind: u32,
    link: &Link,
    kept: &Kept,
    felt: &Carried,
    parent: [Rate; 2],
) -> ([Rate; 2], Vec3) {
    let given = [0, 1].map(|k| felt.articulated.times(parent[k]).impulse - felt.wrench[k].impulse);
    let change = [0, 1].map(|k| {
        let here = parent[k].at(link.parent_arm);
        match kind {
            HINGE => follow_hinge(link, kept, k, here),
            PIN => follow_point(link, kept, k, here.velocity + link.wanted[k].velocity),
            _ => follow_point(link, kept, k, kept.free[k] + kept.give.times(given[k])),
        }
    });
    (change, given[0])
}

/// The body's motion if its joint's point moves so.
fn follow_point(link: &Link, kept: &Kept, k: usize, velocity: Vec3) -> Rate {
    let spin = kept.rest[k] - kept.gain * velocity;
    Rate { velocity, spin }.at(-link.arm)
}

/// The body's motion on a hinge if the parent moves so there.
fn follow_hinge(link: &Link, kept: &Kept, k: usize, here: Rate) -> Rate {
    let velocity = here.velocity + link.wanted[k].velocity;
    let spin = here.spin + link.wanted[k].spin;
    let turn = kept.rest[k].x - kept.gain.x_axis.dot(velocity) - kept.gain.y_axis.dot(spin);
    let spin = spin + turn * kept.gain.z_axis;
    Rate { velocity, spin }.at(-link.arm)
}
// ANCHOR_END: unfold
