//! Chapter 3: collision. Bounding boxes in a KD-tree find the pairs that may touch, closed forms
//! tell where they do, and impulses part them.
//!
//! The pure functions ([`aabb`], [`kd_tree`], [`narrow`], [`layers`]) know nothing of game objects, so that
//! chapter 5 can call them over columns.

pub mod aabb;
pub mod brute_force;
mod checks;
mod collision_tree;
mod contact;
mod dissect;
mod engine;
pub mod grid;
pub mod kd_tree;
pub mod layers;
pub mod narrow;
mod pass_clock;
mod resolve;

pub use checks::check_settings;
pub use collision_tree::{CollisionTree, Margins, placed};
pub use contact::Contact;
pub use dissect::dissect;
pub use engine::{CollisionEngine, ENGINE};
pub use pass_clock::PassClock;
pub use resolve::{
    DEFAULT_SWEEPS, DEFAULT_SWEEPS_OF_BALLS, FAR_NUDGE, LONGEST_SHIFT, Links, NoLinks, Rules,
    SMALL_NUDGE, Span, default_sweeps, resolve_corrected, resolve_printed,
};
