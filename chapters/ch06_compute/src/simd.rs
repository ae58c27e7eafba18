//! Numbers in lanes: a formula that is written once and computed for one row or for eight at a time.
//!
//! A processor multiplies eight numbers as fast as one, if they lie side by side and none needs another
//! instruction than the rest. So a formula is written over a [`Real`], which is `f32` or eight of them, without a
//! branch that depends on a number: what depends is computed either way and chosen with [`Real::select`].
//!
//! A lane of eight has the bits that `f32` alone has: every operation here is one that IEEE 754 rounds
//! correctly, or is made of such; multiply and add are never fused.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

pub mod counted;
mod matrix;
mod quaternion;
mod real;
mod rows;
mod trigonometry;
mod vector;

pub use matrix::{Inertia, Mat3, Round, Symmetric};
pub use quaternion::Quat;
pub use real::{Eight, Four, MOST_LANES, Mask, Real, Widest};
pub use rows::{gather, load, store};
pub use trigonometry::{arc_tangent_of, sine_cosine};
pub use vector::Vec3;

/// What `number` gives for each of N places. [`std::array::from_fn`] isn't always expanded in place.
#[inline(always)]
#[must_use]
pub fn array_of<T: Copy, const N: usize>(mut number: impl FnMut(usize) -> T) -> [T; N] {
    let mut numbers = [number(0); N];
    for (place, value) in numbers.iter_mut().enumerate().skip(1) {
        *value = number(place);
    }
    numbers
}
