//! Chapter 1's demo: the orrery.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch00_shell::main(&ch00_shell::Chapter {
        name: "ch01_hierarchy",
        title: "1. A hierarchy of objects",
        about: "An orrery: sun, planets and moons as nested nodes of a scene graph.",
        engines: &[ch01_hierarchy::ENGINE],
        default_scene: "orrery",
        scenes: &["orrery"],
    })
}
