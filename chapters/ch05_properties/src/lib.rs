//! Chapter 5: properties. The same algorithms as chapters 2 to 4, the same bits, and another layout: all
//! state is columns in one nested container, all behaviour is plain functions over them.

pub mod borrowing;
pub mod columns;
pub mod data;
mod engine;
mod layers;
pub mod plan;
pub mod systems;
pub mod world;

pub use engine::{ENGINE, METHODS, PropertiesEngine};
