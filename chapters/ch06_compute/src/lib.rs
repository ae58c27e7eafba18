//! Chapter 6: compute shaders. The columns of chapter 5 on the GPU, a step in which every row writes
//! only itself, and the same step on the CPU.

pub mod bodies;
pub mod compute;
pub mod footing;
pub mod grid;
pub mod lanes;
mod norm;
pub mod own_row;
#[cfg(feature = "rapier")]
pub mod peer;
pub mod round_trip;
pub mod rows;
pub mod rules;
pub mod schema;
pub mod simd;
pub mod stream;

pub use compute::ENGINE as COMPUTE;
pub use lanes::ENGINE as LANES;
