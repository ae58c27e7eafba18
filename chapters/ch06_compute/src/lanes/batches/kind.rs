//! What a pair needs to know of its bodies, by its kind; and what is done with pairs, written once for all kinds.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

use super::Batch;
use crate::own_row::contact::{Contact, Smooth, Touching, touching, touching_balls};
use crate::own_row::side::{Side, Standing, Turns};
use crate::rows::Press;
use crate::simd::{Inertia, Real, Round, Symmetric};

// ANCHOR: kind
/// What a pair needs to know of its bodies depends on its kind; it is told by how they turn.
pub trait Kind<R: Real, const P: usize>: Turns<R> {
    /// Where the points are now.
    fn touching<I: Inertia<R>>(
        contact: &Contact<R, P>,
        a: &Side<R, I>,
        b: &Side<R, I>,
    ) -> Touching<R, P>;
}

/// Bodies of any shape.
impl<R: Real, const P: usize> Kind<R, P> for Symmetric<R> {
    #[inline(always)]
    fn touching<I: Inertia<R>>(
        contact: &Contact<R, P>,
        a: &Side<R, I>,
        b: &Side<R, I>,
    ) -> Touching<R, P> {
        touching(contact, a, b)
    }
}

/// Two balls.
impl<R: Real> Kind<R, 1> for Round<R> {
    #[inline(always)]
    fn touching<I: Inertia<R>>(
        contact: &Contact<R, 1>,
        a: &Side<R, I>,
        b: &Side<R, I>,
    ) -> Touching<R, 1> {
        touching_balls(contact, a, b)
    }
}

/// A ball on a box that stands.
impl<R: Real> Kind<R, 1> for Standing<R> {
    #[inline(always)]
    fn touching<I: Inertia<R>>(
        contact: &Contact<R, 1>,
        a: &Side<R, I>,
        b: &Side<R, I>,
    ) -> Touching<R, 1> {
        touching(contact, a, b)
    }
}
// ANCHOR_END: kind

/// Bodies of a kind, without friction.
impl<R: Real, I: Kind<R, P>, const P: usize> Kind<R, P> for Smooth<I> {
    #[inline(always)]
    fn touching<J: Inertia<R>>(
        contact: &Contact<R, P>,
        a: &Side<R, J>,
        b: &Side<R, J>,
    ) -> Touching<R, P> {
        I::touching(contact, a, b)
    }
}

/// What is done with a batch of any kind, whatever its number of points.
pub trait Work<R: Real>: Sync {
    /// Does it. `rows` is what the bodies gather, a row a lane.
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]);
}

/// What is done with a batch of one colour: bodies are read and written, and there are no rows.
pub trait Visit<R: Real>: Sync {
    /// Does it.
    fn visit<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>);
}

// ANCHOR: frictionless
/// The same with batches whose pairs have no friction.
pub struct Frictionless<'w, W>(pub &'w W);

impl<R: Real, W: Work<R>> Work<R> for Frictionless<'_, W> {
    fn run<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>, rows: &mut [Press]) {
        self.0.run::<Smooth<I>, P>(batch, rows);
    }
}
// ANCHOR_END: frictionless

impl<R: Real, V: Visit<R>> Visit<R> for Frictionless<'_, V> {
    fn visit<I: Kind<R, P>, const P: usize>(&self, batch: &mut Batch<R, P>) {
        self.0.visit::<Smooth<I>, P>(batch);
    }
}
