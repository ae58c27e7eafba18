//! The own-row method: what a pair, a joint and a body compute in a substep, as pure functions over
//! rows. The kernels have the same functions by the same names.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

pub mod body;
pub mod contact;
pub mod free_rotation;
pub mod limits;
pub mod loops;
pub mod narrow;
pub mod side;
pub mod swing_twist;
pub mod tree;
