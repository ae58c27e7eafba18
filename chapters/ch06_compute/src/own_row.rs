//! The own-row method: what a pair, a joint and a body compute in a substep, as pure functions over
//! rows. The kernels have the same functions by the same names.

pub mod body;
pub mod contact;
pub mod limits;
pub mod loops;
pub mod narrow;
pub mod side;
pub mod tree;
