//! Chapter 1: a scene graph with game objects, and one small scene in three styles.
//!
//! A [`Level`] owns a [`SceneGraph`] and its [`GameObject`]s. Chapters 2 to 4 add rigid
//! bodies, collisions and ragdolls to it. [`ENGINE`] runs scenes whose bodies follow
//! prescribed orbits; [`Orrery`] lends those orbits to the later chapters.

mod component;
mod engine;
mod game_object;
mod level;
mod orbiter;
mod orrery;
mod picture;
mod scene_graph;
pub mod styles;
mod transform;

pub use component::Component;
pub use engine::ENGINE;
pub use game_object::{GameObject, Shared};
pub use level::Level;
pub use orbiter::{Circle, Motion, Orbiter, Spin, SteadyAngle};
pub use orrery::{Member, Orrery};
pub use scene_graph::{GraphError, Keep, NodeId, SceneGraph, SceneNode};
pub use transform::Transform;
