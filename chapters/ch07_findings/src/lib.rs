//! Chapter 7, findings: the program that has every engine and every scene of the book, and the
//! laboratory that measures them: what the charts show, and how they are drawn.

pub mod architecture_method_hardware;
pub mod balls_on_the_gpu;
pub mod bounce;
pub mod broad_phase;
pub mod chain;
pub mod chart;
pub mod columns;
mod commands;
pub mod draw;
mod engines;
pub mod errata;
mod error;
pub mod friction;
pub mod integrate;
mod kept;
mod lab;
pub mod laboratory;
pub mod lanes_kept;
pub mod lanes_roofline;
pub mod left_out;
pub mod limbs;
pub mod mass_ratio;
pub mod methods;
pub mod microseconds_per_body;
pub mod product;
pub mod race;
pub mod ragdoll_run;
#[cfg(feature = "rapier")]
mod rapier;
pub mod rates;
pub mod report_on_engines;
pub mod round_trip;
pub mod stack;
mod stepped;
pub mod substeps_on_the_gpu;
pub mod sweeps;
mod table;
pub mod table1;
pub mod table2;
pub mod tunnelling;

use ch00_shell::Chapter;

pub use commands::main;
pub use error::FindingsError;

/// What the top binary can run: each chapter adds its engine.
pub const CHAPTER: Chapter = Chapter {
    name: "ch07_findings",
    title: "From Objects to Shaders",
    about: "Every engine and every scene of the book, and the charts of what was measured.",
    engines: &[
        ch04_ragdolls::ENGINE,
        ch05_properties::ENGINE,
        ch06_compute::LANES,
        ch06_compute::COMPUTE,
        methods::double::engine::ENGINE,
    ],
    default_scene: "balls",
    scenes: ch00_scenes::builtin::NAMES,
};
