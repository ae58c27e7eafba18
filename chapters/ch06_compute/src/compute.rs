//! The own-row step on the GPU. All state stays there; numbers come down late, and only those that
//! somebody asked for.

pub mod balls;
mod device;
mod driver;
mod engine;
pub mod error;
mod late;
mod layers;
pub mod pairs;
mod scan;
mod tables;

pub use balls::Balls;
pub use driver::Driver;
pub use engine::{ComputeEngine, ENGINE};
pub use error::ComputeError;
pub use pairs::Pairs;
