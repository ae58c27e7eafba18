//! Engine `lanes`, in one program: each that has lanes of its own takes minutes to compile.

mod bits;
mod left_out;
mod measures;
#[path = "../shared/moved.rs"]
mod moved;
mod sleeping;
