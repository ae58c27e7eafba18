//! Pairs without friction.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

use crate::bodies::Bodies;
use crate::own_row::side::Turns;
use crate::simd::{Inertia, Quat, Real, Vec3};

// ANCHOR: smooth
/// How the bodies of a pair without friction turn: as I says. The formulas of friction aren't compiled into what is
/// done with such a pair, and what turns balls isn't even fetched.
#[derive(Clone, Copy, Debug, Default)]
pub struct Smooth<I>(I);

impl<R: Real, I: Inertia<R>> Inertia<R> for Smooth<I> {
    const CENTRAL: bool = I::CENTRAL;
    const RUBS: bool = false;

    #[inline(always)]
    fn answer(self, turning: Vec3<R>) -> Vec3<R> {
        self.0.answer(turning)
    }
}

impl<R: Real, I: Turns<R>> Turns<R> for Smooth<I> {
    #[inline(always)]
    fn attitude(bodies: &Bodies, rows: &[u32]) -> Quat<R> {
        I::attitude(bodies, rows)
    }

    #[inline(always)]
    fn inertia(bodies: &Bodies, rows: &[u32], attitude: Quat<R>, shares: R) -> Self {
        if I::CENTRAL {
            return Self::default();
        }
        Self(I::inertia(bodies, rows, attitude, shares))
    }
}
// ANCHOR_END: smooth
