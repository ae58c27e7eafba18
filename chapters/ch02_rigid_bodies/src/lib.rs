//! Chapter 2: rigid bodies as game objects. The report's `RigidBody`, stepped by velocity-less
//! Verlet, pushed by force and torque callbacks, slowed by drag.
//!
//! A body's velocity is nowhere stored: it is the difference between where the body is and
//! where it was. What that buys and what it costs is what this chapter is about.

mod callbacks;
mod engine;
mod held;
mod load;
mod method;
mod rigid_body;
mod spring;

pub use callbacks::{Callback, Feel, add_magnets};
pub use engine::{ENGINE, RigidBodyEngine};
pub use held::FixedPoint;
pub use load::{Loaded, load_bodies};
pub use method::{METHODS, Method};
pub use rigid_body::{Material, RigidBody};
pub use spring::Spring;
