//! Chapter 7, findings: the program that has every engine and every scene of the book, and the
//! laboratory that measures them: what the charts show, and how they are drawn.

pub mod bounce;
pub mod chart;
mod commands;
pub mod draw;
pub mod errata;
mod error;
pub mod product;
pub mod sweeps;
mod table;
pub mod table1;

use ch00_shell::Chapter;

pub use commands::main;
pub use error::FindingsError;

/// What the top binary can run: each chapter adds its engine.
pub const CHAPTER: Chapter = Chapter {
    name: "ch07_findings",
    title: "From Objects to Shaders",
    about: "Every engine and every scene of the book, and the charts of what was measured.",
    engines: &[ch03_collision::ENGINE],
    default_scene: "balls",
    scenes: &["balls", "pair", "bounce", "bounce_half", "tops", "orrery"],
};
