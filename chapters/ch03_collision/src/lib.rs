//! Chapter 3: collision. Bounding boxes in a KD-tree find the pairs that may touch, closed forms
//! tell where they do, and impulses part them.
//!
//! The pure functions ([`aabb`], [`kd_tree`], [`narrow`]) know nothing of game objects, so that
//! chapter 5 can call them over columns.

pub mod aabb;
mod checks;
mod collision_tree;
mod contact;
mod engine;
pub mod kd_tree;
mod layers;
pub mod narrow;
mod resolve;

pub use collision_tree::{CollisionTree, Margins};
pub use contact::Contact;
pub use engine::{CollisionEngine, ENGINE};
pub use resolve::{DEFAULT_SWEEPS, Rules, resolve_corrected, resolve_printed};
