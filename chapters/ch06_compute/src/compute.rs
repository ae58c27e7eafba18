//! The own-row step on the GPU. All state stays there; numbers come down late, and only those that
//! somebody asked for.

mod ball_kernels;
pub mod balls;

pub use balls::Balls;
