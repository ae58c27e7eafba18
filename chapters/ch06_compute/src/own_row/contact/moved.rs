//! A body that several pairs come to in a substep, one after another.

use crate::own_row::side::Side;
use crate::simd::{Inertia, Real, Vec3};

/// Which visit of a substep it is that a pair makes to its bodies.
#[derive(Clone, Copy, Debug)]
pub struct Visit<R: Real, I> {
    /// The bodies as they are when it comes to them, and what it makes of them.
    pub moved: [Moved<R, I>; 2],
    /// Where what the pair pressed in an earlier visit of the substep was an impact.
    pub was_impact: R::Mask,
    /// Whether it is the last one.
    pub ends: bool,
}

/// A body as it is when a pair comes to it, and what of the pushes it has had by then.
#[derive(Clone, Copy, Debug)]
pub struct Moved<R, I> {
    /// How it moves.
    pub side: Side<R, I>,
    /// Velocity of its push, m/s.
    pub push: Vec3<R>,
    /// Angular velocity of its push, rad/s.
    pub turning_push: Vec3<R>,
}

impl<R: Real, I: Inertia<R>> Moved<R, I> {
    /// Without a push.
    #[inline(always)]
    #[must_use]
    pub fn of(side: Side<R, I>) -> Self {
        Self {
            side,
            push: Vec3::zero(),
            turning_push: Vec3::zero(),
        }
    }

    /// Itself where yes, the other where no.
    #[inline(always)]
    pub(super) fn or(self, mask: R::Mask, other: &Self) -> Self {
        let mut side = self.side;
        let v = |one, other| Vec3::select(mask, one, other);
        side.velocity = v(side.velocity, other.side.velocity);
        side.angular_velocity = v(side.angular_velocity, other.side.angular_velocity);
        Self {
            side,
            push: v(self.push, other.push),
            turning_push: v(self.turning_push, other.turning_push),
        }
    }
}
